// The error per frame: a line for each series, the current frame, and the values under the pointer.

class ErrorPlot {
    constructor(report, on_pick, on_metric) {
        this.metrics = report.metrics.filter(metric => metric.series.length);
        this.frames = report.frames;
        this.looks = series_looks(this.metrics);
        this.svg = by_id("plot");
        this.metric = this.metrics[0] ?? null;
        this.current = null;
        this.hovered = null;
        by_id("plot-card").hidden = !this.metric;
        if (!this.metric) return;
        this.set_up_choice(on_metric);
        this.svg.addEventListener("pointermove", event => this.hover(this.number_under(event)));
        this.svg.addEventListener("pointerleave", () => this.hover(null));
        this.svg.addEventListener("click", event => on_pick(this.number_under(event)));
        new ResizeObserver(() => this.draw()).observe(this.svg);
    }

    set_up_choice(on_metric) {
        const select = by_id("metric");
        fill_select(select, this.metrics.map(metric => metric.name));
        select.hidden = this.metrics.length < 2;
        by_id("metric-name").textContent = this.metrics.length < 2 ? `${this.metric.name} per frame` : "per frame";
        select.addEventListener("change", () => {
            this.metric = this.metrics[Number(select.value)];
            this.draw();
            on_metric();
        });
    }

    /// The series' value at a frame, if it has one.
    value_of(series_name, number) {
        const series = this.metric?.series.find(one => one.name === series_name);
        return series?.points.find(point => point[0] === number)?.[1] ?? null;
    }

    number_under(event) {
        const number = this.axes.number_at(point_in(this.svg, event).x);
        const measured = this.metric.series.flatMap(series => series.points.map(point => point[0]));
        const known = [...measured, ...this.frames.map(frame => frame.number)];
        return known.reduce((best, one) => Math.abs(one - number) < Math.abs(best - number) ? one : best);
    }

    hover(number) {
        this.hovered = number;
        this.draw_marks();
    }

    set_current(number) {
        this.current = number;
        if (this.metric) this.draw_marks();
    }

    draw() {
        this.axes = new PlotAxes(this.svg, this.metric, this.frames);
        by_id("metric-hint").textContent = this.metric.hint;
        const names = this.metric.series.map(series => series.name).join(", ");
        this.svg.setAttribute("aria-label", `${this.metric.name} per frame of ${names}`);
        this.svg.replaceChildren();
        this.axes.draw(this.svg, this.metric);
        this.draw_picture_ticks();
        for (const series of this.metric.series) this.draw_series(series);
        this.marks = make_in(this.svg, "g", {});
        this.svg.append(this.marks);
        this.draw_marks();
    }

    /// Marks the frames that can be looked at where the metric covers more than those.
    draw_picture_ticks() {
        const covered = Math.max(...this.metric.series.map(series => series.points.length));
        if (this.frames.length >= covered) return;
        for (const {number} of this.frames) {
            const x = this.axes.x(number);
            const place = {x1: x, x2: x, y1: this.axes.bottom - 5, y2: this.axes.bottom};
            this.svg.append(make_in(this.svg, "line", {class: "has-picture", ...place}));
        }
    }

    draw_series(series) {
        const {color, kind} = this.looks.get(series.name);
        let path = "";
        let drawing = false;
        for (const [number, value] of series.points) {
            if (is_number(value)) path += `${drawing ? "L" : "M"}${this.axes.x(number).toFixed(1)} ${this.axes.y(value).toFixed(1)}`;
            drawing = is_number(value);
        }
        this.svg.append(make_in(this.svg, "path", {class: `series ${kind}`, d: path, style: `stroke: ${color}`}));
        // A line needs two points; a few may stand alone between gaps and each is worth a dot anyway.
        if (series.points.length <= 24) for (const point of series.points) this.draw_dot(this.svg, series, point, 2.5);
    }

    draw_dot(parent, series, [number, value], radius) {
        if (!is_number(value)) return;
        const place = {cx: this.axes.x(number), cy: this.axes.y(value), r: radius};
        parent.append(make_in(this.svg, "circle", {class: "dot", ...place, style: `fill: ${this.looks.get(series.name).color}`}));
    }

    draw_marks() {
        if (!this.marks) return;
        this.marks.replaceChildren();
        if (this.current !== null) this.draw_current();
        const number = this.hovered ?? this.current;
        if (this.hovered !== null) this.marks.append(this.upright("guide", this.axes.x(this.hovered)));
        for (const series of this.metric.series) this.draw_dot(this.marks, series, [number, this.value_of(series.name, number)], 4.5);
        this.read_out(number);
    }

    draw_current() {
        const x = this.axes.x(this.current);
        const {top} = this.axes;
        this.marks.append(this.upright("current", x));
        this.marks.append(make_in(this.svg, "path", {class: "current-head", d: `M${x - 5} ${top - 9}h10l-5 7z`}));
    }

    upright(name, x) { return make_in(this.svg, "line", {class: name, x1: x, x2: x, y1: this.axes.top - 4, y2: this.axes.bottom}); }

    /// The legend, which doubles as the read-out.
    read_out(number) {
        const entries = this.metric.series.map(series => {
            const {color, kind} = this.looks.get(series.name);
            const mark = make_in(this.svg, "svg", {class: "mark", viewBox: "0 0 26 10"});
            mark.append(make_in(this.svg, "path", {class: `series ${kind}`, d: "M1 5h24", style: `stroke: ${color}`}));
            const value = make("b", {}, number === null ? "" : format_reading(this.value_of(series.name, number)));
            return make("span", {class: "entry"}, mark, series.name, " ", value);
        });
        const at = number === null ? "" : `frame ${number}`;
        by_id("readout").replaceChildren(make("span", {class: "at"}, at), ...entries);
    }
}

/// A colour and a kind of line for each name, the same in every metric. Names that share a metric look different, while looks last.
function series_looks(metrics) {
    const kinds = ["", "dashed", "dotted", "dash-dotted"];
    const groups = metrics.map(metric => metric.series.map(series => series.name));
    const numbers = new Map();
    for (const name of new Set(groups.flat())) {
        const taken = new Set(groups.filter(group => group.includes(name)).flat().map(other => numbers.get(other)));
        const all = Array.from({length: 6 * kinds.length}, (_, i) => i);
        numbers.set(name, all.find(i => !taken.has(i)) ?? numbers.size % all.length);
    }
    return new Map([...numbers].map(([name, i]) => [name, {color: `var(--series-${i % 6})`, kind: kinds[Math.floor(i / 6)]}]));
}
