#!/usr/bin/env python3
"""Writes the mean of EXR files, of every channel, for references that are rendered in parts with seeds of their own.

    /usr/bin/python3 bench/average_exr.py OUT.exr IN.exr...

Wants apt's python3-numpy and python3-openimageio.
"""

import sys

import numpy as np
import OpenImageIO as oiio


def main(to, sources):
    total = None
    for source in sources:
        file = oiio.ImageInput.open(source)
        if not file:
            sys.exit(f"average_exr.py: cannot read {source}")
        spec, pixels = file.spec(), file.read_image(oiio.FLOAT)
        file.close()
        if total is not None and total.shape != pixels.shape:
            sys.exit(f"average_exr.py: {source} has {pixels.shape}, {sources[0]} {total.shape}")
        total = pixels if total is None else total + pixels
    file = oiio.ImageOutput.create(to)
    if not (file and file.open(to, spec) and file.write_image(np.ascontiguousarray(total / len(sources), np.float32)) and file.close()):
        sys.exit(f"average_exr.py: cannot write {to}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
