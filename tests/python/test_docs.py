"""The Python of docs/python.md runs, block after block."""

import contextlib
import io
import os
import pathlib
import re
import tempfile
import unittest

import numpy as np

import quell
from quell import exr
from walls import planes_of, wall

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"


@unittest.skipUnless("general" in quell.presets(), "skipped: docs/python.md, which wants the preset general (QUELL_PRESETS)")
@unittest.skipUnless(exr._exr, "skipped: docs/python.md, as quell was built without OpenEXR (apt install libopenexr-dev)")
class Docs(unittest.TestCase):
    def test_all_blocks(self):
        height, width = 24, 32
        frame = wall(height, width)
        shown = []
        names = {**frame, "rgb": frame["radiance"], "height": height, "width": width, "frames": [frame] * 3, "show": shown.append}
        names["truth"] = np.full((height, width, 3), 0.5, np.float32)
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            here = os.getcwd()
            os.chdir(folder)
            try:
                exr.write("frame.0001.exr", planes_of(frame))
                blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)
                for block in blocks:
                    exec(compile(block, str(PAGE), "exec"), names)
            finally:
                os.chdir(here)
        self.assertGreater(len(blocks), 4)
        self.assertEqual(len(shown), 3)
        self.assertIn("3 of 3", said.getvalue())


if __name__ == "__main__":
    unittest.main()
