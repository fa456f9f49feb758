// The figures and the notes below the pictures.

/// The text, which may break behind each underscore: names of methods and measures have no spaces.
function breakable(text) { return text.split(/(?<=_)/).flatMap((part, i) => i ? [make("wbr"), part] : [part]); }

function make_table(table) {
    const numeric = table.columns.map((_, i) => i > 0 && table.rows.every(row => /^([<>]= )?[-+–]?\d|^[–-]?$/.test(row[i])));
    const style = i => numeric[i] ? {class: "number"} : {};
    const head = make("tr", {}, ...table.columns.map((name, i) => make("th", {scope: "col", ...style(i)}, name)));
    const make_cell = (cell, i) => i ? make("td", style(i), ...breakable(cell)) : make("th", {scope: "row"}, ...breakable(cell));
    const rows = table.rows.map(row => make("tr", {}, ...row.map(make_cell)));
    const frame = make("div", {class: "table-frame"}, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
    return make("section", {class: "card"}, make("h2", {}, table.caption), frame);
}

function make_note(note) {
    const text = make(note.code ? "code" : "span", {}, note.text);
    const value = make("dd", note.code ? {class: "code"} : {}, text);
    // Browsers hide the clipboard from pages that they don't trust, which a file may be.
    if (note.code && navigator.clipboard) value.append(make_copy_button(note.text));
    return [make("dt", {}, note.label), value];
}

function make_copy_button(text) {
    const button = make("button", {type: "button"}, "Copy");
    button.addEventListener("click", async () => {
        const copied = await navigator.clipboard.writeText(text).then(() => true, () => false);
        button.textContent = copied ? "Copied" : "Not allowed";
        setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
    return button;
}

function show_facts(report) {
    const facts = by_id("facts");
    facts.append(...report.tables.map(make_table));
    facts.classList.toggle("wide", report.tables.some(table => table.columns.length > 4));
    if (!report.notes.length) return;
    facts.append(make("section", {class: "card"}, make("h2", {}, "About this run"), make("dl", {}, ...report.notes.flatMap(make_note))));
}
