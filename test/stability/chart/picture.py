"""Draws one scene: error against cost, both logarithmic. Solvers of the library and engines that ran with it are
curves over their substeps, other engines marks; what fell stands in a strip at the top, what is exact but for
rounding in one at the bottom.
"""
import math
from collections import namedtuple

from labels import POINT_RADIUS, RING_RADIUS, Labels
from points import front
from svg import Svg, text_width

# Colours that the colour-blind tell apart: Okabe and Ito, 2008.
Look = namedtuple("Look", "name color marker")
OURS = {
    "auto": Look("Cairn", "#0072B2", "circle"),
    "soft": Look("Cairn, solver 'soft'", "#56B4E9", "down"),
    "direct": Look("Cairn, solver 'direct'", "#009E73", "square"),
    "sequential": Look("Cairn, solver 'sequential'", "#000000", "cross"),
}
PEERS = {
    "box2d": Look("Box2D 3.2", "#D55E00", "diamond"),
    "chipmunk": Look("Chipmunk 7", "#E69F00", "up"),
    "rapier": Look("Rapier 0.36", "#7B4FA3", "pentagon"),
}
OTHERS = Look("other solvers", "#8A8A8A", "cross")
NAMES = {"box2dT": "Box2D 3.2", "avbd": "AVBD"}
FRONT_COLOR, GOOD_COLOR, FELL_COLOR, EXACT_COLOR, GREY = "#333333", "#2E8B57", "#B03A2E", "#5A6B7B", "#444444"


def look_of(engine):
    return OURS.get(engine) or PEERS.get(engine) or OTHERS


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
    name = point.engine[3:].replace("_", " ") if point.engine.startswith("s2_") else NAMES.get(point.engine, look_of(point.engine).name)
    words = spelled(point.setting)
    if point.engine == "chipmunk":
        words = words.replace("substeps", "steps a frame").replace("substep", "step a frame")
    return f"{name}: {words}"


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


class Panel:
    """A rectangle of the page with logarithmic axes."""

    def __init__(self, page, box, scene, points, limit, small):
        self.page, self.scene, self.points, self.limit, self.small = page, scene, points, limit, small
        self.left, self.top, self.right, self.bottom = box
        self.scale = Scale(scene, points, limit)
        costs = [point.cost_us for point in points]
        self.cheap, self.expensive = min(costs) / 1.6, max(costs) * 1.8

    def x(self, cost_us):
        return self.left + (self.right - self.left) * math.log(cost_us / self.cheap) / math.log(self.expensive / self.cheap)

    def y(self, error):
        return self.bottom - (self.bottom - self.top) * math.log(error / self.scale.low) / math.log(self.scale.high / self.scale.low)

    def at(self, point):
        return self.x(point.cost_us), self.y(self.scale.y(point))


SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def short_number(value):
    if 0.01 <= value < 10000.0:
        return f"{value:.10g}"
    mantissa, exponent = f"{value:.0e}".split("e")
    power = "10" + str(int(exponent)).translate(SUPERSCRIPT)
    return power if mantissa == "1" else f"{mantissa}·{power}"


def ticks(low, high, most):
    """Powers of ten between two numbers, at most so many; with 2 and 5 in between where there is room."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    if math.log10(high / low) < 0.4 * most:
        fine = [m * 10.0 ** e for e in range(first - 1, last + 1) for m in (1, 2, 5)]
        return [value for value in fine if low <= value <= high]
    step = (last - first) // most + 1
    return [10.0 ** e for e in range(first, last + 1, step)]


def strip_name(scene):
    return "broke" if scene.name.startswith(("2", "3", "11", "cloth", "crowd")) else "fell"


def draw_strips(panel, size):
    """What lies in a strip has no number: the strip's name stands there."""
    page, scale = panel.page, panel.scale
    width = panel.right - panel.left
    if scale.has_fallen:
        page.rect(panel.left, panel.top, width, panel.y(scale.fallen_bottom) - panel.top, FELL_COLOR, 0.10)
        page.text(panel.left - 6, panel.y(scale.fallen_y) + 0.35 * size, strip_name(panel.scene), size, FELL_COLOR, "end")
    if scale.has_exact:
        top = panel.y(scale.exact_top)
        page.rect(panel.left, top, width, panel.bottom - top, EXACT_COLOR, 0.13)
        page.text(panel.left - 6, panel.y(scale.exact_y) + 0.35 * size, "≤" + short_number(panel.scene.floor), size, "#222222", "end")


def draw_frame(panel):
    page, scale, size = panel.page, panel.scale, 10.5 if panel.small else 12.0
    draw_strips(panel, size)
    margin = (scale.fallen_bottom / scale.exact_top) ** 0.03
    up = [value for value in ticks(scale.exact_top, scale.fallen_bottom, 5 if panel.small else 9)
          if not (scale.has_exact and value <= scale.exact_top * margin) and not (scale.has_fallen and value >= scale.fallen_bottom / margin)]
    for value in up:
        y = panel.y(value)
        page.line(panel.left, y, panel.right, y, "#DDDDDD", 0.7)
        page.text(panel.left - 6, y + 0.35 * size, short_number(value), size, anchor="end")
    for value in ticks(panel.cheap, panel.expensive, 5 if panel.small else 8):
        x = panel.x(value)
        page.line(x, panel.top, x, panel.bottom, "#DDDDDD", 0.7)
        page.text(x, panel.bottom + 1.4 * size, short_number(value), size, anchor="middle")
    page.path([(panel.left, panel.top), (panel.left, panel.bottom), (panel.right, panel.bottom)], "#222222")


def draw_better_corner(panel):
    reach = 0.2 if panel.small else 0.15
    width, height = panel.right - panel.left, panel.bottom - panel.top
    panel.page.polygon([(panel.left, panel.bottom), (panel.left + 1.3 * reach * width, panel.bottom),
                        (panel.left, panel.bottom - 1.6 * reach * height)], GOOD_COLOR, opacity="0.12")
    if not panel.small:
        panel.page.text(panel.left + 8, panel.bottom - 10, "better", 12, GOOD_COLOR, bold=True)


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


def draw_curve(panel, of_engine):
    """No line leads to what fell: there is nothing between."""
    look, lead, ours = look_of(of_engine[0].engine), of_engine[0].engine == "auto", of_engine[0].engine in OURS
    width, size = (2.4 if lead else 1.5) * (0.85 if panel.small else 1.0), (4.4 if lead else 3.6) * (0.8 if panel.small else 1.0)
    run = []
    for point in of_engine + [None]:
        if point is None or point.fell:
            panel.page.path(run, look.color, width, None if ours else "5 3")
            run = []
        else:
            run.append(panel.at(point))
    for point in of_engine:
        panel.page.mark(look.marker, *panel.at(point), size, look.color)


def draw_marks(panel, of_engine):
    look = look_of(of_engine[0].engine)
    for point in of_engine:
        panel.page.mark(look.marker, *panel.at(point), 2.5 if panel.small else 3.6, look.color, False)


def front_steps(panel):
    """Corners of the line that bounds what engines reach, in pixels: down to a point, right to the next."""
    best = front(panel.points)
    if not best:
        return []
    corners = [(panel.x(best[0].cost_us), panel.y(panel.scale.fallen_bottom))]
    for point in best:
        x, y = panel.at(point)
        corners += [(x, corners[-1][1]), (x, y)]
    return corners + [(panel.right, corners[-1][1])]


def drawn(panel, same):
    """Engines of a panel from back to front. Small panels leave out the baseline of a pass a step."""
    series = group(panel.points)
    order = [engine for engine in series if engine not in OURS] + [engine for engine in ("sequential", "direct", "soft", "auto") if engine in series]
    return [series[engine] for engine in order if engine not in same and not (panel.small and engine == "sequential")]


def draw_scene(panel):
    """Returns the solvers left out because they equal the default one."""
    same = same_as_default_solver(group(panel.points))
    draw_frame(panel)
    draw_better_corner(panel)
    if panel.limit:
        y = panel.y(panel.limit)
        panel.page.line(panel.left, y, panel.right, y, GOOD_COLOR, 1.4, "7 4")
        if not panel.small:
            panel.page.text(panel.right - 3, y - 4, "target " + short_number(panel.limit), 11, GOOD_COLOR, "end")
    panel.page.path(front_steps(panel), FRONT_COLOR, 1.2, "1.5 2")
    for of_engine in drawn(panel, same):
        (draw_curve if of_engine[0].here else draw_marks)(panel, of_engine)
    for point in panel.points:
        if point.default and look_of(point.engine) is not OTHERS:
            panel.page.circle(*panel.at(point), 7 if panel.small else 9, "none", look_of(point.engine).color, 1.7)
    return same


# ---------------------------------------------------------------- legend

def draw_legend(page, y, engines, width):
    """One row: engines that are drawn, those of all others as one entry."""
    looks = [(OURS[name], True) for name in OURS if name in engines]
    looks += [(look, engines[name]) for name, look in PEERS.items() if name in engines]
    if any(look_of(name) is OTHERS for name in engines):
        looks.append((OTHERS, False))
    words = [look.name + ("" if here else " *") for look, here in looks]
    gap = min(46.0, (width - sum(text_width(text, 13) + 34 for text in words)) / max(len(words) - 1, 1))
    x = 0.5 * (width - sum(text_width(text, 13) + 34 for text in words) - gap * (len(words) - 1))
    for (look, here), text in zip(looks, words):
        if here:
            page.line(x, y - 4, x + 26, y - 4, look.color, 2.0, None if look in OURS.values() else "5 3")
        page.mark(look.marker, x + 13, y - 4, 4.2, look.color, here)
        page.text(x + 32, y, text, 13)
        x += text_width(text, 13) + 34 + gap


def engines_of(panels, hidden=()):
    """Engine -> measured in this run?"""
    return {point.engine: point.here for panel in panels for point in panel.points
            if point.engine not in hidden and not (panel.small and point.engine == "sequential")}


KEY = "Ring: default setting. Dotted: no engine is both cheaper and better. Dashed: target of the stability suite."
ELSEWHERE_NOTE = "* hollow marks: measured on another machine; accuracy compares, cost only roughly."


def notes(panels):
    return ELSEWHERE_NOTE if any(not point.here for panel in panels for point in panel.points) else ""


# ---------------------------------------------------------------- one scene on a page

def named_peers(points):
    """Whom a reader looks for: the defaults, those on the front, the most accurate."""
    named = [point for point in points if point.default and point.engine not in OURS]
    named += [point for point in front(points) if point.engine not in OURS and point not in named]
    standing = [point for point in points if point.engine not in OURS and not point.fell]
    most_accurate = min(standing, key=lambda point: (point.error, point.cost_us), default=None)
    return named + ([most_accurate] if most_accurate and most_accurate not in named else [])


def label_points(panel, same):
    labels = Labels(panel.page, (panel.left, panel.top, panel.right, panel.bottom), 10.5)
    labels.taken.append((panel.left, panel.bottom - 24, panel.left + 60, panel.bottom))
    if panel.limit:
        labels.taken.append((panel.right - 90, panel.y(panel.limit) - 16, panel.right, panel.y(panel.limit)))
    for of_engine in drawn(panel, same):
        for point in of_engine:
            labels.keep_clear(*panel.at(point), radius_of(point))
        for a, b in zip(of_engine, of_engine[1:]):
            if a.here and not a.fell and not b.fell:
                labels.keep_clear_of_line(*panel.at(a), *panel.at(b))
    corners = front_steps(panel)
    for a, b in zip(corners, corners[1:]):
        labels.keep_clear_of_line(*a, *b)
    shown = [point for point in panel.points if point.engine not in same]
    named = named_peers(shown)
    rest = [point for point in shown if point.here and point.engine not in ("auto", "sequential") and point not in named and not point.fell]
    for texts in ([(point, words_of(point)) for point in shown if point.engine == "auto"], [(point, full_words(point)) for point in named],
                  [(point, words_of(point)) for point in rest]):
        for point, text in texts:
            labels.add(*panel.at(point), radius_of(point), text, look_of(point.engine).color, point.engine == "auto")


def radius_of(point):
    return RING_RADIUS if point.default else POINT_RADIUS


def scene_page(scene, points, limit, path):
    page = Svg(1060, 790)
    panel = Panel(page, (96, 120, 1020, 610), scene, points, limit, False)
    page.text(32, 44, scene.title, 24, bold=True)
    for row, text in enumerate(wrapped(scene.caption, 118)):
        page.text(32, 72 + 18 * row, text, 13)
    page.text(96, 112, scene.axis, 12.5, GREY)
    same = draw_scene(panel)
    label_points(panel, same)
    page.text(558, 656, "cost: microseconds of processor time a frame of 1/60 s", 13.5, anchor="middle")
    draw_legend(page, 696, engines_of([panel], same), 1060)
    small_print = ["Numbers on curves: substeps a frame."]
    if panel.scale.has_fallen:
        small_print.append(f"'{strip_name(scene)}': the scene did not survive.")
    if same:
        small_print.append("Same errors as the default solver, not drawn: " + " and ".join(f"'{engine}'" for engine in same) + ".")
    for row, text in enumerate((KEY, "  ".join(small_print), notes([panel]))):
        page.text(32, 732 + 19 * row, text, 11.5, GREY)
    page.save(path + ".svg")


def wrapped(text, columns):
    lines, line = [], ""
    for word in text.split():
        if len(line) + len(word) + 1 > columns and line:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    return lines + [line]


# ---------------------------------------------------------------- summary

CELL_WIDTH, CELL_HEIGHT = 290, 268


def summary_page(scenes, path, columns=4):
    """scenes: (scene, points, limit)."""
    rows = (len(scenes) + columns - 1) // columns
    width, height = columns * CELL_WIDTH + 24, 92 + rows * CELL_HEIGHT + 112
    page, panels, hidden = Svg(width, height), [], []
    page.text(24, 42, "How wrong is each engine, and what does it cost?", 26, bold=True)
    page.text(24, 70, "Each panel is one scene. Down is more accurate, left is cheaper: the nearer to the corner at the bottom left, "
              "the better.", 14.5)
    for number, (scene, points, limit) in enumerate(scenes):
        left, top = 24 + number % columns * CELL_WIDTH, 92 + number // columns * CELL_HEIGHT
        panels.append(Panel(page, (left + 44, top + 46, left + CELL_WIDTH - 16, top + CELL_HEIGHT - 34), scene, points, limit, True))
        page.text(left, top + 20, scene.title, 14, bold=True)
        page.text(left, top + 37, scene.axis, 11.5, GREY)
        hidden.append(draw_scene(panels[-1]))
    never_drawn = [engine for engine in OURS if all(engine in same for same in hidden)]
    bottom = height - 104
    page.text(0.5 * width, bottom, "microseconds of processor time a frame", 12.5, anchor="middle")
    draw_legend(page, bottom + 34, engines_of(panels, never_drawn), width)
    page.text(24, bottom + 66, "Curves run from 1 to 16 substeps a frame. 'fell', 'broke': the scene did not survive. " + KEY, 11.5, GREY)
    page.text(24, bottom + 84, notes(panels), 11.5, GREY)
    page.save(path + ".svg")
