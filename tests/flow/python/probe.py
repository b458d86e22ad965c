# A device that reads everything that a device can, and compares it with what must be. What is wrong ends the run.
import math

import trundle
from trundle import command, field, metres, number, output, reference, truth


def near(value, wanted, slack):
    if isinstance(wanted, (int, float)):
        assert abs(value - wanted) <= slack, f"{value} where {wanted} is right"
    else:
        assert len(value) == len(wanted)
        for v, w in zip(value, wanted):
            near(v, w, slack)


def refused(error, words, call, *arguments):
    """The run continues."""
    try:
        call(*arguments)
    except error as raised:
        assert words in str(raised), raised
    else:
        raise AssertionError(f"not refused: {words}")


class Probe(trundle.Device):
    """Reads a robot of two bodies that stands before a wall."""

    body_name = field("Body", "", reference("Body").required(), "That stands.")
    geoms = field("Geoms", [], reference("Geom"), "Of the body.")
    weight = field("Weight", 0.0, number(), "N.")
    size = field("Size", (0.1, 0.2, 0.3), metres(), "Three numbers.")
    wanted = command("wanted", "rad", "What the arm is driven to.", count=2)
    seen = output("seen", "m", "Distances.", count=3)
    ticks = truth("ticks", "", "Calls of sense.", type=int)

    def setup(self, mount):
        assert mount.path == "r/probe" and mount.tick == 0.01
        assert self.size == (1.0, 2.0, 3.0) and self.geoms == ["base.block", "base.eye"] and self.wanted[1] == 0
        self.base, self.arm = mount.body(self.body_name), mount.body("arm")
        self.block = mount.geom(self.geoms[0])
        self.pivot, self.weld = mount.joint("pivot"), mount.measured_joint("weld")
        self.eye = mount.frame("base", (0.25, 0, 0.05), (math.pi / 2, 0, 0))  # faces along y
        self.count = mount.peer("Encoder", "turns", "count")
        self.volts = mount.peer("RotaryMotor", "motor", "voltage")
        self.own = mount.peer("Probe", "probe", "ticks")
        assert mount.peer_number("turns", "CountsPerRevolution") == 1000 and mount.peer_text("turns", "Joint") == "pivot"
        refused(LookupError, "turns.Joint is a text, no number", mount.peer_number, "turns", "Joint")
        refused(LookupError, "turns.CountsPerRevolution is a number, no text", mount.peer_text, "turns", "CountsPerRevolution")
        refused(ValueError, "inertia is -1, it must be a finite number from 0 on", mount.add_axial_inertia, self.pivot, -1)
        mount.add_axial_inertia(self.pivot, 0.001)
        mount.add_rotor(self.pivot, 0, 20)
        self.seen[2] = -1

    def act(self, world):
        refused(TypeError, "'pivot' is no joint", world.motor_row, "pivot", 0, 0, 0)
        refused(ValueError, "World.motor_row(): rate is nan, it must be a finite number", world.motor_row, self.pivot, math.nan, 0, 0)
        refused(ValueError, "World.servo_row(): limit is -1, it must be a number from 0 on", world.servo_row, self.pivot, 0, -1, 0)
        refused(ValueError, "World.body_force(): force is inf", world.body_force, self.base, (0, math.inf, 0), (0, 0, 0))
        refused(LookupError, "99 is no joint of the device", world.joint_torque, 99, 1)
        refused(LookupError, "there is no geom 9999", world.surface_velocity, 9999, (0, 0, 0))
        self.volts.value = 3.0 if world.time < 0.5 else 0.0
        world.body_force(self.base, (0, 0, -1), world.body(self.base).pose.position)

    def sense(self, world):
        self.ticks += 1
        refused(AttributeError, "turns/count is measured, not commanded", setattr, self.count, "value", 77)
        refused(AttributeError, "probe/ticks is measured, not commanded", setattr, self.own, "value", 77)
        for fan, words in (((-1,), "World.cast(): range is -1, it must be a finite number above 0"), ((math.nan,), "range is nan"),
                           ((1, (0, 0, 0)), "World.cast(): it has 0 beams"), ((1, (0, math.inf, 2)), "last is inf"),
                           ((1, (0, 0, 1), (2,)), "elevations is 2.0, it must be from -pi/2 to pi/2")):
            refused(ValueError, words, world.cast, self.eye, *fan)
        for read, what in ((world.joint, "joint"), (world.body, "body"), (world.pose, "frame")):
            refused(LookupError, f"99 is no {what} of the device", read, 99)
        pose = world.pose(self.eye)
        near(pose.position, (0.25, 0, 0.05), 1e-3)
        near(pose.direction((1, 0, 0)), (0, 1, 0), 1e-3)
        near(pose.point((2, 0, 1)), (0.25, 2, 1.05), 3e-3)
        state = world.joint(self.pivot)
        near(self.count.value, math.floor(state.position / (2 * math.pi) * 1000 + 1e-9), 1)
        anchor, axis = world.joint_anchor(self.pivot)
        near(anchor, (0, 0, 0.3), 1e-3)
        near(axis, (0, 0, 1), 1e-3)
        echoes = world.cast(self.eye, 3, (-0.1, 0.1, 3), (0.0, 0.2))
        assert len(echoes.distances) == len(echoes.geoms) == len(echoes.normals) == 6
        near(echoes.distances[1], 0.95, 1e-3)
        near(echoes.normals[1], (0, -1, 0), 1e-9)
        wall = world.geom(echoes.geoms[1])
        assert wall.path == "room/wall" and wall.material == "white", wall
        assert world.geom(9999) is None
        near(world.reflectance(echoes.geoms[1], (0.25, 0.95, 0.05), (0, -1, 0)), wall.reflectance, 1e-9)
        assert world.cast(self.eye, 0.5).geoms == [None] and world.cast(self.eye, 0.5).distances == [0.5]
        self.seen[0] = echoes.distances[1]
        assert world.joint_wrench(self.pivot).force == (0, 0, 0)  # not measured
        assert not world.supply().present and world.supply().powered
        assert world.random_bits(3) != world.random_bits(4) and 0 <= world.random(5) < 1
        if world.time < 0.2:
            return
        contacts = [c for geom in (self.block,) for c in world.contacts(geom)]
        near(sum(c.force for c in contacts), self.weight + 1, 0.05 * self.weight)
        near(contacts[0].normal, (0, 0, 1), 1e-3)
        assert world.geom(contacts[0].geom).path == "room/floor"
        near(world.joint_wrench(self.weld).force[2], 9.81 * 0.5, 0.05)
        assert world.body(self.arm).turn_rate[2] > 0 if 0.25 < world.time < 0.5 else True
        self.seen[1] = state.position
        world.draw(1)
