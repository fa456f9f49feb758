// Wheel, drag and pinch on a view, turned into changes of the viewport.

function point_in(element, event) {
    const box = element.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
}

function box_of(element) { return {width: element.clientWidth, height: element.clientHeight}; }

class Gestures {
    constructor(element, viewport) {
        this.element = element;
        this.viewport = viewport;
        this.pointers = new Map(); // where each pressed pointer was last
        element.addEventListener("wheel", event => this.turn_wheel(event), {passive: false});
        element.addEventListener("pointerdown", event => this.press(event));
        element.addEventListener("pointermove", event => this.move(event));
        for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, event => this.release(event));
        element.addEventListener("pointerleave", () => viewport.point_nowhere());
        element.addEventListener("dblclick", event => this.double_click(event));
    }

    turn_wheel(event) {
        event.preventDefault();
        // Wheels that count lines or pages make bigger steps than those that count pixels.
        const unit = [1, 16, 200][event.deltaMode];
        // A pinch on a touchpad arrives as a wheel with Ctrl and in much smaller steps.
        const speed = event.ctrlKey ? 0.01 : 0.002;
        const factor = Math.exp(clamp(-event.deltaY * unit * speed, -0.7, 0.7));
        const point = point_in(this.element, event);
        this.viewport.zoom_at(box_of(this.element), point, factor);
        this.viewport.point_at(this.element, point);
    }

    press(event) {
        if (event.button !== 0) return;
        this.element.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, point_in(this.element, event));
        this.element.classList.add("panning");
    }

    move(event) {
        const point = point_in(this.element, event);
        const before = this.pointers.get(event.pointerId);
        if (before) {
            this.drag(event.pointerId, before, point);
            this.pointers.set(event.pointerId, point);
        }
        if (event.pointerType === "mouse" || before) this.viewport.point_at(this.element, point);
    }

    drag(id, before, point) {
        const box = box_of(this.element);
        const other = [...this.pointers].find(([other_id]) => other_id !== id)?.[1];
        if (!other) {
            this.viewport.pan_by(box, point.x - before.x, point.y - before.y);
            return;
        }
        // Two fingers: their distance zooms about their middle, and the middle's way pans.
        const spread = Math.hypot(before.x - other.x, before.y - other.y);
        const factor = Math.hypot(point.x - other.x, point.y - other.y) / Math.max(spread, 1);
        const middle = {x: (before.x + other.x) / 2, y: (before.y + other.y) / 2};
        this.viewport.zoom_at(box, middle, factor);
        this.viewport.pan_by(box, (point.x - before.x) / 2, (point.y - before.y) / 2);
    }

    release(event) {
        this.pointers.delete(event.pointerId);
        if (this.pointers.size === 0) this.element.classList.remove("panning");
        if (event.pointerType !== "mouse") this.viewport.point_nowhere();
    }

    double_click(event) {
        const factor = this.viewport.zoom > 1.01 ? 1 / this.viewport.zoom : 4;
        this.viewport.zoom_at(box_of(this.element), point_in(this.element, event), factor);
    }
}
