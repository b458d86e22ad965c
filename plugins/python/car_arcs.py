"""Drives a car along arcs, one after the other: steers, drives the way, steers again."""

import math

import trundle
from trundle import degrees, field, metres, metres_per_second, needs, output


class CarArcs(trundle.Controller):
    """Steers a car and drives, for each pair of a steering angle and a way."""

    speed = field("Speed", 0.5, metres_per_second().above(0).at_most(100).live(), "On all arcs.")
    steering = field("Steering", [0.0], degrees().within(-80, 80).counted(1, 100), "Of each arc; positive turns left.")
    ways = field("Ways", [1.0], metres().within(-1e4, 1e4).counted(1, 100), "Of each arc; negative is backwards.")
    drive_name = field("Drive", "drive", needs("AckermannDrive"), "The robot's AckermannDrive.")
    arc = output("arc", "", "Number of the arc under way, from 1; 0 before the first.", type=int)

    def setup(self, robot):
        if len(self.steering) != len(self.ways):
            raise ValueError(f"Steering has {len(self.steering)} angles and Ways {len(self.ways)} ways")
        self.drive = robot.ackermann_drive(self.drive_name)
        self.number, self.is_driving = 0, False

    def update(self, since_last):
        if self.is_driving and not self.drive.done():
            return
        if self.is_driving:
            self.number, self.is_driving = self.number + 1, False
        if self.number == len(self.ways):
            self.drive.stop()
            return self.finish(f"done: {self.number} arcs")
        angle, way = self.steering[self.number], self.ways[self.number]
        self.arc = self.number + 1
        if abs(self.drive.steering() - angle) > 0.002:
            return self.drive.move(0.0, angle)
        self.drive.drive(math.copysign(self.speed, way), angle, way)
        self.is_driving = True
