"""A map of square cells, as controllers/lidar_map/occupancy_grid.cpp."""

import math
from array import array

UNKNOWN, FREE, OCCUPIED = 0, 1, 2
_LEAST = 1.0  # weight of beams that make a cell known
_GREY = {UNKNOWN: 205, FREE: 254, OCCUPIED: 0}


class OccupancyGrid:
    """Square, with the origin of its frame in its middle. A cell counts the beams that have passed it and those that have ended in it, each
    by its weight; it is occupied if it has stopped at least half of them (Hähnel, Burgard, Fox and Thrun 2003). A cell is the number
    y * count + x; m, rad."""

    def __init__(self, side, cell_size):
        self.cell_size = cell_size
        self.count = 2 * math.ceil(side / cell_size / 2)
        self.half = self.count * cell_size / 2
        self.passed = array("d", bytes(8 * self.count * self.count))
        self.stopped = array("d", self.passed)

    def column(self, x):
        """The number of the column or row that x or y is in; the map has 0 to count - 1."""
        return math.floor((x + self.half) / self.cell_size)

    def cell_at(self, x, y):
        """None outside the map."""
        column, row = self.column(x), self.column(y)
        return row * self.count + column if 0 <= column < self.count and 0 <= row < self.count else None

    def middle(self, cell):
        y, x = divmod(cell, self.count)
        return (x + 0.5) * self.cell_size - self.half, (y + 0.5) * self.cell_size - self.half

    def at(self, cell):
        passed, stopped = self.passed[cell], self.stopped[cell]
        if passed + stopped < _LEAST:
            return UNKNOWN
        return OCCUPIED if stopped >= passed else FREE

    def states(self):
        """Of all cells, as bytes."""
        return bytes(UNKNOWN if passed + stopped < _LEAST else OCCUPIED if stopped >= passed else FREE
                     for passed, stopped in zip(self.passed, self.stopped))

    def add_beam(self, x, y, bearing, reach, is_hit, deviation):
        """A beam from (x, y) which ends after `reach` m; `is_hit`: at something. In steps of a quarter of a cell, each cell once. Exact beams
        count more than others, by the square of their `deviation`."""
        cells = 2 * deviation / self.cell_size
        weight = 1 / (1 + cells * cells)
        c, s, step = math.cos(bearing), math.sin(bearing), self.cell_size / 4
        size, half, count, passed, floor = self.cell_size, self.half, self.count, self.passed, math.floor
        end = floor((x + reach * c + half) / size), floor((y + reach * s + half) / size)
        last, way = (-1, -1), 0.0
        while way < reach:
            cell = floor((x + way * c + half) / size), floor((y + way * s + half) / size)
            way += step
            if cell == last or (is_hit and cell == end):
                continue
            last = cell
            if 0 <= cell[0] < count and 0 <= cell[1] < count:
                passed[cell[1] * count + cell[0]] += weight
        if is_hit and 0 <= end[0] < count and 0 <= end[1] < count:
            self.stopped[end[1] * count + end[0]] += weight

    def known_area(self):
        """m^2 that are free or occupied."""
        known = sum(passed + stopped >= _LEAST for passed, stopped in zip(self.passed, self.stopped))
        return known * self.cell_size * self.cell_size

    def picture(self):
        """A binary PGM picture with y upwards: 254 free, 205 unknown, 0 occupied."""
        grey = bytes(map(_GREY.get, self.states()))
        rows = [grey[y * self.count:(y + 1) * self.count] for y in reversed(range(self.count))]
        return f"P5\n{self.count} {self.count}\n255\n".encode() + b"".join(rows)

    def picture_description(self, picture_name):
        """What map_server of ROS reads with the picture."""
        return (f"image: {picture_name}\nresolution: {self.cell_size:g}\norigin: [{-self.half:g}, {-self.half:g}, 0]\n"
                "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
