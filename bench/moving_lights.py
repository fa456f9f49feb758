#!/usr/bin/env python3
"""Writes two glTF scenes in which light moves and surfaces stay, which a history of light is worst at, for quell-trace.

    bench/moving_lights.py FOLDER        writes FOLDER/loft.gltf and FOLDER/bar.gltf, for instance to:
    quell-trace --scene FOLDER/loft.gltf --eye 0.9,1.5,2.6 --target 0.1,.95,-1.6 --fov 46 --size 240x135 --jitter pixel --spp 16 --out OUT
    quell-trace --scene FOLDER/bar.gltf --eye 0.3,1.6,2.9 --target 0,1.15,-1.4 --fov 50 --size 240x135 --jitter pixel --spp 16 --out OUT

loft: a lamp with a shade swings before a wall, behind a railing whose shadows sweep walls and floor. bar: a sign goes out and on again, a fan
turns below a lamp, and someone sways. References are best rendered one frame at a time (--first 38 --frames 1 --reference 144 --seed 7).
Wants apt's python3-numpy.
"""

import argparse
import base64
import json
import math
from pathlib import Path

import numpy as np

FRAMES, FRAMES_PER_SECOND = 64, 24


def box():
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, [triangle for a, b, c, d in sides for triangle in ((a, b, c), (a, c, d))]


def cone(top, sides, closed):
    """Around the y axis: of radius 1 at the bottom and `top` at the top."""
    points, triangles = [], []
    for i in range(sides):
        x, z = math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)
        points += [(x, -1, z), (top * x, 1, top * z)]
        a, b = 2 * i, 2 * ((i + 1) % sides)
        triangles += [(a, a + 1, b + 1), (a, b + 1, b)]
    for i in range(1, sides - 1) if closed else ():
        triangles += [(0, 2 * i, 2 * i + 2), (1, 2 * i + 3, 2 * i + 1)]
    return points, triangles


def ball(around=8, rings=5):
    points = [(0, 1, 0)]
    for ring in range(1, rings):
        for i in range(around):
            down, turn = math.pi * ring / rings, 2 * math.pi * i / around
            points.append((math.sin(down) * math.cos(turn), math.cos(down), math.sin(down) * math.sin(turn)))
    points.append((0, -1, 0))
    last, pairs = len(points) - 1, [(i, (i + 1) % around) for i in range(around)]
    triangles = [(0, 1 + k, 1 + i) for i, k in pairs]
    for a in range(1, 1 + (rings - 2) * around, around):
        b = a + around
        triangles += [triangle for i, k in pairs for triangle in ((a + i, a + k, b + k), (a + i, b + k, b + i))]
    triangles += [(last, last - around + i, last - around + k) for i, k in pairs]
    return points, triangles


def turned(axis, angle):
    return [*(math.sin(angle / 2) * np.array(axis)), math.cos(angle / 2)]


def product(a, b):
    """Of quaternions x, y, z, w."""
    (*v, s), (*w, t) = a, b
    v, w = np.array(v), np.array(w)
    return [*(s * w + t * v + np.cross(v, w)), s * t - v @ w]


class Scene:
    def __init__(self):
        self.data, self.roots = bytearray(), []
        self.lists = {name: [] for name in ("nodes", "meshes", "materials", "accessors", "bufferViews")}
        self.animation = {"samplers": [], "channels": []}
        self.shapes = {
            "box": self.shape(*box()),
            "cylinder": self.shape(*cone(1, 10, True)),
            "shade": self.shape(*cone(0.4, 12, False)),
            "ball": self.shape(*ball()),
        }

    def append(self, name, item):
        self.lists[name].append(item)
        return len(self.lists[name]) - 1

    def accessor(self, values, kind):
        self.data.extend(bytes(-len(self.data) % 4))
        view = self.append("bufferViews", {"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes})
        self.data.extend(values.tobytes())
        flat = values.reshape(len(values), -1)
        bounds = {"min": flat.min(axis=0).tolist(), "max": flat.max(axis=0).tolist()}
        component = 5126 if values.dtype == np.float32 else 5125
        return self.append("accessors", {"bufferView": view, "componentType": component, "count": len(values), "type": kind, **bounds})

    def shape(self, points, triangles):
        corners = np.array(points, np.float32)[np.array(triangles)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
        positions, normals = corners.reshape(-1, 3), np.repeat(normals, 3, axis=0).astype(np.float32)
        indices = self.accessor(np.arange(len(positions), dtype=np.uint32), "SCALAR")
        return {"attributes": {"POSITION": self.accessor(positions, "VEC3"), "NORMAL": self.accessor(normals, "VEC3")}, "indices": indices}

    def material(self, colour, rough=0.7, emission=0.0):
        surface = {"baseColorFactor": [*colour, 1], "roughnessFactor": rough, "metallicFactor": 0}
        made = {"pbrMetallicRoughness": surface, "doubleSided": True}
        if emission:
            made["emissiveFactor"] = list(colour)
            made["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": emission}}
        return self.append("materials", made)

    def node(self, at, shape=None, material=0, scale=(1, 1, 1), turn=(0, 0, 0, 1), parent=None):
        made = {name: [float(x) for x in value] for name, value in (("translation", at), ("scale", scale), ("rotation", turn))}
        if shape:
            made["mesh"] = self.append("meshes", {"primitives": [{**self.shapes[shape], "material": material}]})
        number = self.append("nodes", made)
        (self.roots if parent is None else self.lists["nodes"][parent].setdefault("children", [])).append(number)
        return number

    def animate(self, node, path, at_frame, steps=False):
        times = self.accessor(np.arange(FRAMES, dtype=np.float32) / FRAMES_PER_SECOND, "SCALAR")
        values = self.accessor(np.array([at_frame(f) for f in range(FRAMES)], np.float32), "VEC4" if path == "rotation" else "VEC3")
        self.animation["samplers"].append({"input": times, "output": values, "interpolation": "STEP" if steps else "LINEAR"})
        target = {"node": node, "path": path}
        self.animation["channels"].append({"sampler": len(self.animation["samplers"]) - 1, "target": target})

    def room(self, back, left, floor):
        self.node((0, -0.05, 0), "box", floor, (4, 0.05, 4))
        self.node((0, 1.5, -3.05), "box", back, (4, 1.6, 0.05))
        self.node((-3.05, 1.5, 0), "box", left, (0.05, 1.6, 4))
        self.node((3.05, 1.5, 0), "box", self.material((0.6, 0.55, 0.5), 0.9), (0.05, 1.6, 4))
        self.node((0, 3.1, 0), "box", self.material((0.7, 0.7, 0.7), 0.9), (4, 0.05, 4))

    def write(self, path):
        uri = "data:application/octet-stream;base64," + base64.b64encode(bytes(self.data)).decode()
        head = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_materials_emissive_strength"]}
        head |= {"scene": 0, "scenes": [{"nodes": self.roots}]}
        body = {"buffers": [{"byteLength": len(self.data), "uri": uri}], "animations": [self.animation]}
        path.write_text(json.dumps({**head, **self.lists, **body}))


def loft():
    s = Scene()
    s.room(s.material((0.7, 0.64, 0.55), 0.9), s.material((0.6, 0.42, 0.38), 0.9), s.material((0.42, 0.3, 0.2), 0.6))
    bars = s.material((0.75, 0.72, 0.68), 0.5)
    for i in range(18):
        s.node((-2.2 + 0.27 * i, 0.52, -1), "cylinder", bars, (0.025, 0.5, 0.025))
    s.node((0.2, 1.05, -1), "box", s.material((0.35, 0.2, 0.12), 0.4), (2.5, 0.04, 0.05))
    for i, colour in enumerate(((0.4, 0.25, 0.12), (0.3, 0.35, 0.3), (0.55, 0.5, 0.4), (0.25, 0.3, 0.45))):
        s.node((-1.9 + 1.2 * i, 0.3, -2.2 + 0.25 * (i % 2)), "box", s.material(colour), (0.35, 0.3, 0.28), turned((0, 1, 0), 0.3 * i))
    for i in range(6):
        turn = turned((0, 0, 1), 0.2 * i - 0.4)
        s.node((0.9 + 0.25 * i, 1.9, -2.5), "cylinder", s.material((0.6, 0.5, 0.3), 0.4), (0.02, 0.4, 0.02), turn)
    for i, colour in enumerate(((0.7, 0.6, 0.5), (0.5, 0.6, 0.5), (0.6, 0.4, 0.4))):
        s.node((-1.2 + 0.9 * i, 0.35, 0.2 + 0.2 * i), "ball", s.material(colour, 0.4), (0.35, 0.35, 0.35))
    pivot = s.node((0.1, 2.9, -1.9))
    s.node((0, -1.45, 0), "ball", s.material((1, 0.8, 0.5), emission=260), (0.06, 0.06, 0.06), parent=pivot)
    s.node((0, -1.3, 0), "shade", s.material((0.2, 0.45, 0.35), 0.4), (0.24, 0.15, 0.24), parent=pivot)
    s.node((0, -0.6, 0), "cylinder", s.material((0.05, 0.05, 0.05)), (0.012, 0.55, 0.012), parent=pivot)
    sideways, forwards = (lambda f: turned((0, 0, 1), 0.62 * math.sin(0.36 * f))), (lambda f: turned((1, 0, 0), 0.1 * math.sin(0.31 * f)))
    s.animate(pivot, "rotation", lambda f: product(sideways(f), forwards(f)))
    s.node((2.9, 2.6, 0.5), "box", s.material((0.4, 0.5, 1), emission=1.5), (0.02, 0.2, 0.4))
    return s


def bar():
    s = Scene()
    s.room(s.material((0.6, 0.62, 0.66)), s.material((0.45, 0.5, 0.4), 0.9), s.material((0.6, 0.58, 0.55), 0.35))
    s.node((-0.4, 0.55, -1.6), "box", s.material((0.3, 0.13, 0.08), 0.35), (1.8, 0.55, 0.35))
    for i in range(6):
        s.node((-1.9 + 0.65 * i, 0.35, -0.8), "cylinder", s.material(((0.6, 0.1, 0.1), (0.15, 0.3, 0.5))[i % 2], 0.4), (0.17, 0.35, 0.17))
    for i in range(10):
        glass = s.material(((0.2, 0.5, 0.25), (0.6, 0.4, 0.15), (0.5, 0.55, 0.6))[i % 3], 0.2)
        s.node((-2 + 0.33 * i, 1.27, -1.75), "cylinder", glass, (0.05, 0.17, 0.05))
    lit, out = np.array((0.14, 0.2, 0.03)), np.array((0.0014, 0.002, 0.003))
    sign = s.material((1, 0.15, 0.12), emission=22)
    for i in range(4):
        letter = s.node((-1.7 + 0.42 * i, 2.1, -2.93), "box", sign, lit)
        s.animate(letter, "scale", lambda f: out if f % 11 in (2, 4, 8) else lit, steps=True)
    steady = s.material((0.15, 0.4, 1), emission=9)
    for i in range(3):
        s.node((1.1 + 0.4 * i, 1.9, -2.93), "box", steady, (0.13, 0.3, 0.02))
    fan = s.node((0.5, 2.45, -0.9))
    for i in range(4):
        arm = s.node((0, 0, 0), turn=turned((0, 1, 0), i * math.pi / 2), parent=fan)
        s.node((0.42, 0, 0), "box", s.material((0.5, 0.4, 0.3), 0.5), (0.36, 0.01, 0.1), parent=arm)
    s.animate(fan, "rotation", lambda f: turned((0, 1, 0), 0.22 * f))
    s.node((0.5, 2.85, -0.9), "box", s.material((1, 0.9, 0.75), emission=14), (0.22, 0.02, 0.22))
    head = s.node((0.5, 1.15, -0.7), "ball", s.material((0.75, 0.6, 0.5), 0.5), (0.28, 0.34, 0.28))
    s.animate(head, "translation", lambda f: (0.5 + 0.15 * math.sin(0.3 * f), 1.15, -0.7))
    return s


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for make in (loft, bar):
        make().write(folder / f"{make.__name__}.gltf")


if __name__ == "__main__":
    main()
