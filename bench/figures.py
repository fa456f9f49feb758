#!/usr/bin/env python3
"""Writes docs/figures.md from bench/results: page.md there has the words, and each NAME.csv is a table.

    bench/figures.py                          writes the page
    bench/figures.py --check                  ends with 1 where the page is not what the results give, whatever it says of changed files
    bench/figures.py --changed                prints which files have changed since a table was measured
    COMMAND | bench/figures.py --record NAME... [--machine WORDS]    takes tables in Markdown, in their order, for results of today, by the
                                              commit that is checked out and, unless something else is said, this machine; notes go

The first lines of a table are `# command:`, `# commit:`, `# machine:`, `# date:`, `# files:` (files and folders that its figures depend on) and,
where something is to be said, `# note:`. What isn't known is "not recorded". Cells are as Markdown has them. In page.md a line {{NAME}} stands for a
table and what was recorded of it; {{NAME; columns: a | b; without: EXPRESSION}} leaves out other columns, and rows that have the expression.
A table is marked where git has changes of its files since its commit; without one, since the last commit of its day.
"""

import argparse
import csv
import os
import re
import subprocess
import sys
import textwrap
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FACTS = ("command", "commit", "machine", "date", "files", "note")
UNKNOWN = "not recorded"
MARK = "*Older than its code.*"


class Table:
    """A table, and what was recorded of it."""

    def __init__(self, path):
        self.path, self.facts, rows = path, {}, []
        with open(path, encoding="utf-8", newline="") as file:
            for line in file:
                if not line.startswith("# "):
                    rows.append(line)
                    continue
                name, _, text = line[2:].partition(":")
                self.facts[name] = "\n".join(filter(None, (self.facts.get(name), text.strip())))
        self.columns, *self.rows = csv.reader(rows)
        if wrong := [name for name in FACTS[:-1] if not self.facts.get(name)] + sorted({*self.facts} - {*FACTS}):
            raise LookupError(f"{path}: '# {wrong[0]}:' lacks, or is none of {', '.join(FACTS)}")
        if wrong := [row for row in self.rows if len(row) != len(self.columns)]:
            raise LookupError(f"{path}: {wrong[0]} has {len(wrong[0])} cells, the first line {len(self.columns)}")

    def write(self):
        with open(self.path, "w", encoding="utf-8", newline="") as file:
            for name in FACTS:
                file.writelines(f"# {name}: {line}\n" for line in self.facts.get(name, "").splitlines())
            csv.writer(file, lineterminator="\n").writerows([self.columns, *self.rows])

    def changed(self, root):
        """Files that have changed since; None where git does not know."""

        def git(*words):
            try:
                return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=True).stdout.split()
            except (FileNotFoundError, subprocess.CalledProcessError):
                return None

        since = [self.facts["commit"]]
        if since == [UNKNOWN]:
            since = git("rev-list", "-1", f"--before={self.facts['date']}T23:59:59Z", "HEAD") if self.facts["date"] != UNKNOWN else None
        return git("diff", "--name-only", since[0], "--", *self.facts["files"].split()) if since else None

    def shown(self, options):
        """The table in Markdown."""
        lacks = [name for name in options.get("columns", []) if name not in self.columns]
        if lacks:
            raise LookupError(f"{self.path}: no column '{lacks[0]}' among {self.columns}")
        places = [self.columns.index(name) for name in options.get("columns", self.columns)]
        rows = [row for row in self.rows if "without" not in options or not any(re.search(options["without"], cell) for cell in row)]
        lines = [self.columns, ["---"] * len(self.columns), *rows]
        return "\n".join("| " + " | ".join(line[i] for i in places) + " |" for line in lines)

    def recorded(self, before):
        """Where the figures come from, in a sentence, without what the table before says already."""
        facts = {name: self.facts[name] for name in FACTS[:4] if self.facts[name] != UNKNOWN}
        lacks = [name for name in ("command", "machine", "date") if name not in facts]
        said = ["By " + " and ".join(f"`{line}`" for line in facts["command"].splitlines())] if "command" in facts else []
        if "machine" in facts:
            said = [" on ".join([*said, facts["machine"]])]
        said += [facts["date"]] if "date" in facts else []
        said += [f"commit {facts['commit']}"] if "commit" in facts else []
        text = "; ".join(filter(None, (", ".join(said), f"{', '.join(lacks)} {UNKNOWN}" if lacks else ""))) + "."
        if "command" in facts and before and all(self.facts[name] == before.facts[name] for name in FACTS[:4]):
            text = "By the same run."
        text = text[0].upper() + text[1:]
        text += " " + self.facts["note"].replace("\n", " ") if self.facts.get("note") else ""
        return "\n".join(textwrap.wrap(text, 124, break_long_words=False, break_on_hyphens=False))


def page_of(root):
    """The page in Markdown."""
    results, used = root / "bench/results", []

    def table(found):
        name, *words = (each.strip() for each in found.group(1).split(";"))
        options = {key.strip(): value.strip() for key, _, value in (each.partition(":") for each in words)}
        if "columns" in options:
            options["columns"] = [each.strip() for each in options["columns"].split("|")]
        made = Table(results / f"{name}.csv")
        for each in made.facts["files"].split():
            if not (root / each).exists():
                raise LookupError(f"{made.path}: there is no {each}, which its figures depend on")
        before = used[-1] if used else None
        used.append(made)
        return "\n\n".join([made.shown(options), made.recorded(before), *([MARK] if made.changed(root) else [])])

    text = re.sub(r"\{\{(.*?)\}\}", table, (results / "page.md").read_text(encoding="utf-8"), flags=re.DOTALL)
    if left := sorted({*results.glob("*.csv")} - {table.path for table in used}):
        raise LookupError(f"{left[0]} is on no page: name it in {results / 'page.md'}, or delete it")
    return text


def this_machine():
    try:
        found = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    except OSError:
        found = None
    return f"{os.cpu_count()} cores of {found.group(1).strip() if found else 'an unknown machine'}"


def record(root, names, text, machine):
    """Writes tables in Markdown over those of the results."""
    lines = [[cell.strip() for cell in line.strip().strip("|").split("|")] if line.startswith("|") else None for line in text.splitlines()]
    found = []
    for before, line in zip([None, *lines], lines):
        if line and not before:
            found.append([])
        if line:
            found[-1].append(line)
    if len(found) != len(names):
        raise LookupError(f"{len(found)} tables for {len(names)} names: give one name for each table")
    commit = subprocess.run(["git", "-C", root, "rev-parse", "--short", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
    for name, (columns, _, *rows) in zip(names, found):
        table = Table(root / "bench/results" / f"{name}.csv")
        table.columns, table.rows = columns, rows
        table.facts |= {"commit": commit, "machine": machine, "date": date.today().isoformat(), "note": ""}
        table.write()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true")
    what.add_argument("--changed", action="store_true")
    what.add_argument("--record", nargs="+", metavar="NAME")
    parser.add_argument("--machine")
    options = parser.parse_args()
    root, page = options.root, options.root / "docs/figures.md"
    if options.changed:
        for path in sorted((root / "bench/results").glob("*.csv")):
            changed = Table(path).changed(root)
            print(f"{path.stem}: " + ("not known" if changed is None else ", ".join(changed) or "nothing"))
        return
    if options.record:
        record(root, options.record, sys.stdin.read(), options.machine or this_machine())
    made = page_of(root)
    if not options.check:
        page.write_text(made, encoding="utf-8")
    elif made.replace(f"\n\n{MARK}", "") != page.read_text(encoding="utf-8").replace(f"\n\n{MARK}", ""):
        sys.exit(f"{page} is not what bench/results gives: run bench/figures.py, and change what it should say there")


if __name__ == "__main__":
    try:
        main()
    except (LookupError, OSError) as error:
        sys.exit(f"figures.py: {error}")
