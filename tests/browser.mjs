// What the tests that drive a page in Chromium share. They need playwright-core, found beside this file, through NODE_PATH, or in the folder
// named by QUELL_PLAYWRIGHT; where it or Chromium is missing, they say so in one line and exit with 77, which CTest takes for skipped.
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

const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
              "--disable-component-update", "--disable-sync"];

/// Lets the program write sample pages into a folder, then calls check(browser, folder).
export async function with_pages(program, check) {
    const {chromium} = find_playwright();
    const executablePath = find_chromium();
    const folder = mkdtempSync(join(tmpdir(), "quell_browser_"));
    try {
        execFileSync(program, [folder]);
        const browser = await chromium.launch({executablePath, args});
        try {
            await check(browser, folder);
        } finally {
            await browser.close();
        }
    } finally {
        rmSync(folder, {recursive: true});
    }
}

/// Opens a file; the page's problems collect whatever the console or the network complains about.
export async function open_file(browser, file, options = {}) {
    const context = await browser.newContext({viewport: {width: 1400, height: 900}, ...options});
    const page = await context.newPage();
    const problems = [];
    page.on("pageerror", error => problems.push(`error: ${error.message}`));
    page.on("console", message => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
    page.on("request", request => { if (!/^(file|data):/.test(request.url())) problems.push(`request: ${request.url()}`); });
    await page.goto(pathToFileURL(file).href);
    return {page, problems};
}

/// Waits until what was done so far is on the screen: pages draw before the next refresh.
export function drawn(page) {
    return page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

export const text_of = (page, selector) => page.locator(selector).innerText();
