// The numbers and the picture of one point.

/// Rows of a table: every measure of a row, its time first.
function number_rows(row, measures, with_descriptions) {
    const times = {name: "ms_per_frame", description: "milliseconds per frame"};
    return [times, ...measures].map(measure => make("tr", {}, make("td", {}, with_descriptions ? measure.description : measure.name),
                                                    make("td", {class: "number"}, format_value(row[measure.name]))));
}

class Tooltip {
    constructor(measures) {
        this.measures = measures;
        this.element = by_id("tooltip");
    }

    show(row, event) {
        const table = make("table", {}, make("tbody", {}, ...number_rows(row, this.measures, false)));
        this.element.replaceChildren(make("b", {}, row.method), ` on ${row.scene}, ${row.effect}`, table);
        this.element.hidden = false;
        const {width, height} = this.element.getBoundingClientRect();
        const beside = event.clientX + 16 + width < window.innerWidth ? event.clientX + 16 : event.clientX - 16 - width;
        this.element.style.left = `${Math.max(beside, 4)}px`;
        this.element.style.top = `${clamp(event.clientY - height / 2, 4, Math.max(window.innerHeight - height - 4, 4))}px`;
    }

    hide() { this.element.hidden = true; }
}

class Picked {
    constructor(measures) { this.measures = measures; }

    show(row) {
        by_id("picked").hidden = !row;
        if (!row) return;
        by_id("picked-name").textContent = row.method;
        const threads = row.threads === 1 ? "1 thread" : `${row.threads} threads`;
        by_id("picked-case").textContent = `${row.scene}, ${row.effect}, ${row.width}x${row.height}, ${threads}`;
        by_id("picked-caption").textContent = row.method;
        this.show_picture("picked-picture", row.picture, `${row.method} on ${row.scene}`);
        this.show_picture("reference-picture", row.reference, `reference of ${row.scene}`);
        by_id("picked-numbers").replaceChildren(...number_rows(row, this.measures, true));
    }

    show_picture(id, file, text) {
        const image = by_id(id);
        image.closest("figure").hidden = !file;
        if (!file) return;
        image.src = file.split("/").map(encodeURIComponent).join("/");
        image.alt = text;
    }
}
