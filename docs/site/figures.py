"""Which tables of docs/figures.md become charts. No number stands here: a table that goes, or loses a column, ends the build."""
import charts
from tables import number, plain

PAGE = "docs/figures.md"
# Of which kind a method is, for its colour; the others are `other`.
OWN = {"general", "final-frame", "shadow", "glossy", "dual-cone", "trmv", "blur", "blur-straight", "blur-bent", "blur-split", "quell-denoise"}
INPUTS = {"none", "input"}


def kind_of(method):
    name = method.split(" ")[0]
    return "input" if name in INPUTS else "quell" if name in OWN else "other"


def scene_name(words):
    """`lamp, 1` with what the number means."""
    scene, _, samples = words.partition(", ")
    return f"{scene}, {samples} spp" if samples.isdigit() else words


class Figures:
    def __init__(self, tables):
        self.tables = tables
        self.makers = {
            ("times-memory-compiling", 0): self.times,
            ("cycles-three-scenes", 0): self.samples,
            ("beside-open-image-denoise", 0): self.beside_networks,
            ("beside-open-image-denoise", 1): self.beside_networks,
            ("all-presets", 0): self.speed_and_accuracy,
            ("motion-blur", 0): self.motion_blur,
            ("on-a-gpu", 0): self.gpu,
        }
        for heading, index in self.makers:
            tables.find(PAGE, heading, index)

    @staticmethod
    def pages():
        return {PAGE}

    def for_table(self, page, heading, index):
        """The chart of a table; empty where it has none."""
        maker = self.makers.get((heading, index))
        return maker(self.tables.find(page, heading, index)) if maker else ""

    def of(self, heading, index=0, **options):
        return self.makers[heading, index](self.tables.find(PAGE, heading, index), **options)

    @staticmethod
    def times(table):
        rows = [(plain(row[0]), number(table.of(row, "ms")), kind_of(plain(row[0]))) for row in table.rows]
        return charts.figure("Milliseconds per frame", "1920x1080, one thread; less is better", charts.bars(rows, 0, " ms"))

    @staticmethod
    def samples(table):
        """FLIP over the number of samples, a drawing for each scene."""
        scenes, drawings = {}, []
        for i, column in enumerate(table.columns[1:], 1):
            scene, count = plain(column).split(", ")
            scenes.setdefault(scene, []).append((int(count), i))
        wanted = (("none", "input"), ("svgf", "other"), ("general --extra-frames 0 --quick", "quell"), ("final-frame", "second"))
        rows = {plain(row[0]): row for row in table.rows}
        for scene, places in scenes.items():
            series = [(name, kind, [number(rows[name][i]) for _, i in places]) for name, kind in wanted]
            drawn = charts.lines([count for count, _ in places], series, "samples per pixel", "FLIP", f"FLIP over samples per pixel, {scene}")
            drawings.append(f"<div><h4>{scene}</h4>{drawn}</div>")
        return charts.figure(
            "Error over samples per pixel",
            "scenes of Blender's Cycles; lower is better",
            charts.legend(wanted) + f'<div class="several">{"".join(drawings)}</div>',
            "whole",
        )

    @staticmethod
    def beside_networks(table):
        titles = [plain(column) for column in table.columns[1:]]
        kinds = {"input": "input", "quell-denoise": "quell", "base": "second", "large": "other"}
        picked = [(i, title) for i, title in enumerate(titles, 1) if title in kinds]
        rows = [(scene_name(plain(row[0])), [number(row[i]) for i, _ in picked]) for row in table.rows if row[0].split(", ")[-1].isdigit()]
        return charts.figure(
            "Error beside Open Image Denoise's networks",
            "FLIP, scenes of Blender's Cycles; the networks see one frame at a time; lower is better",
            charts.dots([(title, kinds[title]) for _, title in picked], rows, 4, "FLIP"),
        )

    @staticmethod
    def speed_and_accuracy(table, wanted=None):
        cases = {}
        for row in table.rows:
            name = plain(table.of(row, "preset"))
            point = (name, number(table.of(row, "ms, 1080p")), number(table.of(row, "1080p: FLIP")), kind_of(name))
            cases.setdefault(plain(row[0]), []).append(point)
        wanted = wanted or sorted(cases, key=lambda case: not case.startswith("room"))
        if missing := [case for case in wanted if case not in cases]:
            raise LookupError(f"{PAGE}, all presets: no rows of {missing}")
        drawn = [
            (case, charts.scatter(cases[case], "ms per frame, 1920x1080", "FLIP", f"Milliseconds and FLIP of presets, {case}")) for case in wanted
        ]
        return charts.figure(
            "Speed against accuracy",
            "left is faster, lower is better; on the line nothing is both",
            charts.choice("Scene and effect", drawn),
        )

    @staticmethod
    def motion_blur(table):
        kinds = {"none": "input", "none-8spp-random": "second", "tilemax-blur": "other", "blur": "quell"}
        names = {"none-8spp-random": "8 samples, no denoiser", "none": "none (1 sample)"}
        places = [(table.column(name), name) for name in kinds]
        rows = [(plain(row[0]).split(",")[0], [number(row[i]) for i, _ in places]) for row in table.rows]
        return charts.figure(
            "Motion blur",
            "FLIP from one sample per pixel at a random time; lower is better",
            charts.dots([(names.get(name, name), kinds[name]) for _, name in places], rows, 4, "FLIP"),
        )

    @staticmethod
    def gpu(table):
        rows = [(plain(row[0]), number(table.of(row, "1920x1080")), kind_of(plain(row[0]))) for row in table.rows]
        return charts.figure("Milliseconds per frame on a GPU", "1920x1080; less is better", charts.bars(rows, 2, " ms"))
