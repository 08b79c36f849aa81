"""Writes SVG: lines, marks and texts in pixels, y down. Widths of texts are estimated from the letters of a common sans serif."""
from xml.sax.saxutils import escape

NARROW, WIDE = set("ijl.,:;'|!()[]ftrI1 "), set("mwMWGOQ%@")


def text_width(words, size):
    return size * sum(0.33 if c in NARROW else 0.86 if c in WIDE else 0.66 if c.isupper() else 0.56 for c in words)


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".")


class Svg:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.parts = []

    def add(self, name, text="", **values):
        marks = " ".join(f'{key.replace("_", "-")}="{number(value) if isinstance(value, float) else value}"'
                         for key, value in values.items() if value is not None)
        self.parts.append(f"<{name} {marks}>{text}</{name}>" if text else f"<{name} {marks}/>")

    def line(self, x0, y0, x1, y1, color, width=1.0, dash=None):
        self.add("line", x1=float(x0), y1=float(y0), x2=float(x1), y2=float(y1), stroke=color, stroke_width=width, stroke_dasharray=dash)

    def path(self, points, color, width=1.0, dash=None):
        if len(points) > 1:
            where = " ".join(f"{number(x)},{number(y)}" for x, y in points)
            self.add("polyline", points=where, fill="none", stroke=color, stroke_width=width, stroke_dasharray=dash, stroke_linejoin="round")

    def polygon(self, points, fill, stroke="none", width=0.0, opacity=None):
        where = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self.add("polygon", points=where, fill=fill, stroke=stroke, stroke_width=width, fill_opacity=opacity)

    def rect(self, x, y, width, height, fill, opacity=1.0):
        self.add("rect", x=float(x), y=float(y), width=float(width), height=float(height), fill=fill, fill_opacity=f"{opacity:.2f}")

    def circle(self, x, y, radius, fill, stroke="none", width=0.0):
        self.add("circle", cx=float(x), cy=float(y), r=float(radius), fill=fill, stroke=stroke, stroke_width=width)

    def text(self, x, y, words, size, color="#222222", anchor="start", bold=False):
        self.add("text", escape(words), x=float(x), y=float(y), font_size=float(size), fill=color, text_anchor=anchor,
                 font_weight="bold" if bold else None)

    def mark(self, kind, x, y, size, color, filled=True):
        """size: half of the width."""
        fill, stroke, width = (color, "#ffffff", 0.6) if filled else ("none", color, 1.3)
        corners = MARKS.get(kind)
        if corners is not None:
            self.polygon([(x + size * dx, y + size * dy) for dx, dy in corners], fill, stroke, width)
        elif kind == "cross":
            self.line(x - size, y - size, x + size, y + size, color, 1.3)
            self.line(x - size, y + size, x + size, y - size, color, 1.3)
        else:
            self.circle(x, y, size, fill, stroke, width)

    def save(self, path):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" viewBox="0 0 {self.width} {self.height}" '
                'font-family="DejaVu Sans, Verdana, Helvetica, Arial, sans-serif">\n')
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(head + '<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(self.parts) + "\n</svg>\n")


MARKS = {
    "square": [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
    "diamond": [(0, -1.25), (1.0, 0), (0, 1.25), (-1.0, 0)],
    "up": [(0, -1.15), (1.05, 0.85), (-1.05, 0.85)],
    "down": [(0, 1.15), (1.05, -0.85), (-1.05, -0.85)],
    "pentagon": [(0, -1.1), (1.05, -0.34), (0.65, 0.89), (-0.65, 0.89), (-1.05, -0.34)],
}
