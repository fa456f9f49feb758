// Drives the report page in Chromium: node browser.mjs PATH_OF_report_sample [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {with_pages} from "../browser.mjs";

/// Waits until a page's pictures are there.
async function shown(page) {
    await page.until(() => document.querySelector("#stage").hidden || document.querySelector("#frame-label b"));
    await page.drawn();
    return page;
}

const frame_of = page => page.text("#frame-label b");
const until_frame = (page, number) => page.until(
    wanted => document.querySelector("#frame-label b").textContent === `frame ${wanted}`, number);
/// The colour that a canvas shows at a fraction of its size.
const color_at = (page, selector, x, y) => page.on(selector, (canvas, u, v) => {
    const at = [Math.floor(canvas.width * u), Math.floor(canvas.height * v), 1, 1];
    return [...canvas.getContext("2d").getImageData(...at).data];
}, x, y);

async function check_divider(page) {
    const start = await page.middle("#divider");
    await page.drag(start, 200, 0);
    const view = await page.box("#compare");
    const moved = await page.middle("#divider");
    assert.ok(Math.abs(moved.x - start.x - 200) < 1.5, "the divider follows the mouse");
    const value = async () => Number(await page.attribute("#divider", "aria-valuenow"));
    const before = await value();
    assert.ok(Math.abs(before - 100 * (moved.x - view.x) / view.width) <= 1, "the divider's value is its position");
    await page.focus("#divider");
    await page.press("ArrowLeft");
    assert.equal(await value(), before - 1, "an arrow moves the divider by a hundredth");
    await page.press("Home");
    assert.match(await page.attribute("#divider", "aria-valuetext"), /^noisy 0 %, denoised 100 %$/);
    for (let i = 0; i < 5; ++i) await page.press("ArrowRight", {shift: true});
    assert.equal(await value(), 50);
}

async function check_sides(page) {
    await page.choose("#right-kind", "reference");
    assert.equal(await page.text("#chip-right"), "reference");
    await page.click("#swap");
    assert.equal(await page.text("#chip-left"), "reference");
    await page.click(".pane:nth-child(2) .on-right");
    await page.click(".pane:nth-child(1) .on-left");
    assert.match(await page.text("#chip-left"), /^noisy\s*FLIP 0\.\d+$/, "a side carries the error of its pictures");
    assert.match(await page.text("#chip-right"), /^denoised\s*FLIP 0\.\d+$/);
}

async function check_zoom(page) {
    const level = async () => parseInt(await page.text("#zoom-level"));
    const fit = await level();
    const view = await page.box("#compare");
    // Away from the middle, which lies between two pixels and so may round to either.
    const point = {x: view.x + view.width * 0.3, y: view.y + view.height / 2 + 31};
    await page.move(point.x, point.y);
    await page.drawn();
    const before = await page.text("#pixel");
    for (let i = 0; i < 4; ++i) await page.wheel(-240);
    await page.drawn();
    assert.ok(await level() > 3 * fit, "the wheel zooms in");
    assert.equal(await page.text("#pixel"), before, "what is under the pointer stays there");
    await page.save("zoomed");
    const [pane, large] = await Promise.all([".pane:nth-child(1)", "#compare"].map(one => color_at(page, `${one} canvas`, 0.31, 0.47)));
    assert.deepEqual(pane, large, "a pane shows the part that the large view shows");
    await page.drag(point, 120, 40);
    await page.drawn();
    assert.equal(await page.text("#pixel"), before, "dragging takes the picture along");
    await page.press("0");
    await page.drawn();
    assert.equal(await level(), fit, "0 shows the whole picture again");
    await page.click("#zoom-one");
    await page.drawn();
    assert.equal(await level(), 100);
    await page.click("#zoom-fit");
}

async function check_frames(page) {
    assert.equal(await frame_of(page), "frame 0");
    await page.press(".");
    await until_frame(page, 1);
    assert.equal(await page.text(".pane:nth-child(3) .pane-name"), "reference");
    await page.press(",");
    await until_frame(page, 0);
    await page.fill("#frame-slider", "3");
    await until_frame(page, 3);
    await page.save("missing");
    await page.press(" ");
    await until_frame(page, 5);
    await page.press(" ");
    assert.equal(await page.attribute("#play", "aria-label"), "Play");
}

async function check_plot(page) {
    const frame_2 = await page.box("#plot .dot:nth-of-type(3)");
    await page.move(frame_2.x + 3, frame_2.y + 40);
    assert.match(await page.text("#readout"), /^frame 2\s+noisy 0\.\d+\s+denoised 0\.\d+$/);
    await page.press_mouse();
    await page.release_mouse();
    await until_frame(page, 2);
    await page.choose("#metric", "RMSE");
    assert.match(await page.text("#chip-left"), /RMSE/);
    await page.choose("#metric", "FLIP");
}

/// The page's elements that are wider than the place they have, so that something of them is cut off or must be scrolled to.
const cut_off = page => page.all("body, .card, .table-frame, .readout, .toolbar, .playback", elements =>
    elements.filter(one => one.scrollWidth > one.clientWidth + 1).map(one => `${one.className}: ${one.textContent.slice(0, 40)}`));

async function check_full_page(open) {
    const page = await shown(await open("full.html"));
    await page.save("full");
    for (const check of [check_divider, check_sides, check_zoom, check_frames, check_plot]) await check(page);
    assert.deepEqual(page.problems, []);
}

async function check_sizes(open) {
    for (const [width, height] of [[1920, 1080], [1400, 900], [1024, 768], [420, 900]])
        for (const name of ["full", "figures"]) {
            const page = await shown(await open(`${name}.html`, {width, height}));
            assert.deepEqual(await cut_off(page), [], `all of ${name} is seen at a width of ${width}`);
            await page.save_whole(`${name}_${width}`);
        }
}

async function check_small_screen(open) {
    const page = await shown(await open("full.html", {width: 420, touch: true, dark: true}));
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 420, `nothing sticks out sideways (${width})`);
    await page.save_whole("small");
    assert.deepEqual(page.problems, []);
}

async function check_figures(open) {
    const page = await shown(await open("figures.html"));
    assert.equal(await page.is_visible("#keys"), false, "no word of keys that move pictures");
    const [plot, facts] = [await page.box("#plot-card"), await page.box("#facts")];
    assert.ok(Math.abs(plot.width - facts.width) < 1, "without pictures the plot has their place");
    assert.match(await page.text("#readout"), /^surface\s+surface-clamp\s/, "names alone, until a frame is pointed at");
    const looks = () => page.all("#plot .series",
        lines => lines.map(one => getComputedStyle(one)).map(one => one.stroke + one.strokeDasharray));
    const before = await looks();
    await page.choose("#metric", "cut: RMSE");
    const after = await looks();
    assert.equal(new Set(after).size, 24, "no two lines look alike");
    assert.ok(before.every(one => after.includes(one)), "a method looks the same in every metric");
    const highest = await page.all(".facts td", cells => Math.max(...cells.map(one => one.clientHeight)));
    assert.ok(highest < 40, `a row is a line (${highest} pixels)`);
    await page.hover("#plot");
    assert.match(await page.text("#readout"), /^frame \d+\s+surface \d/);
    assert.deepEqual(page.problems, []);
}

async function check_lesser_pages(open) {
    const late = await shown(await open("late.html"));
    assert.equal(await frame_of(late), "frame 2", "the page opens at a frame that has a reference");

    const bare = await shown(await open("bare.html"));
    assert.equal(await bare.is_visible("#plot-card"), false);
    assert.equal(await bare.is_visible("#playback"), false);
    assert.equal(await bare.text("#chip-left"), "noisy");
    assert.equal((await color_at(bare, "#compare canvas", 0.3, 0.9))[3], 255);
    await bare.save_whole("bare");
    const empty = await shown(await open("empty.html"));
    assert.equal(await empty.text("h1"), "Nothing");
    assert.equal(await empty.is_visible("#stage"), false);
    assert.deepEqual([...bare.problems, ...empty.problems], []);
}

await with_pages(async open => {
    for (const check of [check_full_page, check_sizes, check_small_screen, check_figures, check_lesser_pages]) await check(open);
});
console.log("the report page works in Chromium");
