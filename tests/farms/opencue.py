"""Makes a job by examples/farms/opencue_job.py, and runs its frames as OpenCue does: opencue.py QUELL_DENOISE QUELL_TRACE SOURCE_FOLDER.
OpenCue itself is not needed: what the script calls of its library stands here."""

import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import types

denoise, trace, source = sys.argv[1:4]


class Outline:
    def __init__(self, name, **settings):
        self.name, self.settings, self.layers = name, settings, []

    def add_layer(self, layer):
        self.layers.append(layer)


class Shell:
    def __init__(self, name, **settings):
        self.name, self.settings = name, settings


launched = []
library = {name: types.ModuleType(name) for name in ("outline", "outline.modules", "outline.modules.shell", "outline.cuerun")}
library["outline"].Outline = Outline
library["outline"].modules = library["outline.modules"]
library["outline"].cuerun = library["outline.cuerun"]
library["outline.modules"].shell = library["outline.modules.shell"]
library["outline.modules.shell"].Shell = Shell
library["outline.cuerun"].launch = lambda job, **settings: launched.append((job, settings))
sys.modules.update(library)

spec = importlib.util.spec_from_file_location("opencue_job", pathlib.Path(source) / "examples/farms/opencue_job.py")
script = importlib.util.module_from_spec(spec)
spec.loader.exec_module(script)

with tempfile.TemporaryDirectory(prefix="quell it's ") as name:
    folder = pathlib.Path(name)
    subprocess.run([trace, "--scene", "room", "--frames", "7", "--size", "48x27", "--quiet", "--out", folder / "in"], check=True)
    words = ["--show", "films", "--shot", "a", "--parts", "3", "--cores", "2", "--program", denoise, "--"]
    words += ["--in", f"{folder}/in/frame.%04d.exr", "--out", f"{folder}/out/frame.%04d.exr", "--frames", "0-4,6", "--preset", "svgf"]
    sys.argv[1:] = words
    script.main()
    [(job, settings)] = launched
    assert settings == {"use_pycuerun": False}
    assert job.settings["show"] == "films" and job.settings["shot"] == "a"
    [layer] = job.layers
    assert layer.settings["range"] == "1-3" and layer.settings["chunk"] == 1 and layer.settings["threads"] == 2
    written = []
    for part in (1, 2, 3):
        line = " ".join(layer.settings["command"]).replace("#IFRAME#", str(part))
        ran = subprocess.run(line, shell=True, check=True, capture_output=True, text=True)
        written.append(json.loads(ran.stdout)["written"])
    assert written == [[0, 1], [2, 3], [4, 6]], written
    assert len(list((folder / "out").iterdir())) == 6
