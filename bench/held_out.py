#!/usr/bin/env python3
"""Measures quell-denoise on sequences of Blender's Cycles that nothing was chosen by, beside Open Image Denoise's networks.

    /usr/bin/python3 bench/held_out.py FOLDER [SCENE...] [--denoise PROGRAM] [--samples 1 16] [--clean 64 256]
        [--save RESULTS.json] [--before RESULTS.json] [--parts networks real-time history clean]

A sequence is FOLDER/SCENE/SAMPLES/frame_0001.exr and so on; those frames are measured that FOLDER/SCENE/reference has. What the networks
made lies in FOLDER/SCENE/SAMPLES/oidn, by bench/held_out.sh, which renders all of it too. Rows without it say so by a dash.
Prints tables in Markdown: one row a scene and number of samples, the geometric mean last.

networks    FLIP, RMSE and SSIM beside those of both networks, and flicker: the mean over pixels of the standard deviation over the
            measured frames of output less reference, as a screen shows them
real-time   `general --extra-frames 0` beside `final-frame` and `final-frame --extra-frames 0`
history     each frame beside the same frame denoised by itself; and of windows of 25x25 pixels, every fifth one of those whose RMSE is .002 or
            more, the percentage in which the frame has at most 1.05 times the RMSE of the frame by itself
clean       frames of many samples beside the input: the largest ratio of a frame, and which frames are worse than the input

FLIP, RMSE and flicker have the reference's own noise in them, which brings ratios nearer to 1. Where FOLDER/SCENE/half_1 and half_2 are means
of halves of the reference's samples, a table gives the errors without it: the products of differences to one half and to the other have no
noise of the reference in their mean. Flicker is the root of the mean square over pixels there. Wants apt's python3-numpy and
python3-openimageio.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

PARTS = ("networks", "real-time", "history", "clean")
SIDE, STEP, LEAST, MOST = 25, 5, 0.002, 1.05


def displayed(path):
    """The picture as a screen shows it."""
    file = oiio.ImageInput.open(str(path))
    if not file:
        raise SystemExit(f"held_out.py: cannot read {path}")
    names, pixels = file.spec().channelnames, file.read_image(oiio.FLOAT)
    file.close()
    for prefix in ("ViewLayer.Combined.", ""):
        if all(prefix + letter in names for letter in "RGB"):
            rgb = np.clip(pixels[..., [names.index(prefix + letter) for letter in "RGB"]], 0, 1)
            return np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * np.maximum(rgb, 1e-9) ** (1 / 2.4) - 0.055)
    raise SystemExit(f"held_out.py: no picture in {path}")


def window_errors(squares):
    """The RMSE of each window."""
    sums = np.pad(squares.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    side = min(SIDE, *squares.shape)
    windows = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    return np.sqrt(np.maximum(windows[::STEP, ::STEP], 0) / side**2)


class Sequence:
    """One scene at one number of samples."""

    def __init__(self, program, folder, scene, samples):
        self.program, self.at, self.scene, self.samples = program, folder / scene / str(samples), scene, samples
        self.reference, self.read = folder / scene / "reference", {}
        self.halves = [name for name in ("half_1", "half_2") if (folder / scene / name).is_dir()]
        self.frames = [int(path.stem[len("frame_") :]) for path in sorted(self.reference.glob("frame_*.exr"))]
        self.frames = [number for number in self.frames if (self.at / f"frame_{number:04d}.exr").exists()]

    def run(self, source, frames, options):
        """FLIP, RMSE and SSIM of each frame, the difference to the reference in each pixel, and the pictures."""
        with tempfile.TemporaryDirectory() as to:
            command = [self.program, "--quiet", "--in", source, "--out", f"{to}/%04d.exr", "--layers", "picture", "--frames", ",".join(map(str, frames))]
            command += ["--reference", self.reference / "frame_%04d.exr", *options]
            text = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
            rows = [line.split(",") for line in text.splitlines()]
            scores = {int(row[0]): {"rmse": float(row[1]), "ssim": float(row[2]), "flip": float(row[3])} for row in rows if row[0].isdigit()}
            pictures = np.stack([displayed(f"{to}/{number:04d}.exr") for number in frames])
        return scores, pictures - self.reference_of("reference", frames), pictures

    def reference_of(self, name, frames):
        if name not in self.read:
            self.read[name] = {number: displayed(self.reference.parent / name / f"frame_{number:04d}.exr") for number in self.frames}
        return np.stack([self.read[name][number] for number in frames])

    def measure(self, *options, source=None, frames=None):
        source, frames = source or self.at / "frame_%04d.exr", frames or self.frames
        scores, errors, pictures = self.run(source, frames, options)
        result = {name: float(np.mean([scores[number][name] for number in frames])) for name in ("flip", "rmse", "ssim")}
        result["frames"] = {str(number): scores[number] for number in frames}
        if len(frames) > 1:
            result["flicker"] = float(errors.std(axis=0).mean())
        if len(frames) > 1 and len(self.halves) == 2:
            first, second = (pictures - self.reference_of(name, frames) for name in self.halves)
            result["clean_rmse"] = float(np.sqrt(max((first * second).mean(), 0)))
            first, second = first - first.mean(axis=0), second - second.mean(axis=0)
            result["clean_flicker"] = float(np.sqrt(max((first * second).mean() * len(frames) / (len(frames) - 1), 0)))
        return result, errors

    def network(self, kind):
        """What a network made, or None."""
        if not all((self.at / "oidn" / f"{kind}_{number:04d}.exr").exists() for number in self.frames):
            return None
        return self.measure("--preset", "none", source=self.at / "oidn" / f"{kind}_%04d.exr")[0]

    def history(self, quell, errors):
        """How far frames have more error than by themselves, and the part of windows that don't."""
        ratios, good = {}, []
        for number, error in zip(self.frames, errors):
            alone, (own,) = self.measure("--warmup", "0", "--extra-frames", "0", frames=[number])
            ratios[str(number)] = quell["frames"][str(number)]["rmse"] / alone["rmse"]
            test, other = (window_errors(np.square(each).mean(axis=-1)) for each in (error, own))
            good += (test <= MOST * other)[test >= LEAST].tolist()
        return {"ratios": ratios, "windows": 100 * float(np.mean(good)) if good else 100.0}


def measured(options):
    """Everything, by scene and number of samples."""
    results = {}
    for scene in options.scenes:
        for samples in sorted({*options.samples, *(options.clean if "clean" in options.parts else [])}):
            sequence = Sequence(options.denoise, options.folder, scene, samples)
            if not sequence.frames:
                continue
            found = results[f"{scene}, {samples}"] = {"scene": scene, "samples": samples, "frames": sequence.frames}
            found["input"] = sequence.measure("--preset", "none")[0]
            found["quell"], errors = sequence.measure()
            if samples not in options.samples:
                continue
            if "networks" in options.parts:
                found["base"], found["large"] = sequence.network("base"), sequence.network("large")
            if "real-time" in options.parts:
                found["general_now"] = sequence.measure("--preset", "general", "--extra-frames", "0")[0]
                found["final_now"] = sequence.measure("--preset", "final-frame", "--extra-frames", "0")[0]
            if "history" in options.parts:
                found["history"] = sequence.history(found["quell"], errors)
    return results


def table(head, rows):
    print("\n| " + " | ".join(head) + " |\n|" + " --- |" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")


def pair(one):
    return f"{one['flip']:.4f} ({one['rmse']:.4f})" if one else "-"


def mean(numbers):
    return float(np.exp(np.mean(np.log(numbers)))) if numbers else float("nan")


def with_mean(rows, columns, title="geometric mean"):
    """Rows of a name, texts and numbers; the last row is of the numbers' means."""
    texts = [[name, *said, *(f"{number:.3f}" if number else "-" for number in numbers)] for name, said, numbers in rows]
    if rows:
        means = [mean([numbers[i] for _, _, numbers in rows if numbers[i]]) for i in range(len(columns))]
        texts.append([title, *([""] * len(rows[0][1])), *(f"{number:.3f}" for number in means)])
    return texts


def print_networks(results):
    rows = []
    for name, found in results.items():
        if "large" not in found:
            continue
        quell, base, large = found["quell"], found["base"], found["large"]
        ratios = [None] * 4
        if large:
            best = min(large["rmse"], base["rmse"]) if base else large["rmse"]
            ratios = [quell["flip"] / large["flip"], quell["rmse"] / large["rmse"], quell["rmse"] / best, quell["flicker"] / large["flicker"]]
        said = [pair(found["input"]), pair(quell), pair(base), pair(large), " / ".join(f"{each['ssim']:.3f}" if each else "-" for each in (quell, large))]
        said.append(" / ".join(f"{each['flicker']:.4f}" if each else "-" for each in (quell, large)))
        rows.append((name, said, ratios))
    columns = ["FLIP, over large", "RMSE, over large", "RMSE, over the better", "flicker, over large"]
    table(["FLIP (RMSE)", "input", "`quell-denoise`", "base", "large", "SSIM, large's", "flicker, large's", *columns], with_mean(rows, columns))


def print_without_noise(results):
    rows = []
    for name, found in results.items():
        quell, large = found["quell"], found.get("large")
        if "clean_rmse" not in quell or not large:
            continue
        better = min(each["clean_rmse"] for each in (large, found["base"] or large))
        said = [" / ".join(f"{each[what]:.4f}" for each in (found["input"], quell, found["base"] or large, large)) for what in ("clean_rmse", "clean_flicker")]
        rows.append((name, [said[0], said[1]], [quell["clean_rmse"] / better, quell["clean_flicker"] / large["clean_flicker"]]))
    if rows:
        table(["without the reference's noise", "RMSE: input / `quell-denoise` / base / large", "flicker, the same", "RMSE, over the better", "flicker, over large"], with_mean(rows, ["", ""]))


def print_real_time(results):
    rows = []
    for name, found in results.items():
        if "general_now" in found:
            now, final, final_now = found["general_now"], found["quell"], found["final_now"]
            rows.append((name, [pair(now), pair(final), pair(final_now)], [now[what] / over[what] for over in (final, final_now) for what in ("flip", "rmse")]))
    columns = ["FLIP, over `final-frame`", "RMSE", "FLIP, over the same without later frames", "RMSE"]
    table(["FLIP (RMSE)", "`general --extra-frames 0`", "`final-frame`", "`final-frame --extra-frames 0`", *columns], with_mean(rows, columns))


def print_history(results):
    rows = []
    for name, found in results.items():
        if "history" in found:
            ratios = found["history"]["ratios"]
            worse = [f"{number} ({ratio:.3f})" for number, ratio in ratios.items() if ratio > 1]
            rows.append([name, f"{max(ratios.values()):.3f}", " ".join(worse) or "none", f"{found['history']['windows']:.1f}"])
    table(["RMSE over that of the frame by itself", "most", "frames that are worse", "good windows, percent"], rows)


def print_clean(results, counts):
    rows = []
    for name, found in results.items():
        if found["samples"] in counts:
            ratios = {number: [found["quell"]["frames"][number][what] / found["input"]["frames"][number][what] for what in ("flip", "rmse")] for number in found["quell"]["frames"]}
            worse = [f"{number} ({flip:.3f}, {rmse:.3f})" for number, (flip, rmse) in ratios.items() if max(flip, rmse) > 1]
            rows.append([name, pair(found["input"]), pair(found["quell"]), *(f"{max(each[i] for each in ratios.values()):.3f}" for i in (0, 1)), " ".join(worse) or "none"])
    table(["FLIP (RMSE)", "input", "`quell-denoise`", "most, FLIP over input's", "RMSE", "frames that are worse (FLIP, RMSE)"], rows)


def print_before(results, before):
    rows = []
    for name, found in results.items():
        for row, title in (("quell", "`quell-denoise`"), ("general_now", "`general --extra-frames 0`"), ("final_now", "`final-frame --extra-frames 0`")):
            if row in found and before.get(name, {}).get(row):
                old, new = before[name][row], found[row]
                rows.append((f"{title}, {name}", [pair(old), pair(new)], [new[what] / old[what] for what in ("flip", "rmse", "flicker")]))
    rows.sort(key=lambda row: row[0].split(",")[0])
    columns = ["FLIP, over before", "RMSE", "flicker"]
    for title in sorted({row[0].split(",")[0] for row in rows}):
        of_title = [row for row in rows if row[0].startswith(title + ",")]
        table(["FLIP (RMSE)", "before", "now", *columns], with_mean(of_title, columns))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--denoise", default="build/release/examples/denoise/quell-denoise")
    parser.add_argument("--samples", nargs="*", type=int, default=[1, 16])
    parser.add_argument("--clean", nargs="*", type=int, default=[64, 256])
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--save", type=Path, help="writes all that was measured")
    parser.add_argument("--before", type=Path, help="what --save wrote of another program, to compare with")
    options = parser.parse_args()
    options.scenes = options.scenes or sorted(path.parent.name for path in options.folder.glob("*/reference"))
    results = measured(options)
    if options.save:
        options.save.write_text(json.dumps(results, indent=1))
    if "networks" in options.parts:
        print_networks(results)
        print_without_noise(results)
    if "real-time" in options.parts:
        print_real_time(results)
    if "history" in options.parts:
        print_history(results)
    if "clean" in options.parts:
        print_clean(results, options.clean)
    if options.before:
        print_before(results, json.loads(options.before.read_text()))


if __name__ == "__main__":
    main()
