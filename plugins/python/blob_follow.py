"""Finds a blob of one colour in the camera image, turns and drives towards it, and stops in front of it, as controllers/blob_follow in
C++. Plain Python; with NumPy the search over the pixels of `picture.array` would be shorter and faster."""

import math
from typing import NamedTuple

import trundle
from trundle import degrees, field, metres_per_second, needs, number, radians_per_second


class Blob(NamedTuple):
    """Position and size of the blob in an image."""
    pixels: int = 0
    side: float = 0.0  # of its centre: -1 at the left edge, 1 at the right edge
    share: float = 0.0  # fraction of the image width that it covers


def hue_of(r, g, b):
    """Hue in rad, saturation, brightness."""
    high, low = max(r, g, b), min(r, g, b)
    angle = math.atan2(math.sqrt(3.0) * (g - b), 2 * r - g - b)
    return angle, (high - low) / high if high > 0 else 0.0, high


class BlobFollow(trundle.Controller):
    """Finds a blob of one colour in its camera and drives to it; keeps some of the pictures."""

    colour = field("Color", (0.85, 0.1, 0.08), number().within(0, 1), "Red, green and blue of the blob; its hue counts.")
    tolerance = field("Tolerance", 25 * math.pi / 180, degrees().within(1, 180), "How far a pixel's hue may be off.")
    min_pixels = field("MinPixels", 6, number().within(1, 1e6), "Fewer pixels are no blob.")
    speed = field("Speed", 0.3, metres_per_second().above(0).at_most(10).live(), "Towards the blob.")
    turn_rate = field("TurnRate", 0.8, radians_per_second().above(0).at_most(100).live(), "While it looks around, and at most.")
    stop_share = field("StopShare", 0.5, number().above(0).at_most(1),
                       "It is there when the blob takes that share of the picture's width.")
    keep_every = field("KeepEvery", 10, number().within(0, 1e6),
                       "Every so manieth picture is kept in the log folder; 0 keeps none.")
    camera_name = field("Camera", "eye", needs("Camera"), "The robot's Camera.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")
    pictures = kept = 0
    there = blind = False

    def setup(self, robot):
        self.name = robot.name
        self.drive = robot.differential_drive(self.drive_name)
        self.camera = robot.camera(self.camera_name)
        self.hue = hue_of(*self.colour)[0]
        self.meant = {}  # colours that were judged before

    def update(self, since_last):
        if self.there or self.blind:
            return
        picture = self.camera.capture()
        if not picture:
            return self.go_blind(picture.error)
        self.keep()
        blob = self.find(picture)
        if blob.pixels < self.min_pixels:
            return self.drive.move(0.0, self.turn_rate)
        if blob.share >= self.stop_share:
            self.there = True
            print("there")
            return self.drive.stop()
        # The speed decreases with the distance from the centre of the image.
        turn = min(max(1.5 * blob.side, -1.0), 1.0)
        self.drive.move(self.speed * max(0.0, 1 - 1.5 * abs(blob.side)), -self.turn_rate * turn)

    def is_meant(self, colour):
        angle, saturation, brightness = hue_of(*(part / 255.0 for part in colour))
        if saturation < 0.45 or brightness < 0.15:
            return False
        return abs(math.remainder(angle - self.hue, 2 * math.pi)) <= self.tolerance

    def find(self, picture):
        data, width, meant = picture.pixels.tobytes(), picture.width, self.meant
        count, total, left, right = 0, 0.0, width, -1
        for first in range(0, len(data), 3):
            colour = data[first:first + 3]
            if colour not in meant:
                meant[colour] = self.is_meant(colour)
            if meant[colour]:
                x = first // 3 % width
                count += 1
                total += x + 0.5
                left, right = min(left, x), max(right, x)
        if count == 0:
            return Blob()
        return Blob(count, total / count / width * 2 - 1, (right - left + 1) / width)

    def keep(self):
        self.pictures += 1
        if self.keep_every == 0 or (self.pictures - 1) % self.keep_every != 0:
            return
        self.kept += 1
        if not self.camera.save(f"{self.name}_{self.kept - 1:05}.jpg"):
            self.keep_every = 0  # the run has no logs

    def go_blind(self, why):
        self.warn("cannot see, stays where it is: ", why)
        self.blind = True
        self.drive.stop()
