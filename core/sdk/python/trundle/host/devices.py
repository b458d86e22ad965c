# SPDX-License-Identifier: BSD-2-Clause
"""Devices of one module: their calls, and what they ask the run, as core/control/host/device_calls.cpp answers it."""

import array
import itertools
import math
import operator
import struct
import sys

from .. import description, signals
from ..controller import fnv1a64, random_bits
from ..device import BodyState, Contact, Device, Echoes, Geom, JointState, Mount, Peer, Supply, World, Wrench
from ..ports import Pose
from .instance import Instance
from .wire import Reader, Writer

COMMAND, QUERY = 7, 108  # records
_QUERIES = ("joint", "measured_joint", "body", "geom", "frame", "peer", "peer_number", "peer_text", "add_axial_inertia", "add_rotor",
          "joint_state", "joint_anchor", "joint_wrench", "body_state", "pose", "contacts", "cast", "geom_info", "reflectance")
_COMMANDS = ("print", "motor_row", "servo_row", "joint_torque", "body_force", "surface_velocity", "draw")
_NUMBERS = {name: number for number, name in enumerate(_QUERIES + _COMMANDS)}
_NO_GEOM = 0xffffffff
_CONTACT = struct.Struct("=8dI")
_MOST_BEAMS, _LARGEST_BEARING = 1_000_000, 1e4  # as the run takes them
_LARGEST, _LARGEST_ELEVATION = sys.float_info.max, math.pi / 2 + 1e-12

# What an argument must be, in words and as a test, which no nan passes.
_FINITE = "a finite number", lambda value: abs(value) <= _LARGEST
_FROM_ZERO = "a finite number from 0 on", lambda value: 0 <= value <= _LARGEST
_LIMIT = "a number from 0 on", lambda value: value >= 0  # infinite: there is none
_ABOVE_ZERO = "a finite number above 0", lambda value: 0 < value <= _LARGEST
_BEARING = "from -10000 to 10000 rad", lambda value: abs(value) <= _LARGEST_BEARING
_ELEVATION = "from -pi/2 to pi/2", lambda value: abs(value) <= _LARGEST_ELEVATION


class NotFound(LookupError):
    """The robot has no such joint, body, geom or device: the run says which there are."""


def _handle(value, what):
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 1 << 32:
        raise TypeError(f"{value!r} is no {what}")
    return value


def _check(call, wanted, **arguments):
    """Raises ValueError where a number, or one of a sequence, is not what the run takes: it would end for it."""
    words, holds = wanted
    for name, value in arguments.items():
        for number in value if hasattr(value, "__iter__") else (value,):
            if not holds(number):
                raise ValueError(f"{call}(): {name} is {number!r}, it must be {words}")


def _threes(values):
    return list(zip(*[iter(values)] * 3))


class Calls:
    """What the Mount and the World of a device do."""

    def __init__(self, link, number, seed, path):
        self._link, self._number, self._seed, self._hash = link, number, seed, fnv1a64(path.encode())
        self.tick_number, self._supply = 0, Supply(False, 0.0, 0.0)
        self.peers = array.array("d")
        self._known = {"joint": set(), "body": set(), "geom": set(), "frame": set()}  # handles

    def begin(self, tick_number, supply):
        self.tick_number, self._supply = tick_number, supply

    def _command(self, name, writer):
        return self._link.record(COMMAND, self._number, struct.pack("=I", _NUMBERS[name]) + writer.data())

    def _query(self, name, writer):
        reply = self._link.ask(QUERY, self._number, struct.pack("=I", _NUMBERS[name]) + writer.data())
        if reply is None:
            raise RuntimeError("the simulation is reached in setup, act and sense alone, not in threads")
        reader = Reader(reply)
        fault = reader.status()
        if fault:
            raise NotFound(fault[1])
        return reader

    def _own(self, what, value):
        """A handle that setup found."""
        if _handle(value, what) not in self._known[what]:
            raise NotFound(f"{value} is no {what} of the device: setup finds them")
        return value

    def _any_geom(self, value):
        """Also one that was hit or touched."""
        if _handle(value, "geom") not in self._known["geom"]:
            if self.geom_info(value) is None:
                raise NotFound(f"there is no geom {value}")
            self._known["geom"].add(value)
        return value

    # of Mount

    def find(self, what, name):
        handle = self._query(what, Writer().bytes(name)).number("I")
        self._known[what.replace("measured_", "")].add(handle)
        return handle

    def frame(self, body, pos, hpr):
        pos, hpr = tuple(pos), tuple(hpr)
        _check("Mount.frame", _FINITE, pos=pos, hpr=hpr)
        handle = self._query("frame", Writer().bytes(body).doubles(3, pos).doubles(3, hpr)).number("I")
        self._known["frame"].add(handle)
        return handle

    def peer(self, kind, device, signal):
        reader = self._query("peer", Writer().bytes(kind).bytes(device).bytes(signal))
        self.peers.append(reader.number("d"))
        return Peer(self.peers, len(self.peers) - 1, f"{device}/{signal}", reader.number("I") == signals.COMMAND)

    def peer_number(self, device, field):
        return self._query("peer_number", Writer().bytes(device).bytes(field)).number("d")

    def peer_text(self, device, field):
        return self._query("peer_text", Writer().bytes(device).bytes(field)).text()

    def add_axial_inertia(self, joint, inertia):
        _check("Mount.add_axial_inertia", _FROM_ZERO, inertia=inertia)
        self._query("add_axial_inertia", Writer().number("I", self._own("joint", joint)).number("d", inertia))

    def add_rotor(self, joint, inertia, ratio):
        _check("Mount.add_rotor", _FROM_ZERO, inertia=inertia)
        _check("Mount.add_rotor", _FINITE, ratio=ratio)
        self._query("add_rotor", Writer().number("I", self._own("joint", joint)).number("d", inertia).number("d", ratio))

    # of World

    def _of(self, what, handle):
        return self._query(what, Writer().number("I", handle))

    def joint_state(self, joint):
        return JointState(*self._of("joint_state", self._own("joint", joint)).doubles(3))

    def joint_anchor(self, joint):
        reader = self._of("joint_anchor", self._own("joint", joint))
        return reader.doubles(3), reader.doubles(3)

    def joint_wrench(self, joint):
        reader = self._of("joint_wrench", self._own("joint", joint))
        return Wrench(reader.doubles(3), reader.doubles(3)) if reader.number("B") else None

    def body_state(self, body):
        reader = self._of("body_state", self._own("body", body))
        return BodyState(Pose(reader.doubles(3), reader.doubles(4)), reader.doubles(3), reader.doubles(3))

    def pose(self, frame):
        reader = self._of("pose", self._own("frame", frame))
        return Pose(reader.doubles(3), reader.doubles(4))

    def contacts(self, geom):
        found = _CONTACT.iter_unpack(self._of("contacts", self._any_geom(geom)).bytes())
        return [Contact(c[0:3], c[3:6], c[6], c[7], c[8]) for c in found]

    def cast(self, frame, range, bearings, elevations, own):
        first, step, count = bearings
        count, elevations = operator.index(count), array.array("d", elevations)
        beams = count * len(elevations)
        _check("World.cast", _ABOVE_ZERO, range=range)
        if not 1 <= beams <= _MOST_BEAMS:
            raise ValueError(f"World.cast(): it has {beams} beams, there must be 1 to {_MOST_BEAMS}")
        _check("World.cast", _BEARING, first=first, last=first + step * count)
        _check("World.cast", _ELEVATION, elevations=elevations)
        writer = Writer().number("I", self._own("frame", frame)).number("d", range).number("d", first).number("d", step)
        writer.number("I", count).bytes(elevations.tobytes()).number("B", bool(own))
        reader = self._query("cast", writer)
        distances, geoms, normals = reader.numbers("d"), reader.numbers("I"), reader.numbers("d")
        return Echoes(distances, [None if geom == _NO_GEOM else geom for geom in geoms], _threes(normals))

    def geom_info(self, geom):
        reader = self._of("geom_info", _handle(geom, "geom"))
        if not reader.number("B"):
            return None
        return Geom(reader.text(), reader.text(), reader.doubles(3), *reader.doubles(3), reader.number("I"))

    def reflectance(self, geom, point, normal):
        writer = Writer().number("I", _handle(geom, "geom")).doubles(3, point).doubles(3, normal)
        return self._query("reflectance", writer).number("d")

    def supply(self):
        return self._supply

    def random_bits(self, index):
        return random_bits(self._seed, self._hash, self.tick_number, index)

    def print(self, severity, text):
        return self._command("print", Writer().number("i", severity).bytes(text))

    def _check_phase(self, phase, name):
        if self.phase != phase:
            raise RuntimeError(f"World.{name}() is for {phase}(), not for {self.phase}()")

    def motor_row(self, joint, rate, softness, limit):
        self._check_phase("act", "motor_row")
        _check("World.motor_row", _FINITE, rate=rate)
        _check("World.motor_row", _FROM_ZERO, softness=softness)
        _check("World.motor_row", _LIMIT, limit=limit)
        self._command("motor_row", Writer().number("I", self._own("joint", joint)).doubles(3, (rate, softness, limit)))

    def servo_row(self, joint, rate, limit, damping):
        self._check_phase("act", "servo_row")
        _check("World.servo_row", _FINITE, rate=rate)
        _check("World.servo_row", _LIMIT, limit=limit)
        _check("World.servo_row", _FROM_ZERO, damping=damping)
        self._command("servo_row", Writer().number("I", self._own("joint", joint)).doubles(3, (rate, limit, damping)))

    def joint_torque(self, joint, torque):
        self._check_phase("act", "joint_torque")
        _check("World.joint_torque", _FINITE, torque=torque)
        self._command("joint_torque", Writer().number("I", self._own("joint", joint)).number("d", torque))

    def body_force(self, body, force, point):
        self._check_phase("act", "body_force")
        force, point = tuple(force), tuple(point)
        _check("World.body_force", _FINITE, force=force, point=point)
        self._command("body_force", Writer().number("I", self._own("body", body)).doubles(3, force).doubles(3, point))

    def surface_velocity(self, geom, velocity):
        self._check_phase("act", "surface_velocity")
        velocity = tuple(velocity)
        _check("World.surface_velocity", _FINITE, velocity=velocity)
        self._command("surface_velocity", Writer().number("I", self._any_geom(geom)).doubles(3, velocity))

    def draw(self, watts, conductance):
        self._check_phase("sense", "draw")
        _check("World.draw", _FINITE, watts=watts, conductance=conductance)
        self._command("draw", Writer().doubles(2, (watts, conductance)))


class RunningDevice(Instance):
    """A device of one robot."""

    def __init__(self, reader, link, number):
        super().__init__()
        self.kind, self.title, self._tick, seed = reader.text(), reader.text(), reader.number("d"), reader.number("Q")
        self.read_values(reader)
        self.outside = Calls(link, number, seed, self.title)
        self._own = array.array("d")
        self._world = World(self.outside, self._tick)

    def start(self, kind):
        """Whether it acts, and whether it senses."""
        self.make(kind)
        own = description.members(kind, description.output)
        self._own = array.array("d", bytes(8 * sum(s.count for s in own)))
        view = memoryview(self._own)
        firsts = itertools.accumulate((s.count for s in own), initial=0)
        for signal, first in zip(own, firsts):
            self.instance._outputs[signal.name] = signals.Slot(view, first, signal.count, True, signal.type is int)
        self.instance.setup(Mount(self.outside, self.title, self._tick))
        return [getattr(kind, name) is not getattr(Device, name) for name in ("act", "sense")]

    def call(self, phase, reader):
        """The numbers that it has changed: its own, and those of other devices."""
        tick_number, self._world.time = reader.number("Q"), reader.number("d")
        self.outside.phase = phase
        self.outside.begin(tick_number, Supply(bool(reader.number("B")), *reader.doubles(2)))
        own, peers = reader.bytes(), reader.bytes()
        memoryview(self._own).cast("B")[:] = own
        self.outside.peers[:] = array.array("d", peers)
        getattr(self.instance, phase)(self._world)
        return self.changes(own, peers)

    def changes(self, own=b"", peers=b""):
        now = (self._own.tobytes(), self.outside.peers.tobytes())
        return [b"" if new == old else new for new, old in zip(now, (own, peers))]

    @property
    def idle_until(self):
        """No sense is needed before this time, s."""
        return self.instance._idle_until
