"""The chart as one Markdown table."""
from picture import full_words
from points import limit_of, verdict


def number(value):
    return f"{value:.2g}" if value < 1e4 else f"{value:.0e}"


def error_text(point, scene):
    if point is None:
        return "-"
    if point.fell:
        return "fell"
    return number(point.error) if point.error > scene.floor else f"<= {scene.floor:g}"


def cost_text(point):
    if point is None:
        return "-"
    digits = f"{point.cost_us:.3g}" if point.cost_us < 1000 else f"{point.cost_us:.0f}"
    return digits if point.here else f"({digits})"


def default_of(points, engine):
    return next((point for point in points if point.engine == engine and point.default), None)


def best_peer(points, ours):
    return min((point for point in points if point.engine not in ours and not point.fell),
               key=lambda point: (point.error, point.cost_us), default=None)


def row(scene, points, suite, ours):
    mine, box2d, best = default_of(points, "auto"), default_of(points, "box2d"), best_peer(points, ours)
    judged = verdict(suite, scene)
    limit = limit_of(judged.bounds)
    best_text = "all fell" if best is None else f"{error_text(best, scene)}: {full_words(best)}, {cost_text(best)} us"
    passed = ("yes" if judged.passed else "**no**") if judged.bounds else "-"
    cells = [f"[{scene.title}]({file_name(scene)}.svg)", scene.axis, error_text(mine, scene), cost_text(mine), error_text(box2d, scene), cost_text(box2d),
             best_text, "-" if limit is None else f"{limit:g}", passed]
    return "| " + " | ".join(cells) + " |"


def file_name(scene):
    """1:10 would be a host to some."""
    return scene.name.replace(":", "-")


def write(path, panels, suite, ours):
    head = ["scene", "error", "Cairn", "us", "Box2D 3.2", "us", "most accurate other, any setting", "target", "reached"]
    lines = ["# Speed against accuracy", "",
             "Errors with default settings, and microseconds a frame of 1/60 s. Costs in brackets were measured on another machine and",
             "compare only roughly. *fell*: a pile or arch that should stand did not.", "", "![summary](summary.svg)", "",
             "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += [row(scene, points, suite, ours) for scene, points in panels]
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")
