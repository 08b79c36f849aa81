"""Draws the times of scale.sh: nanoseconds a body over the number of bodies, so that what grows as the number is level.

    python3 examples/bench/scale_plot.py build/scale      reads scale.csv and exponents.csv, writes scale.svg and scale.png
"""
import csv
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "test", "stability", "chart"))

from picture import GOOD_COLOR, plt, save, set_ticks, short_number, ticks  # noqa: E402

# Colours that the colour-blind tell apart: Okabe and Ito, 2008.
LOOKS = {
    "field": ("boxes and circles that are stirred", "#D55E00", "o"),
    "piles": ("pyramids of 55 boxes that stand", "#0072B2", "s"),
    "sweep": ("broadphase alone: sweep-and-prune", "#009E73", "^"),
    "tree": ("broadphase alone: AABB tree", "#777777", "v"),
}
TARGET = 1.1


def read(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def draw_kind(axes, kind, rows, exponent):
    words, color, marker = LOOKS[kind]
    bodies, ns = [float(row["bodies"]) for row in rows], [float(row["ns_per_body"]) for row in rows]
    axes.plot(bodies, ns, color=color, marker=marker, ms=8, lw=2.2, mec="white", mew=0.6, zorder=5, label=words)
    # The most that the target allows, from the first point.
    axes.plot([bodies[0], 1e5], [ns[0], ns[0] * (1e5 / bodies[0]) ** (TARGET - 1.0)], color=color, lw=1.2, ls=(0, (5, 3)), alpha=0.7, zorder=3)
    axes.annotate(f"$N^{{{exponent:.2f}}}$", (bodies[-1], ns[-1]), xytext=(11, 0), textcoords="offset points", color=color, fontsize=15, va="center")


def main():
    folder = sys.argv[1]
    rows = read(os.path.join(folder, "scale.csv"))
    figure, axes = plt.subplots(figsize=(11, 8.2))
    figure.subplots_adjust(left=0.095, right=0.965, top=0.86, bottom=0.2)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for fit in read(os.path.join(folder, "exponents.csv")):
        draw_kind(axes, fit["kind"], [row for row in rows if row["kind"] == fit["kind"]], float(fit["exponent"]))
    ns = [float(row["ns_per_body"]) for row in rows]
    low, high = min(ns) / 1.6, max(ns) * 1.6
    axes.set_xlim(800, 2.0 * max(float(row["bodies"]) for row in rows))
    axes.set_ylim(low, high)
    along, up = [1e3, 1e4, 1e5, 1e6], ticks(low, high, 12)
    set_ticks(axes.xaxis, along, ["1,000", "10,000", "100,000", "1,000,000"], 12)
    set_ticks(axes.yaxis, up, [short_number(value) for value in up], 12)
    axes.grid(True, which="major", color="#DDDDDD", lw=0.7)
    axes.set_xlabel("bodies N, at fixed density", fontsize=13)
    axes.set_ylabel("nanoseconds of processor time a body and step", fontsize=13)
    figure.text(0.03, 0.945, "What a body costs as worlds grow", fontsize=19, fontweight="bold")
    figure.text(0.03, 0.895, "Level is linear: twice the bodies cost twice the time. Exponents are fitted from 1,000 to 100,000 bodies.", fontsize=12.5)
    figure.text(0.03, 0.02, f"Dashed: the target, $N^{{{TARGET}}}$ from the first point.  One core, sleeping off.", fontsize=10.5, color="#444444")
    figure.legend(loc="lower center", ncol=2, fontsize=12, frameon=False, bbox_to_anchor=(0.53, 0.055))
    save(figure, os.path.join(folder, "scale"))


if __name__ == "__main__":
    main()
