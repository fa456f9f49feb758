// Drives the live page in Chromium: node browser.mjs FOLDER_OF_THE_PAGE [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {spawn} from "node:child_process";
import {once} from "node:events";
import {existsSync, readdirSync, statSync} from "node:fs";
import {join} from "node:path";
import {fileURLToPath} from "node:url";
import {with_pages} from "../browser.mjs";

const folder = process.argv[2];
if (!existsSync(join(folder, "index.html"))) {
    console.log("skipped: there is no page, which emscripten makes (apt-get install emscripten)");
    process.exit(77);
}
const bytes = readdirSync(folder).reduce((sum, name) => sum + statSync(join(folder, name)).size, 0);
assert.ok(bytes < 4 << 20, `the page has ${bytes} bytes`);

/// How many different colours the canvas shows in some columns, and their mean.
const look = (from = 0, to = 1) => {
    const canvas = document.getElementById("canvas"), x = Math.floor(from * canvas.width), width = Math.floor(to * canvas.width) - x;
    const copy = new OffscreenCanvas(width, canvas.height).getContext("2d", {willReadFrequently: true});
    copy.drawImage(canvas, -x, 0);
    const {data} = copy.getImageData(0, 0, width, canvas.height);
    const colours = new Set();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
        colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
        sum += data[i] + data[i + 1] + data[i + 2];
    }
    return {colours: colours.size, mean: sum / (3 * data.length / 4)};
};

/// What the browser has complained about, but for WebGPU that it does not have.
const problems = page => page.problems.filter(problem => problem !== "No available adapters.");

let loading = 0; // milliseconds until the first frame was there
await with_pages(async open => {
    const frames = (page, count) => page.evaluate(() => live.frames).then(now => page.until(end => live.frames >= end, now + count));
    const page = await open("index.html", {width: 1280});
    await page.until(() => window.live?.frames > 0);
    await page.choose("#size", "160x90");
    await frames(page, 3);
    assert.ok(!await page.is_visible("#message"));
    loading = Math.round(await page.evaluate(() => live.milliseconds_to_first));
    const first = await page.evaluate(look);
    assert.ok(first.colours > 500 && first.mean > 20 && first.mean < 235, JSON.stringify(first));

    // It turns by mouse, keys and fingers, and goes back.
    const camera = () => page.evaluate(() => ({...live.choice.camera}));
    const start = await camera();
    const middle = await page.middle("#screen");
    await page.drag(middle, 80, 20);
    const turned = await camera();
    assert.ok(turned.yaw < start.yaw && turned.pitch > start.pitch, JSON.stringify(turned));
    await page.focus("#screen");
    await page.press("ArrowRight");
    assert.ok((await camera()).yaw < turned.yaw);
    await page.move(middle.x, middle.y);
    await page.wheel(-120);
    await page.until(before => live.choice.camera.distance < before, start.distance);
    await page.click("#home");
    assert.deepEqual(await camera(), start);

    // Sliders say what they are at; light and motion change the picture.
    await page.fill("#samples", "2");
    assert.equal(await page.text("#samples-value"), "2");
    await page.fill("#motion", "0");
    await page.fill("#light", "90");
    assert.equal(await page.text("#light-value"), "90 %");
    // In a still picture the samples of frames come together.
    await frames(page, 2);
    await page.until(() => live.program.call.reference_samples() >= 4);

    // A frame that is held stays, while its reference converges; the denoised one is nearer to it than the noisy one.
    await page.click("#hold");
    assert.equal(await page.attribute("#hold", "aria-pressed"), "true");
    const held = await page.evaluate(() => live.frames);
    await page.evaluate(() => live.program.call.refine(64)); // on a busy machine it would come to them late
    await page.until(() => Number(document.getElementById("error-noisy").textContent) > 0);
    const [noisy, denoised] = [Number(await page.text("#error-noisy")), Number(await page.text("#error-denoised"))];
    assert.ok(denoised < .6 * noisy, `${denoised}, ${noisy}`);
    assert.equal(await page.evaluate(() => live.frames), held);
    assert.ok(await page.is_visible("#label-reference")); // it has been given room
    const share = await page.evaluate(() => live.choice.borders);
    assert.ok(share[1] < 1);
    // Noise is what has many colours.
    const strips = {noisy: await page.evaluate(look, 0, share[0]), reference: await page.evaluate(look, share[1], 1)};
    assert.ok(strips.noisy.colours > 0 && Math.abs(strips.noisy.mean - strips.reference.mean) < 128, JSON.stringify(strips));
    await page.save("held");

    // The borders of the split go along with the mouse.
    const border = await page.middle("#border-a");
    await page.drag(border, 100, 0);
    assert.ok(await page.evaluate(before => live.choice.borders[0] > before, share[0]));
    assert.deepEqual(await camera(), start);

    // The error map, of a frame that is held, and the way on.
    await page.click("label:has([value=error])");
    assert.ok(await page.is_visible("#scale") && !await page.is_visible("#borders"));
    const map = await page.evaluate(look);
    assert.ok(map.mean > 2 && map.mean < 128, JSON.stringify(map));
    await page.save("error");
    await page.click("#hold");
    assert.equal(await page.attribute("#hold", "aria-pressed"), "false");
    await page.click("label:has([value=denoised])");

    // Each preset and each scene runs, and tells its passes.
    await page.click("summary");
    for (const [preset, scene] of [["svgf", "court"], ["surface-clamp", "court"], ["general", "room"]]) {
        await page.choose("#preset", preset);
        await page.choose("#scene", scene);
        await frames(page, 2);
        await page.until(() => document.querySelectorAll("#passes tr").length > 1);
        const {colours, mean} = await page.evaluate(look);
        assert.ok(colours > 500 && mean > 20 && mean < 245, `${preset}, ${scene}: ${colours} colours, ${mean}`);
        await page.save(`${scene}_${preset}`);
    }
    assert.match(await page.text("#trace"), /^[\d.]+ ms$/);
    assert.ok(!await page.is_visible("#threads-choice")); // a page from a folder may have one

    // Anti-aliasing is one pass more, and its pictures are not those without it.
    const passes = await page.count("#passes tr");
    await page.click("#smooth");
    await frames(page, 3);
    await page.until(before => document.querySelectorAll("#passes tr").length > before, passes);
    assert.ok(await page.evaluate(() => [0, 1].some(which => live.program.call.jitter(which) !== 0)));
    assert.ok((await page.evaluate(look)).colours > 500);
    await page.save("anti_aliased");
    await page.click("#smooth");
    await frames(page, 1);
    assert.deepEqual(await page.evaluate(() => [0, 1].map(which => live.program.call.jitter(which))), [0, 0]);
    assert.deepEqual(problems(page), []);

    // On a telephone nothing runs out of the page, in the light and in the dark; two fingers move the camera.
    for (const dark of [false, true]) {
        const phone = await open("index.html", {width: 380, height: 800, touch: true, dark});
        await phone.until(() => window.live?.frames > 1);
        assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth) <= 380);
        await phone.fill("#motion", "0");
        const {x, y} = await phone.middle("#screen");
        const touch = (type, ...at) => phone.send("Input.dispatchTouchEvent", {type, touchPoints: at.map((dx, id) => ({x: x + dx, y, id}))});
        const before = await phone.evaluate(() => live.choice.camera.distance);
        await touch("touchStart", -30, 30);
        for (const reach of [45, 60, 75]) await touch("touchMove", -reach, reach);
        await touch("touchEnd");
        await phone.until(was => live.choice.camera.distance < was, before);
        assert.deepEqual(problems(phone), []);
        await phone.save_whole(`phone${dark ? "_dark" : ""}`);
    }
});

/// What several threads make of a few frames of each preset, one of them, and the program of one: sums over all pixels, by which they differ.
async function several_against_one() {
    const {program, choice} = live, width = 83, height = 45;
    choice.hold(true);
    const pictures = (of, threads) => {
        of.call.use_threads(threads);
        of.resize(width, height);
        const bytes = [];
        for (const preset of [0, 1, 2])
            for (let i = 0; i < 6; ++i) {
                of.call.advance(i > 3 ? 1 : 0, preset, 1, i / 15, .5, .1 + .01 * i, .1, 3, preset === 0);
                of.call.refine(1);
                for (const which of [noisy, denoised, reference])
                    bytes.push(...new Uint8Array(of.memory.buffer, of.call.picture(which, 1, 0, width), 4 * width * height));
            }
        return bytes;
    };
    const several = pictures(program, program.most_threads);
    const others = [pictures(program, 1), pictures(await Program.of_one_thread(), 1)];
    return {colours: new Set(several).size, differ: others.map(other => other.filter((byte, i) => byte !== several[i]).length)};
}

// Behind a server that allows it, the page has several threads, and shows the same.
let threads = 0;
const server = spawn("python3", [fileURLToPath(new URL("../../examples/live/serve.py", import.meta.url)), folder, "--port", "0"],
                     {stdio: ["ignore", "pipe", "inherit"]});
try {
    const [line] = await once(server.stdout, "data");
    await with_pages(async open => {
        const page = await open("index.html", {width: 1280});
        await page.until(() => window.live?.frames > 2);
        assert.ok(await page.evaluate(() => crossOriginIsolated));
        threads = await page.evaluate(() => live.program.most_threads);
        assert.equal(threads, await page.evaluate(() => Math.min(16, navigator.hardwareConcurrency)));
        const off = await page.evaluate(several_against_one);
        assert.ok(off.colours > 100, JSON.stringify(off));
        assert.deepEqual(off.differ, [0, 0]);
        if (threads > 1) {
            assert.equal(await page.evaluate(() => live.program.workers.length), threads - 1);
            await page.choose("#size", "160x90");
            await page.fill("#threads", "1");
            assert.equal(await page.text("#threads-value"), "1");
            const now = await page.evaluate(() => live.frames);
            await page.until(end => live.frames > end, now + 2);
        }
        await page.save("threads");
        assert.deepEqual(problems(page), []);
    }, [], line.toString().trim());
} finally {
    server.kill();
}

/// The greatest difference of both ways to denoise the same frames, of 255, and how many numbers differ.
async function gpu_against_cpu(is_smooth) {
    const {program, program: {call}, gpu, choice} = live, width = 80, height = 45;
    choice.hold(true);
    const shown = async on_gpu => {
        program.resize(width, height);
        gpu.resize(width, height);
        for (let i = 0; i < 6; ++i) {
            call.advance(0, on_gpu ? traced_only : 0, 1, i / 15, .5, .1 + .01 * i, .1, 3, is_smooth);
            if (on_gpu) await live.run_gpu();
        }
        return new Uint8Array(program.memory.buffer, call.picture(denoised, 1, 0, width), 4 * width * height).slice();
    };
    const [one, other] = [await shown(false), await shown(true)];
    const off = one.map((value, i) => Math.abs(value - other[i]));
    return {most: Math.max(...off), count: off.filter(Boolean).length, of: off.length};
}

// WebGPU, by Chromium's own device without a GPU.
let words = `the live page works in Chromium, and shows a frame ${loading} ms after it was opened; behind a server it has ${threads} threads`;
const switches = ["--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--enable-unsafe-webgpu"];
await with_pages(async open => {
    const page = await open("index.html", {width: 1280});
    await page.until(() => window.live?.frames > 0);
    await page.evaluate(() => live.gpu_ready);
    if (!await page.evaluate(() => Boolean(live.gpu))) {
        words += "; WebGPU is not tried: the page has no shaders, or Chromium no device";
        return;
    }
    await page.choose("#size", "160x90");
    await page.choose("#preset", "general, WebGPU");
    // As long as it takes: a device without a GPU is slow.
    await page.evaluate(() => new Promise(resolve => {
        const end = live.frames + 3;
        const wait = () => live.frames >= end && !live.is_waiting ? resolve() : setTimeout(wait, 20);
        wait();
    }));
    assert.ok((await page.evaluate(look)).colours > 500);
    for (const is_smooth of [false, true]) {
        const off = await page.evaluate(gpu_against_cpu, is_smooth);
        assert.ok(off.most <= 2, JSON.stringify({is_smooth, ...off}));
    }
    const times = await page.evaluate(() => live.gpu.clock && live.gpu.times);
    if (times) assert.ok(times.some(({name, ms}) => name === "temporal" && ms > 0), JSON.stringify(times));
    assert.deepEqual(page.problems, []);
    words += ", and by WebGPU";
}, switches);
console.log(words);
