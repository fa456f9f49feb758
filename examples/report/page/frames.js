// Which frame is shown. A frame appears only once all of its pictures are decoded, so that nothing flickers.

class FrameShow {
    constructor(frames, store, on_shown) {
        this.frames = frames;
        this.store = store;
        this.on_shown = on_shown;
        this.wanted = 0;
        this.shown = -1;
        this.loading = null;
    }

    /// Resolves when the frame wanted last is on the screen. Wishes that come while another frame loads skip those between.
    go_to(index) {
        this.wanted = clamp(index, 0, this.frames.length - 1);
        this.loading ??= this.load_wanted().finally(() => { this.loading = null; });
        return this.loading;
    }

    /// Goes to the frame whose number is nearest, since a metric may cover frames that have no pictures.
    go_to_number(number) {
        const distances = this.frames.map(frame => Math.abs(frame.number - number));
        return this.go_to(distances.indexOf(Math.min(...distances)));
    }

    async load_wanted() {
        while (this.shown !== this.wanted) {
            const index = this.wanted;
            const pictures = await this.load(index);
            this.shown = index;
            this.on_shown(this.frames[index], pictures);
        }
        this.load((this.shown + 1) % this.frames.length);
    }

    load(index) {
        return Promise.all(this.frames[index].pictures.map(picture => picture === null ? null : this.store.load(picture)));
    }
}
