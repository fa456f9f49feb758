"""quell.shaders."""

import json
import pathlib
import struct
import tempfile
import unittest

import quell
from quell import shaders


class Shaders(unittest.TestCase):
    def setUp(self):
        if not shaders.presets():
            self.skipTest("skipped: quell was built without a preset that can be recorded (QUELL_PRESETS)")
        self.preset = shaders.presets()[0]

    def test_the_plan_names_all_texts(self):
        for language in shaders.languages():
            plan, texts = shaders.record(self.preset, language)
            self.assertEqual(plan["name"], self.preset)
            named = [each[kind] for each in plan["passes"] for kind in ("shader", "first") if kind in each]
            self.assertEqual(sorted(texts), sorted(named))
            self.assertTrue(all(plan["entry_point"] in text for text in texts.values()))

    def test_a_folder_has_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            to = pathlib.Path(folder) / "new" / "shaders"
            shaders.write(self.preset, to, language="glsl")
            plan, texts = shaders.record(self.preset, "glsl")
            self.assertEqual(sorted(path.name for path in to.iterdir()), sorted([*texts, "plan.json"]))
            self.assertEqual(json.loads((to / "plan.json").read_text()), plan)
            for name, text in texts.items():
                self.assertEqual((to / name).read_text(), text)

    def test_options(self):
        plain, more = shaders.record(self.preset), shaders.record(self.preset, counts=True, fill_holes=2, most_slots=2)
        self.assertEqual(len(more.plan["passes"]), len(plain.plan["passes"]) + 4)
        self.assertNotIn("counts", plain.plan)
        self.assertEqual(more.plan["counts"][0]["what"], "missing samples")
        self.assertLessEqual(max(each["slots"] for each in more.plan["buffers"]), 2)
        half = shaders.record(self.preset, "glsl", half_precision=True, texel_loads=True, workgroup=(32, 2))
        self.assertEqual(half.plan["workgroup"], [32, 2])
        with self.assertRaisesRegex(quell.Error, "options.workgroup_width, workgroup_height: -1x2"):
            shaders.record(self.preset, workgroup=(-1, 2))
        with self.assertRaisesRegex(quell.Error, "options.fill_holes: -1"):
            shaders.record(self.preset, fill_holes=-1)

    def test_the_block_lies_as_the_plan_says(self):
        made = shaders.record(self.preset)
        offsets = {member["name"]: member["offset"] for member in made.plan["uniforms"]["members"]}
        view = [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, -7], [0, 0, 0, 1]]
        projection = [[2, 0, 0, 0], [0, 3, 0, 0], [0, 0, -1, -0.5], [0, 0, -1, 0]]
        now, then = (quell.Camera(view, projection, jitter) for jitter in ((0.25, -0.5), (0.5, 0)))
        block = made.block((40, 60), 9, camera=now, camera_then=then, shutter=0.25)

        def numbers(name, kind, count):
            return struct.unpack_from(f"<{count}{kind}", block, offsets[name])

        self.assertEqual(len(block), made.plan["uniforms"]["bytes"])
        self.assertEqual(numbers("size", "i", 3), (60, 40, 9))
        self.assertEqual(numbers("jitter", "f", 4), (0.25, -0.5, 0.5, 0))
        self.assertEqual(numbers("shutter", "f", 2), (0.25, 0.25))
        # Column by column: what the right, up, back and origin of the world become.
        self.assertEqual(numbers("clip_from_world", "f", 16), (2, 0, 0, 0, 0, 3, 0, 0, 0, 0, -1, -1, 10, 18, 6.5, 7))
        with self.assertRaisesRegex(quell.Error, "frame.width, frame.height: 0x40"):
            made.block((40, 0), 0)
        with self.assertRaisesRegex(quell.Error, "camera: it is a list"):
            made.block((40, 60), 0, camera=[])

    def test_what_is_wrong(self):
        with self.assertRaisesRegex(quell.Error, "no 'nothing'") as caught:
            shaders.record("nothing")
        self.assertEqual(caught.exception.status, quell.Status.UNKNOWN_PRESET)
        with self.assertRaisesRegex(quell.Error, "give one of: wgsl, glsl"):
            shaders.record(self.preset, "cuda")
        with self.assertRaisesRegex(quell.Error, "quell-shaders") as caught:
            shaders.record(self.preset, "metal")
        self.assertEqual(caught.exception.status, quell.Status.NOT_SUPPORTED)


if __name__ == "__main__":
    unittest.main()
