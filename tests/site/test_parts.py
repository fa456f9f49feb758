"""Tests what the site is made by: tables, charts, colours of code, links."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/site"))

import charts
import check
import highlight
from build import put_live
from figures import Figures
from pages import Pages, place_of
from pictures import FRONT, GALLERY, Programs, paths, small
from skin import Skin
from tables import Tables, number, plain, slug


def written(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


class TablesTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        page = "# Page\n\n## A part, of it\n\n| name | a \\| b |\n| --- | --- |\n| `x`, `y` | **1.5** (2) |\n| z |\n\ntext\n\n| n |\n| --- |\n| 7 |\n"
        self.page = written(self.folder.name, "page.md", page + "```sh\n| no | table |\n| --- | --- |\n```\n")
        self.tables = Tables([self.page])

    def test_reads_tables_by_heading_and_number(self):
        table = self.tables.find(self.page, "a-part-of-it")
        self.assertEqual(table.columns, ["name", "a | b"])
        self.assertEqual(table.rows, [["`x`, `y`", "**1.5** (2)"], ["z", ""]])
        self.assertEqual(self.tables.find(self.page, "a-part-of-it", 1).rows, [["7"]])
        self.assertEqual(len(self.tables.all), 2)
        with self.assertRaisesRegex(LookupError, "has no table 2"):
            self.tables.find(self.page, "a-part-of-it", 2)

    def test_finds_rows_and_columns_or_says_what_lacks(self):
        self.assertEqual(self.tables.row_about(self.page, "y")["a | b"], "**1.5** (2)")
        table = self.tables.find(self.page, "a-part-of-it")
        with self.assertRaisesRegex(LookupError, "no column 'FLIP' among"):
            table.column("FLIP")

    def test_takes_the_first_number(self):
        self.assertEqual([number("**0.25** (3)"), number("-4 %"), number("1,200 ms")], [0.25, -4, 1200])
        with self.assertRaises(ValueError):
            number("none")
        self.assertEqual(plain("[`general`](presets.md)"), "general")
        self.assertEqual(slug("`general`: two, or 3"), "general-two-or-3")


class ChartsTest(unittest.TestCase):
    def test_bars_are_as_long_as_their_values(self):
        drawn = charts.bars([("a", 2, "quell"), ("b", 0.5, "other")], 1, " ms")
        self.assertIn('width:100.00%', drawn)
        self.assertIn('width:25.00%', drawn)
        self.assertIn("0.5 ms", drawn)

    def test_dots_stand_on_a_scale_from_0(self):
        drawn = charts.dots([("a", "input"), ("b", "quell")], [("row", [1.0, 0.5])], 2)
        self.assertIn('left:97.09%', drawn)
        self.assertIn('left:48.54%', drawn)
        self.assertIn('aria-label="a 1.00, b 0.50"', drawn)

    def test_a_plot_is_logarithmic_along_x(self):
        plot = charts.Plot(400, 200, [1, 100], [1.0])
        self.assertAlmostEqual(plot.x(10), (plot.x(1) + plot.x(100)) / 2)
        self.assertAlmostEqual(plot.y(0), 200 - plot.bottom)

    def test_the_front_joins_what_nothing_beats(self):
        points = [("slow", 100, 1.0, "other"), ("fast", 1, 4.0, "input"), ("beaten", 50, 5.0, "other"), ("good", 10, 2.0, "quell")]
        drawn = charts.scatter(points, "ms", "error", "words")
        front = drawn[drawn.index('class="front" d="') :].split('"')[3]
        self.assertEqual(front.count("L"), 2)  # fast, good, slow

    def test_labels_cover_no_points(self):
        labels = charts.Labels(200, [(50, 100), (70, 100)])
        x, y, anchor = labels.place(50, 100, "word")
        self.assertEqual(anchor, "end")  # on the right is the other point
        crowd = [(50 + dx, 100 + dy) for dx in range(-40, 41, 8) for dy in range(-24, 25, 8)]
        self.assertIsNone(charts.Labels(200, crowd).place(50, 100, "word"))


class PagesTest(unittest.TestCase):
    def test_code_is_escaped_and_coloured(self):
        self.assertEqual(
            highlight.highlighted('int a<b>; // "x"', "cpp"), '<span class="keyword">int</span> a&lt;b&gt;; <span class="comment">// "x"</span>'
        )
        self.assertEqual(highlight.highlighted("a --b 'c' <d>", "text"), "a --b 'c' &lt;d&gt;")

    def test_pages_have_places(self):
        self.assertEqual(place_of("docs/using.md"), "docs/using.html")
        self.assertEqual(place_of("README.md"), "docs/readme.html")
        self.assertIsNone(place_of("docs/plans/draw.sh"))
        self.assertIsNone(place_of("examples/notes.md"))

    def test_headings_have_the_anchors_of_github(self):
        found = []
        made = Pages._with_anchors(None, "<h2>A <code>b-c</code>, d</h2><h2>A <code>b-c</code>, d</h2>", found)
        self.assertEqual([anchor for _, anchor, _ in found], ["a-b-c-d", "a-b-c-d-1"])
        self.assertIn('id="a-b-c-d-1"', made)


class SkinTest(unittest.TestCase):
    def test_the_live_page_is_linked_where_there_is_one(self):
        self.assertIn('href="../live/index.html"', Skin(True).top("../"))
        self.assertNotIn("live", Skin(False).top("../"))

    def test_the_page_that_is_shown_is_marked(self):
        self.assertEqual(Skin(False).top("", "Docs").count("aria-current"), 1)


class LiveTest(unittest.TestCase):
    def test_the_live_page_gets_the_top_and_bottom_of_the_site(self):
        with tempfile.TemporaryDirectory() as folder:
            written(folder, "made/index.html", "a<!-- top -->own\ntop<!-- /top -->b<!-- bottom -->c")
            put_live(os.path.join(folder, "made"), os.path.join(folder, "live"), Skin(True))
            with open(os.path.join(folder, "live/index.html"), encoding="utf-8") as text:
                page = text.read()
        self.assertRegex(page, r'(?s)^a.*aria-current=page>Live<.*b<footer.*</footer>c$')
        self.assertNotIn("own", page)


class CheckTest(unittest.TestCase):
    def mistakes(self, page):
        with tempfile.TemporaryDirectory() as folder:
            written(folder, "a/index.html", page)
            written(folder, "b.html", '<h2 id="here">x</h2>')
            return list(check.mistakes(folder))

    def test_links_that_lead_somewhere_pass(self):
        self.assertEqual(self.mistakes('<a href="../b.html#here">x</a><a href="https://example.org">y</a>'), [])

    def test_each_link_that_leads_nowhere_is_a_mistake(self):
        found = self.mistakes('<a href="../c.html">x</a><a href="../b.html#there">x</a><img src="no.png">')
        self.assertEqual(len(found), 4)
        self.assertIn("no.png has no alt", found[0])

    def test_a_page_loads_nothing_from_elsewhere(self):
        self.assertIn("from elsewhere", "".join(self.mistakes('<a href="../b.html">x</a><script src="https://example.org/x.js"></script>')))

    def test_a_folder_without_links_is_a_mistake(self):
        self.assertEqual(len(self.mistakes("<p>x</p>")), 1)


class PicturesTest(unittest.TestCase):
    def test_pictures_are_made_once(self):
        with tempfile.TemporaryDirectory() as folder:
            # Stands in for all programs: the last argument of write_png is what it writes.
            program = written(folder, "program", '#!/bin/sh\necho x >> "$(dirname "$0")/calls"\nfor last; do :; done\ncase $last in *.png) echo > "$last";; esac\n')
            os.chmod(program, 0o755)
            programs, kept = Programs(program, program, program), os.path.join(folder, "kept")

            def calls():
                with open(os.path.join(folder, "calls"), encoding="utf-8") as text:
                    return len(text.read().split())

            shot = small(FRONT)
            programs.make(shot, kept)
            self.assertEqual(calls(), 6)  # traced, denoised, the reference, three pictures
            self.assertTrue(all(map(os.path.exists, paths(shot, kept))))
            programs.make(shot, kept)
            self.assertEqual(calls(), 6)
            programs.make(FRONT, kept)
            self.assertEqual(calls(), 12)  # another size
            with open(program, "a", encoding="utf-8") as text:
                text.write("# newer\n")
            programs.make(FRONT, kept)
            self.assertEqual(calls(), 18)  # another program

    def test_names_of_pictures_differ(self):
        self.assertEqual(len({shot.name() for shot in [FRONT, *GALLERY]}), 1 + len(GALLERY))


if __name__ == "__main__":
    unittest.main()
