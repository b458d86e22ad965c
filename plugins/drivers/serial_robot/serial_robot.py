#!/usr/bin/env python3
"""The driver of a robot with two wheels on a serial line, see fake_robot.py for what is spoken there. `trundle-cli drive` then drives the robot
with the controllers of any experiment whose robot has a DifferentialDrive `base`:

    python3 fake_robot.py                                        # prints the name of its line
    PYTHONPATH=... TRUNDLE_TOKEN=... python3 serial_robot.py robot0 /dev/pts/5 --port 4021
    TRUNDLE_TOKEN=... trundle-cli drive my.sim --at 4021 --set Tick=0.02"""

import math
import os
import select
import sys
import termios
import time
import tty

import trundle

WHEEL_RADIUS, SEPARATION, COUNTS = 0.033, 0.16, 1440  # m, m, counts in a turn: of its data sheet
ANSWER_TIME = 1.0  # s


class SerialLine:
    """Lines of text over a serial port."""

    def __init__(self, path):
        self.path = path
        self.file = os.open(path, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.file)
        settings = termios.tcgetattr(self.file)
        settings[4] = settings[5] = termios.B115200
        termios.tcsetattr(self.file, termios.TCSANOW, settings)
        termios.tcflush(self.file, termios.TCIOFLUSH)
        self.received = b""

    def write(self, text):
        os.write(self.file, text.encode() + b"\n")

    def read(self):
        end = time.monotonic() + ANSWER_TIME
        while b"\n" not in self.received:
            if not select.select([self.file], [], [], max(0.0, end - time.monotonic()))[0]:
                raise TimeoutError(f"the robot on {self.path} does not answer")
            self.received += os.read(self.file, 4096)
        line, self.received = self.received.split(b"\n", 1)
        return line.decode("ascii", "replace")


class SerialRobot(trundle.Driver):
    """Drives a robot with two wheels on a serial line."""

    commands = {f"base/{signal}": count for signal, count in trundle.DriveAmounts.SIGNALS.items()}
    outputs = {"base/odometry": 3, "base/done": 1, "base/busy": 1, "base/finished": 1,
               "leftEncoder/count": 1, "leftEncoder/angle": 1, "rightEncoder/count": 1, "rightEncoder/angle": 1,
               "frontTouch/pressed": 1}
    tick = 0.02

    def __init__(self, robot, path):
        super().__init__(robot)
        self.line = SerialLine(path)
        self.amounts = trundle.DriveAmounts()

    def start(self):
        self.amounts.reset()
        self.pose = [0.0, 0.0, 0.0]
        self.zero = self.last = self.read_state()[:2]

    def read_state(self):
        self.line.write("s")
        words = self.line.read().split()
        if len(words) != 4 or words[0] != "s":
            raise ValueError(f"the robot sent {' '.join(words)!r}")
        return [int(word) for word in words[1:]]

    def act(self, commands):
        linear, angular = self.amounts.speeds(commands, self.tick)
        half = angular * SEPARATION / 2
        self.line.write(f"v {1000 * (linear - half):.1f} {1000 * (linear + half):.1f}")

    def sense(self):
        left, right, bumper = self.read_state()
        per_count = 2 * math.pi / COUNTS
        ways = [(now - before) * per_count * WHEEL_RADIUS for now, before in zip((left, right), self.last)]
        self.last = [left, right]
        way, turn = (ways[0] + ways[1]) / 2, (ways[1] - ways[0]) / SEPARATION
        self.amounts.moved(way, turn)
        self.pose = [self.pose[0] + way * math.cos(self.pose[2] + turn / 2), self.pose[1] + way * math.sin(self.pose[2] + turn / 2),
                     self.pose[2] + turn]
        left, right = left - self.zero[0], right - self.zero[1]
        return {"base/odometry": self.pose, **self.amounts.outputs(), "leftEncoder/count": left, "leftEncoder/angle": left * per_count,
                "rightEncoder/count": right, "rightEncoder/angle": right * per_count, "frontTouch/pressed": bumper}

    def stop(self):
        self.line.write("v 0 0")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: serial_robot.py ROBOT LINE [--port N] [--token-file FILE]")
    robot, path = sys.argv[1:3]
    del sys.argv[1:3]
    SerialRobot(robot, path).main()
