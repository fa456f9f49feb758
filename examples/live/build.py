#!/usr/bin/env python3
"""Builds the live page into a folder, as plain files that need no server, and run on several threads behind serve.py:

    examples/live/build.py --out build/live

Needs emscripten (em++), GLM and xsimd. What it compiles is kept in OUT.kept; with ccache, that is kept too.
"""
import argparse
import base64
import json
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SOURCES = ["exports", "denoiser"]
# xsimd has packs for x86's instructions, of which emscripten makes WebAssembly's. Compiled for threads: both programs are linked of the same.
COMPILE = ["-std=c++20", "-O3", "-pthread", "-msimd128", "-msse4.1", "-fno-rtti", "-Wall", "-Wextra", "-Werror", "-include", "bit_cast.hpp"]
LINK = ["-O2", "--no-entry", "-sALLOW_MEMORY_GROWTH"]
# What a program is linked of beside, and how. That of one thread is a module alone, for which live.js has all that it needs; that of several
# comes with emscripten's own script, which starts them before it is asked for a frame.
ONE_THREAD = (["one_thread"], ["-sSTANDALONE_WASM", "-sERROR_ON_UNDEFINED_SYMBOLS=0", "-sWARN_ON_UNDEFINED_SYMBOLS=0"], "live.wasm")
THREADS = (["workers"], ["-pthread", "-Wno-pthreads-mem-growth", "-sPTHREAD_POOL_SIZE=Module.helpers", "-sMODULARIZE", "-sEXPORT_NAME=live_threads",
                         "-sENVIRONMENT=web,worker,node"], "live_threads.js")


def options():
    parser = argparse.ArgumentParser(description="Builds quell's live page.")
    parser.add_argument("--out", required=True, help="folder for the page; what was there before goes")
    parser.add_argument("--compiler", default="em++", help="emscripten's compiler")
    parser.add_argument("--headers", default="/usr/include", help="folder that has glm and xsimd")
    parser.add_argument("--shaders", help="folder that quell-shaders has made for WebGPU, of the preset general")
    return parser.parse_args()


def run(command, environment):
    if subprocess.run(command, cwd=HERE, env=environment).returncode:
        sys.exit(f"live: this failed: {' '.join(command)}")


def needs(made, listed):
    """Whether a file is older than one that it was made from; `listed` is what the compiler says of those."""
    if not (os.path.exists(made) and os.path.exists(listed)):
        return True
    with open(listed, encoding="utf-8") as text:
        sources = text.read().replace("\\\n", " ").split(":", 1)[1].split()
    paths = [os.path.join(HERE, source) for source in sources] + [os.path.abspath(__file__)]
    return any(not os.path.exists(path) or os.path.getmtime(path) > os.path.getmtime(made) for path in paths)


def environment_for(given, kept):
    """What the compiler runs in, and its switches for folders."""
    # Links to the two libraries alone: beside them may lie headers of this machine's own C library.
    libraries = os.path.join(kept, "include")
    os.makedirs(libraries, exist_ok=True)
    for name in ("glm", "xsimd"):
        link = os.path.join(libraries, name)
        if not os.path.isdir(os.path.join(given.headers, name)):
            sys.exit(f"live: {given.headers} has no {name}: name the folder that has it by --headers")
        if os.path.lexists(link):
            os.remove(link)
        os.symlink(os.path.join(os.path.abspath(given.headers), name), link)
    environment = dict(os.environ)
    environment.setdefault("NODE_PATH", "/usr/share/nodejs") # where Debian has what emscripten's scripts need, whichever node there is
    if shutil.which("ccache"):
        environment.setdefault("EM_COMPILER_WRAPPER", "ccache")
    return environment, [f"-I{ROOT}/include", f"-I{ROOT}/bench", "-isystem", libraries]


def linked(given, kept):
    """Compiles and links both programs into `kept`."""
    environment, folders = environment_for(given, kept)

    def compiled(source):
        made = os.path.join(kept, source + ".o")
        listed = made[:-1] + "d"
        if needs(made, listed):
            run([given.compiler, *COMPILE, *folders, "-MMD", "-MF", listed, "-c", source + ".cpp", "-o", made], environment)
        return made
    shared = [compiled(source) for source in SOURCES]
    for sources, switches, name in (ONE_THREAD, THREADS):
        objects = shared + [compiled(source) for source in sources]
        run([given.compiler, *objects, *LINK, *switches, "-o", os.path.join(kept, name)], environment)


def shaders_in(folder):
    """plan.json and the text of each shader; null without a folder."""
    if not folder:
        return None
    if not os.path.exists(os.path.join(folder, "plan.json")):
        sys.exit(f"live: {folder} has no plan.json: make it by quell-shaders --preset general --language wgsl --out {folder}")

    def read(name):
        with open(os.path.join(folder, name), encoding="utf-8") as text:
            return text.read()
    plan = json.loads(read("plan.json"))
    # Not all that lies there, which may be of an older plan.
    names = {each[kind] for each in plan["passes"] for kind in ("shader", "first") if kind in each}
    return {"plan": plan, "texts": {name: read(name) for name in sorted(names)}}


def main():
    given = options()
    if not shutil.which(given.compiler):
        print(f"skipped: {given.compiler} isn't installed (apt-get install emscripten)")
        sys.exit(77)
    out = os.path.abspath(given.out)
    shaders = shaders_in(given.shaders)
    kept = out + ".kept"
    linked(given, kept)
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(os.path.join(HERE, "page"), out)
    shutil.copy(os.path.join(ROOT, "docs/site/style.css"), out)
    for name in ("live_threads.js", "live_threads.worker.js", "live_threads.wasm"):
        shutil.copy(os.path.join(kept, name), out)
    with open(os.path.join(kept, "live.wasm"), "rb") as program, open(os.path.join(out, "live_wasm.js"), "w", encoding="utf-8") as file:
        file.write(f'const live_wasm = "{base64.b64encode(program.read()).decode()}";\n') # pages that are files may not load it otherwise
    with open(os.path.join(out, "live_shaders.js"), "w", encoding="utf-8") as file:
        file.write(f"const live_shaders = {json.dumps(shaders)};\n")
    size = sum(os.path.getsize(os.path.join(out, name)) for name in os.listdir(out))
    print(f"live: {out}/index.html, {size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
