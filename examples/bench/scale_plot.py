"""Draws the times of scale.sh: nanoseconds a body over the number of bodies, so that what grows as the number is level.

    python3 examples/bench/scale_plot.py build/scale      reads scale.csv and exponents.csv, writes scale.svg
"""
import csv
import math
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "test", "stability", "chart"))

from picture import GREY, short_number, ticks  # noqa: E402
from svg import Svg  # noqa: E402

# Colours that the colour-blind tell apart: Okabe and Ito, 2008.
LOOKS = {
    "field": ("boxes and circles that are stirred", "#D55E00", "circle"),
    "piles": ("pyramids of 55 boxes that stand", "#0072B2", "square"),
    "sweep": ("broadphase alone: sweep-and-prune", "#009E73", "up"),
    "tree": ("broadphase alone: AABB tree", "#777777", "down"),
}
TARGET = 1.1
LEFT, TOP, RIGHT, BOTTOM = 96.0, 112.0, 930.0, 560.0
SUPERSCRIPT = str.maketrans("0123456789.", "⁰¹²³⁴⁵⁶⁷⁸⁹·")


def read(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


class Axes:
    """Both logarithmic."""

    def __init__(self, bodies, ns):
        self.along = (min(bodies) / 1.3, max(bodies) * 1.5)
        self.up = (min(ns) / 1.6, max(ns) * 1.6)

    def at(self, bodies, ns):
        part = lambda value, ends: math.log(value / ends[0]) / math.log(ends[1] / ends[0])  # noqa: E731
        return LEFT + (RIGHT - LEFT) * part(bodies, self.along), BOTTOM - (BOTTOM - TOP) * part(ns, self.up)


def draw_frame(page, axes):
    for value in ticks(*axes.up, 12):
        y = axes.at(axes.along[0], value)[1]
        page.line(LEFT, y, RIGHT, y, "#DDDDDD", 0.7)
        page.text(LEFT - 8, y + 4.5, short_number(value), 13, anchor="end")
    for value in (10 ** k for k in range(3, 7)):
        if axes.along[0] <= value <= axes.along[1]:
            x = axes.at(value, axes.up[0])[0]
            page.line(x, TOP, x, BOTTOM, "#DDDDDD", 0.7)
            page.text(x, BOTTOM + 20, f"{value:,}", 13, anchor="middle")
    page.path([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], "#222222")


def draw_kind(page, axes, kind, rows, exponent):
    _, color, marker = LOOKS[kind]
    points = [(float(row["bodies"]), float(row["ns_per_body"])) for row in rows]
    (first, ns), last = points[0], max(min(1e5, points[-1][0]), points[0][0])
    # The most that the target allows, from the first point.
    page.path([axes.at(first, ns), axes.at(last, ns * (last / first) ** (TARGET - 1.0))], color, 1.2, "6 4")
    page.path([axes.at(*point) for point in points], color, 2.4)
    for point in points:
        page.mark(marker, *axes.at(*point), 5.0, color)
    x, y = axes.at(*points[-1])
    page.text(x + 12, y + 5, "N" + f"{exponent:.2f}".translate(SUPERSCRIPT), 15, color, bold=True)


def draw_legend(page, kinds):
    for number, kind in enumerate(kinds):
        words, color, marker = LOOKS[kind]
        x, y = LEFT + 30 + 400 * (number % 2), 632 + 24 * (number // 2)
        page.line(x, y - 5, x + 30, y - 5, color, 2.4)
        page.mark(marker, x + 15, y - 5, 5.0, color)
        page.text(x + 40, y, words, 13.5)


def main():
    folder = sys.argv[1]
    rows = read(os.path.join(folder, "scale.csv"))
    fits = read(os.path.join(folder, "exponents.csv"))
    page = Svg(1030, 720)
    axes = Axes([float(row["bodies"]) for row in rows], [float(row["ns_per_body"]) for row in rows])
    page.text(32, 44, "What a body costs as worlds grow", 24, bold=True)
    page.text(32, 72, "Level is linear: twice the bodies cost twice the time. Exponents are fitted from 1,000 to 100,000 bodies.", 13.5)
    page.text(LEFT, TOP - 10, "nanoseconds of processor time a body and step", 12.5, GREY)
    draw_frame(page, axes)
    for fit in fits:
        draw_kind(page, axes, fit["kind"], [row for row in rows if row["kind"] == fit["kind"]], float(fit["exponent"]))
    page.text(0.5 * (LEFT + RIGHT), BOTTOM + 44, "bodies N, at fixed density", 13.5, anchor="middle")
    draw_legend(page, [fit["kind"] for fit in fits])
    page.text(32, 700, f"Dashed: the target, N{str(TARGET).translate(SUPERSCRIPT)} from the first point. One core, sleeping off.", 11.5, GREY)
    page.save(os.path.join(folder, "scale.svg"))


if __name__ == "__main__":
    main()
