// Puts the page together from the report's data.

class Page {
    constructor(report) {
        this.report = report;
        this.viewport = new Viewport(report.size);
        this.compare = new CompareView(this.viewport, report.kinds, () => this.sides_changed());
        this.panes = new Panes(this.viewport, report.kinds, (side, kind) => this.compare.choose(side, kind));
        this.viewport.views.push(this.compare, this.panes);
        const store = new PictureStore(store_capacity(report.size, report.kinds.length));
        this.show = new FrameShow(report.frames, store, (frame, pictures) => this.frame_shown(frame, pictures));
        this.playback = new Playback(this.show);
        this.plot = new ErrorPlot(report, number => this.pick(number), () => this.label_sides());
        this.set_up_text();
        this.set_up_zoom();
        document.addEventListener("keydown", event => this.press_key(event));
        document.body.classList.toggle("one-kind", report.kinds.length === 1);
        if (!report.kinds.length || !report.frames.length) this.hide_pictures();
        else this.compare.sides_changed();
        // The first with all pictures, a reference among them; else the first.
        if (report.frames.length) this.show.go_to(report.frames.findIndex(frame => !frame.pictures.includes(null)));
    }

    set_up_text() {
        by_id("title").textContent = this.report.title;
        by_id("subtitle").textContent = this.report.subtitle;
        by_id("subtitle").hidden = !this.report.subtitle;
        show_facts(this.report);
    }

    hide_pictures() {
        for (const id of ["stage", "panes-card", "keys"]) by_id(id).hidden = true;
        document.body.classList.add("no-pictures");
    }

    set_up_zoom() {
        const {width, height} = this.report.size;
        document.documentElement.style.setProperty("--shape", String(height / width));
        by_id("zoom-in").addEventListener("click", () => this.zoom_by(1.5));
        by_id("zoom-out").addEventListener("click", () => this.zoom_by(1 / 1.5));
        by_id("zoom-fit").addEventListener("click", () => this.viewport.zoom_to(1));
        by_id("zoom-one").addEventListener("click", () => this.viewport.zoom_to(this.viewport.one_to_one_zoom()));
        const resized = new ResizeObserver(() => this.resize());
        for (const view of document.querySelectorAll(".view")) resized.observe(view);
        // Fingers scroll the page over a picture that is seen whole, and move the picture once it isn't.
        this.viewport.views.push({draw: () => document.body.classList.toggle("zoomed", this.viewport.zoom > 1.001)});
    }

    resize() {
        this.viewport.main_box = box_of(by_id("compare"));
        this.viewport.keep_in_sight();
        this.viewport.changed();
    }

    zoom_by(factor) { this.viewport.zoom_to(this.viewport.zoom * factor); }

    pick(number) {
        if (!this.report.frames.length) return;
        this.playback.pause();
        this.show.go_to_number(number);
    }

    sides_changed() {
        // The first call comes while the page is still being put together.
        if (!this.panes) return;
        this.panes.mark_sides(this.compare.sides);
        this.label_sides();
    }

    frame_shown(frame, pictures) {
        this.frame = frame;
        const absence = `none for frame ${frame.number}`;
        this.compare.show(pictures, absence);
        this.panes.show(pictures, absence);
        this.playback.frame_shown(frame);
        this.plot.set_current(frame.number);
        this.label_sides();
        this.viewport.changed();
    }

    label_sides() {
        const {plot, frame} = this;
        this.compare.label(name => {
            const value = frame ? plot.value_of(name, frame.number) : null;
            return is_number(value) ? `${plot.metric.name} ${format_reading(value)}` : "";
        });
    }

    press_key(event) {
        const typing = event.target.closest("select, textarea");
        if (typing || event.ctrlKey || event.metaKey || event.altKey || this.report.frames.length === 0) return;
        // Space on a button presses that button.
        if (event.key === " " && event.target.closest("button")) return;
        const actions = {
            ",": () => this.playback.step(-1), ".": () => this.playback.step(1), " ": () => this.playback.toggle(),
            "+": () => this.zoom_by(1.5), "=": () => this.zoom_by(1.5), "-": () => this.zoom_by(1 / 1.5),
            "0": () => this.viewport.zoom_to(1), "1": () => this.viewport.zoom_to(this.viewport.one_to_one_zoom()),
        };
        if (!(event.key in actions)) return;
        event.preventDefault();
        actions[event.key]();
    }
}

new Page(JSON.parse(by_id("report-data").textContent));
