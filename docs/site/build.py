#!/usr/bin/env python3
"""Builds the site into a folder, as plain files that need no server:

    docs/site/build.py --out build/site [--trace P --denoise P --write-png P [--small]] [--live FOLDER]

Needs cmark-gfm and doxygen. With the programs there are pictures, which are kept in OUT.kept for the next time.
"""
import argparse
import json
import os
import re
import shutil
import sys

import check
import interface
import pictures
from figures import Figures
from front import Front
from guide import Guide
from pages import Pages
from skin import HERE, Skin
from tables import Tables

ROOT = os.path.dirname(os.path.dirname(HERE))


def options():
    parser = argparse.ArgumentParser(description="Builds quell's site.")
    parser.add_argument("--out", required=True, help="folder for the site; what was there before goes")
    parser.add_argument("--doxygen", default="doxygen", help="the program")
    parser.add_argument("--trace", help="quell-trace, for pictures")
    parser.add_argument("--denoise", help="quell-denoise, for pictures")
    parser.add_argument("--write-png", help="the program of write_png.cpp, for pictures")
    parser.add_argument("--small", action="store_true", help="small pictures, for tests")
    parser.add_argument("--live", help="folder of the live page and all that it loads, if there is one")
    return parser.parse_args()


def make_pictures(given, kept, out):
    """The folder of the pictures; None without programs that make them."""
    programs = [given.trace, given.denoise, given.write_png]
    if not all(programs):
        return None
    if given.small:
        pictures.FRONT = pictures.small(pictures.FRONT)
        pictures.GALLERY = [pictures.small(shot) for shot in pictures.GALLERY]
    shots = [pictures.FRONT, *pictures.GALLERY]
    maker = pictures.Programs(*map(os.path.abspath, programs))
    for shot in shots:
        maker.make(shot, kept)
    pictures.put(shots, kept, out)
    return kept


def put_live(made, folder, skin):
    """Copies the live page, and gives it the site's top and bottom where it says so."""
    shutil.copytree(made, folder)
    path = os.path.join(folder, "index.html")
    with open(path, encoding="utf-8") as file:
        page = file.read()
    page = re.sub("<!-- top -->.*?<!-- /top -->", lambda _: '<script src="../site.js" defer></script>\n' + skin.top("../", "Live"), page, flags=re.S)
    page = page.replace("<!-- bottom -->", skin.bottom("../"))
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(page)


def main():
    given = options()
    out = os.path.abspath(given.out)
    kept = out + ".kept"
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    has_live = given.live is not None
    skin = Skin(has_live)
    with_pictures = make_pictures(given, kept, os.path.join(out, "pictures"))
    names = interface.write(ROOT, out, kept, skin, given.doxygen)
    os.chdir(ROOT)
    tables = Tables(["README.md", "docs/presets.md", "docs/figures.md", "docs/programs.md"])
    figures = Figures(tables)
    pages = Pages(ROOT, out, skin, names, figures)
    pages.write()
    guide = Guide(tables, lambda words: pages.inline("docs/presets.md", words))
    front = Front(ROOT, tables, skin, figures, guide, pages, has_live)
    with open(os.path.join(out, "index.html"), "w", encoding="utf-8", newline="\n") as file:
        file.write(front.html(with_pictures))
    if has_live:
        put_live(given.live, os.path.join(out, "live"), skin)
    for name in ("style.css", "interface.css", "site.js"):
        shutil.copy(os.path.join(HERE, name), out)
    found = pages.found + [[name, place, names.kinds[name]] for name, place in sorted(names.places.items())]
    with open(os.path.join(out, "search_data.js"), "w", encoding="utf-8") as file:
        file.write(f"window.quell_search = {json.dumps(found, separators=(',', ':'))};\n")
    wrong = list(check.mistakes(out))
    print("\n".join(wrong) or f"site: {out}/index.html")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
