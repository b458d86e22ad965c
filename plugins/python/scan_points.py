"""What a level lidar sees, as points around the robot, as controllers/collect/scan_points.cpp."""

import math

_JUMP = 0.1  # m: between two beams, from one thing to the next
_DEGREE = math.pi / 180
_MEAN_DEPTH = math.pi / 4  # of a circle's front before its middle, averaged over its width, in radii


def length(x, y):
    return math.sqrt(x * x + y * y)


class ScanPoints:
    """The scan of a lidar that faces ahead on the robot's x axis, `ahead` m before the axle. m, rad."""

    def __init__(self, ranges, field_of_view, ahead, max_range):
        self.ranges, self.ahead, self.max_range = list(ranges), ahead, max_range
        self.step = field_of_view / (len(self.ranges) - 1) if len(self.ranges) > 1 else 0.0
        self.first = -field_of_view / 2
        self.points = []
        for i, far in enumerate(self.ranges):
            bearing = self.first + i * self.step
            self.points.append((ahead + far * math.cos(bearing), far * math.sin(bearing)))

    def cylinders(self, radius):
        """Middles of free-standing round things with about this radius: runs of at least three beams, as wide as the thing, that are nearer
        than the beams on both sides."""
        found, r, count = [], self.ranges, len(self.ranges)
        following = 0
        while following < count:
            first = following
            following = first + 1
            while following < count and abs(r[following] - r[following - 1]) < _JUMP:
                following += 1
            if first == 0 or following == count or following - first < 3:
                continue
            if r[first - 1] < r[first] or r[following] < r[following - 1]:
                continue  # something hides its edge
            middle = self.first + self.step * (first + following - 1) / 2
            along = 0.0
            for i in range(first, following):
                along += r[i] * math.cos(self.first + self.step * i - middle)
            along /= following - first
            width = along * self.step * (following - first)  # each beam stands for a step
            if along >= self.max_range or width < 1.2 * radius or width > 2.8 * radius:
                continue
            along += _MEAN_DEPTH * radius
            found.append((self.ahead + along * math.cos(middle), along * math.sin(middle)))
        return found

    def free_bearing(self, desired, reach, width, ignored, ignored_radius):
        """The bearing nearest to the desired one along which nothing is within `reach` m in a lane of `width` m, except around `ignored`. The
        desired bearing itself if all are blocked."""
        for i in range(19):
            for side in (1, -1):
                bearing = desired + side * i * 5 * _DEGREE
                if self.is_free(bearing, reach, width, ignored, ignored_radius):
                    return bearing
        return desired

    def is_free(self, bearing, reach, width, ignored, ignored_radius):
        """Whether nothing is in such a lane."""
        c, s = math.cos(bearing), math.sin(bearing)
        for x, y in self.points:
            along, aside = c * x + s * y, c * y - s * x
            if along < 0 or along > reach or abs(aside) > width / 2:
                continue
            if length(x - ignored[0], y - ignored[1]) >= ignored_radius:
                return False
        return True
