"""From rows of CSV to points of the chart: what a run cost, how wrong it was, whether it fell or flew apart.

The suite's rows are scene,solver,setting,metric,value,bound,pass,us_per_frame; those of peers.csv are
scene,engine,setting,metric,value,ms_per_step, where a step is a frame of 1/60 s whatever it is divided into.
"""
import csv
import math
from collections import namedtuple

# here: measured in this run, so that costs compare; else on another machine.
Point = namedtuple("Point", "engine setting cost_us error fell here default")
# What the suite says about its default settings.
Verdict = namedtuple("Verdict", "bounds passed")

# Engine -> the setting that a new user gets; that of the suite's own is found by default_setting.
DEFAULTS = {"box2d": "ss4", "chipmunk": "ss1", "rapier": "ss4"}
# How peers.csv names the same.
DEFAULTS_ELSEWHERE = {"box2d": "ss4", "chipmunk": "60Hz it10"}


class Rows:
    """Values and costs by (scene, engine, setting)."""

    def __init__(self):
        self.values = {}
        self.cost_us = {}
        self.bounds = {}

    def add(self, row, engine, cost_us):
        key = (row["scene"], engine, row["setting"])
        self.values.setdefault(key, {})[row["metric"]] = float(row["value"])
        # The least of several rounds: what is more was somebody else's.
        self.cost_us[key] = min(cost_us, self.cost_us.get(key, math.inf))
        if row.get("bound"):
            self.bounds.setdefault(key + (row["metric"],), {})[row["bound"]] = row["pass"] == "1"


def read_suite(rows, path, engine=None):
    """engine: the name of all rows; without it, a row's solver."""
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            rows.add(row, engine or row["solver"], float(row["us_per_frame"]))


def default_setting(rows, engine="auto"):
    """Which of the sweep's settings is the run without settings; "default" if it is none of them."""
    runs = [scene for scene, who, setting in rows.values if (who, setting) == (engine, "default")]
    for scene, who, setting in rows.values:
        if who == engine and setting != "default" and all(
                rows.values.get((run, engine, setting)) == rows.values[run, engine, "default"] for run in runs):
            return setting
    return "default"


def read_peers(path):
    rows = Rows()
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            rows.add(row, row["engine"], 1000.0 * float(row["ms_per_step"]))
    return rows


def settings_of(rows, scene):
    """(engine, setting) that ran all of a scene's sources, in order."""
    found = {}
    for source, engine, setting in rows.values:
        if source in scene.sources:
            found[engine, setting] = found.get((engine, setting), 0) + 1
    return [which for which, count in found.items() if count == len(scene.sources)]


def mean(numbers):
    numbers = list(numbers)
    return sum(numbers) / len(numbers)


def has_fallen(values, scene):
    if values.get("stands", 1.0) < 1.0 or values.get("lost", 0.0) > 0.0 or values.get("height_loss_m", 0.0) >= scene.fallen_m:
        return True
    return not abs(values.get(scene.metric, math.nan)) <= scene.ceiling


def points_of(rows, scene, defaults, here):
    points = []
    for engine, setting in settings_of(rows, scene):
        if setting == "default" and defaults.get(engine) != "default":
            continue  # one of the others under another name
        keys = [(source, engine, setting) for source in scene.sources]
        fell = any(has_fallen(rows.values[key], scene) for key in keys)
        error = math.inf if fell else mean(abs(rows.values[key][scene.metric]) for key in keys)
        error = max(error, scene.floor)  # below it nobody is better than another
        cost_us = mean(rows.cost_us[key] for key in keys)
        points.append(Point(engine, setting, cost_us, error, fell, here, defaults.get(engine) == setting))
    return points


def all_points(suite, elsewhere, scene):
    """What ran here replaces the same engine's marks from elsewhere."""
    points = points_of(suite, scene, {**DEFAULTS, "auto": default_setting(suite)}, True)
    ran = {point.engine for point in points}
    seen = set()
    for point in points_of(elsewhere, scene, DEFAULTS_ELSEWHERE, False):
        # Box2D was also run with other stiffnesses, which change nothing where they do not matter: one mark for equal results.
        same = (point.engine.replace("box2dT", "box2d"), point.cost_us, point.error)
        repeated = same in seen and not point.default
        seen.add(same)
        if point.engine not in ran and not repeated:
            points.append(point)
    return points


def front(points):
    """Points that no other is both cheaper and more accurate than, from cheap to accurate."""
    best = []
    for point in sorted((p for p in points if not p.fell), key=lambda p: (p.cost_us, p.error)):
        if not best or point.error < best[-1].error:
            best.append(point)
    return best


def verdict(suite, scene, engine="auto", setting="default"):
    bounds, passed = [], True
    for source in scene.sources:
        for bound, held in suite.bounds.get((source, engine, setting, scene.metric), {}).items():
            passed = passed and held
            if bound not in bounds:
                bounds.append(bound)
        stands = suite.bounds.get((source, engine, setting, "stands"), {})
        passed = passed and all(stands.values())
    return Verdict(bounds, passed)


def limit_of(bounds):
    """The largest error that bounds allow, or None. A bound on both sides is one on the magnitude."""
    limits = [abs(float(bound[2:])) for bound in bounds]
    return min(limits) if limits else None
