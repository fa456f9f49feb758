"""The guided choice of a preset. What a preset reads and does comes from docs/presets.md, what it costs from docs/figures.md."""
import html
from dataclasses import dataclass

import highlight
from figures import PAGE
from tables import number, plain

PRESETS = "docs/presets.md"


@dataclass(frozen=True)
class Answer:
    text: str
    leads_to: str  # the key of a question, or of a result


QUESTIONS = {
    "start": ("What do you want to clean?", [
        Answer("Files that a renderer has written, and nobody waits", "files"),
        Answer("Frames of my own renderer, in real time", "light"),
        Answer("Frames that a denoiser of my own goes on with, such as a network", "accumulated"),
        Answer("A sharp picture that wants motion blur", "tilemax-blur"),
    ]),
    "light": ("How does your renderer hand out light?", [
        Answer("As one colour, with albedo, normal, depth and motion", "shutter"),
        Answer("Split into direct light, visibility, reflections and indirect light", "trmv"),
        Answer("I want to clean the shadows alone: visibility of a light", "shadow"),
        Answer("The reflections alone", "glossy"),
        Answer("The indirect light alone", "dual-cone"),
    ]),
    "shutter": ("Is each sample taken at a random time of an open shutter?", [
        Answer("No: all samples are of one moment", "general"),
        Answer("Yes: the noise is that of motion blur", "turns"),
    ]),
    "turns": ("What moves while the shutter is open?", [
        Answer("Things and the camera, along straight lines", "blur-straight"),
        Answer("Wheels and propellers too: something turns", "blur"),
        Answer("It turns, and my renderer knows each sample's arc", "blur-bent"),
        Answer("Shadows and reflections, unlike the surfaces they lie on", "blur-split"),
    ]),
}


@dataclass(frozen=True)
class Result:
    preset: str
    case: str = ""  # rows of docs/figures.md that say what it costs; empty: none does
    command: str = ""  # what to run, where it is a program
    header: str = "quell/quell.hpp"


BLUR = "quell/presets/blur.hpp"
RESULTS = {
    "files": Result("final-frame", "room, composite", "quell-denoise --in 'shot/frame.%04d.exr' --out 'shot/clean.%04d.exr'"),
    "general": Result("general", "room, composite"),
    "accumulated": Result("accumulated"),
    "trmv": Result("trmv", "room, composite"),
    "shadow": Result("shadow", "fence, shadow"),
    "glossy": Result("glossy", "temple, glossy"),
    "dual-cone": Result("dual-cone", "boxes, indirect"),
    "tilemax-blur": Result("tilemax-blur", "spheres, blur", "quell-denoise --preset tilemax-blur --in 'shot/frame.%04d.exr' --out 'shot/clean.%04d.exr'"),
    "blur": Result("blur", "spheres, blur", header=BLUR),
    "blur-straight": Result("blur-straight", "spheres, blur", header=BLUR),
    "blur-bent": Result("blur-bent", "spheres, blur", header=BLUR),
    "blur-split": Result("blur-split", "spheres, blur", header=BLUR),
}


class Guide:
    def __init__(self, tables, link):
        """`link` makes HTML of Markdown."""
        self.tables, self.link = tables, link

    def html(self):
        """All questions and results; the script shows those on the way, and without it they stand one below the other."""
        questions = "".join(self._question(key, *QUESTIONS[key]) for key in QUESTIONS)
        results = "".join(self._result(key, RESULTS[key]) for key in RESULTS)
        return f'<form class="guide">{questions}{results}</form>'

    def code(self, result):
        """C++ that makes the result's pipeline."""
        call = plain(self.tables.row_about(PRESETS, result.preset)["call"])
        includes = ["quell/quell.hpp"] + ([result.header] if result.header != "quell/quell.hpp" else [])
        return "".join(f"#include <{header}>\n" for header in includes) + f"using namespace quell;\nconstexpr auto denoise = presets::{call};"

    @staticmethod
    def _question(key, words, answers):
        for answer in answers:
            if answer.leads_to not in QUESTIONS and answer.leads_to not in RESULTS:
                raise LookupError(f"guide.py: '{answer.leads_to}' is no question and no result")
        options = "".join(
            f'<label><input type="radio" name="{key}" data-to="{answer.leads_to}"><span>{html.escape(answer.text)}</span></label>'
            for answer in answers
        )
        return f'<fieldset data-step="{key}"><legend>{html.escape(words)}</legend>{options}</fieldset>'

    def _result(self, key, result):
        row = self.tables.row_about(PRESETS, result.preset)
        shown = html.escape(result.command) if result.command else highlight.highlighted(self.code(result), "cpp")
        return f"""<article class="result" data-step="{key}" tabindex="-1"><p class="take">Take</p><h3><code>{result.preset}</code></h3>
<p>{self.link(row["what it does"])}</p><pre tabindex="0"><code>{shown}</code></pre>
<dl><dt>It reads</dt><dd>{self._channels(plain(row["reads"]))}</dd>{self._cost(result)}</dl>
<p class="more">All presets: <a href="docs/presets.html">presets</a>. What the channels hold: <a href="docs/channels.html">channels</a>.</p></article>"""

    @staticmethod
    def _channels(reads):
        return ", ".join(f"<code>{html.escape(name)}</code>" for name in reads.split(", "))

    def _cost(self, result):
        if not result.case:
            return ""
        table = self.tables.find(PAGE, "all-presets")
        for row in table.rows:
            if plain(row[0]) == result.case and plain(table.of(row, "preset")) == result.preset:
                time, memory = number(table.of(row, "ms, 1080p")), number(table.of(row, "bytes per pixel"))
                scene, _, effect = result.case.partition(", ")
                return (
                    f"<dt>It costs</dt><dd>{time:g} ms per frame of 1920x1080 with two threads, {memory:g} bytes per pixel (<code>{scene}</code>,"
                    f' {effect}; <a href="docs/figures.html#all-presets">figures</a>)</dd>'
                )
        raise LookupError(f"{PAGE}, all presets: no row of {result.case}, {result.preset}")
