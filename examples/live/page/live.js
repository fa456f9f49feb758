// The live page: asks the WebAssembly program for frames, and shows them. What the reader moves is `choice`, the camera and the view.
"use strict";

const by_id = id => document.getElementById(id);
const noisy = 0, denoised = 1, reference = 2; // pictures, by the program's numbers
const exposures = [1.9, 0.85]; // of each scene
const traced_only = -1; // a preset's number
const channels = ["radiance", "albedo", "normal", "depth", "motion"]; // by the program's numbers
const full_error = .25; // has the last colour of the map

/// Runs a script that lies beside the page. Pages that are files get at what lies there in no other way.
const load_script = name => new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = name;
    script.onload = resolve;
    script.onerror = () => reject(new Error(`${name} is not there`));
    document.head.append(script);
});

/// The program: its functions, and what its memory holds.
class Program {
    /// The one of several threads where the page may have memory that threads share: its server must allow that.
    static async load() {
        const most = window.crossOriginIsolated ? Math.min(16, navigator.hardwareConcurrency) : 1;
        return most > 1 && await Program.of_threads(most).catch(() => null) || Program.of_one_thread();
    }

    constructor(call, memory, threads) {
        this.call = call;
        this.memory = memory;
        this.most_threads = threads;
    }

    static async of_one_thread() {
        await load_script("live_wasm.js");
        const bytes = Uint8Array.from(atob(live_wasm), letter => letter.charCodeAt(0));
        const fail = name => () => { throw new Error(`the program stopped (${name})`); };
        const {instance: {exports}} = await WebAssembly.instantiate(bytes, {
            page: {milliseconds: () => performance.now()},
            env: {emscripten_notify_memory_growth: () => {}},
            wasi_snapshot_preview1: new Proxy({}, {get: (_, name) => fail(name)}),
        });
        exports._initialize();
        return new Program(exports, exports.memory, 1);
    }

    static async of_threads(count) {
        await load_script("live_threads.js");
        const {asm, wasmMemory, PThread} = await live_threads({helpers: count - 1});
        asm.use_threads(count);
        const program = new Program(asm, wasmMemory, count);
        program.workers = PThread.runningWorkers;
        return program;
    }

    resize(width, height) {
        this.width = width;
        this.height = height;
        this.call.resize(width, height);
    }

    /// Pixels at a place of the memory, which may have grown since. They are copied: a canvas takes none that threads share.
    pixels(place) { return new ImageData(new Uint8ClampedArray(this.memory.buffer, place, 4 * this.width * this.height).slice(), this.width, this.height); }

    text(place) {
        const bytes = new Uint8Array(this.memory.buffer, place);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    /// Floats of all components that go to a device or come back; `count` of them.
    planes(count) {
        const place = this.call.planes(); // first: the memory may grow by it
        return new Float32Array(this.memory.buffer, place, count);
    }

    passes() {
        return Array.from({length: this.call.pass_count()}, (_, i) => ({name: this.text(this.call.pass_name(i)), ms: this.call.pass_milliseconds(i)}));
    }
}

/// A number that follows what is measured, and settles.
class Mean {
    constructor() { this.clear(); }
    clear() { this.value = NaN; }
    add(value) { this.value = Number.isNaN(this.value) ? value : this.value + .12 * (value - this.value); }
    text(digits = 1) { return Number.isNaN(this.value) ? "-" : this.value.toFixed(digits); }
}

/// Everything that the reader can move.
class Choice {
    constructor(changed) {
        this.held = false;
        this.camera = {yaw: 0, pitch: 0, distance: 3};
        this.changed = changed;
        const controls = by_id("controls");
        controls.addEventListener("submit", event => event.preventDefault());
        controls.addEventListener("input", event => this.read(event.target.id));
        by_id("hold").addEventListener("click", () => this.hold(!this.held));
        by_id("home").addEventListener("click", () => this.changed("home"));
        this.read();
    }

    read(id = "") {
        const number = name => Number(by_id(name).value);
        this.scene = number("scene");
        this.is_on_gpu = by_id("preset").value === "gpu";
        this.preset = this.is_on_gpu ? traced_only : number("preset");
        this.samples = number("samples");
        this.light = number("light") / 100;
        this.motion = number("motion") / 10;
        this.threads = number("threads");
        this.is_smooth = by_id("smooth").checked;
        this.view = document.querySelector("[name=view]:checked").value;
        // One border pushes the other.
        if (id === "a") by_id("b").value = Math.max(number("b"), number("a"));
        if (id === "b") by_id("a").value = Math.min(number("a"), number("b"));
        this.borders = [number("a") / 100, number("b") / 100];
        by_id("samples-value").value = this.samples;
        by_id("light-value").value = `${number("light")} %`;
        by_id("motion-value").value = this.motion.toFixed(1);
        by_id("threads-value").value = this.threads;
        by_id("borders").hidden = this.view !== "split";
        if (["scene", "preset", "samples", "light", "motion", "smooth", "size"].includes(id)) this.hold(false);
        this.changed(id);
    }

    /// In percent of the width.
    set_border(id, value) {
        by_id(id).value = Math.round(Math.min(100, Math.max(0, value)));
        this.read(id);
    }

    hold(held) {
        if (held === this.held) return;
        this.held = held;
        by_id("hold").setAttribute("aria-pressed", held);
        by_id("hold").textContent = held ? "Go on" : "Hold frame";
        // The reference is worth a look while it converges: then it gets room, and gives it back.
        if (held && this.borders[1] > .95) {
            this.gave_room = true;
            this.set_border("b", 67);
        } else if (!held && this.gave_room) {
            this.gave_room = false;
            this.set_border("b", 100);
        }
        by_id("screen").classList.toggle("held", held);
        this.changed("hold");
    }

    turn(x, y) {
        this.hold(false);
        this.camera.yaw -= x;
        this.camera.pitch = Math.min(1.3, Math.max(-.22, this.camera.pitch + y));
    }

    move(factor) {
        this.hold(false);
        this.camera.distance = Math.min(14, Math.max(.8, this.camera.distance * factor));
    }
}

/// What a mouse, fingers and keys do to the picture.
class Gestures {
    constructor(choice) {
        this.choice = choice;
        this.screen = by_id("screen");
        this.fingers = new Map(); // places, by the pointer's number
        this.border = "";
        this.screen.addEventListener("pointerdown", event => this.begin(event));
        this.screen.addEventListener("pointermove", event => this.follow(event));
        for (const end of ["pointerup", "pointercancel"]) this.screen.addEventListener(end, event => this.end(event));
        this.screen.addEventListener("wheel", event => {
            event.preventDefault();
            choice.move(Math.exp(.0012 * event.deltaY));
        }, {passive: false});
        this.screen.addEventListener("keydown", event => this.key(event));
    }

    begin(event) {
        this.screen.setPointerCapture(event.pointerId);
        this.fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        // Two fingers move the camera, wherever they are.
        this.border = this.fingers.size === 1 && event.target.classList.contains("border") ? event.target.id.slice(-1) : "";
        this.screen.classList.toggle("turning", !this.border);
    }

    spread() {
        const [one, other] = this.fingers.values();
        return Math.hypot(one.x - other.x, one.y - other.y);
    }

    follow(event) {
        const before = this.fingers.get(event.pointerId);
        if (!before) return;
        const now = {x: event.clientX, y: event.clientY};
        const {left, width, height} = this.screen.getBoundingClientRect();
        if (this.border) {
            this.choice.set_border(this.border, 100 * (now.x - left) / width);
        } else if (this.fingers.size === 1) {
            this.choice.turn(2.4 * (now.x - before.x) / width, 1.6 * (now.y - before.y) / height);
        } else {
            const spread = this.spread();
            this.fingers.set(event.pointerId, now);
            this.choice.move(spread / Math.max(1, this.spread()));
        }
        this.fingers.set(event.pointerId, now);
    }

    end(event) {
        this.fingers.delete(event.pointerId);
        if (this.fingers.size) return;
        this.border = "";
        this.screen.classList.remove("turning");
    }

    key(event) {
        const turns = {ArrowLeft: [-.08, 0], ArrowRight: [.08, 0], ArrowUp: [0, -.06], ArrowDown: [0, .06]}[event.key];
        const factor = {"+": .93, "=": .93, "-": 1.07}[event.key];
        if (turns) this.choice.turn(...turns);
        if (factor) this.choice.move(factor);
        if (turns || factor) event.preventDefault();
    }
}

/// Runs frames and draws them.
class Live {
    constructor(program) {
        this.program = program;
        this.gpu = null;
        this.is_waiting = false; // for the device
        this.canvas = by_id("canvas");
        this.context = this.canvas.getContext("2d", {alpha: false});
        this.means = {rate: new Mean(), trace: new Mean(), denoise: new Mean()};
        this.time = 0;
        this.last_frame = this.last_numbers = 0;
        this.passes = new Map();
        this.frames = 0;
        this.set_threads();
        this.choice = new Choice(what => this.changed(what));
        new Gestures(this.choice);
        this.set_size();
        this.set_camera();
        by_id("message").hidden = true;
        requestAnimationFrame(now => this.step(now));
    }

    set_threads() {
        const {most_threads} = this.program;
        by_id("threads").max = by_id("threads").value = most_threads;
        by_id("threads-choice").hidden = most_threads === 1;
        by_id("cores").textContent = most_threads === 1 ? "one core" : `${most_threads} threads`;
    }

    set_size() {
        const [width, height] = by_id("size").value.split("x").map(Number);
        this.canvas.width = width;
        this.canvas.height = height;
        this.program.resize(width, height);
        this.gpu?.resize(width, height);
    }

    /// The device takes a while to compile; the page runs meanwhile.
    take_gpu(gpu) {
        if (!gpu) return;
        this.gpu = gpu;
        gpu.resize(this.program.width, this.program.height);
        by_id("preset").add(new Option("general, WebGPU", "gpu"));
    }

    set_camera() {
        const [yaw, pitch, distance] = [0, 1, 2].map(which => this.program.call.first_view(this.choice.scene, which));
        this.choice.camera = {yaw, pitch, distance};
    }

    changed(what) {
        if (!this.choice) return; // it is being made
        if (what === "size") this.set_size();
        if (what === "threads") this.program.call.use_threads(this.choice.threads);
        if (what === "scene" || what === "home") this.set_camera();
        if (what === "home") this.choice.hold(false);
        if (what === "hold" && this.choice.held) this.program.call.clear_reference();
        if (what === "preset" || what === "smooth" || what === "threads") this.passes.clear();
        if (what === "preset" || what === "scene") this.gpu?.forget();
        if (["size", "samples", "preset", "smooth", "scene", "threads"].includes(what)) for (const mean of Object.values(this.means)) mean.clear();
        if (this.choice.held && this.program.call.reference_samples() > 0) this.draw();
    }

    step(now) {
        requestAnimationFrame(next => this.step(next));
        if (this.is_waiting) return;
        if (this.choice.held) this.refine();
        else this.advance(now);
        if (!this.is_waiting) this.show(now);
    }

    show(now) {
        this.draw();
        this.milliseconds_to_first ??= performance.now();
        if (now - this.last_numbers < 250) return;
        this.last_numbers = now;
        this.write_numbers();
    }

    /// Denoises what was traced by the device; false where the size has changed meanwhile.
    async run_gpu() {
        const {gpu, program, program: {call}} = this, {buffers} = gpu;
        for (const input of gpu.plan.inputs) {
            call.take_channel(channels.indexOf(input.channel), input.component);
            gpu.set_input(input, program.planes(program.width * program.height));
        }
        const picture = await gpu.run(gpu.block([0, 1, 2, 3].map(call.jitter))).catch(error => {
            if (buffers === gpu.buffers) throw error;
        });
        if (buffers !== gpu.buffers) return false;
        program.planes(picture.length).set(picture);
        call.put_denoised();
        return true;
    }

    /// The device's part of a frame. What it takes includes the ways there and back.
    async denoise_on_gpu(now) {
        this.is_waiting = true;
        const start = performance.now(), is_done = await this.run_gpu();
        this.is_waiting = false;
        if (!is_done) return;
        this.means.denoise.add(performance.now() - start);
        this.note_passes(this.gpu.times);
        this.show(now);
    }

    advance(now) {
        const {scene, preset, samples, light, motion, camera, is_smooth} = this.choice;
        const passed = (now - this.last_frame) / 1000;
        this.last_frame = now;
        this.time += Math.min(.1, passed) * motion;
        this.program.call.advance(scene, preset, samples, this.time, light, camera.yaw, camera.pitch, camera.distance, is_smooth);
        ++this.frames;
        if (passed < 1) this.means.rate.add(passed);
        this.means.trace.add(this.program.call.trace_milliseconds());
        if (this.choice.is_on_gpu) {
            this.denoise_on_gpu(now).catch(error => this.lose_gpu(error));
            return;
        }
        this.means.denoise.add(this.program.call.denoise_milliseconds());
        this.note_passes(this.program.passes());
    }

    note_passes(times) {
        for (const {name, ms} of times) {
            if (!this.passes.has(name)) this.passes.set(name, new Mean());
            this.passes.get(name).add(ms);
        }
    }

    /// Goes on without the device.
    lose_gpu(error) {
        this.is_waiting = false;
        this.gpu = null;
        by_id("preset").value = "0";
        by_id("preset").querySelector("[value=gpu]").remove();
        this.choice.read("preset");
        by_id("caption").textContent = `WebGPU has stopped: ${error.message}`;
    }

    /// As many samples as fit into a refresh of the screen or two.
    refine() {
        const end = performance.now() + 30;
        if (this.program.call.reference_samples() < 4096)
            do this.program.call.refine(1); while (performance.now() < end);
    }

    draw() {
        const {view, borders, scene} = this.choice;
        const {width, height, call} = this.program;
        const put = (which, from, to) => {
            if (to > from) this.context.putImageData(this.program.pixels(call.picture(which, exposures[scene], from, to)), 0, 0, from, 0, to - from, height);
        };
        if (view === "error") {
            this.context.putImageData(this.program.pixels(call.error_map(denoised, exposures[scene], full_error)), 0, 0);
        } else if (view === "split") {
            const [a, b] = borders.map(border => Math.round(border * width));
            put(noisy, 0, a);
            put(denoised, a, b);
            put(reference, b, width);
        } else {
            put(denoised, 0, width);
        }
        this.place_labels();
    }

    place_labels() {
        const {view, borders: [a, b], held} = this.choice;
        const split = view === "split", count = this.program.call.reference_samples();
        const place = (id, shown, at) => {
            by_id(id).hidden = !shown;
            by_id(id).style.left = `${100 * at}%`;
        };
        place("border-a", split, a);
        place("border-b", split, b);
        const label = (id, from, to, text) => {
            place(id, split && to - from > .08, from);
            by_id(id).style.marginLeft = ".5rem";
            by_id(id).textContent = text;
        };
        label("label-noisy", 0, a, "noisy");
        label("label-denoised", a, b, by_id("preset").selectedOptions[0].text);
        label("label-reference", b, 1, `reference, ${count} ${count === 1 ? "sample" : "samples"}`);
        by_id("scale").hidden = view !== "error";
        by_id("scale-end").textContent = full_error;
        by_id("caption").textContent = held ? "Held: noisy and denoised stay as they were in motion, the reference converges." :
            "Drag to turn the camera; wheel or two fingers move it. Hold the frame to compare it with a converged one.";
    }

    write_numbers() {
        const {call} = this.program, exposure = exposures[this.choice.scene], count = call.reference_samples();
        by_id("rate").textContent = Number.isNaN(this.means.rate.value) ? "-" : (1 / this.means.rate.value).toFixed(0);
        by_id("trace").textContent = `${this.means.trace.text()} ms`;
        by_id("denoise").textContent = `${this.means.denoise.text()} ms`;
        by_id("reference").textContent = `${count} ${count === 1 ? "sample" : "samples"}`;
        // Of few samples the reference is as noisy as what it would judge.
        const is_good = count >= 64;
        by_id("error-noisy").textContent = is_good ? call.rmse(noisy, exposure).toFixed(3) : "-";
        by_id("error-denoised").textContent = is_good ? call.rmse(denoised, exposure).toFixed(3) : "-";
        by_id("passes").replaceChildren(...[...this.passes].map(([name, mean]) => {
            const row = document.createElement("tr");
            for (const text of [name, mean.text(2)]) row.insertCell().textContent = text;
            return row;
        }));
    }
}

async function start() {
    window.live = new Live(await Program.load());
    live.gpu_ready = GpuDenoiser.make(live_shaders).catch(() => null).then(gpu => live.take_gpu(gpu));
}

start().catch(error => {
    by_id("message").textContent = error instanceof WebAssembly.CompileError ?
        "This browser can't run it: it needs WebAssembly with SIMD, as Chrome 91, Firefox 89 and Safari 16.4 have it." : `It doesn't run: ${error.message}`;
});
