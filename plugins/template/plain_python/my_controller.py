# A controller that does nothing yet: a start for your own, for a robot without a drive. An experiment beside this folder uses it with
#
#     #loadModule my_controller/my_controller.py
#     Robot robot0 { Config=SimpleRobot  MyController brain { } }
#
# The guide says what a controller can do: motors, sensors, cameras, radios, values for logs, ending the run.
import trundle


class MyController(trundle.Controller):
    """Does nothing yet."""

    def setup(self, robot):
        pass  # gets the robot's devices: self.arm = robot.servo("arm")

    def update(self, since_last):
        pass  # reads and commands them, in each period
