"""Draws one scene: error against cost, both logarithmic. Solvers of the library and engines that ran with it are
curves over their substeps, other engines marks; what fell stands in a strip at the top, what is exact but for
rounding in one at the bottom.
"""
import math
from collections import namedtuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Polygon  # noqa: E402
from matplotlib.ticker import FixedFormatter, FixedLocator, NullFormatter, NullLocator  # noqa: E402

from labels import POINT_RADIUS, RING_RADIUS, Labels  # noqa: E402
from points import front  # noqa: E402

# Colours that the colour-blind tell apart: Okabe and Ito, 2008.
Look = namedtuple("Look", "name color marker")
OURS = {
    "auto": Look("Cairn, default solver", "#0072B2", "o"),
    "direct": Look("Cairn, solver 'direct'", "#009E73", "s"),
    "soft": Look("Cairn, solver 'soft'", "#56B4E9", "v"),
    "sequential": Look("Cairn, solver 'sequential'", "#000000", "P"),
}
PEERS = {
    "box2d": Look("Box2D 3.2", "#D55E00", "D"),
    "box2dT": Look("Box2D 3.2, stiffer contacts or joints", "#D55E00", "d"),
    "chipmunk": Look("Chipmunk 7", "#E69F00", "^"),
    "rapier": Look("Rapier 0.36", "#7B4FA3", "p"),
    "avbd": Look("AVBD", "#CC79A7", "X"),
    "s2": Look("the solvers of Solver2D", "#777777", "x"),
}
FRONT_COLOR, GOOD_COLOR, FELL_COLOR, EXACT_COLOR = "#333333", "#2E8B57", "#B03A2E", "#5A6B7B"

plt.rcParams.update({
    "font.size": 12, "svg.hashsalt": "chart", "svg.fonttype": "path", "axes.spines.top": False, "axes.spines.right": False,
    "axes.axisbelow": True, "font.family": "DejaVu Sans",
})


def look_of(engine):
    return OURS.get(engine) or PEERS.get("s2" if engine.startswith("s2_") else engine) or Look(engine, "#777777", "*")


def words_of(point):
    """ss4 -> 4; an engine's own words stay."""
    return point.setting[2:] if point.setting[2:].isdigit() else point.setting


def spelled(setting):
    """'240Hz it10' -> '10 iterations, 240 steps a second'."""
    words = []
    for word in setting.split():
        if word.startswith("ss"):
            words.insert(0, f"{word[2:]} substep{'' if word == 'ss1' else 's'}")
        elif word.startswith("it"):
            words.insert(0, f"{word[2:]} iterations")
        elif word.endswith("Hz"):
            words += [] if word == "60Hz" else [f"{word[:-2]} steps/s"]
        elif word.startswith(("jh", "ch")):
            words.append(("joints " if word[0] == "j" else "contacts ") + f"{word[2:]} Hz")
        else:
            words.append(word)
    return ", ".join(words)


def full_words(point):
    name = point.engine[3:].replace("_", " ") if point.engine.startswith("s2_") else look_of(point.engine).name
    words = spelled(point.setting)
    if point.engine == "chipmunk":
        words = words.replace("substeps", "steps a frame").replace("substep", "step a frame")
    return f"{'Box2D 3.2' if point.engine == 'box2dT' else name}: {words}"


# ---------------------------------------------------------------- limits: where strips and points lie

class Scale:
    """Decades of the vertical axis: exact strip, errors, fallen strip."""

    def __init__(self, scene, points, limit):
        standing = [point.error for point in points if not point.fell]
        seen = [error for error in standing if error > scene.floor] + ([limit] if limit else [])
        seen = seen or [scene.floor]
        self.floor = scene.floor
        self.has_exact = any(error <= scene.floor for error in standing)
        self.has_fallen = any(point.fell for point in points)
        low = math.log10(scene.floor) if self.has_exact else math.log10(min(seen)) - 0.2
        high = max(math.log10(max(seen)) + 0.2, low + 1.0)
        strip = 0.085 * (high - low)
        self.exact_top, self.fallen_bottom = 10.0 ** low, 10.0 ** high
        self.exact_y, self.fallen_y = 10.0 ** (low - 0.5 * strip), 10.0 ** (high + 0.5 * strip)
        self.low = 10.0 ** (low - strip) if self.has_exact else 10.0 ** low
        self.high = 10.0 ** (high + strip) if self.has_fallen else 10.0 ** high

    def y(self, point):
        if point.fell:
            return self.fallen_y
        return point.error if point.error > self.floor else self.exact_y


def short_number(value):
    if 0.01 <= value < 10000.0:
        return f"{value:.10g}"
    mantissa, exponent = f"{value:.0e}".split("e")
    return f"$10^{{{int(exponent)}}}$" if mantissa == "1" else f"${mantissa}\\cdot10^{{{int(exponent)}}}$"


def ticks(low, high, most):
    """Powers of ten between two numbers, at most so many; with 2 and 5 in between where there is room."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    if math.log10(high / low) < 0.4 * most:
        fine = [m * 10.0 ** e for e in range(first - 1, last + 1) for m in (1, 2, 5)]
        return [value for value in fine if low <= value <= high]
    step = (last - first) // most + 1
    return [10.0 ** e for e in range(first, last + 1, step)]


def set_ticks(axis, values, words, size):
    axis.set_major_locator(FixedLocator(values))
    axis.set_major_formatter(FixedFormatter(words))
    axis.set_minor_locator(NullLocator())
    axis.set_minor_formatter(NullFormatter())
    axis.set_tick_params(labelsize=size, length=3)


def frame(axes, scene, points, scale, small):
    costs = [point.cost_us for point in points]
    left, right, size = min(costs) / 1.6, max(costs) * 1.8, 10 if small else 12
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(left, right)
    axes.set_ylim(scale.low, scale.high)
    along, up = ticks(left, right, 5 if small else 8), ticks(scale.exact_top, scale.fallen_bottom, 5 if small else 9)
    # What lies in a strip has no number: the strip's name stands there.
    margin = (scale.fallen_bottom / scale.exact_top) ** 0.03
    if scale.has_exact:
        up = [value for value in up if value > scale.exact_top * margin]
    if scale.has_fallen:
        up = [value for value in up if value < scale.fallen_bottom / margin]
    words = [short_number(value) for value in up]
    if scale.has_fallen:
        axes.axhspan(scale.fallen_bottom, scale.high, color=FELL_COLOR, alpha=0.10, lw=0)
        up, words = up + [scale.fallen_y], words + [strip_name(scene)]
    if scale.has_exact:
        axes.axhspan(scale.low, scale.exact_top, color=EXACT_COLOR, alpha=0.13, lw=0)
        up, words = up + [scale.exact_y], words + ["$\\leq$" + short_number(scene.floor)]
    axes.grid(True, which="major", color="#DDDDDD", lw=0.7)
    set_ticks(axes.xaxis, along, [short_number(value) for value in along], size)
    set_ticks(axes.yaxis, up, words, size)
    for label, word in zip(axes.get_yticklabels(), words):
        if word == strip_name(scene):
            label.set_color(FELL_COLOR)


def strip_name(scene):
    return "broke" if scene.name.startswith(("2", "3", "11")) else "fell"


def better_corner(axes, small):
    reach = 0.2 if small else 0.15
    axes.add_patch(Polygon([(0, 0), (1.3 * reach, 0), (0, 1.6 * reach)], transform=axes.transAxes, color=GOOD_COLOR, alpha=0.12, lw=0, zorder=0))
    axes.annotate("", (0.006, 0.012), (0.55 * reach, 0.8 * reach), xycoords="axes fraction", zorder=1,
                  arrowprops=dict(arrowstyle="-|>", color=GOOD_COLOR, lw=1.8 if small else 2.4, alpha=0.7))
    if small:
        return []
    return [axes.text(0.55 * reach, 0.83 * reach, "better", transform=axes.transAxes, color=GOOD_COLOR, fontsize=12, fontweight="bold")]


# ---------------------------------------------------------------- marks

def group(points):
    series = {}
    for point in points:
        series.setdefault(point.engine, []).append(point)
    for of_engine in series.values():
        of_engine.sort(key=lambda point: int(words_of(point)) if words_of(point).isdigit() else 0)
    return series


def same_as_default_solver(series):
    """Solvers of ours whose errors are those of the default one at every setting: they would hide it."""
    reference = [(point.setting, point.error) for point in series.get("auto", [])]
    return [engine for engine in ("direct", "soft") if [(point.setting, point.error) for point in series.get(engine, [])] == reference and reference]


def draw_curve(axes, scale, of_engine, small):
    look = look_of(of_engine[0].engine)
    ours = of_engine[0].engine in OURS
    lead = of_engine[0].engine == "auto"
    width = (2.6 if lead else 1.6) * (0.8 if small else 1.0)
    size = (8 if lead else 6.5) * (0.75 if small else 1.0)
    # No line leads to what fell: there is nothing between.
    axes.plot([point.cost_us for point in of_engine], [math.nan if point.fell else scale.y(point) for point in of_engine],
              color=look.color, lw=width, ls="-" if ours else "--", zorder=6 if lead else 5 if ours else 4)
    axes.plot([point.cost_us for point in of_engine], [scale.y(point) for point in of_engine], color=look.color, ls="",
              marker=look.marker, ms=size, mec="white", mew=0.6, zorder=6 if lead else 5 if ours else 4, clip_on=False)


def draw_marks(axes, scale, of_engine, small):
    look = look_of(of_engine[0].engine)
    axes.plot([point.cost_us for point in of_engine], [scale.y(point) for point in of_engine], ls="", color=look.color,
              marker=look.marker, ms=5 if small else 7, mfc="none", mew=1.2 if small else 1.5, zorder=3, clip_on=False)


def ring_defaults(axes, scale, points, small):
    for point in points:
        if point.default:
            axes.plot([point.cost_us], [scale.y(point)], ls="", marker="o", ms=12 if small else 17, mfc="none",
                      mec=look_of(point.engine).color, mew=1.6 if small else 2.0, zorder=7, clip_on=False)


def front_steps(axes, scale, points):
    """Corners of the line that bounds what engines reach: down to a point, right to the next."""
    best = front(points)
    if not best:
        return []
    corners = [(best[0].cost_us, scale.fallen_bottom)]
    for point in best:
        corners += [(point.cost_us, corners[-1][1]), (point.cost_us, scale.y(point))]
    return corners + [(axes.get_xlim()[1], corners[-1][1])]


def draw_front(axes, corners):
    axes.plot([x for x, _ in corners], [y for _, y in corners], color=FRONT_COLOR, lw=1.2, ls=(0, (1, 1.2)), zorder=2)


def draw_scene(axes, scene, points, limit, small=False):
    """Returns words that labels must keep clear of, the scale, and the solvers left out because they equal the default one."""
    scale = Scale(scene, points, limit)
    series = group(points)
    same = same_as_default_solver(series)
    frame(axes, scene, points, scale, small)
    words = better_corner(axes, small)
    if limit:
        axes.axhline(limit, color=GOOD_COLOR, lw=1.4, ls=(0, (6, 3)), zorder=2)
        if not small:
            words.append(axes.text(0.995, limit, "target " + short_number(limit), transform=axes.get_yaxis_transform(), color=GOOD_COLOR,
                                   fontsize=11, ha="right", va="bottom"))
    for engine, of_engine in series.items():
        if engine in same:
            continue
        if of_engine[0].here:
            draw_curve(axes, scale, of_engine, small)
        else:
            draw_marks(axes, scale, of_engine, small)
    draw_front(axes, front_steps(axes, scale, points))
    ring_defaults(axes, scale, points, small)
    return words, scale, same


# ---------------------------------------------------------------- legend

def legend_entries(points_lists, same_everywhere=()):
    engines = {point.engine: point.here for points in points_lists for point in points if point.engine not in same_everywhere}
    entries = []
    for engine in OURS:
        if engine in engines:
            look = OURS[engine]
            entries.append(Line2D([], [], color=look.color, marker=look.marker, ms=8, lw=2.4 if engine == "auto" else 1.6, mec="white", label=look.name))
    for engine, look in PEERS.items():
        present = [here for name, here in engines.items() if name == engine or (engine == "s2" and name.startswith("s2_"))]
        if not present:
            continue
        here = present[0]
        label = look.name if here else f"{look.name} *"
        entries.append(Line2D([], [], color=look.color, marker=look.marker, ms=8, lw=1.6 if here else 0, ls="--" if here else "",
                              mfc=look.color if here else "none", mew=1.5 if not here else 0.6, label=label))
    entries.append(Line2D([], [], color="#555555", marker="o", ms=13, mfc="none", mew=1.8, lw=0, label="default setting"))
    entries.append(Line2D([], [], color=FRONT_COLOR, lw=1.2, ls=(0, (1, 1.2)), label="Pareto front: nothing is both cheaper and better"))
    entries.append(Line2D([], [], color=GOOD_COLOR, lw=1.4, ls=(0, (6, 3)), label="target of the stability suite"))
    return entries


ELSEWHERE_NOTE = "* hollow marks: measured on another machine; accuracy compares, cost only roughly."


def notes(points_lists):
    return ELSEWHERE_NOTE if any(not point.here for points in points_lists for point in points) else ""


def save(figure, path, dpi=110):
    figure.savefig(path + ".svg", metadata={"Date": None})
    figure.savefig(path + ".png", dpi=dpi)
    plt.close(figure)


# ---------------------------------------------------------------- one scene on a page

def obstacles(labels, axes, points, shown, scale, words):
    for text in words:
        labels.keep_clear_of(text)
    for point in shown:
        labels.keep_clear(point.cost_us, scale.y(point), radius_of(point))
    corners = front_steps(axes, scale, points)
    for of_engine in group([point for point in shown if point.here]).values():
        path = [(point.cost_us, scale.y(point)) for point in of_engine if not point.fell]
        for (x0, y0), (x1, y1) in zip(path, path[1:]):
            labels.keep_clear_of_line(x0, y0, x1, y1)
    for (x0, y0), (x1, y1) in zip(corners, corners[1:]):
        labels.keep_clear_of_line(x0, y0, x1, y1)


def radius_of(point):
    return RING_RADIUS if point.default else POINT_RADIUS


def named_peers(points, shown):
    """Whom a reader looks for: the defaults, those on the front, the most accurate."""
    named = [point for point in shown if point.default and point.engine not in OURS]
    named += [point for point in front(points) if point.engine not in OURS and point not in named]
    standing = [point for point in shown if point.engine not in OURS and not point.fell]
    most_accurate = min(standing, key=lambda point: (point.error, point.cost_us), default=None)
    return named + ([most_accurate] if most_accurate and most_accurate not in named else [])


def label_points(axes, scene, points, scale, same, words):
    labels = Labels(axes, 10.5)
    shown = [point for point in points if point.engine not in same]
    obstacles(labels, axes, points, shown, scale, words)

    def add(point, text, weight="normal"):
        labels.add(point.cost_us, scale.y(point), radius_of(point), text, look_of(point.engine).color, weight)

    for point in shown:
        if point.engine == "auto":
            add(point, words_of(point), "bold")
    named = named_peers(points, shown)
    for point in named:
        add(point, full_words(point))
    for point in shown:
        if point.here and point.engine not in ("auto", "sequential") and point not in named and not point.fell:
            add(point, words_of(point))


def scene_page(scene, points, limit, path):
    figure, axes = plt.subplots(figsize=(11, 8.2))
    figure.subplots_adjust(left=0.095, right=0.965, top=0.855, bottom=0.285)
    words, scale, same = draw_scene(axes, scene, points, limit)
    axes.set_xlabel("cost: microseconds of processor time a frame of 1/60 s", fontsize=13)
    axes.set_ylabel(scene.axis, fontsize=13)
    figure.text(0.03, 0.955, scene.title, fontsize=19, fontweight="bold")
    figure.text(0.03, 0.895, wrapped(scene.caption, 118), fontsize=12.5, va="center", linespacing=1.35)
    figure.canvas.draw()
    label_points(axes, scene, points, scale, same, words)
    figure.legend(handles=legend_entries([points], same), loc="lower center", ncol=3, fontsize=11, frameon=False,
                  bbox_to_anchor=(0.5, 0.062))
    small_print = ["Numbers on curves: substeps a frame."]
    if scale.has_fallen:
        small_print.append(f"'{strip_name(scene)}': the scene did not survive.")
    if same:
        names = " and ".join(f"'{engine}'" for engine in same)
        small_print.append(f"Same errors as the default solver, not drawn: {names}.")
    figure.text(0.03, 0.020, "  ".join(small_print) + "\n" + notes([points]), fontsize=10.5, color="#444444", linespacing=1.4)
    save(figure, path)


def wrapped(text, columns):
    lines, line = [], ""
    for word in text.split():
        if len(line) + len(word) + 1 > columns and line:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    return "\n".join(lines + [line])


# ---------------------------------------------------------------- summary

def summary_page(panels, path, columns=4, dpi=110):
    """panels: (scene, points, limit)."""
    rows = (len(panels) + columns - 1) // columns
    wide = columns > 3
    legend = 2.5 if wide else 2.85
    figure, grid = plt.subplots(rows, columns, figsize=(4.75 * columns, 4.3 * rows + 1.0 + legend))
    height, width = figure.get_figheight(), figure.get_figwidth()
    figure.subplots_adjust(left=1.0 / width, right=1.0 - 0.29 / width, top=1.0 - 1.95 / height, bottom=legend / height, hspace=0.43, wspace=0.22)
    cells = list(grid.flat)
    hidden = []
    for axes, (scene, points, limit) in zip(cells, panels):
        hidden.append(draw_scene(axes, scene, points, limit, small=True)[2])
        axes.set_title(f"{scene.title}\n", fontsize=13 if wide else 15, fontweight="bold", loc="left", pad=4)
        axes.text(0.0, 1.025, scene.axis, transform=axes.transAxes, fontsize=11 if wide else 13, color="#444444")
    for axes in cells[len(panels):]:
        axes.axis("off")
    for axes in cells[len(panels) - columns:len(panels)]:
        axes.set_xlabel("microseconds a frame", fontsize=12 if wide else 13)
    figure.text(0.38 / width, 1.0 - 0.55 / height, "How wrong is each engine, and what does it cost?", fontsize=25, fontweight="bold")
    words = "Each panel is one scene. Down is more accurate, left is cheaper: the nearer to the corner at the bottom left, the better."
    figure.text(0.38 / width, 1.0 - 1.05 / height, words + " Both axes are logarithmic." if wide else words, fontsize=15)
    lists = [points for _, points, _ in panels]
    never_drawn = [engine for engine in OURS if all(engine in same for same in hidden)]
    figure.legend(handles=legend_entries(lists, never_drawn), loc="lower center", ncol=columns, fontsize=13, frameon=False, bbox_to_anchor=(0.5, 0.62 / height))
    small_print = ["Curves run from 1 to 16 substeps a frame.  'fell', 'broke': the scene did not survive.  ",
                   "Where a solver of Cairn gives the errors of the default one, it is not drawn.\n"]
    figure.text(0.38 / width, 0.12 / height, "".join(small_print if wide else [small_print[0], "\n"]) + notes(lists), fontsize=12, color="#444444", linespacing=1.4)
    save(figure, path, dpi)
