"""Puts short texts beside points so that they cover neither each other nor the points. Pixels of the figure.

Greedy: texts come in order of weight; each takes the first of eight places around its point, near before far, that
is free, and is left out when none is.
"""
PLACES = [(1, 1), (-1, 1), (1, -1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1)]
DISTANCES = (0.0, 9.0, 20.0)
POINT_RADIUS, RING_RADIUS = 5.0, 12.0
LINE_STEP = 6.0


def overlaps(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def box_at(x, y, width, height, place, gap):
    """Left, bottom, right, top of a text on one side of a point."""
    dx, dy = place
    if dx and dy:
        gap *= 0.8
    left = x + dx * gap - (width if dx < 0 else 0.0 if dx > 0 else 0.5 * width)
    bottom = y + dy * gap - (height if dy < 0 else 0.0 if dy > 0 else 0.5 * height)
    return left, bottom, left + width, bottom + height


class Labels:
    def __init__(self, axes, size):
        self.axes = axes
        self.size = size
        self.renderer = axes.figure.canvas.get_renderer()
        frame = axes.get_window_extent(self.renderer)
        self.frame = (frame.x0 + 2, frame.y0 + 2, frame.x1 - 2, frame.y1 - 2)
        self.taken = []

    def keep_clear(self, x, y, radius):
        px, py = self.axes.transData.transform((x, y))
        self.taken.append((px - radius, py - radius, px + radius, py + radius))

    def keep_clear_of_line(self, x0, y0, x1, y1):
        (ax, ay), (bx, by) = self.axes.transData.transform([(x0, y0), (x1, y1)])
        steps = int(max(abs(bx - ax), abs(by - ay)) / LINE_STEP) + 1
        for k in range(steps + 1):
            x, y = ax + (bx - ax) * k / steps, ay + (by - ay) * k / steps
            self.taken.append((x - 1.0, y - 1.0, x + 1.0, y + 1.0))

    def keep_clear_of(self, text):
        box = text.get_window_extent(self.renderer)
        self.taken.append((box.x0, box.y0, box.x1, box.y1))

    def is_free(self, box):
        inside = box[0] >= self.frame[0] and box[1] >= self.frame[1] and box[2] <= self.frame[2] and box[3] <= self.frame[3]
        return inside and not any(overlaps(box, other) for other in self.taken)

    def add(self, x, y, radius, words, color, weight="normal"):
        text = self.axes.text(x, y, words, color=color, fontsize=self.size, fontweight=weight, zorder=9)
        extent = text.get_window_extent(self.renderer)
        width, height = extent.width, extent.height
        px, py = self.axes.transData.transform((x, y))
        text.remove()
        for distance in DISTANCES:
            for place in PLACES:
                box = box_at(px, py, width, height, place, radius + 1.0 + distance)
                if self.is_free(box):
                    self.taken.append(box)
                    self.write(px, py, box, words, color, weight, distance > 0.0)
                    return True
        return False

    def write(self, px, py, box, words, color, weight, leader):
        """leader: a thin line to a point that is not beside the text."""
        scale = 72.0 / self.axes.figure.dpi
        at = (box[0] - px) * scale, (box[1] - py) * scale
        inverse = self.axes.transData.inverted()
        self.axes.annotate(words, inverse.transform((px, py)), at, textcoords="offset points", color=color, fontsize=self.size,
                           fontweight=weight, ha="left", va="bottom", zorder=9, annotation_clip=False,
                           arrowprops=dict(arrowstyle="-", color=color, lw=0.6, shrinkA=0, shrinkB=3) if leader else None)
