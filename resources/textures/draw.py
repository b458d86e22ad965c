#!/usr/bin/env python3
"""Draws the pictures that the shipped robots wear: `python3 resources/textures/draw.py` writes them beside itself.

Plain Python and its zlib; each is a function from a place (x to the right, y down, both 0..1) to a colour, sampled several times
for each pixel. Equal bytes in every run.
"""

import math
import os
import struct
import zlib

SAMPLES = 2  # along each side of a pixel
LETTERS = {  # 5 x 7
    "A": "01110 10001 10001 11111 10001 10001 10001", "B": "11110 10001 10001 11110 10001 10001 11110",
    "E": "11111 10000 10000 11110 10000 10000 11111", "M": "10001 11011 10101 10101 10001 10001 10001",
    "O": "01110 10001 10001 10001 10001 10001 01110", "R": "11110 10001 10001 11110 10100 10010 10001",
    "T": "11111 00100 00100 00100 00100 00100 00100", "V": "10001 10001 10001 10001 10001 01010 00100"}


def noise(x, y):
    """0..1, the same for the same place."""
    n = (int(x) * 374761393 + int(y) * 668265263) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535


def smooth_noise(x, y):
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    top = noise(i, j) * (1 - u) + noise(i + 1, j) * u
    low = noise(i, j + 1) * (1 - u) + noise(i + 1, j + 1) * u
    return top * (1 - v) + low * v


def shade(colour, light):
    return tuple(c * light for c in colour)


def within(x, y, left, top, right, low):
    return left <= x <= right and top <= y <= low


def ring(x, y, cx, cy, inner, outer):
    return inner <= math.hypot(x - cx, y - cy) <= outer


def written(word, x, y, left, top, high, wide):
    """Whether a letter of `word`, `high` tall and each `wide` wide, covers the place."""
    column, row = (x - left) / wide, (y - top) / high
    if not 0 <= row < 1 or not 0 <= column < len(word):
        return False
    i, j = int((column % 1) * 6), int(row * 7)
    return i < 5 and LETTERS[word[int(column)]].split()[j][i] == "1"


def tyre(x, y):
    """Around: blocks of tread between grooves. The caps are hidden by hubs."""
    n = (x * 28) % 1
    slant = ((x * 28) + (0.5 - abs(y - 0.5)) * 2.2) % 1
    groove = abs(y - 0.5) < 0.06 or slant < 0.22
    grain = 0.92 + 0.16 * smooth_noise(x * 160, y * 40)
    return shade((0.155, 0.155, 0.16) if not groove else (0.075, 0.075, 0.08), grain * (1 + 0.05 * n))


def wheel(x, y):
    """The face of a wheel: side wall, rim, five spokes, hub with bolts."""
    dx, dy = x - 0.5, y - 0.5
    r, turn = 2 * math.hypot(dx, dy), math.atan2(dy, dx)
    light = 1 - 0.16 * (dx + dy)
    if r > 0.80:
        return shade((0.12, 0.12, 0.125), 0.9 + (0.3 if 0.875 < r < 0.89 else 0))
    if r > 0.66:
        return shade((0.70, 0.71, 0.73), light * (0.86 if r < 0.69 else 1))
    if r > 0.26:
        spoke = (turn / (2 * math.pi) * 5) % 1
        if abs(spoke - 0.5) * r < 0.085:
            return shade((0.66, 0.67, 0.69), light)
        return shade((0.10, 0.10, 0.11), 1)
    for k in range(5):
        at = 2 * math.pi * (k + 0.5) / 5
        if math.hypot(dx - 0.085 * math.cos(at), dy - 0.085 * math.sin(at)) < 0.017:
            return (0.28, 0.28, 0.30)
    return shade((0.72, 0.73, 0.75) if r > 0.10 else (0.35, 0.36, 0.38), light)


def hazard(x, y):
    """Yellow and black at 45 degrees, worn a little."""
    worn = smooth_noise(x * 60, y * 60)
    stripe = ((x * 4 + y) % 1) < 0.5
    return shade((0.93, 0.74, 0.10), 0.90 + 0.12 * worn) if stripe else shade((0.09, 0.09, 0.09), 0.9 + 0.4 * worn)


def deck(x, y):
    """Chequer plate in a frame with a screw in each corner."""
    edge = min(x, y, 1 - x, 1 - y)
    if edge < 0.035:
        return shade((0.30, 0.31, 0.33), 1.08 if edge > 0.028 else 1)
    for cx in (0.07, 0.93):
        for cy in (0.07, 0.93):
            d = math.hypot(x - cx, y - cy)
            if d < 0.018:
                return shade((0.78, 0.79, 0.80), 0.6 if abs(x - cx) < 0.004 else 1)
    u, v = x * 14, y * 10
    i, j = int(u), int(v)
    du, dv = u % 1 - 0.5, v % 1 - 0.5
    along, across = (du + dv, du - dv) if (i + j) % 2 else (du - dv, du + dv)
    raised = (along / 0.62) ** 2 + (across / 0.20) ** 2
    base = shade((0.56, 0.57, 0.59), 0.94 + 0.10 * smooth_noise(x * 90, y * 90))
    return shade((0.68, 0.69, 0.71), 1.04 - 0.2 * across) if raised < 1 else shade(base, 0.90 if raised < 1.35 else 1)


def amr_flank(x, y, name):
    """A painted side of a carrier: joints, a vent, a lamp strip, the name from `name` on, where no wheel hides it."""
    paint = shade((0.88, 0.89, 0.90), 1.02 - 0.10 * y + 0.02 * smooth_noise(x * 30, y * 30))
    if y > 0.80:
        return shade((0.17, 0.18, 0.20), 1)
    if 0.735 < y < 0.775:
        return (0.16, 0.62, 0.86)
    if abs(x - 0.52) < 0.0035 or abs(x - 0.90) < 0.0035 or abs(x - 0.10) < 0.0035 or abs(y - 0.06) < 0.007:
        return shade(paint, 0.62)
    if within(x, y, 0.62 - 0.4 * (name > 0.4), 0.18, 0.80 - 0.4 * (name > 0.4), 0.62):
        return shade((0.20, 0.21, 0.23), 1) if ((y - 0.18) * 16) % 1 < 0.55 else shade(paint, 0.88)
    if written("AMR", x, y, name, 0.20, 0.40, 0.112):
        return (0.13, 0.30, 0.55)
    for cx in (0.035, 0.965):
        for cy in (0.14, 0.68):
            if math.hypot((x - cx), (y - cy) * 0.45) < 0.008:
                return shade(paint, 0.55)
    return paint


def amr_left(x, y):
    return amr_flank(x, y, 0.545)


def amr_right(x, y):
    return amr_flank(x, y, 0.145)


def front(x, y):
    """The face of a carrier: a black window for its scanner between two lamps."""
    paint = shade((0.88, 0.89, 0.90), 1.02 - 0.10 * y)
    if y > 0.80:
        return (0.17, 0.18, 0.20)
    if within(x, y, 0.28, 0.26, 0.72, 0.58):
        return shade((0.06, 0.07, 0.09), 1 + 1.6 * max(0, 0.35 - abs(x - y * 0.6 - 0.2)))
    for cx in (0.13, 0.87):
        d = math.hypot(x - cx, (y - 0.42) * 0.5)
        if d < 0.062:
            return shade((0.98, 0.97, 0.90), 1 - 2.4 * d)
        if d < 0.078:
            return (0.30, 0.31, 0.33)
    return paint


def circuit(x, y):
    """A board: chips with legs, copper tracks, gold rings."""
    for left, top, right, low in ((0.12, 0.16, 0.40, 0.46), (0.56, 0.12, 0.78, 0.30), (0.60, 0.54, 0.88, 0.84), (0.14, 0.66, 0.34, 0.82)):
        if within(x, y, left, top, right, low):
            if math.hypot(x - left - 0.03, y - top - 0.03) < 0.012:
                return (0.45, 0.45, 0.46)
            return shade((0.11, 0.11, 0.12), 1.15 - 0.3 * (y - top))
        if within(x, y, left - 0.022, top + 0.01, right + 0.022, low - 0.01) and ((y - top) * 26) % 1 < 0.5:
            return (0.76, 0.76, 0.74)
    for cx in (0.05, 0.95):
        for cy in (0.05, 0.95):
            if ring(x, y, cx, cy, 0.014, 0.032):
                return (0.80, 0.66, 0.30)
            if math.hypot(x - cx, y - cy) < 0.014:
                return (0.05, 0.06, 0.05)
    i, j = int(x * 24), int(y * 24)
    along_x = noise(i // 5, j) > 0.55 and abs((y * 24) % 1 - 0.5) < 0.14
    along_y = noise(i + 77, j // 5 + 31) > 0.66 and abs((x * 24) % 1 - 0.5) < 0.14
    if along_x or along_y:
        return (0.22, 0.47, 0.26)
    if noise(i + 311, j + 97) > 0.90 and ring(x * 24 % 1, y * 24 % 1, 0.5, 0.5, 0.16, 0.34):
        return (0.78, 0.66, 0.34)
    return shade((0.07, 0.30, 0.15), 0.95 + 0.1 * smooth_noise(x * 50, y * 50))


def evbot_side(x, y):
    """A blue case with cooling slots and its name."""
    metal = shade((0.16, 0.34, 0.62), 1.06 - 0.16 * y + 0.03 * smooth_noise(x * 200, y * 6))
    edge = min(x, y, 1 - x, 1 - y)
    if edge < 0.025:
        return shade(metal, 0.75)
    for cx in (0.07, 0.93):
        for cy in (0.12, 0.88):
            if math.hypot(x - cx, (y - cy) * 0.55) < 0.018:
                return shade((0.70, 0.71, 0.73), 1)
    if within(x, y, 0.16, 0.62, 0.84, 0.84):
        return shade((0.05, 0.07, 0.10), 1) if ((x - 0.16) * 20) % 1 < 0.5 else shade(metal, 0.9)
    if written("EVBOT", x, y, 0.18, 0.20, 0.30, 0.132):
        return (0.93, 0.94, 0.95)
    return metal


def carbon(x, y):
    """Dark woven plate with a light edge."""
    if min(x, y, 1 - x, 1 - y) < 0.012:
        return (0.30, 0.31, 0.33)
    u, v = x * 28, y * 28
    over = (int(u) + int(v)) % 2
    wave = abs((u if over else v) % 1 - 0.5)
    return shade((0.165, 0.17, 0.18), 1.22 - 0.75 * wave if over else 0.98 - 0.5 * wave)


def rings(x, y):
    """Once around a mast: bands of black and steel."""
    band = (y * 5) % 1
    return (0.12, 0.12, 0.13) if band < 0.18 else shade((0.66, 0.68, 0.71), 0.86 + 0.28 * abs(x - 0.5))


COURSE = (2.4, 1.6)  # m, of the floor with the line
LINE_WIDTH = 0.018  # m


def line_at(t):
    """A point of the line, m from the middle of the floor, x to the right, y up; t from 0 to 2 pi goes around once."""
    return (0.88 * math.cos(t) + 0.10 * math.cos(2 * t) - 0.06 * math.sin(3 * t),
            0.50 * math.sin(t) + 0.10 * math.sin(3 * t) + 0.06 * math.cos(2 * t))


def line_cells(cell, steps=6000):
    """Points of the line by the cells of a grid that are within a cell of them."""
    cells = {}
    for k in range(steps):
        x, y = line_at(2 * math.pi * k / steps)
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                cells.setdefault((math.floor(x / cell) + i, math.floor(y / cell) + j), []).append((x, y))
    return cells


LINE_CELL = 0.02
LINE_CELLS = line_cells(LINE_CELL)


def line_course(x, y):
    """A floor for line followers: a closed black line on light grey, a dark border."""
    px, py = (x - 0.5) * COURSE[0], (0.5 - y) * COURSE[1]
    if COURSE[0] / 2 - abs(px) < 0.02 or COURSE[1] / 2 - abs(py) < 0.02:
        return (0.45, 0.47, 0.50)
    near = LINE_CELLS.get((math.floor(px / LINE_CELL), math.floor(py / LINE_CELL)), ())
    dark = any(math.hypot(px - qx, py - qy) <= LINE_WIDTH / 2 for qx, qy in near)
    return (0.08, 0.08, 0.09) if dark else (0.80, 0.80, 0.78)


PICTURES = {"tyre": (tyre, 512, 64), "wheel": (wheel, 256, 256), "hazard": (hazard, 256, 64), "deck": (deck, 256, 192),
            "amr_left": (amr_left, 512, 160), "amr_right": (amr_right, 512, 160), "amr_front": (front, 320, 128), "circuit": (circuit, 256, 256),
            "evbot_side": (evbot_side, 320, 128), "carbon": (carbon, 256, 256), "mast": (rings, 64, 128),
            "line_course": (line_course, 960, 640)}


def png(width, height, rows):
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b"")


def draw(function, width, height):
    rows = []
    for row in range(height):
        line = bytearray(1)  # no filter
        for column in range(width):
            total = [0.0, 0.0, 0.0]
            for j in range(SAMPLES):
                for i in range(SAMPLES):
                    colour = function((column + (i + 0.5) / SAMPLES) / width, (row + (j + 0.5) / SAMPLES) / height)
                    for k in range(3):
                        total[k] += min(max(colour[k], 0), 1)
            line += bytes(round(255 * t / SAMPLES ** 2) for t in total)
        rows.append(bytes(line))
    return png(width, height, rows)


if __name__ == "__main__":
    folder = os.path.dirname(os.path.abspath(__file__))
    for name, (function, width, height) in PICTURES.items():
        with open(os.path.join(folder, name + ".png"), "wb") as file:
            file.write(draw(function, width, height))
