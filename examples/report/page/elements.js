// Shorthand for the document.

function by_id(id) { return document.getElementById(id); }

/// Makes an element; text given among the children stays text, so no name in a report can become markup.
function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
}

function fill_select(select, names) {
    select.replaceChildren(...names.map((name, i) => make("option", {value: String(i)}, name)));
}

/// Makes an SVG element in the namespace of the drawing that it is for.
function make_in(svg, tag, attributes, text = "") {
    const element = document.createElementNS(svg.namespaceURI, tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
    element.textContent = text;
    return element;
}
