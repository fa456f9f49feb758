"""How pip builds quell: setuptools puts the package together, CMake its modules.

Environment variables say what CMake is told:
    QUELL_PRESETS                    which presets, as "general;svgf"; all where it is empty
    QUELL_LIBRARY_INSTRUCTION_SETS   what for, as "x86-64;x86-64-v3;x86-64-v4"; this machine where it is empty
    CMAKE_ARGS                       more arguments
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools.build_meta import *  # noqa: F401,F403 - the functions that pip calls
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from wheel.bdist_wheel import bdist_wheel

_root = pathlib.Path(__file__).resolve().parents[2]
_header = (_root / "include" / "quell" / "version.hpp").read_text()
version = ".".join(re.search(f"define QUELL_VERSION_{part} ([0-9]+)", _header).group(1) for part in ("MAJOR", "MINOR", "PATCH"))


def _build_modules(build_folder: pathlib.Path, package_folder: pathlib.Path) -> None:
    """Compiles the modules and installs them where the package is put together."""
    import pybind11

    options = {
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_CXX_FLAGS_RELEASE": "-O2 -DNDEBUG",  # as all of quell's programs
        "CMAKE_INSTALL_PREFIX": package_folder,
        "QUELL_DEVELOP": "OFF",
        "QUELL_INSTALL": "ON",
        "QUELL_LIBRARY": "ON",
        "QUELL_PYTHON": "ON",
        "QUELL_PYTHON_FOLDER": ".",
        "QUELL_PRESETS": os.environ.get("QUELL_PRESETS", ""),
        "QUELL_LIBRARY_INSTRUCTION_SETS": os.environ.get("QUELL_LIBRARY_INSTRUCTION_SETS", ""),
        "Python_EXECUTABLE": sys.executable,
        "pybind11_DIR": pybind11.get_cmake_dir(),
    }
    definitions = [f"-D{name}={value}" for name, value in options.items()]
    arguments = definitions + shlex.split(os.environ.get("CMAKE_ARGS", ""))
    subprocess.run(["cmake", "-S", str(_root), "-B", str(build_folder), *arguments], check=True)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
    subprocess.run(["cmake", "--build", str(build_folder), "--target", "quell_python", "--parallel", jobs], check=True)
    subprocess.run(["cmake", "--install", str(build_folder), "--component", "python"], check=True)


class BuildPy(build_py):
    """The package's files, and its modules."""

    def run(self) -> None:
        if getattr(self, "editable_mode", False):
            raise SystemExit("quell: it can't be installed as editable; build it by CMake (docs/python.md) and set PYTHONPATH")
        super().run()
        build_folder = pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "cmake"
        _build_modules(build_folder, pathlib.Path(self.build_lib).resolve())


class BdistWheel(bdist_wheel):
    """A wheel for one machine and one version of Python."""

    def finalize_options(self) -> None:
        super().finalize_options()
        self.root_is_pure = False

    def run(self) -> None:
        # setuptools tells by extensions that it compiles itself.
        self.distribution.has_ext_modules = lambda: True
        super().run()


class Sdist(sdist):
    """The sources that CMake wants."""

    def make_distribution(self) -> None:
        self.filelist.process_template_line("include CMakeLists.txt docs/python.md")
        for folder in ("include", "bench/baselines", "packaging", "examples/dispatch", "examples/support"):
            self.filelist.process_template_line(f"graft {folder}")
        self.filelist.process_template_line("global-exclude *.pyc")
        super().make_distribution()
