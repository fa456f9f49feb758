#!/usr/bin/env python3
"""Sends a job to OpenCue that denoises a sequence: each of its frames has one part of the sequence's frames.

    python3 examples/farms/opencue_job.py --show films --shot sh010 --parts 6 -- \\
        --in 'shot/frame.%04d.exr' --out 'shot/clean.%04d.exr' --frames 1-48

What stands behind -- goes to quell-denoise. A part that was killed goes on behind the frames that it has written: retry it in CueGUI.
Give --frames where the sequence is still being rendered: the parts must be of the same frames. Wants OpenCue's Python library
(pip install opencue-pyoutline), and its cuebot in CUEBOT_HOSTS.
"""

import argparse
import getpass
import os
import shlex


def command(program, parts, arguments):
    """The command of each part; OpenCue puts its number in place of #IFRAME#."""
    words = [program, *arguments, "--chunk", f"#IFRAME#/{parts}", "--skip-existing", "--json"]
    # OpenCue hands the words to a shell. It must see #IFRAME# as it is, and no % of a pattern is touched.
    return [word if word.startswith("#IFRAME#") else shlex.quote(word) for word in words]


def job_for(options):
    """The job, not sent yet."""
    import outline
    import outline.modules.shell

    job = outline.Outline(options.name, show=options.show, shot=options.shot, user=options.user)
    layer = outline.modules.shell.Shell(
        "denoise",
        command=command(options.program, options.parts, options.arguments),
        range=f"1-{options.parts}",
        chunk=1,
        threads=options.cores,
        threadable=options.cores > 1,
    )
    job.add_layer(layer)
    return job


def parsed(words=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--name", default="quell-denoise", help="of the job")
    parser.add_argument("--show", required=True)
    parser.add_argument("--shot", required=True)
    parser.add_argument("--user", default=getpass.getuser())
    parser.add_argument("--parts", type=int, default=6, help="that the frames are split into")
    parser.add_argument("--cores", type=int, default=4, help="of each part")
    parser.add_argument("--program", default=os.environ.get("QUELL_DENOISE", "quell-denoise"))
    parser.add_argument("arguments", nargs="+", metavar="-- ARGUMENTS", help="of quell-denoise")
    options = parser.parse_args(words)
    if options.parts < 1 or options.cores < 1:
        parser.error("--parts and --cores are 1 or more")
    options.arguments += ["--threads", str(options.cores)]
    return options


def main():
    options = parsed()
    try:
        import outline.cuerun
    except ImportError as why:
        raise SystemExit(f"opencue_job.py: OpenCue's Python library can't be imported ({why}); pip install opencue-pyoutline")
    outline.cuerun.launch(job_for(options), use_pycuerun=False)


if __name__ == "__main__":
    main()
