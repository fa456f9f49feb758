"""The front page."""
import html
import re
import struct

import highlight
import pictures
from tables import plain

PROGRAMS = "docs/programs.md"


def size_of_png(path):
    with open(path, "rb") as file:
        return struct.unpack(">II", file.read(24)[16:])


def compare(shot, kept, caption, first):
    """The slider: the pictures of a shot above each other, and a handle between each two."""
    kinds = shot.kinds()
    width, height = size_of_png(pictures.paths(shot, kept)[0])
    layers = "".join(
        f'<div class="layer {kind}"><img src="pictures/{shot.name()}_{kind}.png" width="{width}" height="{height}"'
        f'{"" if first else " loading=lazy"} alt="{alt(shot, kind)}" draggable="false"><span class="tag">{tag(shot, kind)}</span></div>'
        for kind in reversed(kinds)
    )
    places = (34, 67) if len(kinds) == 3 else (50,)
    handles = "".join(
        f'<input type="range" min="0" max="100" step="1" value="{place}" class="handle" aria-label="Border between {left} and {right}">'
        f'<span class="divider" aria-hidden="true"></span>'
        for place, left, right in zip(places, kinds, kinds[1:])
    )
    style = ";".join(f"--{name}:{place}%" for name, place in zip("ab", places))
    return (
        f'<figure class="compare of{len(kinds)}"><div class="stage" style="{style};aspect-ratio:{width}/{height}">{layers}{handles}</div>'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def samples(shot):
    return "one sample per pixel" if shot.effects == "blur" else "one path per pixel"


def tag(shot, kind):
    return {"noisy": samples(shot), "denoised": shot.preset, "reference": "reference"}[kind]


def alt(shot, kind):
    what = {
        "noisy": f"with the noise of {samples(shot)}",
        "denoised": f"denoised by {shot.preset}",
        "reference": f"the reference of up to {shot.reference} samples per pixel",
    }[kind]
    return f"The scene {shot.scene}, {what}"


class Front:
    def __init__(self, root, tables, skin, figures, guide, pages, has_live):
        self.root, self.tables, self.skin, self.figures = root, tables, skin, figures
        self.guide, self.pages, self.has_live = guide, pages, has_live

    def snippet(self):
        """The first C++ of the read-me."""
        with open(f"{self.root}/README.md", encoding="utf-8") as text:
            return re.search(r"```cpp\n(.*?)```", text.read(), re.DOTALL).group(1)

    def first_picture(self, kept):
        if not kept:
            return ""
        shot = pictures.FRONT
        caption = (
            f"<code>{shot.scene}</code>, frame {shot.frame}: one path per pixel, what <code>{shot.preset}</code> makes of it and of the frames "
            "before, and the converged picture. Move over it, drag, or use the arrow keys."
        )
        return f'<section class="first" aria-label="Noisy, denoised and reference">{compare(shot, kept, caption, True)}</section>'

    def gallery(self, kept):
        if not kept:
            return ""
        items = "".join(
            compare(shot, kept, f"<strong>{shot.scene}</strong> {self.words(shot)}", False) for shot in pictures.GALLERY
        )
        return f"""<section id="gallery"><h2>Scenes, noisy and clean</h2>
<p>One sample per pixel, frame {pictures.GALLERY[0].frame}, denoised as in real time: no frame waits for a later one. All scenes come with
<a href="docs/programs.html#quell-trace"><code>quell-trace</code></a>.</p><div class="gallery">{items}</div></section>"""

    def words(self, shot):
        """What moves in it: what docs/programs.md says, unless that is of several scenes."""
        return html.escape(shot.moves or plain(self.tables.row_about(PROGRAMS, shot.scene)["what moves"]))

    def live(self):
        if not self.has_live:
            return ""
        return """<section id="live"><h2>Live, in this browser</h2><p>A path tracer of one sample per pixel, denoised while it runs.
<a class="button" href="live/index.html">Open the live page</a></p></section>"""

    def pages_of_docs(self):
        table = self.tables.find("README.md", "pages")
        items = "".join(
            f"<li><div>{self.pages.inline('README.md', row[0])}</div><p>{self.pages.inline('README.md', row[1])}</p></li>" for row in table.rows
        )
        return f'<ul class="cards">{items}</ul>'

    def html(self, kept):
        charts = (
            self.figures.of("all-presets", wanted=["room, composite", "fence, shadow", "restaurant, glossy", "spheres, blur"])
            + self.figures.of("beside-open-image-denoise")
            + self.figures.of("cycles-three-scenes")
            + self.figures.of("on-a-gpu")
            + self.figures.of("motion-blur")
        )
        body = f"""<main id="content">
<section class="hero"><div><h1>Ray-traced pictures without the noise, <em>while they are rendered</em></h1>
<p>quell is a header-only C++20 toolkit that cleans what one path per pixel leaves, by reusing earlier frames. Nothing is trained. It runs
on CPUs and on CUDA, from C++, C and Python, and as a program on the files of any renderer.</p>
<p class="buttons"><a class="button" href="docs/readme.html">Get started</a><a class="button quiet" href="#which">Which preset do I need?</a></p>
</div></section>
{self.first_picture(kept)}
<section id="code" class="halves"><div><h2>One line to compose, one to run</h2>
<p>A preset is a pipeline of policies. The frame has exactly the channels that it reads, the history exactly what it must remember, and nothing
is paid for that is not composed.</p><p><a href="docs/using.html">Composing pipelines</a>, <a href="docs/write_your_own.html">writing
policies of your own</a>, <a href="docs/library.html">the compiled library</a>, <a href="docs/python.html">Python</a>.</p></div>
<pre tabindex="0"><code>{highlight.highlighted(self.snippet(), "cpp")}</code></pre></section>
{self.live()}
<section id="which"><h2>Which preset do I need?</h2>{self.guide.html()}</section>
<section id="figures"><h2>Measured</h2><p>Every number has its command and its machine in <a href="docs/figures.html">figures</a>; what does not hold
stands in <a href="docs/limits.html">limits</a>.</p><div class="charts">{charts}</div></section>
{self.gallery(kept)}
<section id="pages"><h2>Pages</h2>{self.pages_of_docs()}</section>
</main>"""
        return self.skin.page(
            "", "quell: real-time denoising of ray-traced pictures", body, "", "front", "A header-only C++20 toolkit that removes the noise from "
            "ray-traced images in real time by reusing earlier frames."
        )
