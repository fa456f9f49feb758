#!/usr/bin/env python3
"""Input filter of docs/Doxyfile: writes the header it is given to standard output, as doxygen 1.9 needs it.

Members that are the same in every policy get the sentence of CONTRACT where the header says nothing of them, as do the values of
channels and deduction guides. Of variables that are declared together, each gets their comment. The inline namespace that is named for
the instruction set is left out, as are comments of whole files. No line is added or removed, so that warnings name the right line.
"""
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


def without_file_comments(lines):
    """What stands above `namespace quell` is about the file: doxygen would take it for what the namespace is."""
    lines = list(lines)
    for i, line in enumerate(lines):
        above = i - 1
        while line.startswith("namespace quell") and above >= 0 and lines[above].startswith("///"):
            lines[above] = lines[above][1:]
            above -= 1
    return lines


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


def main():
    with open(sys.argv[1], encoding="utf-8") as text:
        lines = text.readlines()
    sys.stdout.reconfigure(encoding="utf-8", newline="\n")
    sys.stdout.writelines(header(without_file_comments(lines)))


main()
