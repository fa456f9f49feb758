// The plot of one scene and effect.

class Panel {
    /// `view`: what to show; `on` has hover(row, event), leave() and pick(row).
    constructor(rows, view, on) {
        this.rows = rows;
        this.on = on;
        this.points = new Map();
        const {scene, effect} = rows[0];
        this.svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
        this.svg.setAttribute("viewBox", "0 0 560 380");
        this.svg.setAttribute("role", "group");
        this.svg.setAttribute("aria-label", `${view.measure.name} over milliseconds on ${scene}, ${effect}`);
        this.element = make("section", {class: "card panel"}, make("h2", {}, `${scene}, ${effect}`), this.svg);
        this.draw(view);
    }

    draw({measure, logarithmic}) {
        const known = row => value_of(row, measure.name) !== null && value_of(row, "ms_per_frame") > 0;
        const rows = this.rows.filter(known);
        this.axes = new ChartAxes(rows, measure, logarithmic);
        this.axes.draw(this.svg);
        const front = front_of(rows, measure);
        this.draw_line(front, "front");
        for (const row of [...rows].sort((a, b) => front.includes(a) - front.includes(b))) this.draw_point(row, front.includes(row));
        this.draw_labels(rows, front);
    }

    place(row) { return {x: this.axes.x(row.ms_per_frame), y: this.axes.y(row[this.axes.measure.name])}; }

    draw_line(rows, name) {
        const path = rows.map((row, i) => `${i ? "L" : "M"}${this.place(row).x.toFixed(1)} ${this.place(row).y.toFixed(1)}`).join("");
        this.svg.append(make_in(this.svg, "path", {class: name, d: path}));
    }

    draw_point(row, on_front) {
        const kinds = {"on-front": on_front, input: !row.competes};
        const name = ["point", ...Object.keys(kinds).filter(kind => kinds[kind])].join(" ");
        const {x, y} = this.place(row);
        const text = `${row.method}: ${format_reading(row.ms_per_frame)} ms, ${this.axes.measure.name} ${format_reading(row[this.axes.measure.name])}`;
        const place = {cx: x, cy: y, r: 5.5};
        const point = make_in(this.svg, "circle", {class: name, ...place, tabindex: 0, role: "button", "aria-label": text, "data-method": row.method});
        point.addEventListener("pointerenter", event => this.on.hover(row, event));
        point.addEventListener("pointerleave", () => this.on.leave());
        point.addEventListener("click", () => this.on.pick(row));
        point.addEventListener("focus", () => this.on.pick(row));
        this.points.set(row, point);
        this.svg.append(point);
    }

    /// Names of the presets, the front's first, each where it covers neither a point nor the front, else no point, or at least no name; one
    /// that has no room is left to the tooltip.
    draw_labels(rows, front) {
        const points = rows.map(row => this.place(row)).map(({x, y}) => ({left: x - 5, right: x + 5, top: y - 5, bottom: y + 5}));
        const line = boxes_along(front.map(row => this.place(row)));
        const names = [];
        const named = [...rows].sort((a, b) => front.includes(b) - front.includes(a));
        for (const row of named) {
            const free = this.boxes_beside(row).filter(one => this.is_inside(one) && !names.some(other => overlap(one, other)));
            const keeps_off = boxes => one => !boxes.some(other => overlap(one, other));
            const box = free.find(keeps_off([...points, ...line])) ?? free.find(keeps_off(points)) ?? free[0];
            if (!box) continue;
            names.push(box);
            const style = {class: front.includes(row) ? "label on-front" : "label", x: box.left, y: box.bottom - 3};
            this.svg.append(make_in(this.svg, "text", style, row.method));
        }
    }

    boxes_beside(row) {
        const {x, y} = this.place(row);
        const width = 7.3 * row.method.length, height = 15;
        const at = (left, top) => ({left, right: left + width, top, bottom: top + height});
        return [at(x + 9, y - 7), at(x - 9 - width, y - 7), at(x - width / 2, y - 22), at(x - width / 2, y + 8), at(x + 7, y - 20), at(x + 7, y + 7)];
    }

    is_inside(box) { return box.left > this.axes.left && box.right < this.axes.right + 16 && box.top > 0 && box.bottom < this.axes.bottom; }

    /// Marks the picked row, and the same method in other panels.
    mark(picked) {
        for (const [row, point] of this.points) {
            point.classList.toggle("is-picked", row === picked);
            point.classList.toggle("same", row !== picked && row.method === picked?.method);
        }
    }
}

/// Small boxes along the line through some places.
function boxes_along(places) {
    return places.slice(1).flatMap((to, i) => {
        const from = places[i];
        const count = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / 3);
        return Array.from({length: count + 1}, (_, k) => {
            const x = from.x + (to.x - from.x) * k / count, y = from.y + (to.y - from.y) * k / count;
            return {left: x - 1, right: x + 1, top: y - 1, bottom: y + 1};
        });
    });
}

function overlap(a, b) { return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom; }
