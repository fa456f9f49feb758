// Milliseconds of the processor for a frame of the live page, without a browser: node time.mjs FOLDER_OF_THE_PAGE [WIDTH HEIGHT [FRAMES]]
import {readFileSync} from "node:fs";
import {join} from "node:path";

const [folder, width = 240, height = 135, frames = 40] = process.argv.slice(2);
const [, base64] = readFileSync(join(folder, "live_wasm.js"), "utf8").match(/"(.*)"/);
const cpu_milliseconds = () => {
    const {user, system} = process.cpuUsage();
    return (user + system) / 1000;
};
const {instance: {exports: program}} = await WebAssembly.instantiate(Buffer.from(base64, "base64"), {
    page: {milliseconds: cpu_milliseconds},
    env: {emscripten_notify_memory_growth: () => {}},
    wasi_snapshot_preview1: {proc_exit: code => { throw new Error(`the program ended with ${code}`); }},
});
program._initialize();
program.resize(Number(width), Number(height));
const middle = values => values.sort((a, b) => a - b)[values.length >> 1].toFixed(1);
for (const [scene, name] of ["room", "court"].entries())
    for (const [preset, preset_name] of ["general", "svgf", "surface-clamp"].entries()) {
        const [yaw, pitch, distance] = [0, 1, 2].map(which => program.first_view(scene, which));
        const traced = [], denoised = [];
        for (let i = 0; i < Number(frames); ++i) {
            program.advance(scene, preset, 1, i / 30, .5, yaw, pitch, distance);
            if (i < 8) continue; // V8 compiles better code while it runs
            traced.push(program.trace_milliseconds());
            denoised.push(program.denoise_milliseconds());
        }
        console.log(`${name}, ${preset_name}, ${width}x${height}: traced in ${middle(traced)} ms, denoised in ${middle(denoised)} ms`);
    }
