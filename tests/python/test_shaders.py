"""quell.shaders."""

import json
import pathlib
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
