# plugins/components/conveyor in Python: both give the same bits.
import math

import trundle
from trundle import command, field, metres, metres_per_second, metres_per_second_squared, output, reference


class IndexConveyor(trundle.Device):
    """Carries what lies on a geom along its x axis, by one pitch for each step."""

    geom_path = field("Geom", "", reference("Geom").required(), "The geom whose surface runs.")
    pitch = field("Pitch", 0.5, metres().above(0).at_most(100), "Way of one step.")
    max_speed = field("MaxSpeed", 0.5, metres_per_second().above(0).at_most(100).live(), "Of its surface.")
    max_acceleration = field("MaxAcceleration", 1.0, metres_per_second_squared().above(0).at_most(1e4).live(),
                             "So low that friction can carry the load.")
    steps = command("steps", "", "How many steps it is to be from its start; negative: backwards.", type=int)
    travel = output("travel", "m", "Way of its surface since the start.")
    busy = output("busy", "", "A step is under way.", type=bool)

    def setup(self, mount):
        self.geom = mount.geom(self.geom_path)
        self.speed = self.now = 0.0

    def act(self, world):
        """As fast as it can still stop at its target: v^2 = 2 a way."""
        way, step = self.pitch * self.steps - self.now, self.max_acceleration * world.tick
        safe = math.sqrt(2 * self.max_acceleration * abs(way))
        fastest = min(self.max_speed, max(safe - step, 0.5 * step), abs(way) / world.tick)
        self.speed += min(max(math.copysign(fastest, way) - self.speed, -step), step)
        if abs(way) < 1e-9:
            self.speed = 0.0
        world.surface_velocity(self.geom, (self.speed, 0, 0))

    def sense(self, world):
        if world.time > 0:
            self.now += self.speed * world.tick
        self.travel = self.now
        self.busy = abs(self.speed) > 0
