"""Checks the links of a site's folder: every address leads to a file in it, and every #anchor to an element that has it.
Pages load nothing from elsewhere."""
import os
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.loaded, self.without_alt = [], set(), [], []
        with open(path, encoding="utf-8") as text:
            self.feed(text.read())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        self.links += [given[key] for key in ("href", "src") if given.get(key)]
        if tag in ("script", "img", "link", "iframe"):
            self.loaded += [given[key] for key in ("href", "src") if given.get(key)]
        if tag == "img" and "alt" not in given:
            self.without_alt.append(given.get("src"))


def mistakes(folder):
    """A line for each link that leads nowhere, for what is loaded from elsewhere, and for each picture without words."""
    pages = {}
    for where, _, files in os.walk(folder):
        for name in files:
            if name.endswith(".html"):
                path = os.path.join(where, name)
                pages[path] = Page(path)
    count = 0
    for path, page in sorted(pages.items()):
        shown = os.path.relpath(path, folder)
        for source in page.without_alt:
            yield f"{shown}: the picture {source} has no alt"
        for address in page.loaded:
            if re.match(r"(?:https?:)?//", address):
                yield f"{shown}: loads {address} from elsewhere"
        for link in page.links:
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            file, _, anchor = link.partition("#")
            target = os.path.normpath(os.path.join(os.path.dirname(path), unquote(file))) if file else path
            if not os.path.isfile(target):
                yield f"{shown}: there is no {link}"
            elif anchor and target in pages and unquote(anchor) not in pages[target].anchors:
                yield f"{shown}: nothing has the anchor of {link}"
    if count == 0:
        yield f"{folder}: no links: is it the site's folder?"


if __name__ == "__main__":
    found = list(mistakes(sys.argv[1]))
    print("\n".join(found) or "all links lead somewhere")
    sys.exit(bool(found))
