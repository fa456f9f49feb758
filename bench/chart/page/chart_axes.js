// A panel's coordinates: milliseconds to the right, logarithmic; a measure upwards.

class ChartAxes {
    constructor(rows, measure, logarithmic) {
        this.width = 560, this.height = 380;
        this.left = 72, this.right = 540, this.top = 14, this.bottom = 338;
        this.measure = measure;
        const values = rows.map(row => row[measure.name]);
        const positive = values.filter(value => value > 0);
        this.logarithmic = logarithmic && positive.length === values.length && values.length > 0;
        this.x_range = this.widened(rows.map(row => Math.log10(row.ms_per_frame)), 0.06, 0.1);
        this.y_range = this.widened(this.logarithmic ? values.map(Math.log10) : values, 0.08, 1e-4);
    }

    /// From the least to the most, and some more to either side.
    widened(numbers, part, at_least) {
        const low = least(numbers, 0), high = most(numbers, 1);
        const more = Math.max((high - low) * part, at_least);
        return [low - more, high + more];
    }

    x(ms) { return this.left + this.part(Math.log10(ms), this.x_range) * (this.right - this.left); }
    y(value) { return this.bottom - this.part(this.logarithmic ? Math.log10(value) : value, this.y_range) * (this.bottom - this.top); }
    part(number, [low, high]) { return (number - low) / (high - low); }

    draw(svg) {
        for (const tick of decade_ticks(...this.x_range, 5)) this.draw_upright(svg, this.x(tick), format_value(tick));
        const heights = this.logarithmic ? decade_ticks(...this.y_range, 5) : round_ticks(...this.y_range, 5, false);
        for (const tick of heights) this.draw_level(svg, this.y(tick), format_value(tick));
        const middle = (this.left + this.right) / 2;
        svg.append(make_in(svg, "text", {x: middle, y: this.height - 8, "text-anchor": "middle"}, "milliseconds per frame"));
        const turned = {transform: `translate(14 ${(this.top + this.bottom) / 2}) rotate(-90)`, "text-anchor": "middle"};
        svg.append(make_in(svg, "text", turned, this.measure.name));
    }

    draw_upright(svg, x, text) {
        svg.append(make_in(svg, "line", {class: "grid", x1: x, x2: x, y1: this.top, y2: this.bottom}));
        svg.append(make_in(svg, "text", {x, y: this.bottom + 16, "text-anchor": "middle"}, text));
    }

    draw_level(svg, y, text) {
        svg.append(make_in(svg, "line", {class: "grid", x1: this.left, x2: this.right, y1: y, y2: y}));
        svg.append(make_in(svg, "text", {x: this.left - 6, y: y + 4, "text-anchor": "end"}, text));
    }
}

/// 1, 2 and 5 times powers of ten between two logarithms; powers alone where there would be too many, and any round number where too few.
function decade_ticks(low, high, enough) {
    const with_factors = factors => {
        const ticks = [];
        for (let power = Math.floor(low); power <= Math.ceil(high); ++power)
            for (const factor of factors) ticks.push(Number((factor * 10 ** power).toPrecision(2)));
        return ticks.filter(tick => Math.log10(tick) >= low && Math.log10(tick) <= high);
    };
    const fine = with_factors([1, 2, 5]);
    if (fine.length > 2 * enough) return with_factors([1]);
    return fine.length >= 2 ? fine : with_factors([1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9]);
}
