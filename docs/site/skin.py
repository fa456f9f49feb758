"""What all pages of the site have around them."""
import html
import os

HERE = os.path.dirname(os.path.abspath(__file__))

# The sign: noise that comes to rest. Its colours are those of the style sheet.
SIGN = (
    '<svg class="sign" viewBox="0 0 44 24" width="44" height="24" aria-hidden="true">'
    '<path class="noise" d="M2 12 L4 5 L6 19 L8 3 L10 20 L12 6 L14 17 L16 8"/>'
    '<path class="rest" d="M16 8 C19 16 21 9 24 12 C27 14.500 29 12 42 12"/></svg>'
)
ICON = (
    "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32' fill='none' stroke-width='3' stroke-linejoin='round'%3E"
    "%3Cpath d='M2 16 5 6 8 26 11 5 14 22 16 12' stroke='%23d9622b'/%3E"
    "%3Cpath d='M16 12C19 22 21 16 30 16' stroke='%23178f88'/%3E%3C/svg%3E"
)


class Skin:
    def __init__(self, has_live):
        self.places = [("Which preset", "index.html#which"), ("Figures", "docs/figures.html"), ("Docs", "docs/readme.html")]
        self.places += [("Interface", "interface/index.html")]
        if has_live:
            self.places.insert(1, ("Live", "live/index.html"))

    def head(self, root, title, sheets=("style.css",)):
        links = "\n".join(f'<link rel="stylesheet" href="{root}{sheet}">' for sheet in sheets)
        return f"""<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<link rel="icon" href="{ICON}">
{links}
<script src="{root}site.js" defer></script>"""

    def top(self, root, current=""):
        links = "".join(
            f'<a href="{root}{place}"{" aria-current=page" if text == current else ""}>{text}</a>' for text, place in self.places
        )
        return f"""<a class="skip" href="#content">Skip to the content</a>
<header class="top"><div>
<a class="brand" href="{root}index.html">{SIGN}quell</a>
<nav aria-label="Site">{links}</nav>
<form class="search" role="search" data-root="{root}" hidden><input type="search" placeholder="Search" aria-label="Search pages and names"
 autocomplete="off" role="combobox" aria-expanded="false" aria-controls="found"><ul id="found" role="listbox" hidden></ul></form>
</div></header>"""

    def bottom(self, root):
        return f"""<footer class="bottom"><div><p>quell removes the noise from ray-traced images in real time. MIT licence,
<a href="{root}docs/third_party_notes.html">libraries and publications</a>, <a href="{root}docs/changelog.html">changes</a>,
<a href="{root}docs/contributing.html">contributing</a>.</p></div></footer>"""

    def page(self, root, title, body, current="", kind="", description=""):
        about = f'\n<meta name="description" content="{html.escape(description)}">' if description else ""
        return f"""<!DOCTYPE html>
<html lang="en">
<head>
{self.head(root, html.escape(title))}{about}
</head>
<body class="{kind}">
{self.top(root, current)}
{body}
{self.bottom(root)}
</body>
</html>
"""

    def for_doxygen(self):
        """Header and footer of the interface's pages, in doxygen's words."""
        root, sheets = "$relpath^../", ("style.css", "interface.css")
        above = f"""<!DOCTYPE html>
<html lang="en">
<head>
{self.head(root, "$title", sheets)}
</head>
<body class="interface">
{self.top(root, "Interface")}
<nav class="kinds" aria-label="Interface"><div><a href="$relpath^index.html">Overview</a><a href="$relpath^annotated.html">Types</a>
<a href="$relpath^concepts.html">Concepts</a><a href="$relpath^files.html">Headers</a><a href="$relpath^namespacequell_1_1presets.html">Presets</a>
</div></nav>
<main id="content">
<div id="top">
"""
        return above, f"</main>\n{self.bottom(root)}\n</body>\n</html>\n"
