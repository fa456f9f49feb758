"""The tables of the Markdown pages, by which the site's charts and choices go, so that no number stands twice."""
import re
from dataclasses import dataclass


def slug(heading):
    """The anchor of a heading on GitHub."""
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).replace(" ", "-")


def cells(line):
    """What stands between the bars of a row; a bar behind a backslash is text."""
    return [cell.replace("\\|", "|").strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


def number(cell):
    """The first number of a cell: 0.0726 of `0.0726 (0.0193)`."""
    found = re.search(r"-?\d+(?:[.,]\d+)*", cell)
    if not found:
        raise ValueError(f"no number in '{cell}'")
    return float(found.group().replace(",", ""))


def plain(cell):
    """Without the signs of Markdown."""
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", cell).replace("`", "").replace("*", "").strip()


@dataclass
class Table:
    page: str  # where it stands
    heading: str  # the anchor of its section
    index: int  # 0: the first table of that section
    columns: list
    rows: list  # of lists, as long as columns

    def column(self, title):
        """The number of the column of that title."""
        titles = [plain(column) for column in self.columns]
        if title not in titles:
            raise LookupError(f"{self.page}, #{self.heading}: no column '{title}' among {titles}; docs/site/figures.py asks for it")
        return titles.index(title)

    def of(self, row, title):
        return row[self.column(title)]


class Tables:
    """All tables of some Markdown files."""

    def __init__(self, files):
        self.all = [table for file in files for table in tables_in(file)]

    def find(self, page, heading, index=0):
        for table in self.all:
            if (table.page, table.heading, table.index) == (page, heading, index):
                return table
        raise LookupError(f"{page} has no table {index} below #{heading}; docs/site/figures.py or guide.py asks for it")

    def row_about(self, page, name):
        """The first row of a page whose first cell names `name`, as {title: cell}."""
        for table in self.all:
            for row in table.rows:
                if table.page == page and name in [plain(one) for one in row[0].split(",")]:
                    return dict(zip(map(plain, table.columns), row))
        raise LookupError(f"{page} has no row about '{name}'")


def tables_in(file):
    heading, index, table, in_code = "", 0, None, False
    with open(file, encoding="utf-8") as text:
        lines = text.read().split("\n")
    for line, after in zip(lines, lines[1:] + [""]):
        if line.startswith("```"):
            in_code = not in_code
        if in_code:
            continue
        if found := re.match(r"#+ (.*)", line):
            heading, index = slug(found.group(1)), 0
        if table is None and line.startswith("|") and re.fullmatch(r"[|\s:-]+", after):
            table = Table(file, heading, index, cells(line), [])
        elif table is not None and line.startswith("|"):
            if not re.fullmatch(r"[|\s:-]+", line):
                row = cells(line)
                table.rows.append(row + [""] * (len(table.columns) - len(row)))
        elif table is not None:
            yield table
            table, index = None, index + 1
