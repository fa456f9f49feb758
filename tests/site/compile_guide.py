"""Compiles what the guided choice of a preset says: compile_guide.py COMPILER INCLUDE. As one file, each result in a namespace of its own."""
import os
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
sys.path.insert(0, os.path.join(ROOT, "docs/site"))
os.chdir(ROOT)

from guide import RESULTS, Guide
from tables import Tables

guide = Guide(Tables(["docs/presets.md", "docs/figures.md"]), str)
includes, parts = [], []
for number, result in enumerate(RESULTS.values()):
    lines = guide.code(result).split("\n")
    includes += [line for line in lines if line.startswith("#")]
    parts.append(f"namespace result_{number} {{\n" + "\n".join(line for line in lines if not line.startswith("#")) + "\n}")
code = "\n".join(dict.fromkeys(includes)) + "\n" + "\n".join(parts) + "\n"
compiler, include = sys.argv[1:]
command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", f"-I{include}", "-x", "c++", "-"]
sys.exit(subprocess.run(command, input=code, encoding="utf-8").returncode)
