"""Follows the walls of a room at a constant distance, by the ranges of a level lidar alone, until it is back where it began, as
controllers/wall_follow in C++."""

import math

import trundle
from trundle import degrees, field, metres, metres_per_second, needs, number, one_of, output, radians_per_second

DEGREE = math.pi / 180


def clamp(value, low, high):
    return min(max(value, low), high)


def distance_of(a, b):
    return math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))


class WallFollow(trundle.Controller):
    """Drives ahead until there is a wall, follows it at a distance, and ends the run when it is back at its beginning."""

    speed = field("Speed", 0.15, metres_per_second().above(0).at_most(10).live(), "Along the wall.")
    distance = field("Distance", 0.3, metres().above(0).at_most(100).live(), "From the lidar to the wall.")
    turn_rate = field("TurnRate", 1.5, radians_per_second().above(0).at_most(100).live(), "At most.")
    side = field("Side", "left", one_of("left|right"), "Where the wall is kept.")
    laps = field("Laps", 1, number().within(1, 1000), "Rounds after which it ends the run.")
    field_of_view = field("FieldOfView", 360 * DEGREE, degrees().above(0).at_most(360), "That of the lidar.")
    lidar_name = field("Lidar", "scan", needs("Lidar"), "The robot's Lidar.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    gap = output("gap", "m", "Distance of the nearest wall on its side.")
    lap = output("lap", "", "Rounds done.", type=int)

    def setup(self, robot):
        self.lidar = robot.lidar(self.lidar_name)
        self.drive = robot.differential_drive(self.drive_name)
        self.sign = 1 if self.side == "left" else -1
        self.following = False
        self.travelled = self.turned = 0.0  # m, rad; in this round

    def update(self, since_last):
        if not self.lidar.fresh():
            return  # a scan, not a tick, is its step
        if self.following:
            self.count_laps()
        self.ranges = self.lidar.ranges()
        ahead, _ = self.nearest(-30 * DEGREE, 50 * DEGREE)
        if not self.following and ahead > self.distance:
            return self.drive.move(self.speed, 0)
        if not self.following:
            self.begin()
        gap, bearing = self.nearest(30 * DEGREE, 135 * DEGREE)
        self.gap = gap
        if ahead < 1.05 * self.distance:
            return self.drive.move(0, -self.sign * 0.6 * self.turn_rate)  # a corner: away from the wall
        towards = clamp(3 * (gap - self.distance), -0.7, 0.7)  # rad
        error = bearing - 90 * DEGREE + towards
        turn = clamp(2.5 * error, -self.turn_rate, self.turn_rate)
        self.drive.move(self.speed * clamp(1 - abs(error), 0.3, 1.0), self.sign * turn)

    def nearest(self, start, end):
        """Range and bearing, positive on the side of the wall, of the nearest thing between two bearings. A single stray beam does not
        count: each is the middle one of three neighbours."""
        count = len(self.ranges)
        closed = self.field_of_view > 359.9 * DEGREE
        step = self.field_of_view / max(1, count if closed else count - 1)
        best = 1e9, 0.0
        for i in range(count):
            bearing = self.sign * (-self.field_of_view / 2 + i * step)
            if not start <= bearing <= end:
                continue
            middle = sorted((self.ranges[i - 1], self.ranges[i], self.ranges[(i + 1) % count]))[1]
            if middle < best[0]:
                best = middle, bearing
        return best

    def begin(self):
        self.following = True
        self.start = self.last = self.drive.odometry()
        print("follows the wall on its", self.side)

    def count_laps(self):
        """A round is a full turn that ends near its beginning, both by odometry."""
        now = self.drive.odometry()
        self.travelled += distance_of(now, self.last)
        self.turned += math.remainder(now.heading - self.last.heading, 2 * math.pi)
        self.last = now
        is_back = distance_of(now, self.start) < 1.2 * self.distance
        if not is_back or self.travelled < 8 * self.distance or abs(self.turned) < 300 * DEGREE:
            return
        self.lap += 1
        print(f"round {self.lap} of {self.laps}: {self.travelled:g} m")
        if self.lap >= self.laps:
            self.drive.stop()
            self.finish("went around")
        self.travelled = self.turned = 0.0
