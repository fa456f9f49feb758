"""Renders the Markdown pages: cmark-gfm reads them as GitHub does, and this gives them links, anchors, colours and the site's skin."""
import html
import os
import re
import shutil
import subprocess

import highlight
from tables import plain, slug

# Where pages go that don't stand in docs/.
ELSEWHERE = {
    "README.md": "docs/readme.html",
    "CHANGELOG.md": "docs/changelog.html",
    "SECURITY.md": "docs/security.html",
    "third_party_notes/README.md": "docs/third_party_notes.html",
    "CONTRIBUTING.md": "docs/contributing.html",
}
SHOWN_BY_ANOTHER = {"CONTRIBUTING.md"}
TEXT = {".cpp", ".hpp", ".c", ".h", ".py", ".sh", ".json", ".cmake", ".txt", ""}
PICTURES = {".png", ".svg", ".jpg", ".gif"}


def place_of(page):
    """Where on the site a Markdown file is shown; None where it isn't."""
    if page in ELSEWHERE:
        return ELSEWHERE[page]
    return f"docs/{os.path.basename(page)[:-3]}.html" if os.path.dirname(page) == "docs" and page.endswith(".md") else None


def text_of(marked):
    """The words of a piece of HTML."""
    return html.unescape(re.sub(r"<[^>]*>", "", marked))


class Pages:
    def __init__(self, root, out, skin, names, charts):
        self.root, self.out, self.skin, self.names, self.charts = root, out, skin, names, charts
        self.sources = set()  # files that pages link to, which are shown as code
        self.found = []  # what the search finds: [title, place]
        docs = sorted(f"docs/{name}" for name in os.listdir(os.path.join(root, "docs")) if name.endswith(".md"))
        others = [page for page in ELSEWHERE if page not in SHOWN_BY_ANOTHER and os.path.exists(os.path.join(root, page))]
        self.pages = others[:1] + docs + others[1:]
        self.titles = {page: self._title(page) for page in self.pages}

    def _title(self, page):
        with open(os.path.join(self.root, page), encoding="utf-8") as text:
            return next((plain(line[2:]) for line in text if line.startswith("# ")), page)

    def write(self):
        os.makedirs(os.path.join(self.out, "docs/media"), exist_ok=True)
        for page in self.pages:
            self._write_page(page)
        for source in sorted(self.sources):
            self._write_source(source)

    def body_of(self, page):
        """HTML of the whole page without its skin."""
        command = ["cmark-gfm", "-e", "table", "-e", "strikethrough", "-e", "autolink", "--unsafe", os.path.join(self.root, page)]
        return subprocess.run(command, check=True, capture_output=True, encoding="utf-8").stdout

    def inline(self, page, words):
        """HTML of a piece of a page in one line, with links from the site's front."""
        made = subprocess.run(["cmark-gfm", "--unsafe"], input=words, check=True, capture_output=True, encoding="utf-8").stdout
        made = re.sub(r"</?p>", "", made).strip()
        return re.sub(r'<a href="([^"]*)">(.*?)</a>', lambda found: self._link(page, found, ""), made, flags=re.DOTALL)

    def _write_page(self, page):
        body = self.body_of(page)
        headings = []
        body = self._with_anchors(body, headings)
        body = re.sub(r'<pre><code(?: class="language-([^"]*)")?>(.*?)</code></pre>', self._code, body, flags=re.DOTALL)
        body = re.sub(r'<a href="([^"]*)">(.*?)</a>', lambda found: self._link(page, found), body, flags=re.DOTALL)
        body = self._with_names(body)
        body = re.sub(r'<img src="([^"]*)" alt="([^"]*)"[^>]*>', lambda found: self._picture(page, found), body)
        body = self._with_charts(page, body)
        body = re.sub(r"<table>.*?</table>", self._table, body, flags=re.DOTALL)
        place = place_of(page)
        title = "Read me" if page == "README.md" else self.titles[page]
        self.found += [[title, place, "page"]] + [[text_of(h), f"{place}#{anchor}", title] for level, anchor, h in headings if level > 1]
        whole = f"""<div class="page">
{self._side(page, headings)}
<main id="content" class="prose">
{body}
</main>
</div>"""
        current = "Figures" if page == "docs/figures.md" else "Docs"
        self._save(place, self.skin.page("../", f"{title} | quell", whole, current, "docs"))

    def _side(self, page, headings):
        rows = []
        for other in self.pages:
            title = "Read me" if other == "README.md" else self.titles[other]
            here = other == page
            rows.append(f'<li><a href="{os.path.basename(place_of(other))}"{" aria-current=page" if here else ""}>{html.escape(title)}</a>')
            inner = [f'<li><a href="#{anchor}">{text_of(heading)}</a></li>' for level, anchor, heading in headings if level == 2]
            rows.append(f"<ul>{''.join(inner)}</ul></li>" if here and inner else "</li>")
        return f'<details class="side" open><summary>Pages and contents</summary><nav aria-label="Pages"><ul>{"".join(rows)}</ul></nav></details>'

    def _with_anchors(self, body, headings):
        used = {}

        def anchored(found):
            level, heading = int(found.group(1)), found.group(2)
            name = slug(text_of(heading))
            again = used.get(name, 0)
            used[name] = again + 1
            name += f"-{again}" if again else ""
            headings.append((level, name, heading))
            sign = f' <a class="anchor" href="#{name}" aria-label="Link to this section">#</a>' if level > 1 else ""
            return f'<h{level} id="{name}">{heading}{sign}</h{level}>'

        return re.sub(r"<h([1-6])>(.*?)</h\1>", anchored, body, flags=re.DOTALL)

    @staticmethod
    def _code(found):
        language, code = found.group(1) or "", html.unescape(found.group(2))
        return f'<pre tabindex="0"><code>{highlight.highlighted(code, language)}</code></pre>'

    def _with_names(self, body):
        """Links code in text to the interface, outside of headings, links and blocks of code."""
        pieces = re.split(r"(<(?:h[1-6]|pre|a)\b.*?</(?:h[1-6]|pre|a)>)", body, flags=re.DOTALL)

        def named(found):
            place = self.names.place_of(html.unescape(found.group(1)))
            return f'<a class="name" href="../{place}">{found.group(0)}</a>' if place else found.group(0)

        linked = "".join(piece if i % 2 else re.sub(r"<code>([^<]*)</code>", named, piece) for i, piece in enumerate(pieces))
        return re.sub(r"(?<!<pre tabindex=\"0\">)<code>[^<]*</code>", self._with_whole_options, linked)

    @staticmethod
    def _with_whole_options(found):
        """No line ends within an option: between its dashes is none of its places."""
        return re.sub(r"--[\w-]+", r'<span class="option">\g<0></span>', found.group(0))

    def _link(self, page, found, start="docs"):
        """The link, as it is on a page of the folder `start`."""
        target, text = html.unescape(found.group(1)), found.group(2)
        if target.startswith("#") or re.match(r"[a-z]+:", target):
            return found.group(0)
        file, _, anchor = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), file))
        place = place_of(path)
        if place and os.path.exists(os.path.join(self.root, path)):
            return f'<a href="{os.path.relpath(place, start or ".")}{"#" + anchor if anchor else ""}">{text}</a>'
        if os.path.splitext(path)[1] in TEXT and os.path.isfile(os.path.join(self.root, path)):
            self.sources.add(path)
            return f'<a href="{os.path.relpath(self._source_place(path), start or ".")}">{text}</a>'
        return text  # folders

    def _picture(self, page, found):
        source, alt = html.unescape(found.group(1)), found.group(2)
        path = os.path.normpath(os.path.join(self.root, os.path.dirname(page), source))
        shutil.copy(path, os.path.join(self.out, "docs/media"))
        name = os.path.basename(path)
        kind = ' class="drawing"' if name.endswith(".svg") else ""
        return f'<a href="media/{name}"{kind}><img src="media/{name}" alt="{alt}" loading="lazy"></a>'

    def _with_charts(self, page, body):
        """Each chart above the table that it is made from."""
        if page not in self.charts.pages():
            return body
        pieces = re.split(r"(<h[1-6] id=\"[^\"]*\">|<table>)", body)
        heading, index, made = "", 0, []
        for piece in pieces:
            if found := re.match(r'<h[1-6] id="([^"]*)">', piece):
                heading, index = found.group(1), 0
            if piece == "<table>":
                made.append(self.charts.for_table(page, heading, index))
                index += 1
            made.append(piece)
        return "".join(made)

    @staticmethod
    def _table(found):
        """Wide tables scroll by themselves; cells that are numbers stand on the right."""
        table = re.sub(r"<td>((?:<strong>)?-?[\d.,]+(?: \([\d.,]+\))?(?: %)?(?:</strong>)?)</td>", r'<td class="number">\1</td>', found.group(0))
        return f'<div class="scroll" tabindex="0" role="group" aria-label="Table">{table}</div>'

    @staticmethod
    def _source_place(path):
        return f"source/{path.replace('/', '_')}.html"

    def _write_source(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as text:
            code = text.read()
        language = os.path.splitext(path)[1][1:] or "sh"
        shown = highlight.highlighted(code, language) if path != "LICENSE" else html.escape(code)
        body = f'<main id="content" class="prose alone"><h1>{path}</h1><pre tabindex="0"><code>{shown}</code></pre></main>'
        self._save(self._source_place(path), self.skin.page("../", f"{path} | quell", body, "Docs", "docs"))

    def _save(self, place, text):
        path = os.path.join(self.out, place)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
