// The frame slider and its buttons.

class Playback {
    constructor(show) {
        this.show = show;
        this.playing = false;
        this.slider = by_id("frame-slider");
        this.slider.max = String(show.frames.length - 1);
        this.slider.addEventListener("input", () => this.jump(Number(this.slider.value)));
        by_id("frame-previous").addEventListener("click", () => this.step(-1));
        by_id("frame-next").addEventListener("click", () => this.step(1));
        by_id("play").addEventListener("click", () => this.toggle());
        by_id("playback").hidden = show.frames.length < 2;
    }

    jump(index) {
        this.pause();
        this.show.go_to(index);
    }

    step(by) { this.jump(this.after(by)); }

    after(by) {
        const count = this.show.frames.length;
        return (this.show.wanted + by + count) % count;
    }

    toggle() {
        if (this.playing) this.pause();
        else if (this.show.frames.length > 1) this.play();
    }

    pause() { this.set_playing(false); }

    async play() {
        this.set_playing(true);
        const run = this.run = Symbol("run"); // tells this loop from one started after a pause
        while (this.playing && this.run === run) {
            const due = performance.now() + 1000 / Number(by_id("speed").value);
            await this.show.go_to(this.after(1));
            await new Promise(resolve => setTimeout(resolve, Math.max(0, due - performance.now())));
        }
    }

    set_playing(playing) {
        this.playing = playing;
        const button = by_id("play");
        button.classList.toggle("playing", playing);
        button.title = playing ? "Pause (space)" : "Play (space)";
        button.setAttribute("aria-label", playing ? "Pause" : "Play");
    }

    frame_shown(frame) {
        this.slider.value = String(this.show.wanted);
        this.slider.setAttribute("aria-valuetext", `frame ${frame.number}`);
        const position = `${this.show.shown + 1} of ${this.show.frames.length}`;
        by_id("frame-label").replaceChildren(make("b", {}, `frame ${frame.number}`), ` · ${position}`);
    }
}
