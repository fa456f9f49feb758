// A page in Chromium: what it shows, and what a user does to it. Elements are named by CSS selectors; the first that matches is meant.
import assert from "node:assert/strict";

const patience = 8000; // milliseconds

export class Page {
    /// Opens an address; `problems` collects whatever the console or the network complains about, and what is fetched from elsewhere.
    static async open(chromium, address, {width = 1400, height = 900, touch = false, dark = false} = {}) {
        const page = new Page();
        page.problems = [];
        page.origin = address.startsWith("file:") ? "file:" : new URL(address).origin;
        const session = await chromium.open_tab(event => page.hear(event));
        page.send = (method, params) => chromium.send(method, params, session);
        for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
        await page.set_size(width, height);
        await page.send("Emulation.setFocusEmulationEnabled", {enabled: true});
        await page.send("Emulation.setTouchEmulationEnabled", {enabled: touch});
        const features = [{name: "prefers-color-scheme", value: dark ? "dark" : "light"}];
        await page.send("Emulation.setEmulatedMedia", {features});
        const {errorText} = await page.send("Page.navigate", {url: address});
        assert.equal(errorText, undefined, address);
        await page.until(() => document.readyState === "complete");
        return page;
    }

    set_size(width, height) {
        return this.send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
    }

    hear({method, params}) {
        if (method === "Runtime.exceptionThrown") this.problems.push(params.exceptionDetails.exception?.description ?? "an error");
        if (method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(params.type))
            this.problems.push(params.args.map(part => part.value ?? part.description).join(" "));
        if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level)) this.problems.push(params.entry.text);
        if (method === "Network.requestWillBeSent" && !/^(data|blob):/.test(params.request.url) && !params.request.url.startsWith(this.origin))
            this.problems.push(`request: ${params.request.url}`);
    }

    /// Calls a function in the page; what goes in and comes out is JSON.
    async evaluate(task, ...inputs) {
        const expression = `(${task})(...${JSON.stringify(inputs)})`;
        const {result, exceptionDetails} = await this.send("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
        assert.equal(exceptionDetails, undefined, exceptionDetails?.exception?.description);
        return result.value;
    }

    /// Calls task(element, ...inputs) in the page.
    on(selector, task, ...inputs) {
        const find = `(selector, ...inputs) => {
            const element = document.querySelector(selector);
            if (!element) throw new Error("no element is " + selector);
            return (${task})(element, ...inputs);
        }`;
        return this.evaluate(find, selector, ...inputs);
    }

    /// Calls task(elements) in the page with all that match.
    all(selector, task) { return this.evaluate(`selector => (${task})([...document.querySelectorAll(selector)])`, selector); }

    async until(task, ...inputs) {
        const end = Date.now() + patience;
        while (!await this.evaluate(task, ...inputs)) {
            assert.ok(Date.now() < end, `waited in vain for ${task} of ${inputs}; ${this.problems}`);
            await new Promise(resolve => setTimeout(resolve, 20));
        }
    }

    /// Waits until what was done so far is on the screen: pages draw before the next refresh.
    drawn() { return this.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() => resolve())))); }

    text(selector) { return this.on(selector, element => (element.innerText ?? element.textContent).trim()); }
    attribute(selector, name) { return this.on(selector, (element, one) => element.getAttribute(one), name); }
    count(selector) { return this.all(selector, elements => elements.length); }
    is_visible(selector) { return this.on(selector, element => element.checkVisibility() && element.getClientRects().length > 0); }

    /// Where the element is on the screen, scrolled to where that is needed.
    box(selector) {
        return this.on(selector, element => {
            element.scrollIntoView({block: "nearest", inline: "nearest"});
            const {x, y, width, height} = element.getBoundingClientRect();
            return {x, y, width, height};
        });
    }

    async middle(selector) {
        const {x, y, width, height} = await this.box(selector);
        return {x: x + width / 2, y: y + height / 2};
    }

    mouse(type, more) { return this.send("Input.dispatchMouseEvent", {type, ...this.pointer, ...more}); }

    async move(x, y) {
        this.pointer = {x, y};
        await this.mouse("mouseMoved", this.pressed ? {button: "left", buttons: 1} : {});
    }

    async press_mouse() {
        this.pressed = true;
        await this.mouse("mousePressed", {button: "left", buttons: 1, clickCount: 1});
    }

    async release_mouse() {
        this.pressed = false;
        await this.mouse("mouseReleased", {button: "left", buttons: 0, clickCount: 1});
    }

    async drag(from, x, y) {
        await this.move(from.x, from.y);
        await this.press_mouse();
        for (let i = 1; i <= 4; ++i) await this.move(from.x + x * i / 4, from.y + y * i / 4);
        await this.release_mouse();
    }

    wheel(deltaY) { return this.mouse("mouseWheel", {deltaX: 0, deltaY}); }

    /// Points at the middle of an element, which must lie free there.
    async hover(selector) {
        const {x, y} = await this.middle(selector);
        const is_free = await this.on(selector, (element, at) => element.contains(document.elementFromPoint(at.x, at.y)), {x, y});
        assert.ok(is_free, `the mouse can't reach ${selector} at ${x}, ${y}`);
        await this.move(x, y);
    }

    async click(selector) {
        await this.hover(selector);
        await this.press_mouse();
        await this.release_mouse();
    }

    /// Presses a key by its name in KeyboardEvent.key.
    async press(key, {shift = false} = {}) {
        const event = {key, modifiers: shift ? 8 : 0};
        await this.send("Input.dispatchKeyEvent", {type: "keyDown", text: key.length === 1 ? key : undefined, ...event});
        await this.send("Input.dispatchKeyEvent", {type: "keyUp", ...event});
    }

    focus(selector) { return this.on(selector, element => element.focus()); }

    /// Gives a field its value, as a user's choice does.
    fill(selector, value) {
        return this.on(selector, (element, wanted) => {
            element.focus();
            element.value = wanted;
            if (element.value !== wanted) throw new Error(`${element.id} can't be ${wanted}`);
            for (const name of ["input", "change"]) element.dispatchEvent(new Event(name, {bubbles: true}));
        }, value);
    }

    /// Chooses an option by what it reads.
    async choose(selector, text) {
        const value = await this.on(selector, (element, wanted) => [...element.options].find(one => one.text === wanted)?.value, text);
        await this.fill(selector, value);
        await this.on(selector, element => element.blur());
    }

    /// A part of the page, else what the screen shows of it, as PNG in base64.
    async picture(part = undefined, captureBeyondViewport = false) {
        const clip = part && {x: part.x, y: part.y, width: part.width, height: part.height, scale: 1};
        return (await this.send("Page.captureScreenshot", {format: "png", clip, captureBeyondViewport})).data;
    }

    /// The whole page, however high. What is under the mouse then changes, so this is for pages that nothing more is done to.
    async whole_picture() { return this.picture((await this.send("Page.getLayoutMetrics")).cssContentSize, true); }
}
