"""Compiles what the guided choice of a preset says, and compares what docs/presets.md says that presets read with what they do:
compile_guide.py COMPILER INCLUDE. As one file, each result in a namespace of its own."""
import os
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
sys.path.insert(0, os.path.join(ROOT, "docs/site"))
os.chdir(ROOT)

from guide import PRESETS, RESULTS, Guide
from tables import Tables, plain

COMPARES_NAMES = """
template <class... Cs, class... Names> constexpr bool are(quell::Channels<Cs...>, Names... names) {
    auto const is_named = [&](std::string_view channel) { return ((channel == names) || ...); };
    return sizeof...(Cs) == sizeof...(Names) && (is_named(Cs::name) && ...);
}
using namespace quell;
"""


def of_guide(tables):
    """Includes and code of the results."""
    guide = Guide(tables, str)
    includes, parts = [], []
    for number, result in enumerate(RESULTS.values()):
        lines = guide.code(result).split("\n")
        includes += [line for line in lines if line.startswith("#")]
        parts.append(f"namespace result_{number} {{\n" + "\n".join(line for line in lines if not line.startswith("#")) + "\n}")
    return includes, parts


def of_presets(tables):
    """The same of all rows that have a call and what it reads."""
    parts = [COMPARES_NAMES]
    for table in tables.all:
        if table.page != PRESETS or "call" not in table.columns:
            continue
        for row in table.rows:
            name, call = plain(row[0]), plain(table.of(row, "call"))
            channels = ", ".join(f'"{channel}"' for channel in plain(table.of(row, "reads")).split(", "))
            parts.append(
                f"constexpr auto preset_{name.replace('-', '_')} = presets::{call};\n"
                f"static_assert(are(decltype(preset_{name.replace('-', '_')})::reads{{}}, {channels}),\n"
                f'              "{PRESETS}: `{name}` reads other channels");'
            )
    return ["#include <baselines/named.hpp>", "#include <string_view>"], parts


tables = Tables([PRESETS, "docs/figures.md"])
includes, parts = (guide + presets for guide, presets in zip(of_guide(tables), of_presets(tables)))
code = "\n".join(dict.fromkeys(includes)) + "\n" + "\n".join(parts) + "\n"
compiler, include = sys.argv[1:]
command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", f"-I{include}", f"-I{ROOT}/bench", "-x", "c++", "-"]
sys.exit(subprocess.run(command, input=code, encoding="utf-8").returncode)
