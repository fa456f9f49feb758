"""Lets doxygen write the interface, in the site's skin."""
import os
import re
import subprocess

from names import Names


def write(root, out, work, skin, doxygen):
    """Runs doxygen, any warning of which is an error, and returns the names that it knows."""
    os.makedirs(work, exist_ok=True)
    above, below = skin.for_doxygen()
    settings = {"OUTPUT_DIRECTORY": out, "HTML_OUTPUT": "interface", "GENERATE_TAGFILE": os.path.join(work, "names.xml")}
    for key, name, text in (("HTML_HEADER", "above.html", above), ("HTML_FOOTER", "below.html", below)):
        settings[key] = os.path.join(work, name)
        with open(settings[key], "w", encoding="utf-8") as file:
            file.write(text)
    with open(os.path.join(root, "docs/Doxyfile"), encoding="utf-8") as file:
        lines = [file.read()] + [f'{key} = "{value}"' for key, value in settings.items()]
    subprocess.run([doxygen, "-"], input="\n".join(lines), encoding="utf-8", cwd=root, check=True)
    folder = os.path.join(out, "interface")
    for name in os.listdir(folder):
        path = os.path.join(folder, name)
        if name.endswith(".html"):
            _mend(path, folder)
        # Doxygen's own look and search, which no page uses.
        elif not name.endswith(".svg"):
            os.remove(path)
    return Names(settings["GENERATE_TAGFILE"], "interface")


def _mend(path, folder):
    """Takes out doxygen's scripts, and what needs them, and links to lists that this doxygen doesn't write."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"<script(?![^>]*site\.js)[^>]*>.*?</script>\n?", "", text, flags=re.DOTALL)
    text = re.sub(r' on(?:click|mouseover|keydown)="[^"]*"', "", text)
    text = text.replace('style="display:none;"', "")
    text = re.sub(r'<img src="(?:closed|open)\.png"[^>]*>(?:&#160;)?', "", text)
    for list_of in ("annotated.html", "concepts.html", "files.html"):
        if not os.path.exists(os.path.join(folder, list_of)):
            text = re.sub(rf'<a href="{list_of}">[^<]*</a>', "", text)
    # A section of private members, which isn't there, is named above too.
    text = re.sub(r'<a href="#(nested-classes)">[^<]*</a> &#124;\s*', lambda found: found.group(0) if f'id="{found.group(1)}"' in text else "", text)
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
