// Chromium without a window, driven over two pipes. What it is told and what it says is the DevTools protocol: JSON, a zero byte after each
// message. So the tests need a Chromium and node, and no package of npm's.
import {spawn} from "node:child_process";

// As root in a container Chromium starts only without its sandbox; the tests open no pages but their own.
const switches = ["--headless", "--remote-debugging-pipe", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--no-first-run",
                  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
                  "--force-color-profile=srgb", "--host-resolver-rules=MAP * ~NOTFOUND"];

export class Chromium {
    /// Starts the program; what it keeps about its user goes into the folder `profile`. `more` are switches for it.
    constructor(program, profile, more = []) {
        this.asked = new Map(); // what waits for an answer, by the message's number
        this.listeners = new Map(); // who hears a session's events
        this.last_number = 0;
        this.complaints = "";
        this.half_message = [];
        this.process = spawn(program, [...switches, ...more, `--user-data-dir=${profile}`], {stdio: ["ignore", "ignore", "pipe", "pipe", "pipe"]});
        this.process.stderr.on("data", text => { this.complaints += text; });
        this.process.stdio[3].on("error", () => {}); // the end of the process says it better
        this.process.stdio[4].on("data", bytes => this.take(bytes));
        this.ended = new Promise(resolve => {
            this.process.on("error", error => resolve(error.message));
            this.process.on("close", code => resolve(`ended with ${code}`));
        });
        this.ended.then(how => this.fail_all(`Chromium ${how}\n${this.complaints}`));
    }

    fail_all(message) {
        for (const {reject} of this.asked.values()) reject(new Error(message));
        this.asked.clear();
    }

    take(bytes) {
        for (let end; (end = bytes.indexOf(0)) >= 0; bytes = bytes.subarray(end + 1)) {
            this.answer(JSON.parse(Buffer.concat([...this.half_message, bytes.subarray(0, end)]).toString()));
            this.half_message = [];
        }
        this.half_message.push(bytes);
    }

    answer(message) {
        const asked = this.asked.get(message.id);
        this.asked.delete(message.id);
        if (!asked) this.listeners.get(message.sessionId)?.(message);
        else if (message.error) asked.reject(new Error(`${asked.method}: ${message.error.message}`));
        else asked.resolve(message.result);
    }

    /// Resolves to the command's result. Without a session, the command is the browser's own.
    send(method, params = {}, sessionId = undefined) {
        const id = ++this.last_number;
        const answered = new Promise((resolve, reject) => this.asked.set(id, {method, resolve, reject}));
        this.process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
        return answered;
    }

    /// A tab of its own, which shares nothing with others; resolves to its session.
    async open_tab(listener) {
        const {browserContextId} = await this.send("Target.createBrowserContext");
        const {targetId} = await this.send("Target.createTarget", {url: "about:blank", browserContextId});
        const {sessionId} = await this.send("Target.attachToTarget", {targetId, flatten: true});
        this.listeners.set(sessionId, listener);
        return sessionId;
    }

    async close() {
        this.send("Browser.close").catch(() => {});
        await this.ended;
    }
}
