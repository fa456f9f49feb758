// What moves on the site: the slider, the guided choice, charts of which one is shown, the search, and the list of pages. All of it is there
// without scripts too, but for the search.
"use strict";

// The slider. Each border is a range, so that keys work; the border nearest to the pointer goes along with it, and pushes the other.
for (const stage of document.querySelectorAll(".compare .stage")) {
    const handles = [...stage.querySelectorAll(".handle")];
    const show = () => handles.forEach((handle, i) => {
        stage.style.setProperty(`--${"ab"[i]}`, `${handle.value}%`);
        handle.setAttribute("aria-valuetext", `${Math.round(handle.valueAsNumber)} %`);
    });
    const move = (moved, value) => {
        handles[moved].value = value;
        handles.forEach((other, i) => {
            if (i < moved) other.value = Math.min(other.value, value);
            if (i > moved) other.value = Math.max(other.value, value);
        });
        show();
    };
    handles.forEach((handle, i) => {
        handle.step = "any";
        handle.addEventListener("input", () => move(i, handle.valueAsNumber));
        // A key's step is of one in a hundred, ten with Shift.
        handle.addEventListener("keydown", event => {
            const way = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[event.key];
            if (!way) return;
            event.preventDefault();
            move(i, Math.min(100, Math.max(0, handle.valueAsNumber + way * (event.shiftKey ? 10 : 1))));
        });
    });
    let held = null;
    const place = event => {
        const box = stage.getBoundingClientRect();
        return Math.min(100, Math.max(0, 100 * (event.clientX - box.left) / box.width));
    };
    const nearest = value => {
        const distances = handles.map(handle => Math.abs(handle.valueAsNumber - value));
        const tie = handles.length > 1 && distances[0] === distances[1];
        return tie ? (value > handles[0].valueAsNumber ? 1 : 0) : distances.indexOf(Math.min(...distances));
    };
    const follow = event => {
        const value = place(event);
        held ??= nearest(value);
        move(held, value);
    };
    stage.addEventListener("pointerdown", event => {
        if (event.pointerType !== "mouse") held = nearest(place(event));
        follow(event);
    });
    stage.addEventListener("pointermove", follow);
    for (const end of ["pointerleave", "pointerup", "pointercancel"])
        stage.addEventListener(end, event => { if (end !== "pointerup" || event.pointerType !== "mouse") held = null; });
}

// The guided choice: the questions on the way, and the result at its end.
for (const guide of document.querySelectorAll(".guide")) {
    const steps = new Map([...guide.querySelectorAll("[data-step]")].map(step => [step.dataset.step, step]));
    const show = () => {
        const way = new Set();
        for (let key = "start"; key && !way.has(key); key = steps.get(key).querySelector("input:checked")?.dataset.to) way.add(key);
        for (const [key, step] of steps) {
            step.hidden = !way.has(key);
            if (step.hidden) for (const input of step.querySelectorAll("input")) input.checked = false;
        }
    };
    for (const result of guide.querySelectorAll(".result")) result.setAttribute("aria-live", "polite");
    guide.addEventListener("change", show);
    guide.addEventListener("submit", event => event.preventDefault());
    show();
}

// Drawings of which one is shown.
for (const choice of document.querySelectorAll(".choice")) {
    const parts = [...choice.children];
    if (parts.length < 2) continue;
    const label = document.createElement("label");
    const select = document.createElement("select");
    for (const part of parts) select.add(new Option(part.dataset.title));
    const show = () => parts.forEach((part, i) => { part.hidden = i !== select.selectedIndex; });
    select.addEventListener("change", show);
    label.append(choice.dataset.name, select);
    choice.prepend(label);
    choice.classList.add("one");
    show();
}

// The list of pages: open where there is room beside the page.
const side = document.querySelector("details.side");
if (side) {
    const room = matchMedia("(min-width: 56.01rem)");
    const fit = () => { side.open = room.matches; };
    room.addEventListener("change", fit);
    fit();
    const here = side.querySelector("[aria-current]");
    if (here && room.matches) side.scrollTop = here.offsetTop - side.offsetTop - 80;
}

// The search. Its data is a script, since pages that are files may not load anything else; it is loaded when someone searches.
const search = document.querySelector("form.search");
if (search) {
    const input = search.querySelector("input"), list = search.querySelector("ul"), root = search.dataset.root;
    search.hidden = false;
    let loading = null;
    const load = () => loading ??= new Promise(resolve => {
        const script = document.createElement("script");
        script.src = `${root}search_data.js`;
        script.onload = () => resolve(window.quell_search);
        document.head.append(script);
    });
    const rank = (title, words) => {
        const low = title.toLowerCase();
        if (!words.every(word => low.includes(word))) return Infinity;
        const starts_a_word = low.split(/\W+/).some(part => part.startsWith(words[0]));
        const order = low === words.join(" ") ? 0 : low.startsWith(words[0]) ? 1 : starts_a_word ? 2 : 3;
        return order + low.length / 1000; // short titles first
    };
    let chosen = -1;
    const choose = index => {
        const rows = [...list.querySelectorAll("[role=option]")];
        chosen = rows.length ? (index + rows.length) % rows.length : -1;
        rows.forEach((row, i) => row.setAttribute("aria-selected", i === chosen));
        rows[chosen]?.scrollIntoView({block: "nearest"});
        if (chosen >= 0) input.setAttribute("aria-activedescendant", rows[chosen].id);
    };
    const show = async () => {
        const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
        const all = await load();
        const found = words.length ? all.map(entry => [rank(entry[0], words), entry]).filter(([order]) => order < Infinity) : [];
        found.sort((a, b) => a[0] - b[0]);
        list.replaceChildren(...found.slice(0, 12).map(([, [title, place, kind]], i) => {
            const row = document.createElement("li"), link = document.createElement("a"), what = document.createElement("span");
            row.id = `found${i}`;
            row.setAttribute("role", "option");
            link.href = root + place;
            link.tabIndex = -1;
            what.textContent = kind;
            link.append(title, what);
            row.append(link);
            return row;
        }));
        if (words.length && !found.length) {
            const row = document.createElement("li");
            row.className = "none";
            row.textContent = "Nothing has that name.";
            list.append(row);
        }
        list.hidden = !words.length;
        input.setAttribute("aria-expanded", !list.hidden);
        choose(0);
    };
    input.addEventListener("focus", load);
    input.addEventListener("input", show);
    search.addEventListener("submit", event => {
        event.preventDefault();
        list.querySelector("[aria-selected=true] a")?.click();
    });
    search.addEventListener("keydown", event => {
        if (event.key === "Escape") { list.hidden = true; input.setAttribute("aria-expanded", false); }
        if (event.key === "ArrowDown" || event.key === "ArrowUp") {
            event.preventDefault();
            choose(chosen + (event.key === "ArrowDown" ? 1 : -1));
        }
    });
    search.addEventListener("focusout", event => { if (!search.contains(event.relatedTarget)) list.hidden = true; });
    list.addEventListener("pointerdown", event => event.preventDefault()); // the input keeps the focus until the link is followed
}
