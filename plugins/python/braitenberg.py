"""Braitenberg: Vehicles, Experiments in Synthetic Psychology (1984), vehicles 2 and 3: two light sensors, each tied to one of two wheels, as
controllers/braitenberg in C++."""

import trundle
from trundle import field, metres, metres_per_second, needs, one_of, unit_of


class Braitenberg(trundle.Controller):
    """Two light sensors drive two wheels: it flees from light, attacks it, comes to rest before it or explores."""

    vehicle = field("Vehicle", "love", one_of("fear|aggression|love|explorer"),
                    "2a: each sensor drives the wheel on its side; 2b: the other one; 3a, 3b: they slow them down instead.")
    speed = field("Speed", 0.1, metres_per_second().above(0).at_most(10).live(), "Of a wheel, at most.")
    reference = field("Reference", 1000.0, unit_of("lx").above(0).at_most(1e9).live(),
                      "Illuminance that drives a wheel fully, or stops it.")
    reached = field("Reached", 0.0, unit_of("lx").within(0, 1e9).live(),
                    "The run ends where it is so bright on both sides; 0: never.")
    track_width = field("TrackWidth", 0.053, metres().above(0).at_most(10), "Distance of its wheels.")
    left = field("Left", "leftLight", needs("LightSensor"), "The robot's LightSensor on the left.")
    right = field("Right", "rightLight", needs("LightSensor"), "The one on the right.")
    drive_name = field("Drive", "base", needs("DifferentialDrive"), "The robot's DifferentialDrive.")

    def setup(self, robot):
        self.left_light = robot.light_sensor(self.left)
        self.right_light = robot.light_sensor(self.right)
        self.drive = robot.differential_drive(self.drive_name)

    def update(self, since_last):
        if self.left_light.time() < 0 or self.right_light.time() < 0:
            return
        on_left, on_right = self.left_light.illuminance(), self.right_light.illuminance()
        if self.reached > 0 and min(on_left, on_right) >= self.reached:
            self.drive.stop()
            return self.finish("reached the light")
        if self.vehicle in ("aggression", "explorer"):
            on_left, on_right = on_right, on_left
        left, right = self.wheel(on_left), self.wheel(on_right)
        self.drive.move((left + right) / 2, (right - left) / self.track_width)

    def wheel(self, light):
        """m/s of a wheel whose sensor sees `light` lx."""
        share = min(max(light / self.reference, 0.0), 1.0)
        return self.speed * (1 - share if self.vehicle in ("love", "explorer") else share)
