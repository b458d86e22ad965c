"""Finds cylinders with a lidar, grips them one after the other, and puts them down in a row at home, as controllers/collect in C++. Sonars see
what is beside and behind it."""

import math

import trundle
from trundle import degrees, field, metres, metres_per_second, needs, number, output, radians_per_second

from scan_points import ScanPoints, length

ALIGN = 0.65  # m from the axle to a cylinder: here it turns to it before it drives on to grip it
LANE = 0.52  # m: what it needs beside nothing
RETREAT = 0.5  # m back from what it has put down
SAME_THING = 0.3  # m between where a cylinder was and is seen
RELEASED = 0.15  # m back: its jaws are clear of what it has put down
PASS = 0.1  # m/s with which it passes what its back would swing into
DEGREE = math.pi / 180


def wrapped(angle):
    return math.remainder(angle, 2 * math.pi)


def clamp(value, low, high):
    return min(max(value, low), high)


class Collect(trundle.Controller):
    """Finds cylinders with its lidar, grips them, puts them down in a row at home, and ends the run when all are there."""

    count = field("Count", 6, number().within(1, 100), "Cylinders to bring.")
    radius = field("Radius", 0.04, metres().within(0.01, 0.5), "Of a cylinder.")
    home = field("Home", (-0.9, 0.0), metres(), "Middle of the row that it makes at home, seen from its start, x ahead.")
    spacing = field("Spacing", 0.34, metres().within(0.1, 10), "Between two cylinders in the row.")
    survey = field("Survey", [1.5, 0.0], metres().counted(2, 100), "x, y, and so on: where it looks around if it sees none.")
    speed = field("Speed", 0.4, metres_per_second().above(0).at_most(10).live(), "At most.")
    turn_rate = field("TurnRate", 0.8, radians_per_second().above(0).at_most(100).live(), "At most.")
    grip = field("Grip", 0.315, metres().within(0, 10), "From the axle to the middle of its jaws.")
    lidar_ahead = field("LidarAhead", 0.165, metres().within(-10, 10), "From the axle to the lidar.")
    field_of_view = field("FieldOfView", 240 * DEGREE, degrees().above(0).at_most(360), "That of the lidar.")
    max_range = field("MaxRange", 4.0, metres().above(0), "That of the lidar.")
    sonar_names = field("Sonars", [f"sonar{i}" for i in range(16)], needs("RangeSensor").counted(0, 100), "RangeSensors around it.")
    sonar_bearings = field("SonarBearings", [b * DEGREE for b in (90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170,
                                                                  170, 150, 130, 90)],
                           degrees().within(-180, 180).counted(0, 100), "Where each of them looks to, positive to the left.")
    clearance = field("Clearance", 0.2, metres().within(0, 10), "From its sonars to what it does not turn or drive back into.")
    lidar_name = field("Lidar", "scan", needs("Lidar"), "The robot's Lidar.")
    gripper_name = field("Gripper", "gripper", needs("Gripper"), "The robot's Gripper; it is open at the start.")
    lift_name = field("Lift", "lift", needs("LinearMotor"), "The LinearMotor that lifts the gripper.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    delivered = output("delivered", "", "Cylinders at home.", type=int)

    def setup(self, robot):
        if len(self.sonar_bearings) != len(self.sonar_names):
            return self.fail("Sonars and SonarBearings are not equally many")
        self.sonars = [robot.range_sensor(name) for name in self.sonar_names]
        self.lidar = robot.lidar(self.lidar_name)
        self.gripper = robot.gripper(self.gripper_name)
        self.lift = robot.linear_motor(self.lift_name)
        self.drive = robot.differential_drive(self.drive_name)
        self.state = self.search
        self.since = self.turned = self.last_heading = self.best_far = 0.0
        self.target, self.best = (0.0, 0.0), None
        self.surveyed = self.row = 0

    def update(self, since_last):
        if not self.lidar.fresh():
            return  # a scan, not a tick, is its step
        self.here = self.drive.odometry()
        self.scan = ScanPoints(self.lidar.ranges(), self.field_of_view, self.lidar_ahead, self.max_range)
        self.state()

    def enter(self, state):
        self.state = state
        self.since = self.time
        self.turned, self.last_heading = 0.0, self.here.heading
        self.start = self.here
        self.row = 0

    def elapsed(self):
        """s in this state"""
        return self.time - self.since

    def outside(self, x, y):
        """A point of the robot's frame in that of its odometry; inside() is the way back."""
        c, s = math.cos(self.here.heading), math.sin(self.here.heading)
        return self.here.x + c * x - s * y, self.here.y + s * x + c * y

    def inside(self, point):
        c, s = math.cos(self.here.heading), math.sin(self.here.heading)
        x, y = point[0] - self.here.x, point[1] - self.here.y
        return c * x + s * y, c * y - s * x

    def nearest(self, to, within):
        """The cylinder nearest to a point of the odometry's frame that is not at home, and not farther than `within` m."""
        best = None
        for seen in self.scan.cylinders(self.radius):
            x, y = self.outside(*seen)
            if abs(x - self.home[0]) < self.spacing and abs(y - self.home[1]) < self.spacing * (self.count + 1) / 2.0:
                continue
            far = length(x - to[0], y - to[1])
            if far < within:
                within, best = far, (x, y)
        return best

    def search(self):
        """Turns around once, then goes to the nearest cylinder that it has seen."""
        seen = self.nearest((self.here.x, self.here.y), self.best_far if self.best else self.max_range)
        if seen:
            self.best = seen
            self.best_far = length(seen[0] - self.here.x, seen[1] - self.here.y)
        self.turned += abs(wrapped(self.here.heading - self.last_heading))
        self.last_heading = self.here.heading
        if self.turned < 2 * math.pi:
            return self.steer(0.0, self.turn_rate, (0.0, 0.0), 0.0)
        self.drive.stop()
        if self.best:
            self.target, self.best = self.best, None
            return self.enter(self.approach)
        at = 2 * (self.surveyed % (len(self.survey) // 2))
        self.surveyed += 1
        self.target = (self.survey[at], self.survey[at + 1])
        self.enter(self.drive_to_survey)

    def is_near(self, low, high):
        """Whether something is near a sonar that looks between two bearings, positive to the left."""
        return any(low <= bearing <= high and sonar.time() >= 0 and sonar.range() < self.clearance
                   for sonar, bearing in zip(self.sonars, self.sonar_bearings))

    def steer(self, linear, turn, ignored, ignored_radius):
        """Drives and turns; where its back would swing into something, it goes past that first."""
        swings = False
        if turn > 0.1:
            swings = self.is_near(-160 * DEGREE, -80 * DEGREE)
        elif turn < -0.1:
            swings = self.is_near(80 * DEGREE, 160 * DEGREE)
        if not swings or not self.scan.is_free(0.0, 0.6, LANE, ignored, ignored_radius):
            return self.drive.move(linear, turn)
        self.drive.move(max(linear, PASS), clamp(turn, -0.1, 0.1))

    def drive_to(self, stop, ignored=(0.0, 0.0), ignored_radius=0.0):
        """Drives towards the target around what is in the way. True: nearer than `stop` m."""
        x, y = self.inside(self.target)
        far = length(x, y)
        if far < stop:
            self.drive.stop()
            return True
        bearing = self.scan.free_bearing(math.atan2(y, x), min(far, 1.0), LANE, ignored, ignored_radius)
        turn = clamp(2 * bearing, -self.turn_rate, self.turn_rate)
        most = min(self.speed, 0.1 + 0.8 * (far - stop))
        self.steer(0 if abs(bearing) > 30 * DEGREE else most * math.cos(2 * bearing), turn, ignored, ignored_radius)
        return False

    def drive_to_survey(self):
        if self.drive_to(0.15) or self.elapsed() > 60:
            self.enter(self.search)

    def approach(self):
        """To where it can grip the target, and turned to it."""
        self.target = self.nearest(self.target, SAME_THING) or self.target
        if self.elapsed() > 60:
            return self.enter(self.search)
        if not self.drive_to(ALIGN, self.inside(self.target), 0.15):
            return
        x, y = self.inside(self.target)
        bearing = math.atan2(y, x)
        if abs(bearing) > 1 * DEGREE:
            return self.drive.move(0, clamp(1.5 * bearing, -self.turn_rate, self.turn_rate))
        self.enter(self.reach)

    def reach(self):
        """Straight to it, until it is between the jaws."""
        self.target = self.nearest(self.target, 0.1) or self.target
        x, y = self.inside(self.target)
        if x > self.grip:
            return self.drive.move(clamp(x - self.grip, 0.03, 0.12), 2 * math.atan2(y, x))
        self.drive.stop()
        self.gripper.set_opening(-1)
        self.enter(self.close)

    def close(self):
        if self.gripper.holding():
            self.lift.set_target(0.05)
            if self.lift.position() > 0.045:
                self.enter(self.carry)
        elif self.elapsed() > 8:
            print("gripped nothing")
            self.release()

    def release(self):
        self.gripper.set_opening(0)
        self.lift.set_target(0)
        self.enter(self.open)

    def carry(self):
        """To a place before its slot in the row, there turned to it, and to the slot."""
        if self.gripper.position() < -0.18:
            print("lost it")
            return self.release()
        slot_x = self.home[0]
        slot_y = self.home[1] + self.spacing * (self.delivered - 0.5 * (self.count - 1))
        self.target = (slot_x + self.grip + RETREAT, slot_y)
        if self.row == 0 and not self.drive_to(0.08, (self.grip, 0.0), 0.12):
            return
        self.row = max(self.row, 1)
        off, aside = wrapped(math.pi - self.here.heading), self.here.y - slot_y
        if self.row == 1 and abs(off) > 1 * DEGREE:
            return self.drive.move(0, clamp(1.5 * off, -self.turn_rate, self.turn_rate))
        self.row = 2
        if self.here.x > slot_x + self.grip:
            return self.drive.move(clamp(self.here.x - slot_x - self.grip, 0.04, 0.2), 1.5 * (off + clamp(1.5 * aside, -0.4, 0.4)))
        self.drive.stop()
        self.lift.set_target(0)
        self.enter(self.put_down)

    def put_down(self):
        if self.lift.position() > 0.002 and self.elapsed() < 8:
            return
        self.gripper.set_opening(0)
        self.delivered += 1
        print("brought", self.delivered, "of", self.count)
        self.enter(self.open)

    def open(self):
        if self.gripper.position() > -0.01 or self.elapsed() > 8:
            self.enter(self.retreat)

    def retreat(self):
        gone = length(self.here.x - self.start.x, self.here.y - self.start.y)
        blocked = gone > RELEASED and (self.is_near(120 * DEGREE, 180 * DEGREE) or self.is_near(-180 * DEGREE, -120 * DEGREE))
        if gone < RETREAT and not blocked and self.elapsed() < 10:
            return self.drive.move(-0.25, 0)
        self.drive.stop()
        if self.delivered >= self.count:
            return self.finish("all are home")
        self.enter(self.search)
