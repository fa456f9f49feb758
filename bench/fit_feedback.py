#!/usr/bin/env python3
"""Fits the shares of residual feedback (include/quell/resolve/residual_feedback_fit.hpp) to renders of Blender's Cycles.

    PYTHONPATH=build/release/packaging/python bench/fit_feedback.py FOLDER SCENE... [--samples 1 16] [--frames 37,41]
        [--program build/release/bench/quell-feedback-slopes] [--slopes FOLDER] [--reference 512] [--ridge 0.05] [--no-cross-validation]

A sequence is FOLDER/SCENE/SAMPLES/frame_0001.exr and so on, references are FOLDER/SCENE/512. The program writes how each picture changes with
each share to --slopes (by default FOLDER/slopes), where it is not there yet: about a minute a scene and number of samples at 240x135.

Least squares, iterated. The error is half that of displayed pixels, and half that of what FLIP compares: both pictures blurred as eyes blur
them (a Gaussian), in a colour space of even differences, weighted anew in each round so that squares stand for FLIP's power of .7. Scenes weigh
the same. --ridge pulls towards the shares that the program was compiled with. Prints the shares, and what they give of today's FLIP and RMSE:
for scenes that had no part, by leaving out one at a time, and for those in the fit. Wants apt's python3-numpy and quell's Python module.
"""

import argparse
import subprocess
from pathlib import Path

import numpy as np
import quell

BLUR = 1.03  # pixels: FLIP's filter for brightness at 67 pixels per degree, nearly
PIXELS = 3000  # of each frame that displayed errors are taken of
WHITE = np.array([0.950428545, 1.0, 1.088900371])
XYZ = np.array(
    [[0.412390799, 0.357584339, 0.180480788], [0.212639006, 0.715168679, 0.072192315], [0.019330819, 0.119194780, 0.950532152]]
)


def colours(planes, prefix):
    return np.stack([planes[prefix + letter].astype(np.float32) for letter in "RGB"], axis=-1)


def reference_of(path):
    planes = quell.exr.read(path).planes
    return colours(planes, next(prefix for prefix in ("ViewLayer.Combined.", "") if prefix + "R" in planes))


def displayed(linear):
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055).astype(np.float32)


def slope_of_display(linear):
    return 1.055 / 2.4 * np.clip(linear, 0.003, 1) ** (1 / 2.4 - 1)


def blurred(picture):
    radius = 3
    kernel = np.exp(-(np.arange(-radius, radius + 1) ** 2) / (2 * BLUR * BLUR)).astype(np.float32)
    kernel /= kernel.sum()
    height, width = picture.shape[:2]
    padded = np.pad(picture, ((radius, radius), (radius, radius)) + ((0, 0),) * (picture.ndim - 2), mode="edge")
    rows = sum(kernel[i] * padded[i : i + height] for i in range(2 * radius + 1))
    return sum(kernel[i] * rows[:, i : i + width] for i in range(2 * radius + 1))


def brightness(xyz):
    """CIE's f, before L* is made of it."""
    return np.where(xyz > (6 / 29) ** 3, np.cbrt(np.maximum(xyz, 1e-9)), xyz / (3 * (6 / 29) ** 2) + 4 / 29)


def hunt_lab(linear):
    """L*a*b*, with colours that weigh less in the dark (Hunt), as FLIP compares it."""
    f = brightness(np.clip(linear, 0, 1) @ XYZ.T / WHITE)
    light = 116 * f[..., 1] - 16
    return np.stack([light, 5 * light * (f[..., 0] - f[..., 1]), 2 * light * (f[..., 1] - f[..., 2])], axis=-1)


def hunt_lab_slopes(changes, linear):
    """How that changes. changes: height, width, shares, 3."""
    xyz = np.clip(linear, 0, 1) @ XYZ.T / WHITE
    slope = np.where(xyz > (6 / 29) ** 3, np.maximum(xyz, 1e-4) ** (-2 / 3) / 3, 1 / (3 * (6 / 29) ** 2))
    light = np.maximum(116 * brightness(xyz)[..., 1] - 16, 0)[..., None]
    f = changes @ (XYZ.T / WHITE) * slope[..., None, :]
    return np.stack([116 * f[..., 1], 5 * light * (f[..., 0] - f[..., 1]), 2 * light * (f[..., 1] - f[..., 2])], axis=-1)


class Item:
    """One frame of one scene."""

    def __init__(self, slopes, reference, seed):
        planes = quell.exr.read(slopes).planes
        self.names = sorted({name.rsplit(".", 1)[0] for name in planes if "." in name})
        self.picture, self.reference = colours(planes, ""), reference_of(reference)
        self.changes = np.stack([colours(planes, name + ".") for name in self.names], axis=2)
        self.today = self.errors(np.zeros(len(self.names)))
        self.make_rows(seed)

    def errors(self, step):
        picture = self.picture + np.tensordot(self.changes, step.astype(np.float32), axes=([2], [0]))
        shown, reference = displayed(picture), displayed(self.reference)
        return quell.metrics.flip(reference, shown).mean, quell.metrics.rmse(reference, shown)

    def make_rows(self, seed):
        changes = self.changes * ((self.picture > 0) & (self.picture < 1))[:, :, None]
        reference, picture = np.clip(self.reference, 0, 1), np.clip(self.picture, 0, 1)
        lights = blurred(reference), blurred(picture)
        every = (slice(None, None, 3), slice(None, None, 3))
        self.seen = hunt_lab_slopes(blurred(changes)[every], (0.5 * (lights[0] + lights[1]))[every]).reshape(-1, len(self.names), 3)
        self.seen_error = (hunt_lab(lights[0]) - hunt_lab(lights[1]))[every].reshape(-1, 3)
        pixels = np.random.default_rng(seed).integers(0, picture.shape[0] * picture.shape[1], PIXELS)
        slope = slope_of_display(0.5 * (reference + picture)).reshape(-1, 3)[pixels]
        self.pixels = changes.reshape(-1, len(self.names), 3)[pixels] * slope[:, None]
        self.pixels_error = (displayed(reference) - displayed(picture)).reshape(-1, 3)[pixels]

    def moments(self, step, power=0.7):
        """What is to be added to the normal equations."""
        left = self.seen_error - np.einsum("pkc,k->pc", self.seen, step)
        light, colour = np.abs(left[:, 0]), np.hypot(left[:, 1], left[:, 2])
        both = light + colour
        little = 0.25 * both.mean()
        before = np.abs(self.seen_error[:, 0]) + np.hypot(self.seen_error[:, 1], self.seen_error[:, 2])
        weight = power * (both + little) ** (power - 1) / (before**power).sum() / 2
        weights = np.stack([weight / (light + little), weight / (colour + little), weight / (colour + little)], axis=-1).reshape(-1, 1)
        rows = self.seen.transpose(0, 2, 1).reshape(-1, len(self.names))
        matrix, vector = (rows * weights).T @ rows, (rows * weights).T @ self.seen_error.reshape(-1)
        rows, error = self.pixels.transpose(0, 2, 1).reshape(-1, len(self.names)), self.pixels_error.reshape(-1)
        per_error = 0.5 / (2 * (error @ error))
        return matrix + rows.T @ rows * per_error, vector + rows.T @ error * per_error


def fit(items, ridge, rounds=6):
    """What is to be added to today's shares."""
    step = np.zeros(len(items[0].names))
    for _ in range(rounds):
        moments = [item.moments(step) for item in items]
        matrix = sum(each[0] for each in moments) / len(items)
        vector = sum(each[1] for each in moments) / len(items)
        step = np.linalg.solve(matrix + np.diag(ridge * np.diag(matrix) + 1e-9), vector)
    return step


def gain(items, step):
    """New errors over today's: FLIP, RMSE."""
    return np.exp(np.mean([np.log(item.errors(step)) - np.log(item.today) for item in items], axis=0))


def main():
    parser = argparse.ArgumentParser(description="Fits the shares of residual feedback to renders.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--samples", nargs="+", default=["1", "16"])
    parser.add_argument("--frames", default="37,41")
    parser.add_argument("--program", type=Path, default=Path("build/release/bench/quell-feedback-slopes"))
    parser.add_argument("--slopes", type=Path)
    parser.add_argument("--reference", default="512")
    parser.add_argument("--ridge", type=float, default=0.05)
    parser.add_argument("--no-cross-validation", action="store_true")
    options = parser.parse_args()
    for samples in options.samples:
        items = {}
        for scene in options.scenes:
            frames, to = options.folder / scene / samples, (options.slopes or options.folder / "slopes") / scene / samples
            references = options.folder / scene / options.reference
            if not to.is_dir():
                subprocess.run([options.program, frames / "frame_%04d.exr", samples, options.frames, to], check=True)
            items[scene] = [
                Item(slopes, references / f"frame_{slopes.stem.split('.')[-1]}.exr", seed) for seed, slopes in enumerate(sorted(to.iterdir()))
            ]
        everything = [item for scene in items.values() for item in scene]
        step = fit(everything, options.ridge)
        print(f"\n{samples} samples, to be added to the shares of today:")
        for name, value in zip(everything[0].names, step):
            print(f"    {name:14} {value:+.4f}")
        print("\n| scene | in the fit: FLIP (RMSE) over today's | left out |\n| --- | --- | --- |")
        left_out = []
        for scene, own in items.items():
            row = "| {} | {:.3f} ({:.3f}) |".format(scene, *gain(own, step))
            if not options.no_cross_validation and len(items) > 1:
                rest = [item for other, each in items.items() if other != scene for item in each]
                left_out.append(gain(own, fit(rest, options.ridge)))
                row += " {:.3f} ({:.3f}) |".format(*left_out[-1])
            print(row, flush=True)
        if left_out:
            print("| mean | {:.3f} ({:.3f}) | {:.3f} ({:.3f}) |".format(*gain(everything, step), *np.exp(np.mean(np.log(left_out), axis=0))))


if __name__ == "__main__":
    main()
