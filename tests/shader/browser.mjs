// Runs shaders of presets by WebGPU in Chromium, and compares with the CPU: node browser.mjs PROGRAM, which writes the page.
import assert from "node:assert/strict";
import {with_pages} from "../browser.mjs";

/// How far the pictures of a preset are from the CPU's, relative above 1, where that joins products and sums and where it does not.
async function differences(which) {
    const {plan, texts, width, height, frames} = cases[which];
    const gpu = await GpuDenoiser.make({plan, texts});
    if (!gpu) return null;
    const floats = words => new Float32Array(Uint32Array.from(words).buffer);
    gpu.resize(width, height);
    const off = [0, 0];
    for (const {has_past, block, inputs, wanted} of frames) {
        if (!has_past) gpu.forget();
        plan.inputs.forEach((input, slot) => gpu.set_input(input, floats(inputs[slot])));
        const picture = await gpu.run(Uint32Array.from(block));
        wanted.forEach((planes, way) => planes.forEach((plane, component) => floats(plane).forEach((value, i) => {
            const by = Math.abs(picture[component * plane.length + i] - value) / Math.max(1, Math.abs(value));
            off[way] = Math.max(off[way], Number.isNaN(by) ? Infinity : by);
        })));
    }
    gpu.device.destroy();
    return off;
}

const switches = ["--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--enable-unsafe-webgpu"];
await with_pages(async open => {
    const page = await open("index.html");
    const presets = await page.evaluate(() => cases.map(({name, allowed}) => ({name, allowed})));
    if (presets.length === 0) {
        console.log("skipped: the presets that are tried here are not compiled in (QUELL_PRESETS)");
        process.exitCode = 77;
    }
    for (const [which, {name, allowed}] of presets.entries()) {
        const start = performance.now();
        const off = await page.evaluate(differences, which);
        if (!off) {
            console.log("skipped: Chromium has no device for WebGPU");
            process.exitCode = 77;
            return;
        }
        const [joined, apart] = off.map(by => by.toExponential(1));
        console.log(`${name}: ${joined} from the CPU, ${apart} where it joins no product and sum, ${((performance.now() - start) / 1000).toFixed(1)} s`);
        assert.deepEqual(page.problems, []);
        assert.ok(Math.min(...off) <= allowed, name);
    }
}, switches);
