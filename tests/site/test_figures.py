"""Tests bench/figures.py, which writes docs/figures.md from bench/results."""
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / "bench/figures.py"
RESULT = """# command: measure --all
# commit: {commit}
# machine: a machine
# date: 2020-01-02
# files: code
# note: Two notes.
case,`a`,b
"one, 1",0.50 (1),2
two,3,
"""
TABLE = "| case | `a` | b |\n| --- | --- | --- |\n| one, 1 | 0.50 (1) | 2 |\n| two | 3 |  |\n"
MARK = "\n\n*Older than its code.*"
wants_git = unittest.skipUnless(shutil.which("git"), "there is no git")


class FiguresTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.result("not recorded")
        self.write("bench/results/page.md", "# Figures\n\n{{times}}\n")
        self.write("code/a.txt", "1")
        self.write("docs/figures.md", "")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def result(self, commit):
        self.write("bench/results/times.csv", RESULT.format(commit=commit))

    def git(self, *words, date="2020-01-01T12:00:00Z"):
        name = ["-c", "user.name=a", "-c", "user.email=a@b.c"]
        env = {"GIT_COMMITTER_DATE": date, "GIT_AUTHOR_DATE": date, "PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": str(self.root)}
        made = subprocess.run(["git", "-C", self.root, *name, *words], check=True, capture_output=True, text=True, env=env)
        return made.stdout.strip()

    def commit(self, date):
        self.git("add", "-A")
        self.git("commit", "-qm", "x", date=date)
        return self.git("rev-parse", "HEAD")

    def run_with(self, *options, text=""):
        return subprocess.run([sys.executable, "-B", PROGRAM, "--root", self.root, *options], input=text, capture_output=True, text=True, check=False)

    def page(self):
        made = self.run_with()
        self.assertEqual(made.returncode, 0, made.stderr)
        return (self.root / "docs/figures.md").read_text(encoding="utf-8")

    def test_a_table_stands_in_the_page_with_what_was_recorded_of_it(self):
        self.assertEqual(self.page(), f"# Figures\n\n{TABLE}\nBy `measure --all` on a machine, 2020-01-02. Two notes.\n")

    def test_columns_and_rows_can_be_left_out(self):
        self.write("bench/results/page.md", "{{times; columns: b | case; without: tw|3$}}")
        self.assertIn("| b | case |\n| --- | --- |\n| 2 | one, 1 |\n\nBy", self.page())
        self.write("bench/results/page.md", "{{times; columns: c}}")
        self.assertIn("no column 'c'", self.run_with().stderr)

    def test_a_check_finds_each_difference(self):
        self.assertIn("is not what", self.run_with("--check").stderr)
        self.page()
        self.assertEqual(self.run_with("--check").returncode, 0)
        self.result("abc")
        self.assertEqual(self.run_with("--check").returncode, 1)

    def test_what_lacks_is_said(self):
        for wrong, words in (("# machine: a machine\n", "machine"), ("two,3,\n", "cells"), ("# files: code\n", "files")):
            self.write("bench/results/times.csv", RESULT.replace(wrong, "two\n" if wrong.startswith("two") else ""))
            self.assertIn(words, self.run_with().stderr)
        self.write("bench/results/times.csv", RESULT.replace("files: code", "files: cod"))
        self.assertIn("there is no cod", self.run_with().stderr)
        self.write("bench/results/other.csv", RESULT)
        self.write("bench/results/times.csv", RESULT)
        self.assertIn("is on no page", self.run_with().stderr)

    @wants_git
    def test_a_table_is_marked_where_its_files_have_changed_since_its_commit(self):
        self.git("init", "-q")
        commit = self.commit("2020-01-01T12:00:00Z")
        self.result(commit)
        self.assertNotIn(MARK, self.page())
        self.write("other.txt", "2")
        self.commit("2020-01-01T13:00:00Z")
        self.assertNotIn(MARK, self.page())
        self.write("code/a.txt", "2")
        self.commit("2020-01-01T14:00:00Z")
        self.assertIn(MARK, self.page())
        self.assertEqual(self.run_with("--changed").stdout, "times: code/a.txt\n")
        self.write("docs/figures.md", self.page().replace(MARK, ""))
        self.assertEqual(self.run_with("--check").returncode, 0)

    @wants_git
    def test_without_a_commit_its_day_counts(self):
        self.git("init", "-q")
        self.commit("2020-01-02T22:00:00Z")
        self.assertNotIn(MARK, self.page())
        self.write("code/a.txt", "2")
        self.commit("2020-01-03T01:00:00Z")
        self.assertIn(MARK, self.page())

    @wants_git
    def test_tables_in_markdown_become_results_of_today(self):
        self.git("init", "-q")
        commit = self.commit("2020-01-01T12:00:00Z")
        made = self.run_with("--record", "times", "--machine", "another machine", text="words\n\n| case | c |\n| --- | --- |\n| x, 1 | `4` |\n\nwords\n")
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn("| case | c |\n| --- | --- |\n| x, 1 | `4` |\n\nBy `measure --all` on another machine,", self.page())
        self.assertIn(commit[:7], self.page())
        self.assertNotIn("Two notes.", self.page())
        self.assertIn("0 tables for 1 names", self.run_with("--record", "times").stderr)


if __name__ == "__main__":
    unittest.main()
