// Drives the site in Chromium: node browser.mjs FOLDER_OF_THE_SITE [FOLDER_FOR_SCREENSHOTS]
import assert from "node:assert/strict";
import {with_pages} from "../browser.mjs";

const pages = ["index.html", "docs/readme.html", "docs/figures.html", "docs/how_a_frame_runs.html", "interface/index.html",
               "interface/namespacequell_1_1presets.html"];

/// The least contrast of text on its ground (WCAG), over elements that have text of their own.
const least_contrast = () => {
    const light = part => (part /= 255) <= .04045 ? part / 12.92 : ((part + .055) / 1.055) ** 2.4;
    const luminance = ([r, g, b]) => .2126 * light(r) + .7152 * light(g) + .0722 * light(b);
    const parts = color => color.match(/[\d.]+/g).map(Number);
    const ground = element => {
        for (let e = element; e; e = e.parentElement) {
            const [r, g, b, alpha = 1] = parts(getComputedStyle(e).backgroundColor);
            if (alpha === 1) return [r, g, b];
        }
        return [255, 255, 255];
    };
    let least = {contrast: 21, text: ""};
    for (const element of document.querySelectorAll("body *")) {
        const own = [...element.childNodes].filter(node => node.nodeType === 3).map(node => node.data.trim()).join("");
        if (!own || !element.checkVisibility({checkOpacity: true}) || element.closest("svg, .tag, script, style")) continue;
        const [a, b] = [luminance(parts(getComputedStyle(element).color)), luminance(ground(element))];
        const contrast = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
        if (contrast < least.contrast) least = {contrast, text: own};
    }
    return least;
};

const two = [[380, false], [1280, true]], four = [...two, [380, true], [1280, false]];

await with_pages(async open => {
    // No page is wider than a telephone, loads anything from elsewhere, or has text that is hard to read, in the light and in the dark.
    for (const name of pages)
        for (const [width, dark] of name === "index.html" ? four : two) {
            const page = await open(name, {width, dark});
            const shown = `${name}, ${width} pixels${dark ? ", dark" : ""}`;
            assert.deepEqual(page.problems, [], shown);
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width, `${shown}: runs out of the page`);
            const {contrast, text} = await page.evaluate(least_contrast);
            assert.ok(contrast >= 4.5, `${shown}: '${text}' has a contrast of ${contrast}`);
            await page.save_whole(`${name.replace(/\W/g, "_")}_${width}${dark ? "_dark" : ""}`);
        }

    const front = await open("index.html", {width: 1280});
    const place = name => front.on(".first .stage", (stage, property) => parseFloat(getComputedStyle(stage).getPropertyValue(property)), name);
    if (await front.count(".first .stage")) {
        // The border goes along with the mouse, and pushes the other one.
        const {x, y, width, height} = await front.box(".first .stage");
        await front.move(x + .1 * width, y + height / 2);
        assert.ok(Math.abs(await place("--a") - 10) < 1, `${await place("--a")}`);
        await front.move(x + .9 * width, y + height / 2);
        assert.ok(Math.abs(await place("--a") - 90) < 1 && Math.abs(await place("--b") - 90) < 1, `${await place("--b")}`);
        await front.move(x + .9 * width, y - 30);
        // Keys move what has the focus.
        await front.focus(".first .handle");
        const before = await place("--a");
        for (let i = 0; i < 3; ++i) await front.press("ArrowLeft");
        assert.ok(Math.abs(await place("--a") - before + 3) < .1, `${before}, ${await place("--a")}`);
        await front.press("ArrowLeft", {shift: true});
        assert.ok(Math.abs(await place("--a") - before + 13) < .1);
        // All three pictures are there, of one size.
        const sizes = await front.all(".first img", images => images.map(image => `${image.naturalWidth}x${image.naturalHeight}`));
        assert.ok(sizes.length === 3 && new Set(sizes).size === 1 && sizes[0] !== "0x0", `${sizes}`);
    }

    // The guided choice leads through its questions to one result, and back.
    const visible_steps = () => front.all("[data-step]", steps => steps.filter(step => !step.hidden).map(step => step.dataset.step));
    assert.deepEqual(await visible_steps(), ["start"]);
    for (const to of ["light", "shutter", "general"]) await front.click(`[data-to='${to}']`);
    assert.deepEqual(await visible_steps(), ["start", "light", "shutter", "general"]);
    assert.match(await front.text("article[data-step=general]"), /presets::general\(radiance, Demodulate\{\}\).*It costs.*ms per frame/s);
    await front.click("[data-to=files]");
    assert.deepEqual(await visible_steps(), ["start", "files"]);
    assert.match(await front.text("article[data-step=files]"), /quell-denoise --in '/); // with the signs that a shell takes

    // Each of its results has room on a telephone.
    const narrow = await open("index.html", {width: 380, dark: true});
    for (const to of await narrow.all("input[data-to]", inputs => inputs.map(input => input.dataset.to))) {
        const way = [to];
        while (await narrow.on(`[data-to='${way[0]}']`, input => input.name) !== "start") way.unshift(await narrow.on(`[data-to='${way[0]}']`, input => input.name));
        for (const step of way) await narrow.on(`[data-to='${step}']`, input => input.click());
        assert.ok(await narrow.is_visible(`[data-step='${to}']`), to);
        assert.ok(await narrow.evaluate(() => document.documentElement.scrollWidth) <= 380, `the result ${to} runs out of the page`);
    }

    // One drawing of several is shown, and another one by choice.
    const drawn = () => front.all(".choice > div", parts => parts.filter(part => part.checkVisibility()).map(part => part.dataset.title));
    const [first] = await drawn();
    await front.on(".choice select", select => { select.selectedIndex = 1; select.dispatchEvent(new Event("change")); });
    assert.ok((await drawn()).length === 1 && (await drawn())[0] !== first);

    // The search finds pages, sections and names, by keys alone.
    await front.focus(".search input");
    for (const letter of "MotionConv") await front.press(letter);
    await front.until(() => document.querySelector(".search [aria-selected=true]")?.innerText.startsWith("MotionConvention"));
    const found = await front.attribute(".search [aria-selected=true] a", "href");
    assert.match(found, /^interface\/structquell_1_1MotionConvention\.html$/);

    // Commands keep their quotes and dashes.
    const programs = await open("docs/programs.html");
    assert.match(await programs.text("main"), /quell-denoise --in 'out\/room\/frame\.%04d\.exr' --out/);
    assert.deepEqual(front.problems, []);
});
console.log("the site works in Chromium");
