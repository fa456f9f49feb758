// Legends of pictures whose colours stand for numbers.

/// The kinds' colour scales, each once, since several error maps mostly share one.
function distinct_scales(kinds) {
    const scales = kinds.map(kind => kind.scale).filter(scale => scale);
    return [...new Map(scales.map(scale => [JSON.stringify(scale), scale])).values()];
}

function make_scale(scale) {
    const bar = make("span", {class: "bar"});
    bar.style.background = `linear-gradient(90deg, ${scale.colors.join(", ")})`;
    const [low, high] = [scale.low, scale.high].map(end => make("span", {}, format_value(end)));
    return make("div", {class: "scale"}, scale.label, low, bar, high);
}
