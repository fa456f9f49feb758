"""quell.exr."""

import pathlib
import tempfile
import unittest

import numpy as np

import quell
from quell import exr
from walls import planes_of, same_bits, wall

HEIGHT, WIDTH = 20, 30
@unittest.skipUnless(exr._exr, "skipped: quell was built without OpenEXR (apt install libopenexr-dev)")
class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "frame.exr"

    def test_planes_and_attributes_come_back(self):
        random = np.random.default_rng(1)
        planes = {
            "R": random.random((HEIGHT, WIDTH)).astype(np.float16),
            "depth.Z": random.random((HEIGHT, WIDTH), np.float32)[::-1],
            "instance.ID": random.integers(0, 1000, (HEIGHT, WIDTH)).astype(np.uint32),
        }
        projection = np.arange(16, dtype=np.float32).reshape(4, 4)
        attributes = {"owner": "Jørgen", "take": 3, "gain": 0.5, "quell:jitter": (0.25, -0.5), "quell:projection": projection}
        exr.write(self.path, planes, attributes)
        found = exr.read(self.path)
        self.assertEqual(list(found.planes), sorted(planes))
        for name, plane in planes.items():
            self.assertTrue(same_bits(found.planes[name], plane), name)
        for name, value in attributes.items():
            self.assertTrue(np.array_equal(found.attributes[name], value), name)
        self.assertEqual(list(exr.read(str(self.path), ["R"]).planes), ["R"])

    def test_pictures_are_written_by_letters(self):
        picture = wall(HEIGHT, WIDTH)["radiance"]
        exr.write(self.path, {"": picture, "denoised": picture[..., ::-1]})
        found = exr.read(self.path).planes
        self.assertEqual(sorted(found), ["B", "G", "R", "denoised.B", "denoised.G", "denoised.R"])
        self.assertTrue(same_bits(found["R"], picture[..., 0]) and same_bits(found["denoised.R"], picture[..., 2]))

    def test_a_frame_is_what_a_denoiser_takes(self):
        frame = wall(HEIGHT, WIDTH)
        view, projection = np.eye(4, dtype=np.float32), np.float32([[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, -2], [0, 0, -1, 0]])
        view[0, 3] = 7
        exr.write(self.path, planes_of(frame), {"quell:view": view, "quell:projection": projection, "quell:shutter": 0.25})
        read = exr.read_frame(self.path)
        self.assertEqual(sorted(read), sorted([*frame, "camera", "shutter"]))
        for name in frame:
            self.assertTrue(same_bits(read[name], frame[name]), name)
        self.assertTrue(np.array_equal(read["camera"].view, view) and np.array_equal(read["camera"].projection, projection))
        self.assertEqual(read["shutter"], 0.25)
        denoiser, other = (quell.Denoiser("svgf", (HEIGHT, WIDTH)) for _ in range(2))
        self.assertTrue(same_bits(denoiser(read), other(frame)))
        self.assertEqual(list(exr.read_frame(self.path, ["depth"])), ["depth", "camera", "shutter"])

    def test_channels_are_written_by_the_names_that_are_read(self):
        frame = {**wall(HEIGHT, WIDTH), "instance": np.arange(HEIGHT * WIDTH, dtype=np.uint32).reshape(HEIGHT, WIDTH)}
        for picture in ("", "radiance"):
            exr.write(self.path, {picture if name == "radiance" else name: value for name, value in frame.items()})
            self.assertEqual(sorted(exr.read(self.path).planes), sorted([*planes_of(wall(HEIGHT, WIDTH)), "instance.ID"]))
            read = exr.read_frame(self.path)
            self.assertEqual(sorted(read), sorted(frame))
            for name in frame:
                self.assertTrue(np.array_equal(read[name], frame[name]), name)
        exr.write(self.path, {"depth": frame["depth"][..., np.newaxis], "motion.X": frame["depth"], "other": frame["depth"]})
        self.assertEqual(sorted(exr.read(self.path).planes), ["depth.Z", "motion.X", "other"])

    def test_names_of_others(self):
        frame = wall(HEIGHT, WIDTH)
        planes = planes_of(frame)
        planes["Z"] = planes.pop("depth.Z")
        exr.write(self.path, planes)
        with self.assertRaisesRegex(quell.Error, "depth.Z.*it has: .*Z"):
            exr.read_frame(self.path, ["depth"])
        self.assertTrue(same_bits(exr.read_frame(self.path, ["depth"], names={"depth": "Z"})["depth"], frame["depth"]))
        with self.assertRaisesRegex(quell.Error, "motion.*1 components.*2"):
            exr.read_frame(self.path, names={"motion": ["Z"]})

    def test_names_of_blender(self):
        frame = wall(HEIGHT, WIDTH)
        depth = frame["depth"].copy()
        depth[0, 0] = 1e10
        planes = {"ViewLayer.Depth.Z": depth}
        for letter, c in zip("XY", range(2)):
            planes[f"ViewLayer.Vector.{letter}"] = frame["motion"][..., c]
        for letter, c in zip("RGB", range(3)):
            for light in ("DiffDir", "GlossDir"):
                planes[f"ViewLayer.{light}.{letter}"] = frame["radiance"][..., c]
        exr.write(self.path, planes)
        self.assertEqual(exr.signals(self.path), ["diffuse", "glossy"])
        with self.assertRaisesRegex(quell.Error, "several signals.*diffuse, glossy"):
            exr.read_frame(self.path)
        with self.assertRaisesRegex(quell.Error, "'volume'.*diffuse, glossy"):
            exr.read_frame(self.path, signal="volume")
        read = exr.read_frame(self.path, quell.Denoiser("svgf", (HEIGHT, WIDTH)).reads, signal="glossy")
        self.assertTrue(np.isinf(read["depth"][0, 0]) and read["depth"][1, 1] == depth[1, 1])
        self.assertTrue(np.array_equal(read["motion"], frame["motion"] * (1, -1)))
        self.assertTrue(np.all(read["albedo"] == 1))

    def test_what_is_refused(self):
        plane = np.zeros((HEIGHT, WIDTH), np.float32)
        exr.write(self.path, planes_of(wall(HEIGHT, WIDTH)))
        for words, call in (
            ("nowhere.exr", lambda: exr.read("nowhere.exr")),
            ("no channel 'X'.*it has: ", lambda: exr.read(self.path, ["X"])),
            ("channel 'colour'.*channels.md", lambda: exr.read_frame(self.path, ["colour"])),
            ("plane 'R'.*float64", lambda: exr.write(self.path, {"R": plane.astype(float)})),
            ("plane 'R'.*shape", lambda: exr.write(self.path, {"R": plane[0]})),
            ("plane 'G'.*shape", lambda: exr.write(self.path, {"R": plane, "G": plane[1:]})),
            ("plane 'motion'.*2 components: motion.X, motion.Y", lambda: exr.write(self.path, {"motion": plane[..., np.newaxis]})),
            ("plane 'other'.*shape", lambda: exr.write(self.path, {"other": np.zeros((HEIGHT, WIDTH, 2), np.float32)})),
            ("no planes", lambda: exr.write(self.path, {})),
            ("size is 30x0", lambda: exr.write(self.path, {"R": plane[:0]})),
            ("2\\^24", lambda: exr.write(self.path, {"R": np.full((2, 2), 1 << 30, np.uint32)})),
            ("attribute 'a'", lambda: exr.write(self.path, {"R": plane}, {"a": {}})),
            ("nowhere", lambda: exr.write("/nowhere/frame.exr", {"R": plane})),
        ):
            with self.subTest(words), self.assertRaisesRegex(quell.Error, words):
                call()
        self.assertIn("R", exr.read(self.path).planes)  # the file is as it was


if __name__ == "__main__":
    unittest.main()
