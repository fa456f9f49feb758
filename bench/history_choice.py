#!/usr/bin/env python3
"""Prints how far history helps and where it hurts: RMSE of frames with their history, by themselves, and with a choice between both.

    PYTHONPATH=build/release/packaging/python bench/history_choice.py FOLDER SCENE...
        [--samples 1 16] [--presets general final-frame] [--program build/release/examples/denoise/quell-denoise]

A sequence is FOLDER/SCENE/SAMPLES/frame_0001.exr and so on, by Blender's Cycles; frames with a reference in FOLDER/SCENE/512 are measured.
Presets denoise the picture as one signal in real time, by its diffuse and glossy colour (Denoiser(preset, choose_history=SAMPLES)); "alone" is
the same frame after forget(). Last is the part of windows of 25x25 pixels, every fifth one of those whose RMSE is .002 or more, in which the
choice has at most 1.05 times the RMSE of the frame alone; in brackets the same without a choice. --program adds a row for what that program
makes of the files with all that it does, beside the frame alone, which the program then denoises without those around it.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import quell

SIDE, STEP, LEAST, MOST = 25, 5, 0.002, 1.05


def colour(planes, name):
    return np.stack([planes[f"ViewLayer.{name}.{letter}"].astype(np.float32) for letter in "RGB"], axis=-1)


def picture_of(path):
    return colour(quell.exr.read(path).planes, "Combined")


def frame_of(path, reads):
    """The picture as one signal: where nothing has a colour, as on lamps, it is 1."""
    planes = quell.exr.read(path).planes
    albedo = np.clip(colour(planes, "DiffCol") + colour(planes, "GlossCol"), 0, 1)
    albedo[albedo.max(axis=-1) == 0] = 1
    guides = [name for name in reads if name not in ("radiance", "albedo")]
    return {**quell.exr.read_frame(path, guides, signal="diffuse"), "radiance": colour(planes, "Combined"), "albedo": albedo}


def window_errors(test, reference):
    """The RMSE of each window, as a screen shows them."""
    squares = np.square(quell.metrics.displayed(test).astype(np.float64) - quell.metrics.displayed(reference)).mean(axis=-1)
    sums = np.pad(squares.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    side = min(SIDE, *squares.shape)
    windows = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    return np.sqrt(np.maximum(windows[::STEP, ::STEP], 0) / side**2), float(np.sqrt(squares.mean()))


def good_share(test, alone):
    counts = test >= LEAST
    return (test <= MOST * alone)[counts].tolist()


class Row:
    """Errors over frames."""

    def __init__(self):
        self.errors, self.good, self.good_unchosen, self.worst = [], [], [], 0.0

    def add(self, chosen, alone, history, reference):
        pictures = [window_errors(each, reference) for each in (chosen, alone, history)]
        self.errors.append([rmse for _, rmse in pictures])
        self.good += good_share(pictures[0][0], pictures[1][0])
        self.good_unchosen += good_share(pictures[2][0], pictures[1][0])
        self.worst = max(self.worst, pictures[0][1] / pictures[1][1])

    def __str__(self):
        chosen, alone, history = np.mean(self.errors, axis=0)
        shares = [100 * float(np.mean(each)) if each else 100.0 for each in (self.good, self.good_unchosen)]
        return f"{alone:.4f} | {history:.4f} | {chosen:.4f} | {self.worst:.3f} | {shares[0]:.1f} % ({shares[1]:.1f} %)"


def of_preset(preset, folder, references, samples):
    """What the library makes."""
    paths = sorted(folder.glob("frame_*.exr"))
    height, width = picture_of(paths[0]).shape[:2]
    chosen, history, alone = [quell.Denoiser(preset, (height, width), choose_history=choice) for choice in (samples, 0, 0)]
    row = Row()
    for path in paths:
        if path.name > max(references):
            break
        frame = frame_of(path, chosen.reads)
        pictures = [chosen(frame), history(frame)]
        if path.name in references:
            alone.forget()
            row.add(pictures[0], alone(frame), pictures[1], references[path.name])
    return row


def of_program(program, folder, references):
    row = Row()
    for name, reference in references.items():
        number = name[len("frame_") : -len(".exr")]

        def run(*options):
            with tempfile.TemporaryDirectory() as to:
                command = [program, "--quiet", "--in", folder / "frame_%04d.exr", "--out", f"{to}/%04d.exr", "--frames", number]
                subprocess.run([*command, *options], check=True)
                return picture_of(f"{to}/{number}.exr")

        row.add(run(), run("--warmup", "0", "--extra-frames", "0"), run("--quick"), reference)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--samples", nargs="+", default=["1", "16"])
    parser.add_argument("--presets", nargs="*", default=["general", "final-frame"])
    parser.add_argument("--program")
    options = parser.parse_args()
    print("| scene, samples | | alone | history | chosen | most, chosen / alone | windows |\n| --- | --- | --- | --- | --- | --- | --- |")
    for scene in options.scenes:
        references = {path.name: picture_of(path) for path in sorted((options.folder / scene / "512").glob("frame_*.exr"))}
        for samples in options.samples:
            folder = options.folder / scene / samples
            measured = {name: picture for name, picture in references.items() if (folder / name).exists()}
            if not measured:
                continue
            for preset in options.presets:
                print(f"| {scene}, {samples} | `{preset}` | {of_preset(preset, folder, measured, int(samples))} |", flush=True)
            if options.program:
                print(f"| {scene}, {samples} | `quell-denoise` | {of_program(options.program, folder, measured)} |", flush=True)


if __name__ == "__main__":
    main()
