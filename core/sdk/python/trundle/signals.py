# SPDX-License-Identifier: BSD-2-Clause
"""Slots of the signal image, and the names that lead to them."""

import array
import difflib

OUTPUT, COMMAND, TRUTH = 1, 2, 3
# A port of the first kind also fits devices of the second; the same list as in core/model/port_kinds.cpp.
SAME_SIGNALS = {("DifferentialDrive", "SkidDrive"), ("DifferentialDrive", "TrackDrive")}
_MOST_LISTED = 30


class UnknownPort(LookupError):
    """The robot has no such port or signal; the message lists those that it has."""


class Slot:
    """One signal: `count` doubles in the robot's image. Published outputs and commands can be set, those that are `whole` to whole
    numbers only."""

    __slots__ = ("_view", "_first", "count", "writable", "whole")

    def __init__(self, view, first, count, writable=False, whole=False):
        self._view, self._first, self.count, self.writable, self.whole = view, first, count, writable, whole

    def get(self, element=0):
        return self._view[self._first + element] if 0 <= element < self.count else 0.0

    def set(self, value, element=0):
        if not self.writable or not 0 <= element < self.count:
            return
        try:
            is_broken = self.whole and value % 1 != 0
            if not is_broken:
                self._view[self._first + element] = value
        except TypeError:
            if isinstance(value, (int, float)):
                raise
            raise TypeError(f"a signal takes a number, not {value!r}") from None
        except (ValueError, OverflowError):
            raise ValueError("a signal takes no number as large as this") from None
        if is_broken:
            raise ValueError(f"an output of type int takes whole numbers, not {value!r}")

    def values(self):
        """All of them, as a read-only memoryview of doubles in the image: they change with the next tick."""
        return self._view[self._first:self._first + self.count].toreadonly()

    def __len__(self):
        return self.count

    def __getitem__(self, element):
        if not 0 <= element < self.count:
            raise IndexError(element)
        return self.get(element)

    def __setitem__(self, element, value):
        if not 0 <= element < self.count:
            raise IndexError(element)
        self.set(value, element)


class Entry:
    """A signal of the robot's layout. Type: 1 real, 2 integer, 3 boolean."""

    __slots__ = ("path", "type", "direction", "count", "offset")

    def __init__(self, path, type, direction, count, offset):
        self.path, self.type, self.direction, self.count, self.offset = path, type, direction, count, offset


def port_fits(port, device):
    """Whether a port for devices of the kind `port` ("": any) binds a device of the kind `device`: of the same kind, or of one that has
    the same signals."""
    return not port or port == device or (port, device) in SAME_SIGNALS


def _meant(word, candidates):
    near = difflib.get_close_matches(word, candidates, 1)
    return f"; did you mean '{near[0]}'?" if near else ""


def _listed(words):
    words = list(words)
    return ", ".join(words[:_MOST_LISTED]) + (" ..." if len(words) > _MOST_LISTED else "") if words else "none"


def unknown_signal(signal, names):
    """The message for a port that has only the signals `names`."""
    return f"the port has no signal '{signal}'{_meant(signal, list(names))}; its signals: {_listed(names)}"


class Image:
    """The signals of one robot. `devices`: (kind, name, update period) of each; `sensors`, `commands`: memoryviews of doubles; `claim`:
    called with the path of each command that is bound; None: all are this controller's. `published`: counts of the outputs that the
    controller's kind describes, by name."""

    def __init__(self, robot, controller, kind, devices, entries, sensors, commands, claim=None, published=None):
        self.robot, self.controller, self.kind, self.devices = robot, controller, kind, devices
        self.entries = {}
        for entry in entries:
            self.entries.setdefault(entry.path, entry)
        self._sensors, self._commands, self._claim = sensors, commands, claim
        self._published = published or {}

    def _slot(self, entry, writable):
        if writable and entry.direction == COMMAND and self._claim:
            self._claim(entry.path)
        return Slot(self._commands if writable else self._sensors, entry.offset, entry.count, writable)

    def _below(self, prefix, truth):
        return _listed(p[len(prefix):] for p, e in self.entries.items() if p.startswith(prefix) and (e.direction == TRUTH) == truth)

    def _ports(self, kind):
        fitting = [name for k, name, _ in self.devices if k == kind]
        if fitting:
            return f"its {kind} ports: {_listed(fitting)}"
        return "its ports: " + _listed(f"{name} ({k})" for k, name, _ in self.devices)

    def device(self, kind, name):
        """The kind, name and update period of a device that a port of the kind `kind` binds; "": any."""
        found = next((d for d in self.devices if d[1] == name), None)
        wanted = f"{kind} port" if kind else "port"
        if found is None:
            near = _meant(name, [n for k, n, _ in self.devices if not kind or k == kind])
            raise UnknownPort(f"{self.robot} has no {wanted} '{name}'{near} ({self._ports(kind)})")
        if not port_fits(kind, found[0]):
            raise UnknownPort(f"{self.robot} has no {wanted} '{name}': that is of kind {found[0]} ({self._ports(kind)})")
        return found

    def bind(self, kind, device, signal):
        self.device(kind, device)
        prefix = f"{self.robot}/{device}/"
        entry = self.entries.get(prefix + signal)
        if entry is None:
            raise UnknownPort(f"{self.robot} has no signal '{device}/{signal}'; the signals of {device}: "
                              f"{self._below(prefix, False)}")
        if entry.direction == TRUTH:
            raise UnknownPort(f"{self.robot} gives '{device}/{signal}' through the port groundTruth alone: a real robot cannot "
                              "measure it")
        return self._slot(entry, entry.direction == COMMAND)

    def bind_all(self, kind, device):
        """The slots of all signals of a device but its ground truth, by name."""
        self.device(kind, device)
        prefix = f"{self.robot}/{device}/"
        return {p[len(prefix):]: self._slot(e, e.direction == COMMAND) for p, e in self.entries.items()
                if p.startswith(prefix) and e.direction != TRUTH}

    def truth(self, signal):
        entry = self.entries.get(f"{self.robot}/{signal}")
        if entry is None or entry.direction != TRUTH:
            raise UnknownPort(f"{self.robot} has no ground truth '{signal}'; there is: {self._below(self.robot + '/', True)}")
        return self._slot(entry, False)

    def published(self, signal):
        prefix = f"{self.robot}/{self.controller}/"
        entry = self.entries.get(prefix + signal)
        if entry is None and signal in self._published:  # it came during the run, which has no signal for this
            count = self._published[signal]
            return Slot(memoryview(array.array("d", bytes(8 * count))), 0, count, True)
        if entry is None:
            raise UnknownPort(f"{self.robot} cannot publish '{signal}' (the outputs of {self.kind}: {self._below(prefix, False)})")
        return self._slot(entry, True)

    def has(self, device, signal=""):
        if device and not any(name == device for _, name, _ in self.devices):
            return False
        path = f"{self.robot}/{device}/{signal}" if device else f"{self.robot}/{signal}"
        return path in self.entries if signal else any(p.startswith(path) for p in self.entries)
