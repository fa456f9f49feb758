// Drives the report page in Chromium: node browser.mjs PATH_OF_report_sample [FOLDER_FOR_SCREENSHOTS]
// Needs playwright-core, found beside this file, through NODE_PATH, or in the folder named by QUELL_PLAYWRIGHT; where it or Chromium
// is missing, says so in one line and exits with 77, which CTest takes for skipped.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, rmSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

function skip(reason) {
    console.log(`skipped: ${reason}`);
    process.exit(77);
}

function find_playwright() {
    const places = [import.meta.url];
    if (process.env.QUELL_PLAYWRIGHT) places.unshift(pathToFileURL(join(process.env.QUELL_PLAYWRIGHT, "package.json")));
    for (const place of places) {
        try {
            return createRequire(place)("playwright-core");
        } catch { /* the next place may have it */ }
    }
    return skip("playwright-core isn't installed (npm install playwright-core; name its folder in QUELL_PLAYWRIGHT)");
}

function find_chromium() {
    const places = [process.env.QUELL_CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
    return places.find(place => place && existsSync(place)) ?? skip("Chromium isn't installed (name it in QUELL_CHROMIUM)");
}

const {chromium} = find_playwright();
const executablePath = find_chromium();
const folder = mkdtempSync(join(tmpdir(), "quell_browser_"));
const screenshots = process.argv[3];

const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
              "--disable-component-update", "--disable-sync"];

/// Opens one of the sample pages; its problems collect whatever the console or the network complains about.
async function open_page(browser, name, options = {}) {
    const context = await browser.newContext({viewport: {width: 1400, height: 900}, ...options});
    const page = await context.newPage();
    const problems = [];
    page.on("pageerror", error => problems.push(`error: ${error.message}`));
    page.on("console", message => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
    page.on("request", request => { if (!/^(file|data):/.test(request.url())) problems.push(`request: ${request.url()}`); });
    await page.goto(pathToFileURL(join(folder, name)).href);
    await page.waitForFunction(() => document.querySelector("#stage").hidden || document.querySelector("#frame-label b"));
    await drawn(page);
    return {page, problems};
}

/// Waits until what was done so far is on the screen: the page draws before the next refresh.
function drawn(page) {
    return page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

async function picture_of_page(page, name) {
    if (screenshots) await page.screenshot({path: join(screenshots, `${name}.png`)});
}

async function middle_of(page, selector) {
    const box = await page.locator(selector).boundingBox();
    return {x: box.x + box.width / 2, y: box.y + box.height / 2, width: box.width, left: box.x};
}

const text_of = (page, selector) => page.locator(selector).innerText();
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

async function check_all() {
    execFileSync(process.argv[2], [folder]);
    const browser = await chromium.launch({executablePath, args});
    try {
        await check_full_page(browser);
        await check_small_screen(browser);
        await check_lesser_pages(browser);
    } finally {
        await browser.close();
    }
}

try {
    await check_all();
    console.log("the report page works in Chromium");
} finally {
    rmSync(folder, {recursive: true});
}
