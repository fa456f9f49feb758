// A small view of every kind of picture, all in step with the large one.

class Pane {
    constructor(kind, index, viewport, on_choice) {
        this.kind = kind;
        this.viewport = viewport;
        this.bitmap = null;
        this.absence = "";
        this.canvas = make("canvas");
        this.swatch = make("i");
        this.value_text = document.createTextNode("");
        this.value = make("span", {class: "pane-value", hidden: ""}, this.swatch, this.value_text);
        this.view = make("div", {class: "view"}, this.canvas, this.value);
        this.buttons = {left: this.make_button("left", index, on_choice), right: this.make_button("right", index, on_choice)};
        const name = make("span", {class: "pane-name", title: kind.description || kind.name}, kind.name);
        const head = make("div", {class: "pane-head"}, name, this.buttons.left, this.buttons.right);
        this.element = make("figure", {class: "pane"}, head, this.view);
        new Gestures(this.view, viewport);
    }

    make_button(side, index, on_choice) {
        const text = `Show ${this.kind.name} on the ${side}`;
        const button = make("button", {type: "button", class: `on-${side}`, title: text, "aria-label": text}, make("i"));
        button.addEventListener("click", () => on_choice(side, index));
        return button;
    }

    draw() {
        const target = begin_canvas(this.canvas);
        const box = box_of(this.view);
        draw_layer(target, this.viewport, box, this.bitmap, this.absence, 0, target.width);
        draw_marker(target, this.viewport, box, this.view);
        this.show_value();
    }

    show_value() {
        const {pointed, size} = this.viewport;
        this.value.hidden = !pointed || !this.bitmap;
        if (this.value.hidden) return;
        const color = read_pixel(this.bitmap, size, pointed);
        this.swatch.style.background = `rgb(${color.join(" ")})`;
        this.value_text.data = color.join(" ");
    }
}

class Panes {
    constructor(viewport, kinds, on_choice) {
        this.viewport = viewport;
        this.panes = kinds.map((kind, index) => new Pane(kind, index, viewport, on_choice));
        const holder = by_id("panes");
        holder.style.setProperty("--pane-columns", String(clamp(kinds.length, 1, kinds.length > 4 ? 3 : 2)));
        holder.append(...this.panes.map(pane => pane.element));
        by_id("scales").append(...distinct_scales(kinds).map(make_scale));
    }

    show(pictures, absence) {
        this.panes.forEach((pane, index) => Object.assign(pane, {bitmap: pictures[index], absence}));
    }

    mark_sides(sides) {
        this.panes.forEach((pane, index) => {
            for (const side of ["left", "right"]) pane.buttons[side].setAttribute("aria-pressed", String(sides[side] === index));
        });
    }

    draw() {
        for (const pane of this.panes) pane.draw();
        const {pointed} = this.viewport;
        by_id("pixel").textContent = pointed ? `pixel ${pointed.x}, ${pointed.y} · 8-bit sRGB` : "point at a picture to read its pixels";
    }
}
