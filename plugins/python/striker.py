"""Finds a ball and a goal by their colours in its camera image, goes around the ball until the goal is behind it, and pushes it there, as
controllers/striker in C++. Plain Python; with NumPy the search over the pixels of `picture.array` would be shorter and faster."""

import math
from typing import NamedTuple

import trundle
from trundle import degrees, field, metres, metres_per_second, needs, number, output

DEGREE = math.pi / 180
IN_MOUTH = 0.13  # m
ALIGNED, LOSE_WAY = 0.06, 0.5  # rad: it begins to push, it gives up
LOSE_SIDE = 0.05  # m


def clamp(value, low, high):
    return min(max(value, low), high)


def hue_of(r, g, b):
    return math.atan2(math.sqrt(3.0) * (g - b), 2 * r - g - b)


class Blob(NamedTuple):
    """Pixels of one colour in an image; `bottom`: its lowest row."""
    pixels: int = 0
    bottom: int = 0
    column: float = 0.0  # means
    row: float = 0.0


class Spot(NamedTuple):
    """On the floor, in the robot's frame, m."""
    x: float = 0.0
    y: float = 0.0

    def distance(self):
        return math.sqrt(self.x * self.x + self.y * self.y)


class Striker(trundle.Controller):
    """Finds a ball and a goal in its camera, goes around the ball and pushes it into the goal; for an OmniDrive."""

    ball_colour = field("BallColor", (0.9, 0.5, 0.1), number().within(0, 1), "Red, green and blue; the hue counts.")
    goal_colour = field("GoalColor", (0.15, 0.35, 0.7), number().within(0, 1), "Red, green and blue; the hue counts.")
    speed = field("Speed", 0.8, metres_per_second().above(0).at_most(10).live(), "With the ball.")
    orbit = field("Orbit", 0.22, metres().within(0.05, 10).live(), "How far from the ball it goes around it.")
    kick_at = field("KickAt", 0.6, metres().within(0, 10).live(), "It brakes that far from the goal; the ball rolls on.")
    ball_radius = field("BallRadius", 0.0215, metres().above(0).at_most(1), "Its middle is that high.")
    forward = field("CameraForward", 0.058, metres().within(-1, 1), "Place of the camera before the middle of the base.")
    height = field("CameraHeight", 0.135, metres().above(0).at_most(10), "Above the floor.")
    pitch = field("CameraPitch", 36 * DEGREE, degrees().within(0, 89), "How far it looks down.")
    field_of_view = field("FieldOfView", 90 * DEGREE, degrees().within(10, 150), "Of the camera, from left to right.")
    camera_name = field("Camera", "eye", needs("Camera"), "The robot's Camera.")
    drive_name = field("Drive", "base", needs("OmniDrive"), "The robot's OmniDrive.")
    kicked = output("kicked", "", "1 after it let the ball roll.", type=int)

    def setup(self, robot):
        self.drive = robot.omni_drive(self.drive_name)
        self.camera = robot.camera(self.camera_name)
        self.seen = Spot()  # where the ball was seen last
        self.pushes = self.ended = False
        self.ball_hues, self.goal_hues = {}, {}  # colours that were judged before

    def update(self, since_last):
        if self.ended:
            return
        picture = self.camera.capture()
        if not picture:
            return self.end("cannot see, stays where it is: " + picture.error)
        goal, ball = self.goal_in(picture), self.ball_in(picture)
        if not ball and goal and self.pushes and self.seen.distance() < IN_MOUTH:
            ball = self.seen  # too near to be seen
        if not ball:
            return self.drive.move(0, 0, 2)
        self.seen = ball
        if goal and self.pushes and goal.distance() < self.kick_at:
            self.kicked = 1
            return self.end("kicks")
        self.play(ball, goal)

    def play(self, ball, goal):
        """Without a goal in sight it goes around the ball until there is one."""
        bearing = math.atan2(ball.y, ball.x)
        way = math.atan2(goal.y - ball.y, goal.x - ball.x) if goal else 0.0  # from the ball to the goal
        error = math.remainder(way - bearing, 2 * math.pi) if goal else 1.0
        if self.pushes:
            holds = abs(way) < LOSE_WAY and abs(ball.y) < LOSE_SIDE and ball.x < self.orbit + LOSE_SIDE
        else:
            holds = abs(error) < ALIGNED and abs(bearing) < 2 * ALIGNED
        self.pushes = bool(goal) and holds
        if self.pushes:
            return self.drive.move(self.speed, clamp(3 * ball.y, -0.2, 0.2), 2.5 * way)
        near = clamp(self.orbit / ball.distance(), 0.0, 1.0)  # far away it only drives to the ball
        ahead, aside = clamp(2 * (ball.distance() - self.orbit), -0.3, 1.0), near * clamp(-1.5 * error, -0.5, 0.5)
        self.drive.move(ahead, aside, 3 * bearing - aside / ball.distance())

    def ball_in(self, picture):
        blob = self.find(picture, self.ball_colour, 14 * DEGREE, self.ball_hues)
        return self.on_floor(picture, blob.column, blob.row, self.ball_radius) if blob.pixels >= 2 else None

    def goal_in(self, picture):
        blob = self.find(picture, self.goal_colour, 20 * DEGREE, self.goal_hues)
        return self.on_floor(picture, blob.column, blob.bottom + 1, 0.0) if blob.pixels >= 6 else None

    def on_floor(self, picture, column, row, up):
        """Where a pixel's ray comes to a height above the floor; nothing above the horizon."""
        focus = picture.width / 2.0 / math.tan(self.field_of_view / 2)
        left, high = (picture.width / 2.0 - column) / focus, (picture.height / 2.0 - row) / focus
        ahead, down = math.cos(self.pitch) + high * math.sin(self.pitch), math.sin(self.pitch) - high * math.cos(self.pitch)
        if down < 0.01 or ahead <= 0:
            return None
        scale = (self.height - up) / down
        return Spot(self.forward + ahead * scale, left * scale)

    @staticmethod
    def find(picture, colour, tolerance, judged):
        hue, data, width = hue_of(*colour), picture.pixels.tobytes(), picture.width
        count, columns, rows, bottom = 0, 0.0, 0.0, 0
        for first in range(0, len(data), 3):
            pixel = data[first:first + 3]
            if pixel not in judged:
                high, low = max(pixel), min(pixel)  # neither too dark nor too pale
                judged[pixel] = (high >= 40 and high - low >= high // 2
                                 and abs(math.remainder(hue_of(*pixel) - hue, 2 * math.pi)) <= tolerance)
            if judged[pixel]:
                bottom, x = divmod(first // 3, width)
                count += 1
                columns += x + 0.5
                rows += bottom + 0.5
        return Blob(count, bottom, columns / max(count, 1), rows / max(count, 1))

    def end(self, why):
        print(why)
        self.ended = True
        self.drive.stop()
