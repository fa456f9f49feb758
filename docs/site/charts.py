"""Draws charts: bars and rows of dots as HTML, which wraps as text does, and the rest as SVG, once wide and once for a telephone. Their
colours are classes of the style sheet: `input`, `quell`, `other` and so on."""
import html
import math

WIDTHS = (("wide", 520, 340), ("narrow", 330, 330))


def shown(value, digits):
    return f"{value:.{digits}f}" if digits else f"{value:,.0f}"


def figure(title, note, drawn, kind=""):
    return (
        f'<figure class="chart {kind}"><figcaption><strong>{html.escape(title)}</strong> <span>{note}</span></figcaption>{drawn}</figure>\n'
    )


def bars(rows, digits, unit=""):
    """One bar per row of (label, value, class)."""
    most = max(value for _, value, _ in rows)
    made = "".join(
        f'<li class="{kind}"><span class="label">{html.escape(label)}</span><span class="track"><span class="bar" '
        f'style="width:{100 * value / most:.2f}%"></span></span><span class="value">{shown(value, digits)}{unit}</span></li>'
        for label, value, kind in rows
    )
    return f'<ul class="bars">{made}</ul>'


def legend(series):
    marks = "".join(f'<li><span class="dot {kind}"></span>{html.escape(name)}</li>' for name, kind in series)
    return f'<ul class="legend">{marks}</ul>'


def dots(series, rows, digits, note=""):
    """Rows of (label, values), a dot for each of `series`, which is of (name, class). The scale begins at 0."""
    most = max(value for _, values in rows for value in values) * 1.03
    made = []
    for label, values in rows:
        marks = "".join(
            f'<span class="dot {kind}" style="left:{100 * value / most:.2f}%" title="{html.escape(name)}: {shown(value, digits)}"></span>'
            for (name, kind), value in zip(series, values)
        )
        words = ", ".join(f"{name} {shown(value, digits)}" for (name, _), value in zip(series, values))
        made.append(
            f'<li><span class="label">{html.escape(label)}</span><span class="line" role="img" aria-label="{html.escape(words)}">'
            f"{marks}</span></li>"
        )
    scale = "".join(f'<span style="left:{100 * tick / most:.2f}%">{tick:g}</span>' for tick in ticks(0, most, 4))
    made.append(f'<li class="scale" aria-hidden="true"><span class="label">{note}</span><span class="line">{scale}</span></li>')
    return legend(series) + f'<ul class="dots">{"".join(made)}</ul>'


def ticks(least, most, count):
    """Round numbers from least to most."""
    step = 10 ** math.floor(math.log10((most - least) / count))
    step = next(step * k for k in (1, 2, 2.5, 5, 10) if (most - least) / (step * k) <= count)
    first = math.ceil(least / step - 1e-9)
    return [round(step * k, 10) for k in range(first, math.floor(most / step + 1e-9) + 1)]


class Plot:
    """An SVG of two axes. x is logarithmic, y begins at 0 or is logarithmic too."""

    def __init__(self, width, height, xs, ys, log_y=False, margin=(46, 12, 40, 14)):
        self.width, self.height, self.log_y = width, height, log_y
        self.left, self.right, self.bottom, self.top = margin
        self.x0, self.x1 = min(xs) / 1.25, max(xs) * 1.25
        self.y0, self.y1 = (min(ys) / 1.15, max(ys) * 1.15) if log_y else (0, max(ys) * 1.08)
        self.parts = []

    def x(self, value):
        part = math.log(value / self.x0) / math.log(self.x1 / self.x0)
        return self.left + part * (self.width - self.left - self.right)

    def y(self, value):
        part = math.log(value / self.y0) / math.log(self.y1 / self.y0) if self.log_y else value / self.y1
        return self.height - self.bottom - part * (self.height - self.bottom - self.top)

    def text(self, x, y, words, kind="", anchor="start"):
        self.parts.append(f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{html.escape(words)}</text>')

    def axes(self, x_title, y_title, x_ticks=None):
        low, right = self.height - self.bottom, self.width - self.right
        steps = [k * 10.0**p for p in range(-3, 6) for k in (1, 2, 5)]
        y_ticks = [t for t in steps if self.y0 <= t <= self.y1] if self.log_y else ticks(0, self.y1, 5)
        for tick in y_ticks:
            y = self.y(tick)
            self.parts.append(f'<path class="grid" d="M{self.left} {y:.1f}H{right}"/>')
            self.text(self.left - 6, y + 4, f"{tick:g}", "tick", "end")
        for tick in x_ticks or [t for t in steps if self.x0 <= t <= self.x1]:
            self.text(self.x(tick), low + 17, f"{tick:g}", "tick", "middle")
        self.parts.append(f'<path class="axis" d="M{self.left} {low}H{right}"/>')
        self.text(right, self.height - 4, x_title, "title", "end")
        self.text(2, 10, y_title, "title")

    def svg(self, kind, label):
        return (
            f'<svg class="plot {kind}" viewBox="0 0 {self.width} {self.height}" role="img" aria-label="{html.escape(label)}">'
            f"{''.join(self.parts)}</svg>"
        )


class Labels:
    """Puts words beside points, where they cover neither points nor each other."""

    def __init__(self, width, points):
        self.width, self.taken = width, [(x - 5, y - 5, x + 5, y + 5) for x, y in points]

    def place(self, x, y, words):
        """(x, y, anchor) of the words beside the point (x, y), or None where there is no room."""
        wide = 7.2 * len(words)  # of bold letters
        for dx, dy, anchor in ((9, 4, "start"), (-9, 4, "end"), (0, -10, "middle"), (0, 18, "middle"), (7, -7, "start"), (7, 16, "start"),
                               (-7, -7, "end"), (-7, 16, "end")):
            left = x + dx - {"start": 0, "middle": wide / 2, "end": wide}[anchor]
            box = (left, y + dy - 10, left + wide, y + dy + 3)
            own = (x - 5, y - 5, x + 5, y + 5)
            if box[0] < 2 or box[2] > self.width - 2 or box[1] < 14:
                continue
            if all(other == own or box[2] < other[0] or box[0] > other[2] or box[3] < other[1] or box[1] > other[3] for other in self.taken):
                self.taken.append(box)
                return x + dx, y + dy, anchor
        return None


def scatter(points, x_title, y_title, label):
    """Points of (name, x, y, class); the line joins those of which none is both further left and lower."""
    made = []
    for kind, width, height in WIDTHS:
        plot = Plot(width, height, [x for _, x, _, _ in points], [y for _, _, y, _ in points])
        plot.axes(x_title, y_title)
        front, least = [], math.inf
        for _, x, y, _ in sorted(points, key=lambda p: (p[1], p[2])):
            if y < least:
                front.append(f"{plot.x(x):.1f} {plot.y(y):.1f}")
                least = y
        plot.parts.append(f'<path class="front" d="M{"L".join(front)}"/>')
        labels = Labels(width, [(plot.x(x), plot.y(y)) for _, x, y, _ in points])
        # What matters most gets its words first, and all words lie below the points.
        ordered = sorted(points, key=lambda p: (p[3] != "quell", p[3] != "input"))
        for name, x, y, mark in ordered:
            if placed := labels.place(plot.x(x), plot.y(y), name):
                plot.text(placed[0], placed[1], name, mark, placed[2])
        for name, x, y, mark in reversed(ordered):
            plot.parts.append(
                f'<circle class="{mark}" cx="{plot.x(x):.1f}" cy="{plot.y(y):.1f}" r="5"><title>{html.escape(name)}: {x:g}, {y:g}</title></circle>'
            )
        made.append(plot.svg(kind, label))
    return "".join(made)


def lines(xs, series, x_title, y_title, label):
    """A line for each of `series`, which is of (name, class, values). Both axes are logarithmic."""
    plot = Plot(320, 250, xs, [value for _, _, values in series for value in values], log_y=True)
    plot.axes(x_title, y_title, xs)
    for name, kind, values in series:
        path = "L".join(f"{plot.x(x):.1f} {plot.y(y):.1f}" for x, y in zip(xs, values))
        plot.parts.append(f'<path class="line {kind}" d="M{path}"/>')
        for x, y in zip(xs, values):
            plot.parts.append(
                f'<circle class="{kind}" cx="{plot.x(x):.1f}" cy="{plot.y(y):.1f}" r="3.5"><title>{name}: {y:g} at {x:g}</title></circle>'
            )
    return plot.svg("", label)


def choice(name, shown_of):
    """Several drawings of which one is shown at a time; `shown_of` is of (title, drawing). Without scripts all are."""
    parts = "".join(f'<div data-title="{html.escape(title)}"><h4>{html.escape(title)}</h4>{drawn}</div>' for title, drawn in shown_of)
    return f'<div class="choice" data-name="{html.escape(name)}">{parts}</div>'
