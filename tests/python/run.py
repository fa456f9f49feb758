"""Runs all tests beside it. Status 77, after one line, where NumPy is missing."""

import pathlib
import sys
import unittest

try:
    import numpy  # noqa: F401
except ImportError:
    print(f"skipped: {sys.executable} has no NumPy (apt-get install python3-numpy)")
    sys.exit(77)

folder = pathlib.Path(__file__).resolve().parent
ran = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.discover(str(folder)))
for case, why in ran.skipped:
    print(why)
sys.exit(0 if ran.wasSuccessful() else 1)
