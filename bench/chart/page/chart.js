// Puts the chart together from its data.

class Chart {
    constructor(data) {
        this.rows = data.rows;
        this.measures = data.measures;
        this.tooltip = new Tooltip(data.measures);
        this.details = new Picked(data.measures);
        by_id("title").textContent = data.title;
        by_id("subtitle").textContent = data.subtitle;
        this.fill("scene", ["all", ...unique(this.rows.map(row => row.scene))]);
        this.fill("effect", ["all", ...unique(this.rows.map(row => row.effect))]);
        this.fill("measure", this.measures.map(measure => measure.name));
        by_id("log").addEventListener("change", () => this.draw());
        this.draw();
    }

    fill(id, names) {
        by_id(id).replaceChildren(...names.map(name => make("option", {value: name}, name)));
        by_id(id).addEventListener("change", () => this.draw());
    }

    draw() {
        const chosen = id => by_id(id).value;
        const fits = (row, id) => chosen(id) === "all" || row[id] === chosen(id);
        const measure = this.measures.find(one => one.name === chosen("measure"));
        const view = {measure, logarithmic: by_id("log").checked};
        const on = {hover: (row, event) => this.tooltip.show(row, event), leave: () => this.tooltip.hide(), pick: row => this.pick(row)};
        const cases = by_case(this.rows.filter(row => fits(row, "scene") && fits(row, "effect")));
        this.panels = cases.map(rows => new Panel(rows, view, on));
        by_id("direction").textContent = `${measure?.description}: ${measure?.higher_is_better ? "higher" : "lower"} is better`;
        by_id("panels").replaceChildren(...this.panels.map(panel => panel.element));
        if (!cases.length) by_id("panels").append(make("p", {class: "card"}, "No scene here has this effect."));
        by_id("panels").classList.toggle("single", cases.length === 1);
        this.tooltip.hide();
        const still_there = cases.some(rows => rows.includes(this.picked));
        this.pick(still_there ? this.picked : front_of(cases[0] ?? [], measure).pop() ?? cases[0]?.[0] ?? null);
    }

    pick(row) {
        this.picked = row;
        this.details.show(row);
        for (const panel of this.panels) panel.mark(row);
    }
}

new Chart(JSON.parse(by_id("chart-data").textContent));
