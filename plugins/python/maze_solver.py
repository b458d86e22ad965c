"""Finds the shortest way through a maze of square cells: explores it to the goal and back, then runs the way it has found."""

import math
from collections import deque

import trundle
from trundle import field, metres, metres_per_second, needs, number, output, radians_per_second, unit_of

STEPS = ((1, 0), (0, 1), (-1, 0), (0, -1))  # cells, by heading: 0 is where it looks at the start, then counter-clockwise


class MazeSolver(trundle.Controller):
    """Explores a maze by flood filling until it is at the goal, returns, and runs the shortest way known."""

    cell = field("Cell", 0.18, metres().above(0).at_most(100), "From the middle of a cell to that of the next.")
    wall = field("Wall", 0.012, metres().within(0, 10), "Thickness of the walls.")
    size = field("Size", [16.0, 16.0], number().within(1, 100).counted(2, 2), "Cells ahead of the start and to its left, with its own.")
    goal = field("Goal", [7.0, 7.0], number().within(0, 99).counted(2, 2), "The cell to reach, counted from that of the start, 0,0.")
    speed = field("Speed", 0.35, metres_per_second().above(0).at_most(10).live(), "While it explores.")
    fast = field("RunSpeed", 0.8, metres_per_second().above(0).at_most(10).live(), "On the known way.")
    turn_rate = field("TurnRate", 6.0, radians_per_second().above(0).at_most(100).live(), "In place.")
    braking = field("Braking", 1.2, unit_of("m/s^2").above(0).at_most(100), "Before it stops.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    front_names = field("Front", ["frontLeft", "frontRight"], needs("RangeSensor").counted(1, 10), "RangeSensors ahead.")
    left_name = field("Left", "sideLeft", needs("RangeSensor"), "The RangeSensor to the left.")
    right_name = field("Right", "sideRight", needs("RangeSensor"), "The RangeSensor to the right.")
    front_place = field("FrontPlace", 0.047, metres().within(0, 10), "Of the RangeSensors ahead, in front of the axle.")
    side_place = field("SidePlace", 0.031, metres().within(0, 10), "Of those to the sides, from the middle.")
    phase = output("phase", "", "1 explores, 2 returns, 3 runs, 4 is done.", type=int)
    visited = output("visited", "", "Cells that it has been in.", type=int)
    way = output("way", "", "Cells of the shortest way known, from the start to the goal.", type=int)

    def setup(self, robot):
        self.drive = robot.differential_drive(self.drive_name)
        self.front = [robot.range_sensor(name) for name in self.front_names]
        self.sides = [(robot.range_sensor(self.left_name), 1), (robot.range_sensor(self.right_name), -1)]
        self.columns, self.rows = int(self.size[0]), int(self.size[1])
        self.target = int(self.goal[0]), int(self.goal[1])
        if not self.is_inside(self.target):
            raise ValueError(f"the goal {self.target} is not in the maze of {self.columns} by {self.rows} cells")
        self.at, self.heading = (0, 0), 0
        self.walls = {}  # (cell, heading): whether there is one
        self.seen = set()
        self.x = self.y = self.angle = 0.0  # where it thinks that it is, from the middle of the first cell
        self.last = None
        self.stretch = self.turn_to = None
        self.phase = 1

    def update(self, since_last):
        if self.front[0].time() < 0:
            return
        self.follow_odometry()
        if self.turn_to is not None:
            return self.turn()
        if self.stretch is not None:
            return self.go()
        self.decide()

    # --- where it is ---

    def follow_odometry(self):
        now = self.drive.odometry()
        before = self.last or now
        self.last = now
        turned = math.remainder(now.heading - before.heading, 2 * math.pi)
        middle = before.heading + turned / 2
        way = (now.x - before.x) * math.cos(middle) + (now.y - before.y) * math.sin(middle)
        self.x += way * math.cos(self.angle + turned / 2)
        self.y += way * math.sin(self.angle + turned / 2)
        self.angle = math.remainder(self.angle + turned, 2 * math.pi)

    def error(self):
        """How far its heading is off, and how far it is to the left of the line through the cells."""
        dx, dy = STEPS[self.heading]
        to_left = (self.y - self.at[1] * self.cell) * dx - (self.x - self.at[0] * self.cell) * dy
        return math.remainder(self.angle - self.heading * math.pi / 2, 2 * math.pi), to_left

    def shift(self, ahead, left):
        dx, dy = STEPS[self.heading]
        self.x += ahead * dx - left * dy
        self.y += ahead * dy + left * dx

    def correct(self):
        """Compares the walls beside it with where they should be: shifts, and turns what it thinks of its heading."""
        off, to_left = self.error()
        free = (self.cell - self.wall) / 2
        for sensor, sign in self.sides:
            reading = sensor.range() * math.cos(off) + self.side_place
            measured = sign * (free - reading)
            if abs(measured - to_left) > 0.1 * self.cell:
                continue  # no wall, or the end of one
            self.shift(0, 0.05 * (measured - to_left))
            self.angle += 0.3 * (measured - to_left)

    # --- how it moves ---

    def turn(self):
        off, _ = self.error()
        if abs(off) < 0.02:
            self.turn_to = None
            return self.drive.stop()
        self.drive.move(0, max(-self.turn_rate, min(self.turn_rate, -10 * off)))

    def go(self):
        """Along a stretch of cells, to the middle of the last one."""
        self.correct()
        dx, dy = STEPS[self.heading]
        rest = (self.stretch[0] * self.cell - self.x) * dx + (self.stretch[1] * self.cell - self.y) * dy
        if self.walls.get((self.stretch, self.heading)):
            reading = min(sensor.range() for sensor in self.front) + self.front_place
            measured = reading - (self.cell - self.wall) / 2  # the wall behind the last cell says how far it is
            if abs(measured - rest) < 0.2 * self.cell:
                self.shift(0.2 * (rest - measured), 0)
        if rest < 0.002:
            self.at, self.stretch = self.stretch, None
            return self.drive.stop()
        off, to_left = self.error()
        top = self.fast if self.phase == 3 else self.speed
        speed = min(top, math.sqrt(2 * self.braking * rest))
        self.drive.move(speed, -8 * off - 60 * to_left)

    # --- where it goes ---

    def is_inside(self, cell):
        return 0 <= cell[0] < self.columns and 0 <= cell[1] < self.rows

    def look(self):
        """Notes the walls around the cell that it is in."""
        self.seen.add(self.at)
        ahead = min(sensor.range() for sensor in self.front) + self.front_place
        beside = [sensor.range() + self.side_place for sensor, _ in self.sides]
        for turn, reading in ((0, ahead), (1, beside[0]), (3, beside[1])):
            self.note(self.at, (self.heading + turn) % 4, reading < 0.75 * self.cell)
        self.visited = len(self.seen)

    def note(self, cell, heading, is_wall):
        beyond = cell[0] + STEPS[heading][0], cell[1] + STEPS[heading][1]
        self.walls[cell, heading] = is_wall
        self.walls[beyond, (heading + 2) % 4] = is_wall

    def distances(self, goal, known_only=False):
        """Steps from each cell to the goal. What was not seen counts as open, or as a wall."""
        steps = {goal: 0}
        queue = deque([goal])
        while queue:
            cell = queue.popleft()
            for heading, (dx, dy) in enumerate(STEPS):
                beyond = cell[0] + dx, cell[1] + dy
                if self.is_inside(beyond) and beyond not in steps and not self.walls.get((cell, heading), known_only):
                    steps[beyond] = steps[cell] + 1
                    queue.append(beyond)
        return steps

    def best_heading(self, cell, heading, steps, known_only):
        """Of the headings that lead nearer the one ahead first; None if there is none."""
        best = None
        for turn in (0, 1, 3, 2):
            new = (heading + turn) % 4
            beyond = cell[0] + STEPS[new][0], cell[1] + STEPS[new][1]
            if self.walls.get((cell, new), known_only) or beyond not in steps:
                continue
            if steps[beyond] < steps[cell] and (best is None or steps[beyond] < best[0]):
                best = steps[beyond], new
        return best and best[1]

    def decide(self):
        self.look()
        home, known_only = (0, 0), self.phase == 3
        if self.at == (home if self.phase == 2 else self.target):
            self.phase += 1
            known = self.distances(self.target, True).get(home)
            if known is not None:
                self.way = known
            if self.phase == 2:
                print(f"in the middle after {self.time:.2f} s, {self.visited} cells seen")
            if self.phase == 3:
                print(f"back at the start, the shortest way known has {self.way} cells")
                self.began = self.time
            if self.phase == 4:
                print(f"ran it in {self.time - self.began:.2f} s")
                return self.finish("solved")
            known_only = self.phase == 3
        steps = self.distances(home if self.phase == 2 else self.target, known_only)
        heading = self.best_heading(self.at, self.heading, steps, known_only) if self.at in steps else None
        if heading is None:
            return self.finish("there is no way to the goal")
        if heading != self.heading:
            self.heading = self.turn_to = heading
            return
        self.stretch = self.ahead(self.at, steps, known_only)

    def ahead(self, cell, steps, known_only):
        """The end of the stretch: the next cell, on a known way the last one before a turn."""
        dx, dy = STEPS[self.heading]
        cell = cell[0] + dx, cell[1] + dy
        while known_only and steps[cell] > 0 and self.best_heading(cell, self.heading, steps, True) == self.heading:
            cell = cell[0] + dx, cell[1] + dy
        return cell
