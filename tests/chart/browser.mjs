// Drives the page of quell-chart in Chromium, on made-up rows: node browser.mjs PATH_OF_chart_sample [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {with_pages} from "../browser.mjs";

const panel = scene => `.panel:has([aria-label*=" on ${scene},"])`;
const point = (scene, method) => `${panel(scene)} [data-method="${method}"]`;
const panels = page => page.all(".panel h2", elements => elements.map(one => one.innerText));
const on_front = (page, scene) => page.all(`${panel(scene)} .point.on-front`,
    points => points.map(one => [one.cx.baseVal.value, one.dataset.method]).sort((a, b) => a[0] - b[0]).map(one => one[1]));
const height_of = async (page, selector) => Number(await page.attribute(selector, "cy"));

async function check_panels(page) {
    assert.deepEqual(await panels(page), ["fence, shadow", "temple, glossy"]);
    assert.deepEqual(await on_front(page, "fence"), ["none", "surface", "svgf", "other"]);
    assert.equal((await page.attribute(`${panel("fence")} .front`, "d")).match(/[ML]/g).length, 4);
    const x = async method => Number(await page.attribute(point("fence", method), "cx"));
    const [a, b, c] = [await x("none"), await x("surface"), await x("svgf")];
    assert.ok(Math.abs((c - a) / (b - a) - Math.log(15 / 0.2) / Math.log(1.5 / 0.2)) < 1e-3, "time is logarithmic");
    assert.ok(await height_of(page, point("fence", "svgf")) > await height_of(page, point("fence", "none")), "less error is lower");
    const labels = await page.all(`${panel("fence")} .label`, elements => elements.map(one => one.textContent));
    assert.equal(labels.filter(one => one === "svgf").length, 1, "points on the front have their names");
    const crossed = await page.on(panel("fence"), element => {
        const line = element.querySelector(".front");
        const places = Array.from({length: 500}, (_, i) => line.getPointAtLength(line.getTotalLength() * i / 499));
        const is_in = (at, {x, y, width, height}) => at.x > x && at.x < x + width && at.y > y + 2 && at.y < y + height - 2;
        const is_crossed = label => places.some(one => is_in(one, label.getBBox()));
        return [...element.querySelectorAll(".label")].filter(is_crossed).map(one => one.textContent);
    });
    assert.deepEqual(crossed, [], "the front crosses no name");
}

async function check_tooltip(page) {
    await page.hover(point("temple", "svgf"));
    const tooltip = await page.text("#tooltip");
    assert.match(tooltip, /^svgf on temple, glossy/);
    assert.match(tooltip, /ms_per_frame\s+15\b/);
    assert.match(tooltip, /rmse\s+0\.018\b/);
    assert.match(tooltip, /bytes_per_pixel\s+150\b/);
    await page.hover(point("temple", "other"));
    assert.match(await page.text("#tooltip"), /flicker\s+–/, "what isn't known is a dash");
    await page.save("tooltip");
    await page.hover("h1");
    assert.equal(await page.is_visible("#tooltip"), false);
}

/// The red of a picture's middle as it is on the screen, once the picture is there: a page may not read its files' pixels.
async function color_of(page, selector) {
    await page.until(one => document.querySelector(one).complete && document.querySelector(one).naturalWidth > 0, selector);
    await page.drawn();
    const {x, y} = await page.middle(selector);
    const top = await page.evaluate(() => window.scrollY);
    const picture = await page.picture({x: Math.floor(x), y: Math.floor(y + top), width: 1, height: 1});
    return page.evaluate(async bytes => {
        const image = await createImageBitmap(new Blob([Uint8Array.from(atob(bytes), one => one.charCodeAt(0))]));
        const canvas = document.createElement("canvas").getContext("2d");
        canvas.drawImage(image, 0, 0);
        return canvas.getImageData(0, 0, 1, 1).data[0];
    }, picture);
}

async function check_pictures(page) {
    await page.click(point("fence", "svgf"));
    assert.equal(await page.text("#picked-name"), "svgf");
    const [first, reference] = [await color_of(page, "#picked-picture"), await color_of(page, "#reference-picture")];
    assert.ok(Math.abs(first - 0.15 * 255) < 3, `the fourth row's picture (${first})`);
    assert.ok(reference > 250, `the reference beside it (${reference})`);
    await page.focus(point("temple", "none"));
    assert.match(await page.text("#picked-case"), /^temple, glossy/);
    assert.ok(Math.abs(await color_of(page, "#picked-picture") - 0.3 * 255) < 3, "the keyboard reaches the pictures too");
    assert.match(await page.attribute(point("fence", "none"), "class"), /\bsame\b/, "the method is marked in other panels");
}

async function check_measures(page) {
    await page.choose("#measure", "ssim");
    assert.match(await page.text("#direction"), /higher is better/);
    assert.ok(await height_of(page, point("fence", "svgf")) < await height_of(page, point("fence", "none")), "more similarity is higher");
    assert.deepEqual(await on_front(page, "fence"), ["none", "surface", "svgf", "other"]);
    await page.choose("#measure", "flicker");
    assert.deepEqual(await on_front(page, "fence"), ["none"], "the front is that of the measure");
    assert.equal(await page.count(point("fence", "other")), 0, "no point where nothing is known");
    await page.choose("#measure", "bytes_per_pixel");
    assert.match(await page.text(`${panel("fence")} svg`), /bytes_per_pixel/);
    await page.choose("#measure", "rmse");
    const middle = async () => (await height_of(page, point("fence", "svgf"))) - (await height_of(page, point("fence", "surface")));
    const linear = await middle();
    await page.click("#log");
    assert.ok(await middle() > linear, "a logarithmic scale spreads what is small");
    await page.click("#log");
}

async function check_filters(page) {
    await page.choose("#scene", "temple");
    assert.deepEqual(await panels(page), ["temple, glossy"]);
    await page.save("single");
    await page.choose("#effect", "shadow");
    assert.deepEqual(await panels(page), []);
    await page.choose("#scene", "all");
    assert.deepEqual(await panels(page), ["fence, shadow"]);
    await page.choose("#effect", "all");
}

async function check_sizes(open) {
    for (const [width, height] of [[1920, 1080], [1400, 900], [420, 900]]) {
        const page = await open("index.html", {width, height, dark: width < 900});
        const needed = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(needed <= width, `nothing sticks out sideways (${needed} of ${width})`);
        await page.save_whole(`width_${width}`);
        assert.deepEqual(page.problems, []);
    }
}

await with_pages(async open => {
    const page = await open("index.html");
    await page.drawn();
    for (const check of [check_panels, check_tooltip, check_pictures, check_measures, check_filters]) await check(page);
    await check_sizes(open);
    const empty = await open("empty.html");
    assert.equal(await empty.is_visible("#picked"), false);
    assert.deepEqual([...page.problems, ...empty.problems], []);
});
console.log("the chart page works in Chromium");
