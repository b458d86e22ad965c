# A sensor that measures the distance straight ahead: a start for your own. An experiment beside this folder loads it with
#
#     #loadModule my_sensor/my_sensor.py
#
# and the RobotConfig of its robot has it with
#
#     MySensor eye { Body=chassis Pos=0.15,0,0.05 }
#
# The lines of a Sensor (Body, Pos, HPR, UpdatePeriod, Latency) and the noise of a range come from the package. For an actuator derive
# from trundle.Device and override setup(self, mount) and act(self, world).
import trundle
from trundle import field, metres, output


class MySensor(trundle.Sensor, trundle.RangeNoise):
    """Measures the distance straight ahead."""

    max_range = field("MaxRange", 2.0, metres().above(0).at_most(100), "Nothing beyond is seen.")
    distance = output("distance", "m", "To what is straight ahead; MaxRange if nothing is.")

    def begin(self, mount):
        self.distance = self.max_range

    def measure(self, world):
        echo = world.cast(self.frame, self.max_range).distances[0]
        return self.apply(echo, 0.0, self.max_range, world)

    def publish(self, reading, time):
        self.distance = reading
