// Milliseconds for a frame of the live page, without a browser: node time.mjs FOLDER_OF_THE_PAGE [WIDTH HEIGHT [FRAMES [THREADS]]]
// Of one thread: the processor's. With more: those that pass, of frames by one thread and by all of them in turn.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join, resolve} from "node:path";

const [folder, ...numbers] = process.argv.slice(2);
const [width = 240, height = 135, frames = 40, threads = 1] = numbers.map(Number);
const cpu_milliseconds = () => {
    const {user, system} = process.cpuUsage();
    return (user + system) / 1000;
};
async function of_one_thread() {
    const [, base64] = readFileSync(join(folder, "live_wasm.js"), "utf8").match(/"(.*)"/);
    const {instance: {exports}} = await WebAssembly.instantiate(Buffer.from(base64, "base64"), {
        page: {milliseconds: cpu_milliseconds},
        env: {emscripten_notify_memory_growth: () => {}},
        wasi_snapshot_preview1: {proc_exit: code => { throw new Error(`the program ended with ${code}`); }},
    });
    exports._initialize();
    return exports;
}
async function of_threads() {
    const make = createRequire(import.meta.url)(resolve(folder, "live_threads.js"));
    const {asm} = await make({helpers: threads - 1, wasmBinary: readFileSync(join(folder, "live_threads.wasm"))});
    asm.use_threads(threads);
    return asm;
}

const program = await (threads > 1 ? of_threads() : of_one_thread());
program.resize(width, height);
const middle = values => values.sort((a, b) => a - b)[values.length >> 1].toFixed(1);
const counts = threads > 1 ? [1, threads] : [1];
for (const [scene, name] of ["room", "court"].entries())
    for (const [preset, preset_name] of ["general", "svgf", "surface-clamp"].entries()) {
        const [yaw, pitch, distance] = [0, 1, 2].map(which => program.first_view(scene, which));
        const times = counts.map(() => ({traced: [], denoised: []}));
        for (let i = 0; i < frames * counts.length; ++i) {
            const turn = i % counts.length;
            program.use_threads(counts[turn]);
            program.advance(scene, preset, 1, i / 30, .5, yaw, pitch, distance, 0);
            if (i < 8 * counts.length) continue; // V8 compiles better code while it runs
            times[turn].traced.push(program.trace_milliseconds());
            times[turn].denoised.push(program.denoise_milliseconds());
        }
        for (const [turn, {traced, denoised}] of times.entries())
            console.log(`${name}, ${preset_name}, ${width}x${height}, ${counts[turn]} of ${threads} threads: traced in ${middle(traced)} ms, denoised in ${middle(denoised)} ms`);
    }
process.exit(0); // workers would wait for more
