#!/usr/bin/env python3
"""Prints what light given back gains: FLIP and RMSE of presets without it and with it, and the processors' milliseconds per frame.

    PYTHONPATH=build/release/packaging/python bench/give_back.py FOLDER SCENE...
        [--samples 1 16] [--presets general final-frame] [--later-frames 0] [--choose-history]

Sequences and references are those of bench/history_choice.py, and the picture is denoised as one signal as there, in real time:
Denoiser(preset, give_back=SAMPLES). --later-frames N denoises each frame with those after it too, --choose-history with its history and without.
"""

import argparse
import time
from pathlib import Path

import numpy as np
import quell
from history_choice import frame_of, picture_of


def row_of(preset, frames, references, samples, options):
    """Mean FLIP, RMSE and milliseconds."""
    size = next(iter(references.values())).shape[:2]
    denoiser = quell.Denoiser(
        preset, size, give_back=samples, two_sided=options.later_frames > 0, choose_history=options.history * options.choose_history
    )
    names, scores, taken = list(frames), [], 0.0
    for i, name in enumerate(names):
        begin = time.process_time()
        picture = denoiser(frames[name], later=[frames[each] for each in names[i + 1 : i + 1 + options.later_frames]])
        taken += time.process_time() - begin
        if name in references:
            shown = quell.metrics.displayed(references[name]), quell.metrics.displayed(picture)
            scores.append((quell.metrics.flip(*shown).mean, quell.metrics.rmse(*shown)))
    return (*np.mean(scores, axis=0), 1000 * taken / len(names))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--samples", nargs="+", type=int, default=[1, 16])
    parser.add_argument("--presets", nargs="+", default=["general", "final-frame"])
    parser.add_argument("--later-frames", type=int, default=0)
    parser.add_argument("--choose-history", action="store_true")
    options = parser.parse_args()
    print("| FLIP (RMSE) | " + " | ".join(f"`{preset}` | light given back" for preset in options.presets) + " |")
    print("| --- |" + " --- |" * (2 * len(options.presets)))
    milliseconds = []
    for scene in options.scenes:
        for samples in options.samples:
            options.history = samples
            folder = options.folder / scene / str(samples)
            references = {path.name: picture_of(path) for path in sorted((options.folder / scene / "512").glob("frame_*.exr"))}
            references = {name: picture for name, picture in references.items() if (folder / name).exists()}
            if not references:
                continue
            paths = sorted(folder.glob("frame_*.exr"))
            last = [path.name for path in paths].index(max(references)) + 1
            reads = quell.Denoiser("final-frame", (1, 1)).reads
            frames = {path.name: frame_of(path, reads) for path in paths[: last + options.later_frames]}
            rows = [row_of(preset, frames, references, count, options) for preset in options.presets for count in (0, samples)]
            milliseconds.append([row[2] for row in rows])
            print(f"| `{scene}`, {samples} | " + " | ".join(f"{flip:.4f} ({rmse:.4f})" for flip, rmse, _ in rows) + " |", flush=True)
    print("| ms per frame of a processor | " + " | ".join(f"{each:.0f}" for each in np.median(milliseconds, axis=0)) + " |")


if __name__ == "__main__":
    main()
