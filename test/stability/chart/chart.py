"""Runs the stability suite over solvers and substeps and draws error against cost: see README.md.

    python3 test/stability/chart/chart.py build/bin/stability build/chart [--peer box2d=program]... [--rounds 3]

    scenes.py   which metric is a scene's error, its title and caption
    points.py   rows of CSV -> points
    picture.py  points -> pictures; svg.py writes them, labels.py keeps their texts apart
    table.py    points -> Markdown

A peer's program is the same suite with another engine under it; it writes the same CSV.
"""
import argparse
import os
import subprocess
import sys

sys.dont_write_bytecode = True

HERE = os.path.dirname(os.path.abspath(__file__))
DEAR_US = 10000.0

import picture  # noqa: E402
import points  # noqa: E402
import table  # noqa: E402
from scenes import README, SCENES, SUMMARY  # noqa: E402


def run(program, arguments, path):
    """The suite's exit code is 1 when a bound is broken, which is not the chart's business."""
    done = subprocess.run([program, *arguments, "--csv", path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    last = done.stdout.strip().rsplit("\n", 1)[-1]
    if done.returncode not in (0, 1) or not os.path.exists(path):
        sys.exit(f"chart: {program} failed:\n{done.stdout[-2000:]}")
    return last


def asked_for():
    """Arguments that run all scenes, and the cases of each: the numbered ones in one run, every other scene by itself."""
    runs = [((), [source for scene in SCENES if not scene.arguments for source in scene.sources])]
    return runs + [(scene.arguments, list(scene.sources)) for scene in SCENES if scene.arguments]


def repeat(suite, name, program, folder, turn):
    """All settings of an engine again, but for what is so expensive that its cost is known well enough."""
    settings = {}
    for arguments, sources in asked_for():
        for (case, engine, setting), cost_us in suite.cost_us.items():
            if case in sources and (engine == name if name else engine in picture.OURS) and cost_us < DEAR_US:
                settings.setdefault((engine, setting, arguments), []).append(case)
    for number, ((engine, setting, arguments), cases) in enumerate(settings.items()):
        file = os.path.join(folder, f"{name or 'cairn'}_{turn}_{number}.csv")
        run(program, ["--solver", "auto" if name else engine, "--substeps", setting[2:], *(arguments or cases)], file)
        points.read_suite(suite, file, name)


def sweep(suite, name, program, folder, options):
    for number, (arguments, cases) in enumerate(asked_for()):
        file = os.path.join(folder, f"{name or 'cairn'}_{'sweep' if options else 'default'}_{number}.csv")
        print(f"chart: {name or 'cairn'}: {run(program, [*options, *(arguments or cases)], file)}", flush=True)
        points.read_suite(suite, file, name)


def measure(program, peers, folder, rounds):
    """Engines take turns, so that a slow minute of the machine is everybody's."""
    suite = points.Rows()
    programs = [(None, program), *peers]
    for name, path in programs:
        sweep(suite, name, path, folder, ["--sweep"])
    for turn in range(2, rounds + 1):
        for name, path in programs:
            repeat(suite, name, path, folder, turn)
        print(f"chart: round {turn} of {rounds}", flush=True)
    sweep(suite, None, program, folder, [])
    return suite


def draw(suite, folder):
    elsewhere = points.read_peers(os.path.join(HERE, "peers.csv"))
    panels = []
    for scene in SCENES:
        of_scene = points.all_points(suite, elsewhere, scene)
        if not any(point.here for point in of_scene):
            sys.exit(f"chart: the suite measured no {scene.metric} in {scene.name}")
        limit = points.limit_of(points.verdict(suite, scene).bounds)
        picture.scene_page(scene, of_scene, limit, os.path.join(folder, table.file_name(scene)))
        panels.append((scene, of_scene, limit))
    for names, file in ((SUMMARY, "summary"), (README, "readme")):
        picture.summary_page([next(panel for panel in panels if panel[0].name == name) for name in names], os.path.join(folder, file))
    table.write(os.path.join(folder, "chart.md"), [panel[:2] for panel in panels], suite, picture.OURS)


def main():
    parser = argparse.ArgumentParser(description="Runs the stability suite and draws error against cost.")
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--peer", action="append", default=[], metavar="NAME=PROGRAM")
    parser.add_argument("--rounds", type=int, default=3, help="costs are the least of so many (default 3)")
    asked = parser.parse_args()
    os.makedirs(os.path.join(asked.folder, "csv"), exist_ok=True)
    suite = measure(asked.program, [peer.split("=", 1) for peer in asked.peer], os.path.join(asked.folder, "csv"), max(asked.rounds, 1))
    draw(suite, asked.folder)
    print(f"chart: {os.path.join(asked.folder, 'summary.svg')}, {os.path.join(asked.folder, 'chart.md')}")


if __name__ == "__main__":
    main()
