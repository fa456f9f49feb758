// The plot's coordinates, its grid and its labels.

class PlotAxes {
    constructor(svg, metric, frames) {
        this.width = Math.max(svg.clientWidth, 120);
        this.height = svg.clientHeight;
        const points = metric.series.flatMap(series => series.points);
        const numbers = [...points.map(point => point[0]), ...frames.map(frame => frame.number)];
        const values = points.map(point => point[1]).filter(is_number);
        this.x_range = this.padded(least(numbers, 0), most(numbers, 0));
        this.y_ticks = this.choose_y_ticks(Math.min(0, least(values, 0)), most(values, 1));
        this.y_range = [this.y_ticks[0], this.y_ticks[this.y_ticks.length - 1]];
        const label_width = Math.max(...this.y_ticks.map(tick => format_value(tick).length));
        this.left = 30 + 6.6 * label_width;
        this.right = this.width - 10;
        this.top = 14;
        this.bottom = this.height - 36;
    }

    padded(low, high) { return low < high ? [low, high] : [low - 0.5, high + 0.5]; }

    /// Ticks that reach up to the highest value or beyond it.
    choose_y_ticks(low, high) {
        const top = high > low ? high : low + 1;
        const ticks = round_ticks(low, top, 4, false);
        const step = ticks[1] - ticks[0];
        if (ticks[0] > low) ticks.unshift(Number((ticks[0] - step).toPrecision(12)));
        if (ticks[ticks.length - 1] < top) ticks.push(Number((ticks[ticks.length - 1] + step).toPrecision(12)));
        return ticks;
    }

    x(number) { return this.left + (number - this.x_range[0]) / (this.x_range[1] - this.x_range[0]) * (this.right - this.left); }

    y(value) { return this.bottom - (value - this.y_range[0]) / (this.y_range[1] - this.y_range[0]) * (this.bottom - this.top); }

    number_at(x) { return this.x_range[0] + (x - this.left) / (this.right - this.left) * (this.x_range[1] - this.x_range[0]); }

    draw(svg, metric) {
        for (const tick of this.y_ticks) {
            const y = Math.round(this.y(tick)) + 0.5;
            svg.append(make_in(svg, "line", {class: "grid", x1: this.left, x2: this.right, y1: y, y2: y}));
            svg.append(make_in(svg, "text", {x: this.left - 6, y: y + 4, "text-anchor": "end"}, format_value(tick)));
        }
        const space = (this.right - this.left) / 52;
        for (const tick of round_ticks(...this.x_range, space, true)) {
            const x = this.x(tick);
            svg.append(make_in(svg, "line", {class: "grid", x1: x, x2: x, y1: this.bottom, y2: this.bottom + 4}));
            svg.append(make_in(svg, "text", {x, y: this.bottom + 17, "text-anchor": "middle"}, String(tick)));
        }
        this.draw_titles(svg, metric);
    }

    draw_titles(svg, metric) {
        const middle = (this.top + this.bottom) / 2;
        svg.append(make_in(svg, "text", {x: (this.left + this.right) / 2, y: this.height - 3, "text-anchor": "middle"}, "frame"));
        const turned = {transform: `translate(12 ${middle}) rotate(-90)`, "text-anchor": "middle"};
        svg.append(make_in(svg, "text", turned, metric.unit ? `${metric.name} (${metric.unit})` : metric.name));
    }
}
