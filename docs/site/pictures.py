"""The pictures of the site: built-in scenes, traced and denoised by quell's own programs, and kept for the next time."""
import hashlib
import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Shot:
    """One frame of a built-in scene as the site shows it. The frames before it are the denoiser's history."""

    scene: str
    preset: str = "general"
    effects: str = "composite"
    size: str = "480x270"
    frame: int = 32
    history: int = 24
    reference: int = 0  # samples per pixel of the converged frame; 0: none
    moves: str = ""  # what moves in it, where docs/programs.md says it of several scenes at once

    def name(self):
        return self.scene

    def settings(self):
        """What its pictures depend on."""
        return repr(replace(self, moves=""))

    def kinds(self):
        return ["noisy", "denoised"] + (["reference"] if self.reference else [])


# The first is what the front begins with.
FRONT = Shot("room", size="960x540", reference=128)
GALLERY = [
    Shot("pinkroom"),
    Shot("apples"),
    Shot("temple"),
    Shot("restaurant"),
    Shot("boxes"),
    Shot("disk"),
    Shot("leaves", moves="at frame 24 leaves open, and the light falls through them"),
    Shot("mixed", preset="blur", effects="blur", moves="things with several motions, while the shutter is open"),
    Shot("propeller", preset="blur", effects="blur", moves="something turns while the shutter is open"),
]


def small(shot):
    """The same, in the time that a test has: it shows that all programs run, not what they can do."""
    return replace(shot, size="96x54", history=2, reference=4 if shot.reference else 0)


@dataclass(frozen=True)
class Programs:
    """Paths of the programs that make pictures."""

    trace: str
    denoise: str
    write_png: str

    def make(self, shot, kept):
        """Leaves the shot's pictures in the folder `kept`, unless the same programs left them there."""
        made_by = f"{shot.settings()} {self._version()}"
        stamp = os.path.join(kept, shot.name() + ".txt")
        if all(os.path.exists(path) for path in [stamp, *paths(shot, kept)]):
            with open(stamp, encoding="utf-8") as text:
                if text.read() == made_by:
                    return
        print(f"site: pictures of {shot.scene}, {shot.size}", flush=True)
        os.makedirs(kept, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=kept) as work:
            self._run(shot, work, kept)
        with open(stamp, "w", encoding="utf-8") as text:
            text.write(made_by)

    def _version(self):
        """Another one where the programs' code is."""
        version = hashlib.sha256()
        for program in (self.trace, self.denoise, self.write_png):
            with open(program, "rb") as file:
                version.update(file.read())
        return version.hexdigest()

    def _run(self, shot, work, kept):
        frames = os.path.join(work, "frame.%04d.exr")
        trace = [self.trace, "--scene", shot.scene, "--size", shot.size, "--effects", shot.effects, "--out", work, "--quiet"]
        subprocess.run(trace + ["--first", str(shot.frame - shot.history), "--frames", str(shot.history + 1)], check=True)
        # As in real time: no frame waits for a later one.
        subprocess.run(
            [self.denoise, "--in", frames, "--out", os.path.join(work, "denoised.%04d.exr"), "--preset", shot.preset, "--quiet"]
            + (["--extra-frames", "0"] if shot.preset == "general" else []),
            check=True,
        )
        if shot.reference:
            subprocess.run(trace + ["--first", str(shot.frame), "--frames", "1", "--reference", str(shot.reference)], check=True)
        files = [f"{'frame' if kind == 'noisy' else kind}.{shot.frame:04d}.exr" for kind in shot.kinds()]
        for file, path in zip(files, paths(shot, kept)):
            subprocess.run([self.write_png, os.path.join(work, file), path], check=True)


def paths(shot, folder):
    return [os.path.join(folder, f"{shot.name()}_{kind}.png") for kind in shot.kinds()]


def put(shots, kept, out):
    """Copies the pictures that there are into the folder `out`."""
    os.makedirs(out, exist_ok=True)
    for shot in shots:
        for path in paths(shot, kept):
            shutil.copy(path, out)
