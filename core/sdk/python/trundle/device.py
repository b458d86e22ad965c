# SPDX-License-Identifier: BSD-2-Clause
"""The base class of sensors and actuators, and what they reach: as device.h and mount.h in C++."""

from typing import NamedTuple

from .controller import INFO, WARNING
from .ports import Pose

_UNIT = 2.0 ** -53


class JointState(NamedTuple):
    """rad and rad/s, m and m/s of a slider, 0 at the start pose; `effort` of its motor in the last step, N m or N."""
    position: float
    rate: float
    effort: float


class BodyState(NamedTuple):
    """`velocity` of the origin of its frame, m/s; `turn_rate`, rad/s; both in the world's axes."""
    pose: Pose
    velocity: tuple
    turn_rate: tuple


class Wrench(NamedTuple):
    """N and N m."""
    force: tuple
    torque: tuple


class Contact(NamedTuple):
    """Of the last step, in the world: m; `normal` towards the geom that was asked for; `force` along it, N; `geom`: the other one."""
    position: tuple
    normal: tuple
    depth: float
    force: float
    geom: int


class Echoes(NamedTuple):
    """Layer by layer: m, the range where nothing is hit; the geom, or None; the normal against the beam, in the world."""
    distances: list
    geoms: list
    normals: list


class Geom(NamedTuple):
    """What is hit. `path` and `object` (its number in pictures of cameras with Mode=segmentation) are ground truth, which no sensor
    measures."""
    path: str
    material: str
    colour: tuple
    reflectance: float
    opacity: float
    shininess: float
    object: int


class Supply(NamedTuple):
    """The battery of the robot, V; without one its devices have all the power that they need."""
    present: bool
    voltage: float
    nominal: float

    @property
    def powered(self):
        return not self.present or self.voltage > 0


class Peer:
    """A signal of another device of the robot. Commands alone can be set."""

    __slots__ = ("_image", "_at", "name", "is_command")

    def __init__(self, image, at, name, is_command):
        self._image, self._at, self.name, self.is_command = image, at, name, is_command

    @property
    def value(self):
        return self._image[self._at]

    @value.setter
    def value(self, value):
        if not self.is_command:
            raise AttributeError(f"{self.name} is measured, not commanded: it can only be read")
        self._image[self._at] = value


class Mount:
    """What a device finds in setup. What is not there is an exception, with the names that are. Handles are plain numbers for the methods of
    World."""

    def __init__(self, calls, path, tick):
        self._calls, self.path, self.tick = calls, path, tick

    def joint(self, name):
        """A hinge or slider."""
        return self._calls.find("joint", name)

    def measured_joint(self, name):
        """A joint of any kind, whose wrench is measured from now on."""
        return self._calls.find("measured_joint", name)

    def body(self, name):
        return self._calls.find("body", name)

    def geom(self, path):
        """"body.geom"."""
        return self._calls.find("geom", path)

    def frame(self, body, pos=(0, 0, 0), hpr=(0, 0, 0)):
        """A frame fixed to a body, by its name: m, and heading, pitch, roll in rad."""
        return self._calls.frame(body, pos, hpr)

    def peer(self, kind, device, signal):
        """One number of another device of the robot; kind "": any. This device then acts before the other one and senses after it. The
        value of a command can be set, any other one only read."""
        return self._calls.peer(kind, device, signal)

    def peer_number(self, device, field):
        """The value of a field of another device, in SI units and radians."""
        return self._calls.peer_number(device, field)

    def peer_text(self, device, field):
        return self._calls.peer_text(device, field)

    def add_axial_inertia(self, joint, inertia):
        """Adds kg m^2 to the joint's child about the joint's axis, as of a rotor that turns with it."""
        self._calls.add_axial_inertia(joint, inertia)

    def add_rotor(self, joint, inertia, ratio):
        """Adds a rotor of so many kg m^2 on the joint's parent, which turns `ratio` times as far against it as the joint's child."""
        self._calls.add_rotor(joint, inertia, ratio)


class World:
    """What a device reaches in act and sense. `time`, s: of the last completed tick in act, of the tick just stepped in sense. Each method
    that reads something but supply and random numbers is a message to the simulation and back: some tens of microseconds."""

    def __init__(self, calls, tick):
        self._calls, self.tick, self.time = calls, tick, 0.0

    def joint(self, joint):
        return self._calls.joint_state(joint)

    def joint_anchor(self, joint):
        """Anchor (m) and unit axis in the world, moving with the parent body."""
        return self._calls.joint_anchor(joint)

    def joint_wrench(self, joint):
        """What acts across a joint of Mount.measured_joint() in the last step; zeros of any other joint."""
        return self._calls.joint_wrench(joint)

    def body(self, body):
        return self._calls.body_state(body)

    def pose(self, frame):
        """Of a frame of Mount.frame(), in the world."""
        return self._calls.pose(frame)

    def contacts(self, geom):
        return self._calls.contacts(geom)

    def cast(self, frame, range, bearings=(0.0, 0.0, 1), elevations=(0.0,), own=False):
        """A fan of beams from a frame: `bearings` are the first (rad), the step and the count, counter-clockwise about its z axis from its
        x axis, `elevations` (rad) one for each layer. Geoms of the own robot are ignored unless `own`."""
        return self._calls.cast(frame, range, bearings, elevations, own)

    def geom(self, geom):
        """What a geom of an echo or contact is; None if it is unknown."""
        return self._calls.geom_info(geom)

    def reflectance(self, geom, point, normal):
        """Share of light that a geom returns at a point of its surface, 0..1, by the picture or colour of its material."""
        return self._calls.reflectance(geom, point, normal)

    def supply(self):
        return self._calls.supply()

    def random_bits(self, index=0):
        """64 bits: a function of (seed, device, tick, index), the same in every run."""
        return self._calls.random_bits(index)

    def random(self, index=0):
        """[0, 1)."""
        return (self.random_bits(index) >> 11) * _UNIT

    def print(self, *parts):
        self._calls.print(INFO, "".join(map(str, parts)))

    def warn(self, *parts):
        self._calls.print(WARNING, "".join(map(str, parts)))

    # In act alone.

    def motor_row(self, joint, rate, softness, limit):
        """Drives the joint towards `rate` with an effort of (rate - new rate) / softness, at most `limit`, solved within the step."""
        self._calls.motor_row(joint, rate, softness, limit)

    def servo_row(self, joint, rate, limit, damping):
        """Keeps the joint at `rate` with at most `limit` at rest and against the motion, limit - damping * |joint rate| along it."""
        self._calls.servo_row(joint, rate, limit, damping)

    def joint_torque(self, joint, torque):
        self._calls.joint_torque(joint, torque)

    def body_force(self, body, force, point):
        """N, at a point of the world (m)."""
        self._calls.body_force(body, force, point)

    def surface_velocity(self, geom, velocity):
        """m/s in the geom's frame, as of a conveyor belt."""
        self._calls.surface_velocity(geom, velocity)

    # In sense alone.

    def draw(self, watts, conductance=0.0):
        """What the device drew from the battery in this tick; negative: what it gave back. If its current grows with the voltage,
        `conductance` (A/V) says by how much."""
        self._calls.draw(watts, conductance)


class Device:
    """A sensor or an actuator of a robot: a component of its RobotConfig. Fields, outputs and commands are class attributes, as of a
    Controller. Override act (before each step), sense (after it) or both; a phase that is not overridden costs nothing. An exception
    ends the run, with its file and line in the report. A class whose name begins with _ is no kind of its own."""

    def __new__(cls, *arguments, **more):
        made = super().__new__(cls)
        made._outside, made._outputs, made._idle_until = None, {}, 0.0
        return made

    def __init__(self):
        pass

    def setup(self, mount):
        """Finds joints, bodies, geoms and other devices. Called once before the run."""

    def act(self, world):
        """Drives something. Called before each step."""

    def sense(self, world):
        """Measures something. Called after each step."""
