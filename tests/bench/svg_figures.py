"""Plots and maps on linear axes as SVG, with nothing but text."""

import math
import os

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 360, 60, 110, 40, 50
COLOURS = ["#1f5fa8", "#c2571a", "#2f8f4e", "#7b4fa3"]


def save(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _ticks(low, high):
    """Round numbers from low to high, five or so."""
    step = 10 ** math.floor(math.log10((high - low) / 5))
    step *= next(factor for factor in (1, 2, 5, 10) if (high - low) / (step * factor) <= 6.5)
    return [step * i for i in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


class _Sheet:
    def __init__(self, title, width, height, x_range, y_range):
        self.width, self.height, self.x_range, self.y_range = width, height, x_range, y_range
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                      'font-family="sans-serif" font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>',
                      f'<text x="{LEFT}" y="22" font-size="15">{title}</text>']

    def at(self, x, y):
        (x0, x1), (y0, y1) = self.x_range, self.y_range
        return (LEFT + (x - x0) / (x1 - x0) * (self.width - LEFT - RIGHT), self.height - BOTTOM - (y - y0) / (y1 - y0) * (self.height - TOP - BOTTOM))

    def axes(self, x_label, y_label):
        left, bottom = self.at(self.x_range[0], self.y_range[0])
        right, top = self.at(self.x_range[1], self.y_range[1])
        for x in _ticks(*self.x_range):
            place, _ = self.at(x, 0)
            self.parts.append(f'<line x1="{place:.1f}" y1="{top:.1f}" x2="{place:.1f}" y2="{bottom:.1f}" stroke="#ddd"/>')
            self.parts.append(f'<text x="{place:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{x:g}</text>')
        for y in _ticks(*self.y_range):
            _, place = self.at(0, y)
            self.parts.append(f'<line x1="{left:.1f}" y1="{place:.1f}" x2="{right:.1f}" y2="{place:.1f}" stroke="#ddd"/>')
            self.parts.append(f'<text x="{left - 8:.1f}" y="{place + 4:.1f}" text-anchor="end">{y:g}</text>')
        self.parts.append(f'<text x="{(left + right) / 2:.1f}" y="{self.height - 12}" text-anchor="middle">{x_label}</text>')
        self.parts.append(f'<text transform="translate(16 {(top + bottom) / 2:.1f}) rotate(-90)" text-anchor="middle">{y_label}</text>')

    def line(self, points, colour):
        path = " ".join("{:.1f},{:.1f}".format(*self.at(x, y)) for x, y in points)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')

    def dots(self, points, colour, radius=3):
        self.parts += ['<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="{}"/>'.format(*self.at(x, y), radius, colour) for x, y in points]

    def name(self, index, text, colour):
        x, y = self.width - RIGHT + 14, TOP + 16 + 18 * index
        self.parts.append(f'<circle cx="{x}" cy="{y - 4}" r="4" fill="{colour}"/><text x="{x + 10}" y="{y}">{text}</text>')

    def text(self):
        return "\n".join(self.parts) + "\n</svg>\n"


def plot(title, x_label, y_label, series):
    """`series`: {name: [(x, y), ...]}."""
    xs = [x for line in series.values() for x, _ in line]
    ys = [y for line in series.values() for _, y in line]
    room = 0.05 * (max(ys) - min(ys)) or 1
    sheet = _Sheet(title, WIDTH, HEIGHT, (min(xs), max(xs)), (min(ys) - room, max(ys) + room))
    sheet.axes(x_label, y_label)
    for index, (name, line) in enumerate(series.items()):
        colour = COLOURS[index % len(COLOURS)]
        sheet.line(line, colour)
        sheet.dots(line, colour, 2)
        sheet.name(index, name, colour)
    return sheet.text()


def map_of(title, things, way):
    """Places {name: [(x, y), ...]} and a way, one metre as long up as across."""
    points = [point for places in things.values() for point in places] + list(way)
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    x_range, y_range = (min(xs) - 1, max(xs) + 1), (min(ys) - 1, max(ys) + 1)
    across = WIDTH - LEFT - RIGHT
    height = round(across * (y_range[1] - y_range[0]) / (x_range[1] - x_range[0])) + TOP + BOTTOM
    sheet = _Sheet(title, WIDTH, height, x_range, y_range)
    sheet.axes("x [m]", "y [m]")
    sheet.line(way, "#555")
    for index, (name, places) in enumerate(things.items()):
        colour = COLOURS[index % len(COLOURS)]
        sheet.dots(places, colour, 5)
        sheet.name(index, name, colour)
    return sheet.text()
