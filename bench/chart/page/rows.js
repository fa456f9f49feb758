// What can be said of a chart's rows.

/// The row's value of a measure; milliseconds too.
function value_of(row, name) { return is_number(row[name]) ? row[name] : null; }

/// Parts of a list that agree in scene and effect.
function by_case(rows) {
    const cases = new Map();
    for (const row of rows) {
        const name = `${row.scene}, ${row.effect}`;
        cases.set(name, [...cases.get(name) ?? [], row]);
    }
    return [...cases.values()];
}

/// The rows that no other is both faster and better than, from the fastest to the slowest.
function front_of(rows, measure) {
    const sign = measure.higher_is_better ? -1 : 1;
    const known = rows.filter(row => row.competes && value_of(row, measure.name) !== null && value_of(row, "ms_per_frame") !== null);
    const beats = (a, b) => a.ms_per_frame < b.ms_per_frame && sign * a[measure.name] < sign * b[measure.name];
    return known.filter(row => !known.some(other => beats(other, row))).sort((a, b) => a.ms_per_frame - b.ms_per_frame);
}

function unique(list) { return [...new Set(list)]; }
