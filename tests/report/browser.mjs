// Drives the report page in Chromium: node browser.mjs PATH_OF_report_sample [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {join} from "node:path";
import {drawn, open_file, text_of, with_pages} from "../browser.mjs";

const screenshots = process.argv[3];
let folder = "";

/// Opens one of the sample pages.
async function open_page(browser, name, options = {}) {
    const opened = await open_file(browser, join(folder, name), options);
    await opened.page.waitForFunction(() => document.querySelector("#stage").hidden || document.querySelector("#frame-label b"));
    await drawn(opened.page);
    return opened;
}

async function picture_of_page(page, name) {
    if (screenshots) await page.screenshot({path: join(screenshots, `${name}.png`)});
}

async function middle_of(page, selector) {
    const box = await page.locator(selector).boundingBox();
    return {x: box.x + box.width / 2, y: box.y + box.height / 2, width: box.width, left: box.x};
}

const frame_of = page => text_of(page, "#frame-label b");
const until_frame = (page, number) => page.waitForFunction(
    wanted => document.querySelector("#frame-label b").textContent === `frame ${wanted}`, number, {timeout: 4000});
/// The colour that a canvas shows at a fraction of its size.
const color_at = (page, selector, x, y) => page.locator(selector).evaluate((canvas, [u, v]) => {
    const at = [Math.floor(canvas.width * u), Math.floor(canvas.height * v), 1, 1];
    return [...canvas.getContext("2d").getImageData(...at).data];
}, [x, y]);

async function check_divider(page) {
    const start = await middle_of(page, "#divider");
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    await page.mouse.move(start.x + 200, start.y, {steps: 4});
    await page.mouse.up();
    const view = await middle_of(page, "#compare");
    const moved = await middle_of(page, "#divider");
    assert.ok(Math.abs(moved.x - start.x - 200) < 1.5, "the divider follows the mouse");
    const divider = page.locator("#divider");
    const value = Number(await divider.getAttribute("aria-valuenow"));
    assert.ok(Math.abs(value - 100 * (moved.x - view.left) / view.width) <= 1, "the divider's value is its position");
    await divider.press("ArrowLeft");
    assert.equal(Number(await divider.getAttribute("aria-valuenow")), value - 1, "an arrow moves the divider by a hundredth");
    await divider.press("Home");
    assert.match(await divider.getAttribute("aria-valuetext"), /^noisy 0 %, denoised 100 %$/);
    for (let i = 0; i < 5; ++i) await divider.press("Shift+ArrowRight");
    assert.equal(await divider.getAttribute("aria-valuenow"), "50");
}

async function check_sides(page) {
    await page.selectOption("#right-kind", {label: "reference"});
    assert.equal(await text_of(page, "#chip-right"), "reference");
    await page.click("#swap");
    assert.equal(await text_of(page, "#chip-left"), "reference");
    await page.click(".pane:nth-child(2) .on-right");
    await page.click(".pane:nth-child(1) .on-left");
    assert.match(await text_of(page, "#chip-left"), /^noisy\s*FLIP 0\.\d+$/, "a side carries the error of its pictures");
    assert.match(await text_of(page, "#chip-right"), /^denoised\s*FLIP 0\.\d+$/);
}

async function check_zoom(page) {
    const level = async () => parseInt(await text_of(page, "#zoom-level"));
    const fit = await level();
    const view = await middle_of(page, "#compare");
    // Away from the middle, which lies between two pixels and so may round to either.
    const point = {x: view.left + view.width * 0.3, y: view.y + 31};
    await page.mouse.move(point.x, point.y);
    await drawn(page);
    const before = await text_of(page, "#pixel");
    for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -240);
    await drawn(page);
    assert.ok(await level() > 3 * fit, "the wheel zooms in");
    assert.equal(await text_of(page, "#pixel"), before, "what is under the pointer stays there");
    await picture_of_page(page, "zoomed");
    const [pane, large] = [await color_at(page, ".pane:nth-child(1) canvas", 0.31, 0.47), await color_at(page, "#compare canvas", 0.31, 0.47)];
    assert.deepEqual(pane, large, "a pane shows the part that the large view shows");
    await page.mouse.down();
    await page.mouse.move(point.x + 120, point.y + 40, {steps: 3});
    await page.mouse.up();
    await drawn(page);
    assert.equal(await text_of(page, "#pixel"), before, "dragging takes the picture along");
    await page.keyboard.press("0");
    await drawn(page);
    assert.equal(await level(), fit, "0 shows the whole picture again");
    await page.click("#zoom-one");
    await drawn(page);
    assert.equal(await level(), 100);
    await page.click("#zoom-fit");
}

async function check_frames(page) {
    assert.equal(await frame_of(page), "frame 0");
    await page.keyboard.press(".");
    await until_frame(page, 1);
    assert.equal(await text_of(page, ".pane:nth-child(3) .pane-name"), "reference");
    await page.keyboard.press(",");
    await until_frame(page, 0);
    await page.locator("#frame-slider").fill("3");
    await until_frame(page, 3);
    await picture_of_page(page, "missing");
    await page.keyboard.press("Space");
    await until_frame(page, 5);
    await page.keyboard.press("Space");
    assert.equal(await page.getAttribute("#play", "aria-label"), "Play");
}

async function check_plot(page) {
    const frame_2 = await page.locator("#plot .dot").nth(2).boundingBox();
    await page.mouse.move(frame_2.x + 3, frame_2.y + 40);
    assert.match(await text_of(page, "#readout"), /^frame 2\s+noisy 0\.\d+\s+denoised 0\.\d+$/);
    await page.mouse.click(frame_2.x + 3, frame_2.y + 40);
    await until_frame(page, 2);
    await page.selectOption("#metric", {label: "RMSE"});
    assert.match(await text_of(page, "#chip-left"), /RMSE/);
    await page.selectOption("#metric", {label: "FLIP"});
}

async function check_full_page(browser) {
    const {page, problems} = await open_page(browser, "full.html");
    await picture_of_page(page, "full");
    await check_divider(page);
    await check_sides(page);
    await check_zoom(page);
    await check_frames(page);
    await check_plot(page);
    assert.deepEqual(problems, []);
}

async function check_small_screen(browser) {
    const {page, problems} = await open_page(browser, "full.html", {viewport: {width: 420, height: 900}, hasTouch: true, colorScheme: "dark"});
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 420, `nothing sticks out sideways (${width})`);
    await picture_of_page(page, "small");
    assert.deepEqual(problems, []);
}

async function check_lesser_pages(browser) {
    const bare = await open_page(browser, "bare.html");
    assert.equal(await bare.page.isVisible("#plot-card"), false);
    assert.equal(await bare.page.isVisible("#playback"), false);
    assert.equal(await text_of(bare.page, "#chip-left"), "noisy");
    assert.equal((await color_at(bare.page, "#compare canvas", 0.3, 0.9))[3], 255);
    await picture_of_page(bare.page, "bare");
    const empty = await open_page(browser, "empty.html");
    assert.equal(await text_of(empty.page, "h1"), "Nothing");
    assert.equal(await empty.page.isVisible("#stage"), false);
    assert.deepEqual([...bare.problems, ...empty.problems], []);
}

await with_pages(process.argv[2], async (browser, pages) => {
    folder = pages;
    await check_full_page(browser);
    await check_small_screen(browser);
    await check_lesser_pages(browser);
});
console.log("the report page works in Chromium");
