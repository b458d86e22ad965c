"""Explores a place and draws its map, from the ranges of a level lidar and the odometry of its wheels alone, as controllers/lidar_map in C++."""

import math

import trundle
from trundle import degrees, field, metres, metres_per_second, needs, number, output, radians_per_second, text

from frontier_planner import FrontierPlanner
from occupancy_grid import OccupancyGrid

DEGREE = math.pi / 180
LOOK_AHEAD = 0.15  # m along its path: where it heads
SCANS_PER_PLAN = 5
LONGEST = 60  # s without anything new: what is left cannot be seen


def clamp(value, low, high):
    return min(max(value, low), high)


class LidarMap(trundle.Controller):
    """Drives to where its map ends until all that it can reach is known, saves the map as a picture, and ends the run."""

    cell_size = field("CellSize", 0.05, metres().within(0.005, 1), "Side of a cell of the map.")
    side = field("Side", 14.0, metres().within(1, 200), "Of the whole map; it begins in the middle.")
    speed = field("Speed", 0.15, metres_per_second().above(0).at_most(10).live(), "At most.")
    turn_rate = field("TurnRate", 1.2, radians_per_second().above(0).at_most(100).live(), "At most.")
    clearance = field("Clearance", 0.25, metres().within(0, 10), "From its axle to what is in the map.")
    used_range = field("UsedRange", 2.5, metres().above(0).at_most(1000), "What is farther from the lidar does not get into the map.")
    deviation = field("Deviation", 0.004, metres().within(0, 10), "Noise of the lidar.")
    deviation_per_metre = field("DeviationPerMetre", 0.0175, number().within(0, 10), "Its NoisePerMetre.")
    lidar_ahead = field("LidarAhead", -0.032, metres().within(-10, 10), "From the axle to the lidar.")
    field_of_view = field("FieldOfView", 360 * DEGREE, degrees().above(0).at_most(360), "That of the lidar.")
    file = field("File", "map.pgm", text(), "Of the map, in the log folder; with a .yaml beside it that ROS reads.")
    lidar_name = field("Lidar", "scan", needs("Lidar"), "The robot's Lidar.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    known = output("known", "m^2", "Area of the cells that are free or occupied.")

    def setup(self, robot):
        self.lidar = robot.lidar(self.lidar_name)
        self.drive = robot.differential_drive(self.drive_name)
        self.map = OccupancyGrid(self.side, self.cell_size)
        self.path, self.scans, self.grown = [], 0, 0.0  # grown: s, when its map last became larger

    def update(self, since_last):
        if not self.lidar.fresh():
            return  # a scan, not a tick, is its step
        self.here = self.drive.odometry()
        self.ranges = list(self.lidar.ranges())
        self.add_scan()
        if self.scans % SCANS_PER_PLAN == 0:
            area = self.map.known_area()
            if area > self.known + 0.01:
                self.grown = self.time
            self.known = area
            if self.time - self.grown > LONGEST:
                return self.save()
            path = FrontierPlanner(self.map, self.clearance).path(self.map.cell_at(self.here.x, self.here.y))
            if path is None:
                return self.save()
            self.path = path
        self.scans += 1
        self.follow()

    def beam_step(self):
        """rad between two beams."""
        closed = self.field_of_view > 359.9 * DEGREE
        return self.field_of_view / max(1, len(self.ranges) - (0 if closed else 1))

    def add_scan(self):
        here, step, first = self.here, self.beam_step(), self.here.heading - self.field_of_view / 2
        x, y = here.x + self.lidar_ahead * math.cos(here.heading), here.y + self.lidar_ahead * math.sin(here.heading)
        for i, reach in enumerate(self.ranges):
            self.map.add_beam(x, y, first + i * step, min(reach, self.used_range), reach < self.used_range,
                              self.deviation + self.deviation_per_metre * reach)

    def follow(self):
        """Heads for the cell of its path that is farthest within LOOK_AHEAD."""
        goal = self.path[0]
        for cell in self.path:
            if self.distance(cell) < LOOK_AHEAD:
                goal = cell
        x, y = self.map.middle(goal)
        error = math.remainder(math.atan2(y - self.here.y, x - self.here.x) - self.here.heading, 2 * math.pi)
        turn = clamp(2 * error, -self.turn_rate, self.turn_rate)
        if self.is_blocked():
            return self.drive.move(-0.3 * self.speed, turn)  # its map is wrong here
        self.drive.move(0 if abs(error) > 40 * DEGREE else self.speed * math.cos(error), turn)

    def is_blocked(self):
        """Something is ahead of it, nearer than half of its clearance."""
        first, step = -self.field_of_view / 2, self.beam_step()
        return any(abs(first + i * step) < 35 * DEGREE and reach + self.lidar_ahead < self.clearance / 2
                   for i, reach in enumerate(self.ranges))

    def distance(self, cell):
        x, y = self.map.middle(cell)
        x, y = x - self.here.x, y - self.here.y
        return math.sqrt(x * x + y * y)

    def save(self):
        self.drive.stop()
        picture = self.open_log(self.file)
        if picture.open:
            picture.write(self.map.picture())
            stem = self.file[:self.file.rindex(".")] if "." in self.file else self.file
            self.open_log(stem + ".yaml").write(self.map.picture_description(self.file.rsplit("/", 1)[-1]))
            print(f"mapped {self.known:g} m^2 into {self.file}")
        else:
            self.warn("there is no log folder for ", self.file)
        self.finish("mapped")
