#!/usr/bin/env python3
"""A robot with two wheels on a serial line that is not there: its line is a pseudo-terminal, whose name it prints, and its body a few
equations. It moves by the clock of the wall, as a real one does.

The line has 115200 baud, one request a line:
    v LEFT RIGHT    speeds of the wheels, mm/s
    s               answers: s LEFT RIGHT BUMPER   counts of both encoders, 1 if the bumper is pressed
Without a request for half a second it stops. Ctrl+C or SIGTERM ends it; it then prints where it really is."""

import math
import os
import select
import signal
import sys
import time
import tty

WHEEL_RADIUS = 0.033  # m
SEPARATION = 0.16  # m, between the wheels
COUNTS = 1440  # of an encoder in a turn of its wheel
LAG = 0.06  # s, with which a wheel follows its speed
WATCHDOG = 0.5  # s
WALL = 2.0  # m ahead of its start, where its bumper is pressed
STEP = 0.002  # s


class Body:
    def __init__(self):
        self.x = self.y = self.heading = 0.0
        self.wanted, self.speeds, self.angles = [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]
        self.clock = self.heard = time.monotonic()

    def advance(self):
        now = time.monotonic()
        if now - self.heard > WATCHDOG:
            self.wanted = [0.0, 0.0]
        while self.clock + STEP <= now:
            self.clock += STEP
            for i in range(2):
                self.speeds[i] += (self.wanted[i] - self.speeds[i]) * STEP / LAG
                self.angles[i] += self.speeds[i] * STEP / WHEEL_RADIUS
            way = (self.speeds[0] + self.speeds[1]) / 2 * STEP
            turn = (self.speeds[1] - self.speeds[0]) / SEPARATION * STEP
            self.x = min(self.x + way * math.cos(self.heading + turn / 2), WALL)
            self.y += way * math.sin(self.heading + turn / 2)
            self.heading += turn

    def answer(self, line):
        words = line.split()
        self.heard = time.monotonic()
        if len(words) == 3 and words[0] == b"v":
            self.wanted = [float(word) / 1000 for word in words[1:]]
        elif words == [b"s"]:
            counts = [math.floor(angle / (2 * math.pi) * COUNTS) for angle in self.angles]
            return f"s {counts[0]} {counts[1]} {int(self.x >= WALL)}\n".encode()
        return b""


def main():
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: sys.exit())
    line, other = os.openpty()  # the other end stays open here, so that clients may come and go
    tty.setraw(other)
    body, received = Body(), b""
    try:
        print(os.ttyname(other), flush=True)
        while True:
            ready, _, _ = select.select([line], [], [], 0.01)
            body.advance()
            if ready:
                received += os.read(line, 4096)
            *lines, received = received.split(b"\n")
            for each in lines:
                os.write(line, body.answer(each))
    finally:
        print(f"at {body.x:.4f} {body.y:.4f} {body.heading:.4f}", flush=True)


if __name__ == "__main__":
    main()
