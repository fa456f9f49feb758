// Which part of the pictures is seen. Every view shares one viewport and so shows the same part.

class Viewport {
    constructor(size) {
        this.size = size;
        this.zoom = 1; // 1 shows the whole picture
        this.center = {x: 0.5, y: 0.5}; // in fractions of the picture
        this.pointed = null; // the pixel under the pointer
        this.views = [];
        this.main_box = {width: 1, height: 1};
    }

    fit_scale(box) { return Math.min(box.width / this.size.width, box.height / this.size.height); }

    /// Where the picture lies in a box of this size: the scale and the corner, in the page's pixels.
    placement(box) {
        const scale = this.fit_scale(box) * this.zoom;
        return {
            scale,
            x: box.width / 2 - this.center.x * this.size.width * scale,
            y: box.height / 2 - this.center.y * this.size.height * scale,
        };
    }

    one_to_one_zoom() { return 1 / (window.devicePixelRatio * this.fit_scale(this.main_box)); }

    /// Zooms so that what lies under the point stays there.
    zoom_at(box, point, factor) {
        const before = this.placement(box);
        const most = Math.max(1, 48 / this.fit_scale(this.main_box));
        this.zoom = clamp(this.zoom * factor, Math.min(1, this.one_to_one_zoom()), most);
        const ratio = this.zoom * this.fit_scale(box) / before.scale;
        const after = {x: point.x + (before.x - point.x) * ratio, y: point.y + (before.y - point.y) * ratio};
        this.center_on(box, after, before.scale * ratio);
    }

    zoom_to(zoom) {
        const middle = {x: this.main_box.width / 2, y: this.main_box.height / 2};
        this.zoom_at(this.main_box, middle, zoom / this.zoom);
    }

    pan_by(box, x, y) {
        const place = this.placement(box);
        this.center_on(box, {x: place.x + x, y: place.y + y}, place.scale);
    }

    center_on(box, corner, scale) {
        this.center.x = (box.width / 2 - corner.x) / (this.size.width * scale);
        this.center.y = (box.height / 2 - corner.y) / (this.size.height * scale);
        this.keep_in_sight();
        this.changed();
    }

    /// Moves the centre so that the main view shows no emptiness beside a picture that could fill it.
    keep_in_sight() {
        const scale = this.fit_scale(this.main_box) * this.zoom;
        const half_x = Math.min(0.5, this.main_box.width / (2 * this.size.width * scale));
        const half_y = Math.min(0.5, this.main_box.height / (2 * this.size.height * scale));
        this.center.x = clamp(this.center.x, half_x, 1 - half_x);
        this.center.y = clamp(this.center.y, half_y, 1 - half_y);
    }

    /// Tells all views which pixel the pointer is at in one of them.
    point_at(view, point) {
        const box = box_of(view);
        const place = this.placement(box);
        const x = Math.floor((point.x - place.x) / place.scale);
        const y = Math.floor((point.y - place.y) / place.scale);
        const inside = x >= 0 && y >= 0 && x < this.size.width && y < this.size.height;
        this.pointed = inside ? {x, y, view} : null;
        this.changed();
    }

    point_nowhere() {
        this.pointed = null;
        this.changed();
    }

    /// Draws all views once before the next screen refresh, however many changes come until then.
    changed() {
        this.pending ??= requestAnimationFrame(() => {
            this.pending = null;
            for (const view of this.views) view.draw();
        });
    }
}
