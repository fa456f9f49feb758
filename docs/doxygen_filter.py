#!/usr/bin/env python3
"""Input filter of docs/Doxyfile: writes the file it is given to standard output, as doxygen 1.9 needs it.

Pages: headings get the anchors that GitHub gives them, with the page's name before, and links are rewritten to match. Links to
what isn't a page of the site become plain text.
Headers: members that are the same in every policy get the sentence of CONTRACT where the header says nothing of them, as do the
values of channels and deduction guides. Of variables that are declared together, each gets their comment. The inline namespace that
is named for the instruction set is left out.
No line is added or removed, so that warnings name the right line.
"""
import os
import re
import sys

CONTRACT = {
    "reads": "Channels of this frame that it reads.",
    "remembers": "Channels of the previous frame that it reads.",
    "keeps": "Channels that it makes in this frame and reads in the next.",
    "emits": "Channels that it makes for later passes of this frame.",
    "parts": "Policies that it is made of; what they declare counts as declared by it.",
    "name": "Name in plans and error messages.",
    "Signal": "The signal that it works on.",
    "farthest_tap": "Largest distance, in pixels along x or y, at which it looks at images of this frame.",
    "leaves_signal": "It makes channels and leaves the signal as it is.",
    "needs_camera": "Frame::camera must be set.",
    "emit_channels": "Makes the channels of `emits` for a pixel, or for a pack of neighbours (filter/filter_kernel.hpp).",
    "filter": "The new value of the signal at a pixel, or at a pack of neighbours (filter/filter_kernel.hpp).",
    "for_each_pass": "Calls pass(kernel) for each of its passes, in order (filter/filter_kernel.hpp).",
    "previous": "Where in the previous frame the pixel's surface was (motion/motion_source.hpp).",
    "fetch": "Interpolates the history at the place that the motion source found (motion/history_fetch.hpp).",
    "blend": "Joins the present with the past (blend/blend_policy.hpp).",
}
INLINE_NAMESPACE = "::inline QUELL_INSTRUCTION_SET"  # users write quell::Frame
TYPE_OR_CONSTANT = re.compile(r"(?:using|static constexpr (?:auto|bool|int)) (\w+) = ")
FUNCTION = re.compile(r"(?:template <[^<>]*> )?(?:QUELL_KERNEL|constexpr) (?:[\w:]+(?: [\w:]+)*) (\w+)\(")
CHANNEL = re.compile(r"inline constexpr ([A-Z]\w*)(?:<[^;]*>)? \w+;$")
DEDUCTION_GUIDE = re.compile(r"(?:template <.*> )?\w+\(.*\) -> .*;$")
VARIABLES = re.compile(r"((?:static |constexpr |inline )*(?:[\w:]|<[\w:, ]*>)+) (\w.*);(?: +///< (.*))?$")


def outside_brackets(text, separator):
    """The pieces of a list of declarators; commas in brackets are no separators."""
    pieces, depth = [""], 0
    for sign in text:
        depth += (sign in "({[<") - (sign in ")}]>")
        if sign == separator and depth == 0:
            pieces.append("")
        else:
            pieces[-1] += sign
    return [piece.strip() for piece in pieces]


def separate(code, comment):
    """`int a, b; ///< text` as two declarations with one comment each."""
    found = VARIABLES.match(code)
    if not found or not (comment or found.group(3)):
        return code
    text = " ".join(filter(None, [comment, found.group(3)]))
    names = outside_brackets(found.group(2), ",")
    return " ".join(f"/** {text} */ {found.group(1)} {name};" for name in names) if len(names) > 1 else code


def header(lines):
    before, comment = "", ""
    for line in lines:
        line = line.replace(INLINE_NAMESPACE, "")
        line = re.sub(r"(?<= \{ )(?=static constexpr auto name = )", f"/** {CONTRACT['name']} */ ", line)  # a struct in one line
        code = line.strip()
        indent = re.match(r"[ \t]*", line).group()
        found = TYPE_OR_CONSTANT.match(code) or FUNCTION.match(code)
        documented = "///" in line or (before.startswith("/// ") and before != "/// @endcond") or before.endswith("*/")
        if found and found.group(1) in CONTRACT and not documented:
            yield indent + f"/** {CONTRACT[found.group(1)]} */ " + code + "\n"
        elif not documented and CHANNEL.match(code):
            yield indent + f"/** {CHANNEL.match(code).group(1)} as a value. */ " + code + "\n"
        elif not documented and DEDUCTION_GUIDE.match(code):
            yield indent + "/** Deduction guide. */ " + code + "\n"
        else:
            yield indent + separate(code, comment) + "\n"
        comment = f"{comment} {code[4:]}".strip() if code.startswith("/// ") else ""
        before = code


def slug(heading):
    """The anchor of a heading on GitHub."""
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", "-")


def anchor(page, name):
    return f"{os.path.splitext(os.path.basename(page))[0].lower()}_{name}"


def titles(page):
    """Anchors of the page's first heading: doxygen makes it the page's title, which has no anchor but the page itself."""
    with open(page, encoding="utf-8") as text:
        return {slug(line[2:].strip()) for line in text if line.startswith("# ")}


def link(page, root):
    def rewritten(match):
        text, target = match.group(1), match.group(2)
        if re.match(r"[a-z]+:", target):
            return match.group(0)
        file, _, name = target.partition("#")
        path = os.path.normpath(os.path.join(os.path.dirname(page), file)) if file else page
        if not is_page(path, root):
            return text
        if name and name not in titles(path):
            return f"[{text}](#{anchor(path, name)})"
        return f"[{text}]({os.path.relpath(path, os.path.dirname(page))})"

    return rewritten


def is_page(path, root):
    return path.endswith(".md") and os.path.dirname(path) in (root, os.path.join(root, "docs")) and os.path.exists(path)


def page_of_the_site(page, lines):
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    page = os.path.abspath(page)
    used, in_code = {}, False
    for line in lines:
        if line.startswith("```"):
            in_code = not in_code
        if in_code or line.startswith("```"):
            yield line
            continue
        heading = re.match(r"(#+) (.*)", line)
        if heading:
            name = slug(heading.group(2))
            again = used.get(name, 0)
            used[name] = again + 1
            name += f"-{again}" if again else ""
            title = len(heading.group(1)) == 1
            yield line if title else f"{line.rstrip()} {{#{anchor(page, name)}}}\n"
            continue
        code = re.findall(r"`[^`]*`", line)
        line = re.sub(r"`[^`]*`", "`", line)
        line = re.sub(r"(?<!!)\[([^\]]*)\]\(([^)\s]*)\)", link(page, root), line)
        yield re.sub("`", lambda _: code_span(code.pop(0), line.startswith("|")) if code else "`", line)


def code_span(code, in_table):
    """Doxygen 1.9 ends code at a bar in a table's cell, and takes a # there for a link: escaped HTML in its place."""
    if not in_table or not ("\\|" in code or "#" in code):
        return code
    return "<tt>" + code[1:-1].replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("#", "\\#") + "</tt>"


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as text:
        lines = text.readlines()
    sys.stdout.reconfigure(encoding="utf-8", newline="\n")
    sys.stdout.writelines(page_of_the_site(path, lines) if path.endswith(".md") else header(lines))


main()
