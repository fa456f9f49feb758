"""Denoises EXR frames, such as those of quell-trace, and says how far they are from their references:
    denoise_files.py FOLDER TO
"""

import pathlib
import sys

import quell
from quell import exr, metrics

folder, to = (pathlib.Path(name) for name in sys.argv[1:])
to.mkdir(parents=True, exist_ok=True)
paths = sorted(folder.glob("frame.*.exr"))
frames = (exr.read_frame(path) for path in paths)  # each is read when it is wanted

for path, picture in zip(paths, quell.denoise(frames, "general")):
    exr.write(to / path.name, {"": picture})
    reference = path.with_name(path.name.replace("frame", "reference"))
    if reference.exists():
        truth = exr.read_frame(reference, ["radiance"])["radiance"]
        shown, wanted = metrics.displayed(picture), metrics.displayed(truth)
        print(f"{path.name}: FLIP {metrics.flip(wanted, shown).mean:.4f}, SSIM {metrics.ssim(wanted, shown):.4f}")
