// Runs shaders of presets by WebGPU in Chromium, and compares with the CPU: node browser.mjs PROGRAM, which writes the page.
import assert from "node:assert/strict";
import {with_pages} from "../browser.mjs";

/// How far the pictures of a preset are from the CPU's, relative above 1, where that joins products and sums and where it does not.
/// `counts` are sentences about what the device has counted otherwise.
async function differences(which) {
    const {plan, texts, width, height, frames} = cases[which];
    const gpu = await GpuDenoiser.make({plan, texts});
    if (!gpu) return null;
    const floats = words => new Float32Array(Uint32Array.from(words).buffer);
    gpu.resize(width, height);
    const off = [0, 0], counts = [];
    const counted = async ({fraction, buffer, slot, block}) => {
        const squares = Math.ceil(width / fraction) * Math.ceil(height / fraction), bytes = 4 * squares;
        const back = gpu.device.createBuffer({size: bytes, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        const encoder = gpu.device.createCommandEncoder();
        encoder.copyBufferToBuffer(gpu.buffers[buffer], 4 * slot * width * height + block * bytes, back, 0, bytes);
        gpu.device.queue.submit([encoder.finish()]);
        await back.mapAsync(GPUMapMode.READ);
        return new Float32Array(back.getMappedRange()).reduce((sum, each) => sum + each, 0);
    };
    for (const {has_past, block, inputs, wanted, totals} of frames) {
        if (!has_past) gpu.forget();
        plan.inputs.forEach((input, slot) => gpu.set_input(input, floats(inputs[slot])));
        const picture = await gpu.run(Uint32Array.from(block));
        wanted.forEach((planes, way) => planes.forEach((plane, component) => floats(plane).forEach((value, i) => {
            const by = Math.abs(picture[component * plane.length + i] - value) / Math.max(1, Math.abs(value));
            off[way] = Math.max(off[way], Number.isNaN(by) ? Infinity : by);
        })));
        for (const [i, total] of totals.entries()) {
            const found = await counted(plan.counts[i]);
            if (found !== total) counts.push(`${plan.counts[i].what}: ${found}, not ${total}`);
        }
    }
    gpu.device.destroy();
    return {off, counts};
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
        const found = await page.evaluate(differences, which);
        if (!found) {
            console.log("skipped: Chromium has no device for WebGPU");
            process.exitCode = 77;
            return;
        }
        const {off, counts} = found, [joined, apart] = off.map(by => by.toExponential(1));
        console.log(`${name}: ${joined} from the CPU, ${apart} where it joins no product and sum, ${((performance.now() - start) / 1000).toFixed(1)} s`);
        assert.deepEqual(page.problems, []);
        assert.deepEqual(counts, []);
        assert.ok(Math.min(...off) <= allowed, name);
    }
}, switches);
