"""Finds a dark line on a light floor and follows it, by three ground sensors alone, until it is back where it began, as
controllers/line_follow in C++."""

import math

import trundle
from trundle import field, metres_per_second, needs, number, output, radians_per_second


def distance_of(a, b):
    return math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))


class LineFollow(trundle.Controller):
    """Drives ahead until it sees a dark line, follows it, and ends the run when it is back at its beginning."""

    speed = field("Speed", 0.08, metres_per_second().above(0).at_most(10).live(), "Where the line is straight.")
    turn_rate = field("TurnRate", 3.0, radians_per_second().above(0).at_most(100).live(), "At most.")
    threshold = field("Threshold", 0.3, number().within(0.01, 1).live(), "Reflectance halfway from the line to the floor.")
    laps = field("Laps", 1, number().within(1, 1000), "Rounds after which it ends the run.")
    left = field("Left", "leftGround", needs("GroundSensor"), "The robot's GroundSensor on the left.")
    middle = field("Middle", "middleGround", needs("GroundSensor"), "The one in the middle.")
    right = field("Right", "rightGround", needs("GroundSensor"), "The one on the right.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    offset = output("offset", "", "Where the line is: 1 below the left sensor, -1 below the right one.")
    lap = output("lap", "", "Rounds done.", type=int)

    def setup(self, robot):
        self.sensors = [robot.ground_sensor(name) for name in (self.left, self.middle, self.right)]
        self.drive = robot.differential_drive(self.drive_name)
        self.following = False
        self.line_side = 1.0  # where the line was last: 1 left, -1 right
        self.travelled = self.turned = 0.0  # m, rad; in this round

    def darkness(self, sensor):
        """0 on the floor to 1 on the line."""
        return 0.0 if sensor.time() < 0 else min(max(1 - sensor.reflectance() / (2 * self.threshold), 0.0), 1.0)

    def update(self, since_last):
        dark = [self.darkness(sensor) for sensor in self.sensors]
        seen = max(dark) > 0.5
        if not self.following:
            if not seen:
                return self.drive.move(self.speed, 0)
            self.begin()
        self.count_laps()
        if self.lap >= self.laps:
            return
        if not seen:
            return self.drive.move(0, self.line_side * 0.6 * self.turn_rate)  # back to where it was last
        self.offset = (dark[0] - dark[2]) / (dark[0] + dark[1] + dark[2])
        if abs(self.offset) > 0.2:
            self.line_side = 1.0 if self.offset > 0 else -1.0
        self.drive.move(self.speed * (1 - 0.6 * abs(self.offset)), self.turn_rate * self.offset)

    def begin(self):
        self.following = True
        self.start = self.last = self.drive.odometry()
        print("found the line")

    def count_laps(self):
        """A round is a full turn that ends near its beginning, both by odometry."""
        now = self.drive.odometry()
        self.travelled += distance_of(now, self.last)
        self.turned += math.remainder(now.heading - self.last.heading, 2 * math.pi)
        self.last = now
        if distance_of(now, self.start) >= 0.1 or self.travelled < 1 or abs(self.turned) < 1.5 * math.pi:
            return
        self.lap += 1
        print(f"round {self.lap} of {self.laps}: {self.travelled:g} m")
        if self.lap >= self.laps:
            self.drive.stop()
            self.finish("went around")
        self.travelled = self.turned = 0.0
