"""Runs the stability suite over solvers and substeps and draws error against cost: see README.md.

    python3 test/stability/chart/chart.py build/bin/stability build/chart [--peer box2d=program]... [--rounds 3]

    scenes.py   which metric is a scene's error, its title and caption
    points.py   rows of CSV -> points
    picture.py  points -> pictures; labels.py keeps their texts apart
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

try:
    import picture
except ImportError as missing:
    sys.exit(f"chart: {missing.name} is not installed for {sys.executable} (Debian: python3-matplotlib)")
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


def repeat(suite, name, program, folder, turn):
    """All settings of an engine again, but for what is so dear that its cost is known well enough."""
    settings = {}
    for (case, engine, setting), cost_us in suite.cost_us.items():
        if (engine == name if name else engine in picture.OURS) and cost_us < DEAR_US:
            settings.setdefault((engine, setting), []).append(case)
    for (engine, setting), cases in settings.items():
        file = os.path.join(folder, f"{name or 'cairn'}_{turn}_{engine}_{setting}.csv")
        run(program, ["--solver", "auto" if name else engine, "--substeps", setting[2:], *cases], file)
        points.read_suite(suite, file, name)


def measure(program, peers, folder, rounds):
    """Engines take turns, so that a slow minute of the machine is everybody's."""
    suite = points.Rows()
    cases = [source for scene in SCENES for source in scene.sources]
    programs = [(None, program), *peers]
    for name, path in programs:
        file = os.path.join(folder, f"{name or 'cairn'}_1.csv")
        print(f"chart: {name or 'cairn'}: {run(path, ['--sweep', *cases], file)}", flush=True)
        points.read_suite(suite, file, name)
    for turn in range(2, rounds + 1):
        for name, path in programs:
            repeat(suite, name, path, folder, turn)
        print(f"chart: round {turn} of {rounds}", flush=True)
    file = os.path.join(folder, "cairn_default.csv")
    run(program, cases, file)
    points.read_suite(suite, file)
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
    for names, columns, dpi, file in ((SUMMARY, 4, 110, "summary"), (README, 3, 80, "readme")):
        picture.summary_page([next(panel for panel in panels if panel[0].name == name) for name in names], os.path.join(folder, file), columns, dpi)
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
    print(f"chart: {os.path.join(asked.folder, 'summary.png')}, {os.path.join(asked.folder, 'chart.md')}")


if __name__ == "__main__":
    main()
