// The large view: one picture left of a divider that can be moved, another right of it.

class CompareView {
    constructor(viewport, kinds, on_choice) {
        this.viewport = viewport;
        this.kinds = kinds;
        this.on_choice = on_choice;
        this.element = by_id("compare");
        this.canvas = this.element.querySelector("canvas");
        this.sides = {left: 0, right: Math.min(1, kinds.length - 1)};
        this.position = 0.5;
        this.pictures = [];
        this.absence = "";
        new Gestures(this.element, viewport);
        this.set_up_choice();
        this.set_up_divider();
        this.move_divider(0.5);
    }

    set_up_choice() {
        for (const side of ["left", "right"]) {
            const select = by_id(`${side}-kind`);
            fill_select(select, this.kinds.map(kind => kind.name));
            select.addEventListener("change", () => this.choose(side, Number(select.value)));
        }
        by_id("swap").addEventListener("click", () => {
            [this.sides.left, this.sides.right] = [this.sides.right, this.sides.left];
            this.sides_changed();
        });
    }

    choose(side, kind) {
        this.sides[side] = kind;
        this.sides_changed();
    }

    sides_changed() {
        for (const side of ["left", "right"]) {
            const kind = this.kinds[this.sides[side]];
            by_id(`${side}-kind`).value = String(this.sides[side]);
            by_id(`scale-${side}`).hidden = !kind.scale;
            by_id(`scale-${side}`).replaceChildren(...(kind.scale ? [make_scale(kind.scale)] : []));
        }
        this.describe_divider();
        this.on_choice(this.sides);
        this.viewport.changed();
    }

    set_up_divider() {
        const divider = by_id("divider");
        divider.addEventListener("pointerdown", event => {
            // Else the view would take the press for the begin of a pan.
            event.stopPropagation();
            divider.setPointerCapture(event.pointerId);
        });
        divider.addEventListener("pointermove", event => {
            if (!divider.hasPointerCapture(event.pointerId)) return;
            this.move_divider(point_in(this.element, event).x / this.element.clientWidth);
        });
        divider.addEventListener("dblclick", event => {
            event.stopPropagation();
            this.move_divider(0.5);
        });
        divider.addEventListener("keydown", event => this.press_key(event));
    }

    press_key(event) {
        const step = event.shiftKey ? 0.1 : 0.01;
        const moves = {
            ArrowLeft: -step, ArrowDown: -step, ArrowRight: step, ArrowUp: step, PageDown: -0.1, PageUp: 0.1, Home: -1, End: 1,
        };
        if (!(event.key in moves)) return;
        event.preventDefault();
        this.move_divider(this.position + moves[event.key]);
    }

    move_divider(position) {
        this.position = clamp(position, 0, 1);
        by_id("divider").style.left = `${this.position * 100}%`;
        this.describe_divider();
        this.viewport.changed();
    }

    describe_divider() {
        const percent = Math.round(this.position * 100);
        const names = [this.kinds[this.sides.left]?.name, this.kinds[this.sides.right]?.name];
        by_id("divider").setAttribute("aria-valuenow", String(percent));
        by_id("divider").setAttribute("aria-valuetext", `${names[0]} ${percent} %, ${names[1]} ${100 - percent} %`);
    }

    /// Takes the shown frame's pictures, by kind, and what to say where one is missing.
    show(pictures, absence) {
        this.pictures = pictures;
        this.absence = absence;
    }

    /// Labels the sides, each with the error of its pictures where that is known.
    label(error_of) {
        for (const side of ["left", "right"]) {
            const name = this.kinds[this.sides[side]]?.name ?? "";
            by_id(`chip-${side}`).replaceChildren(name, make("small", {}, error_of(name)));
        }
    }

    draw() {
        const target = begin_canvas(this.canvas);
        const box = box_of(this.element);
        const split = Math.round(this.position * target.width);
        const {left, right} = this.sides;
        draw_layer(target, this.viewport, box, this.pictures[left], this.absence, 0, split);
        draw_layer(target, this.viewport, box, this.pictures[right], this.absence, split, target.width);
        draw_marker(target, this.viewport, box, this.element);
        by_id("zoom-level").value = `${Math.round(this.viewport.placement(box).scale * target.ratio * 100)} %`;
    }
}
