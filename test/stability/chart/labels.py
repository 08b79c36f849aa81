"""Puts short texts beside points so that they cover neither each other nor the points. Pixels, y down.

Greedy: texts come in order of weight; each takes the first of eight places around its point, near before far, that
is free, and is left out when none is.
"""
from svg import text_width

PLACES = [(1, -1), (-1, -1), (1, 1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1)]
DISTANCES = (0.0, 9.0, 20.0)
POINT_RADIUS, RING_RADIUS = 5.0, 11.0
LINE_STEP = 6.0


def overlaps(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def box_at(x, y, width, height, place, gap):
    """Left, top, right, bottom of a text on one side of a point."""
    dx, dy = place
    if dx and dy:
        gap *= 0.8
    left = x + dx * gap - (width if dx < 0 else 0.0 if dx > 0 else 0.5 * width)
    top = y + dy * gap - (height if dy < 0 else 0.0 if dy > 0 else 0.5 * height)
    return left, top, left + width, top + height


class Labels:
    def __init__(self, page, frame, size):
        self.page, self.size = page, size
        left, top, right, bottom = frame
        self.frame = (left + 2, top + 2, right - 2, bottom - 2)
        self.taken = []

    def keep_clear(self, x, y, radius):
        self.taken.append((x - radius, y - radius, x + radius, y + radius))

    def keep_clear_of_line(self, x0, y0, x1, y1):
        steps = int(max(abs(x1 - x0), abs(y1 - y0)) / LINE_STEP) + 1
        for k in range(steps + 1):
            self.keep_clear(x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps, 1.0)

    def is_free(self, box):
        inside = box[0] >= self.frame[0] and box[1] >= self.frame[1] and box[2] <= self.frame[2] and box[3] <= self.frame[3]
        return inside and not any(overlaps(box, other) for other in self.taken)

    def add(self, x, y, radius, words, color, bold=False):
        width, height = text_width(words, self.size) * (1.1 if bold else 1.0), 1.15 * self.size
        for distance in DISTANCES:
            for place in PLACES:
                box = box_at(x, y, width, height, place, radius + 1.0 + distance)
                if self.is_free(box):
                    self.taken.append(box)
                    if distance > 0.0: # a thin line to a point that is not beside the text
                        nearest = min(max(x, box[0]), box[2]), min(max(y, box[1]), box[3])
                        self.page.line(x, y, *nearest, color, 0.6)
                    self.page.text(box[0], box[3] - 0.22 * height, words, self.size, color, bold=bold)
                    return True
        return False
