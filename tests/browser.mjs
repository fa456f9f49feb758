// What the tests that drive a page in Chromium share. Where no Chromium is installed they say so in one line and exit with 77, which CTest
// takes for skipped.
import {execFileSync} from "node:child_process";
import {existsSync, mkdirSync, mkdtempSync, rmSync, statSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {Chromium} from "./chromium.mjs";
import {Page} from "./page.mjs";

function find_chromium() {
    const usual = ["chromium", "chromium-headless-shell", "google-chrome", "chromium-browser"].map(name => `/usr/bin/${name}`);
    const found = (process.env.QUELL_CHROMIUM ? [process.env.QUELL_CHROMIUM] : usual).find(place => existsSync(place));
    if (found) return found;
    console.log("skipped: Chromium isn't installed (apt-get install chromium, or name it in QUELL_CHROMIUM)");
    return process.exit(77);
}

/// Lets the program write sample pages, or takes those of a folder, then calls check(open): open(name, options) opens one of them. A folder
/// for screenshots may be the second argument; page.save(name) and page.save_whole(name) then leave some there. `switches` are
/// Chromium's. `address` is that of a server on 127.0.0.1 which has the pages; without one they are opened as files.
export async function with_pages(check, switches = [], address = "") {
    const [program, screenshots] = process.argv.slice(2);
    const chromium_program = find_chromium();
    const folder = mkdtempSync(join(tmpdir(), "quell_browser_"));
    const are_there = statSync(program).isDirectory();
    const pages = are_there ? program : join(folder, "pages");
    let chromium = null;
    try {
        if (screenshots) mkdirSync(screenshots, {recursive: true});
        if (!are_there) {
            mkdirSync(pages);
            execFileSync(program, [pages]);
        }
        const more = address ? ["--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"] : [];
        chromium = new Chromium(chromium_program, join(folder, "profile"), [...switches, ...more]);
        await check(async (name, options) => {
            const page = await Page.open(chromium, address ? address + name : pathToFileURL(join(pages, name)).href, options);
            const save = async (picture, task) => {
                if (screenshots) writeFileSync(join(screenshots, `${picture}.png`), await task(), "base64");
            };
            page.save = picture => save(picture, () => page.picture());
            page.save_whole = picture => save(picture, () => page.whole_picture());
            return page;
        });
    } finally {
        await chromium?.close();
        rmSync(folder, {recursive: true, maxRetries: 5});
    }
}
