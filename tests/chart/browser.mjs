// Drives the page of quell-chart in Chromium, on made-up rows: node browser.mjs PATH_OF_chart_sample [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {join} from "node:path";
import {drawn, open_file, text_of, with_pages} from "../browser.mjs";

const screenshots = process.argv[3];

async function picture_of_page(page, name) {
    if (screenshots) await page.screenshot({path: join(screenshots, `${name}.png`), fullPage: true});
}

const panel = scene => `.panel:has(h2:text-matches("^${scene},"))`;
const point = (scene, method) => `${panel(scene)} [data-method="${method}"]`;
const panels = page => page.locator(".panel h2").allInnerTexts();
const on_front = (page, scene) => page.locator(`${panel(scene)} .point.on-front`).evaluateAll(
    points => points.map(one => [one.cx.baseVal.value, one.dataset.method]).sort((a, b) => a[0] - b[0]).map(one => one[1]));
const height_of = async (page, selector) => Number(await page.locator(selector).getAttribute("cy"));

async function check_panels(page) {
    assert.deepEqual(await panels(page), ["fence, shadow", "temple, glossy"]);
    assert.deepEqual(await on_front(page, "fence"), ["none", "surface", "svgf/levels=1", "svgf/levels=3", "svgf", "other"]);
    assert.equal(await page.locator(`${panel("fence")} .front`).getAttribute("d").then(path => path.match(/[ML]/g).length), 6);
    const x = async method => Number(await page.locator(point("fence", method)).getAttribute("cx"));
    const [a, b, c] = [await x("none"), await x("surface"), await x("svgf")];
    assert.ok(Math.abs((c - a) / (b - a) - Math.log(15 / 0.2) / Math.log(1.5 / 0.2)) < 1e-3, "time is logarithmic");
    assert.ok(await height_of(page, point("fence", "svgf")) > await height_of(page, point("fence", "none")), "less error is lower");
    assert.equal(await page.locator(`${panel("fence")} .label`, {hasText: /^svgf$/}).count(), 1, "points on the front have their names");
}

async function check_tooltip(page) {
    await page.hover(point("temple", "svgf"));
    const tooltip = await text_of(page, "#tooltip");
    assert.match(tooltip, /^svgf on temple, glossy/);
    assert.match(tooltip, /ms_per_frame\s+15\b/);
    assert.match(tooltip, /rmse\s+0\.018\b/);
    assert.match(tooltip, /bytes_per_pixel\s+150\b/);
    await page.hover(point("temple", "other"));
    assert.match(await text_of(page, "#tooltip"), /flicker\s+–/, "what isn't known is a dash");
    await picture_of_page(page, "tooltip");
    await page.hover("h1");
    assert.equal(await page.isVisible("#tooltip"), false);
}

/// The colour of a picture's first pixel, once it is there.
async function color_of(page, selector) {
    await page.waitForFunction(one => document.querySelector(one).complete && document.querySelector(one).naturalWidth > 0, selector);
    const box = await page.locator(selector).screenshot();
    return page.evaluate(async bytes => {
        const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
        const canvas = document.createElement("canvas").getContext("2d");
        canvas.drawImage(image, 0, 0);
        return canvas.getImageData(image.width >> 1, image.height >> 1, 1, 1).data[0];
    }, [...box]);
}

async function check_pictures(page) {
    await page.click(point("fence", "svgf"));
    assert.equal(await text_of(page, "#picked-name"), "svgf");
    const [first, reference] = [await color_of(page, "#picked-picture"), await color_of(page, "#reference-picture")];
    assert.ok(Math.abs(first - 0.15 * 255) < 3, `the fourth row's picture (${first})`);
    assert.ok(reference > 250, `the reference beside it (${reference})`);
    await page.focus(point("temple", "none"));
    assert.match(await text_of(page, "#picked-case"), /^temple, glossy/);
    assert.ok(Math.abs(await color_of(page, "#picked-picture") - 0.45 * 255) < 3, "the keyboard reaches the pictures too");
    assert.match(await page.getAttribute(point("fence", "none"), "class"), /\bsame\b/, "the method is marked in other panels");
}

async function check_measures(page) {
    await page.selectOption("#measure", "ssim");
    assert.match(await text_of(page, "#direction"), /higher is better/);
    assert.ok(await height_of(page, point("fence", "svgf")) < await height_of(page, point("fence", "none")), "more similarity is higher");
    assert.deepEqual(await on_front(page, "fence"), ["none", "surface", "svgf/levels=1", "svgf/levels=3", "svgf", "other"]);
    await page.selectOption("#measure", "flicker");
    assert.deepEqual(await on_front(page, "fence"), ["none"], "the front is that of the measure");
    assert.equal(await page.locator(point("fence", "other")).count(), 0, "no point where nothing is known");
    await page.selectOption("#measure", "bytes_per_pixel");
    assert.match(await page.locator(`${panel("fence")} svg`).textContent(), /bytes_per_pixel/);
    await page.selectOption("#measure", "rmse");
    const middle = async () => (await height_of(page, point("fence", "svgf"))) - (await height_of(page, point("fence", "surface")));
    const linear = await middle();
    await page.check("#log");
    assert.ok(await middle() > linear, "a logarithmic scale spreads what is small");
    await page.uncheck("#log");
}

async function check_filters(page) {
    await page.selectOption("#scene", "temple");
    assert.deepEqual(await panels(page), ["temple, glossy"]);
    await picture_of_page(page, "single");
    await page.selectOption("#effect", "shadow");
    assert.deepEqual(await panels(page), []);
    await page.selectOption("#scene", "all");
    assert.deepEqual(await panels(page), ["fence, shadow"]);
    await page.selectOption("#effect", "all");
    await page.selectOption("#variants", "none");
    assert.equal(await page.locator(".point.variant").count(), 0);
    assert.equal(await page.locator(".curve").count(), 0);
    await page.selectOption("#variants", "svgf/levels");
    assert.equal(await page.locator(".point.variant").count(), 6);
    const path = await page.locator(`${panel("fence")} .curve`).getAttribute("d");
    assert.equal(path.match(/[ML]/g).length, 4, "the curve goes through the preset too");
}

await with_pages(process.argv[2], async (browser, folder) => {
    const {page, problems} = await open_file(browser, join(folder, "index.html"));
    await drawn(page);
    await picture_of_page(page, "chart");
    for (const check of [check_panels, check_tooltip, check_pictures, check_measures, check_filters]) await check(page);
    const small = await open_file(browser, join(folder, "index.html"), {viewport: {width: 420, height: 900}, colorScheme: "dark"});
    const width = await small.page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 420, `nothing sticks out sideways (${width})`);
    await picture_of_page(small.page, "small");
    const empty = await open_file(browser, join(folder, "empty.html"));
    assert.equal(await empty.page.isVisible("#picked"), false);
    assert.deepEqual([...problems, ...small.problems, ...empty.problems], []);
});
console.log("the chart page works in Chromium");
