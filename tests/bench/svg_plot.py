"""A line plot on logarithmic axes as SVG, with nothing but text."""

import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 400, 70, 150, 40, 50
COLOURS = ["#1f5fa8", "#c2571a", "#2f8f4e", "#7b4fa3"]


def _decades(low, high):
    return list(range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1))


def _label(value):
    return f"{value:g}"


def log_plot(title, x_label, y_label, series):
    """`series`: {name: [(x, y), ...]} with positive numbers."""
    points = [point for line in series.values() for point in line]
    x_decades = _decades(min(x for x, _ in points), max(x for x, _ in points))
    y_decades = _decades(min(y for _, y in points), max(y for _, y in points))
    if len(x_decades) == 1:
        x_decades.append(x_decades[0] + 1)
    if len(y_decades) == 1:
        y_decades.append(y_decades[0] + 1)

    def place(value, decades, begin, end):
        return begin + (math.log10(value) - decades[0]) / (decades[-1] - decades[0]) * (end - begin)

    def x_at(value):
        return place(value, x_decades, LEFT, WIDTH - RIGHT)

    def y_at(value):
        return place(value, y_decades, HEIGHT - BOTTOM, TOP)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
             f'<text x="{LEFT}" y="22" font-size="15">{title}</text>']
    for decade in x_decades:
        x = x_at(10.0 ** decade)
        parts.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#ddd"/>')
        parts.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{_label(10.0 ** decade)}</text>')
    for decade in y_decades:
        y = y_at(10.0 ** decade)
        parts.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{_label(10.0 ** decade)}</text>')
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 12}" text-anchor="middle">{x_label}</text>')
    parts.append(f'<text transform="translate(16 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">{y_label}</text>')
    for index, (name, line) in enumerate(series.items()):
        colour = COLOURS[index % len(COLOURS)]
        path = " ".join(f"{x_at(x):.1f},{y_at(y):.1f}" for x, y in line)
        parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts += [f'<circle cx="{x_at(x):.1f}" cy="{y_at(y):.1f}" r="3" fill="{colour}"/>' for x, y in line]
        y = TOP + 16 + 18 * index
        parts.append(f'<line x1="{WIDTH - RIGHT + 12}" y1="{y - 4}" x2="{WIDTH - RIGHT + 30}" y2="{y - 4}" stroke="{colour}" stroke-width="2"/>')
        parts.append(f'<text x="{WIDTH - RIGHT + 36}" y="{y}">{name}</text>')
    return "\n".join(parts) + "\n</svg>\n"
