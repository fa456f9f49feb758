// Numbers as people read them.

function clamp(value, low, high) { return Math.min(Math.max(value, low), high); }

function is_number(value) { return typeof value === "number" && Number.isFinite(value); }

function format_value(value) {
    if (!is_number(value)) return "–";
    const size = Math.abs(value);
    if (size !== 0 && (size < 0.0001 || size >= 100000)) return value.toExponential(2);
    return size >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(4)));
}

/// The same with as many digits for every value, so that values under one another compare at a glance.
function format_reading(value) {
    const size = Math.abs(value);
    return is_number(value) && size >= 0.0001 && size < 1000 ? value.toPrecision(3) : format_value(value);
}

/// Round numbers from low to high, about count of them.
function round_ticks(low, high, count, whole) {
    const rough = (high - low) / Math.max(count, 1);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].find(factor => factor * power >= rough * 0.999) * power;
    const used = whole ? Math.max(1, Math.round(step)) : step;
    const ticks = [];
    for (let i = Math.ceil(low / used - 1e-9); i * used <= high + used * 1e-9; ++i) ticks.push(Number((i * used).toPrecision(12)));
    return ticks;
}

// Spreading a long list into Math.min() would overflow the stack, hence the folds.
function least(list, otherwise) { return list.length ? list.reduce((a, b) => Math.min(a, b)) : otherwise; }

function most(list, otherwise) { return list.length ? list.reduce((a, b) => Math.max(a, b)) : otherwise; }
