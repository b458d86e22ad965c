# A controller that drives a circle: a start for your own. An experiment beside this folder uses it with
#
#     #loadModule my_controller/my_controller.py
#     Robot robot0 { Config=SimpleRobot  MyController brain { Speed = 0.2 } }
#
# The guide says what a controller can do besides: sensors, cameras, radios, values for logs, ending the run.
import trundle
from trundle import field, metres_per_second, radians_per_second


class MyController(trundle.Controller):
    """Drives a circle."""

    speed = field("Speed", 0.2, metres_per_second().within(-2, 2), "Along the circle.")
    turn_rate = field("TurnRate", 0.5, radians_per_second().within(-5, 5), "Positive turns left.")

    def setup(self, robot):
        self.drive = robot.differential_drive("base")

    def update(self, since_last):
        self.drive.move(self.speed, self.turn_rate)
