# SPDX-License-Identifier: BSD-2-Clause
"""The description of a controller or device: fields, signals, alternatives. Checks, property rows, completion and the manual are made from
it, without running the code."""

import json
import math

from .device import Device
from .quantity import Quantity

FORMAT = 1
VERSION = "1.13.0"  # as in trundle/abi.h
INTERFACE = (1, 10)
MOST_PUBLISHED = 1000
MANY_ELEMENTS = 100000
_SIGNAL_TYPES = {float: "real", int: "integer", bool: "boolean"}


def _type_of(value):
    """The type in the description, and the least and largest number of elements, of a default."""
    for kind, name in ((bool, "boolean"), (int, "integer"), (float, "number"), (str, "text")):
        if isinstance(value, kind):
            return name, (1, 1)
    if isinstance(value, (tuple, list)):
        name = "text" if any(isinstance(v, str) for v in value) else "number"
        return name, (len(value), len(value)) if isinstance(value, tuple) else (0, MANY_ELEMENTS)
    raise TypeError(f"{value!r} is no default of a field: bool, int, float, str, or a tuple or list of numbers or texts")


class field:
    """A property of the controller's block: speed = field("Speed", 0.3, metres_per_second().above(0), "When it drives.")

    The default is in SI units and radians. Its type is that of the field: 1.0 is a number, 1 an integer (in a unit such as ms or deg a
    number, too), a tuple has a fixed number of elements, a list any. A default of None means "not given"; `type` is then float, int, bool
    or str."""

    def __init__(self, name, default, quantity, help, type=None):
        if not isinstance(quantity, Quantity):
            raise TypeError(f"the field {name} needs a quantity, such as metres()")
        if hasattr(default, "tolist"):  # of numpy
            default = default.tolist()
        self.name, self.default, self.quantity, self.help = name, default, quantity, help
        sample = default
        if default is None:
            if type is None and not quantity.type:
                raise TypeError(f"the field {name} has the default None, so it needs type=float, int, bool or str")
            sample = (type or str)()
        self.type, self.counts = _type_of(sample)
        if self.type == "integer" and quantity.scale != 1:  # 90 deg is no whole number of radians
            self.type = "number"
        self.type = quantity.type or self.type
        self.counts = quantity.counts or self.counts
        self.attribute = ""
        if default is not None and not quantity.is_required:
            self._check(self._elements(default))

    def _check(self, values):
        """The default is held to what the text is."""
        least, most = self.counts
        if not least <= len(values) <= most:
            raise ValueError(f"the default of the field {self.name} has {len(values)} elements, its quantity wants {least} to {most}")
        q = self.quantity
        for value in values:
            if self.type == "choice" and value not in q.choices:
                raise ValueError(f"the default {value!r} of the field {self.name} is not one of {', '.join(q.choices)}")
            if self.type not in ("number", "integer"):
                continue
            if not math.isfinite(value):
                raise ValueError(f"the default of the field {self.name} is {value}, which is no finite number")
            given = value / q.scale
            slack = 1e-9 * abs(given)
            below = given <= q.minimum if q.min_exclusive else given < q.minimum - slack
            above = given >= q.maximum if q.max_exclusive else given > q.maximum + slack
            if below or above:
                limit = f"{'above' if q.min_exclusive else 'at least'} {q.minimum:g}" if below else \
                    f"{'below' if q.max_exclusive else 'at most'} {q.maximum:g}"
                unit = f" {q.unit}" if q.unit else ""
                raise ValueError(f"the default of the field {self.name} is {given:g}{unit}, it must be {limit}{unit}")

    def __set_name__(self, owner, attribute):
        self.attribute = attribute

    def __get__(self, instance, owner=None):  # an attribute of the instance comes first
        if instance is None:
            return self
        return list(self.default) if isinstance(self.default, list) else self.default

    def _elements(self, value):
        return list(value) if isinstance(value, (tuple, list)) else [value]

    def to_python(self, numbers, texts):
        """The value of the attribute for a value of the text: SI numbers, or texts."""
        if self.type in ("number", "integer", "boolean"):
            convert = {"number": float, "integer": int, "boolean": bool}[self.type]
            values = [convert(v) for v in numbers]
        else:
            values = list(texts)
        if not self.counts[0] <= len(values) <= self.counts[1]:
            raise ValueError(f"{self.name} has the wrong count of elements")
        if self.counts == (1, 1):
            return values[0]
        return values if isinstance(self.default, list) else tuple(values)

    def to_json(self):
        q = self.quantity
        described = {
            "name": self.name, "type": self.type, "unit": q.unit, "help": self.help, "choices": list(q.choices), "scale": q.scale,
            "minimum": q.minimum if math.isfinite(q.minimum) else None,
            "maximum": q.maximum if math.isfinite(q.maximum) else None,
            "min_exclusive": q.min_exclusive, "max_exclusive": q.max_exclusive, "required": q.is_required, "live": q.is_live,
            "count": list(self.counts)}
        if self.default is not None and not q.is_required:
            numeric = self.type in ("number", "integer", "boolean")
            described["default"] = [float(v) if numeric else str(v) for v in self._elements(self.default)]
        return described


class output:
    """A signal that the controller or device publishes: explored = output("explored", "m^2", "Floor seen so far.")

    Assign to it in setup and update: self.explored = 3.5. It is 0 until then, and keeps its value. With a `count` above 1 it is a
    sequence: self.goal = (1, 2), self.goal[0] = 1."""

    direction = "output"

    def __init__(self, name, unit, help, type=float, count=1):
        if type not in _SIGNAL_TYPES:
            raise TypeError(f"the output {name} is of type float, int or bool")
        self.name, self.unit, self.help, self.type, self.count = name, unit, help, type, int(count)

    def __get__(self, instance, owner=None):
        if instance is None:
            return self
        slot = instance._outputs.get(self.name)
        if self.count > 1:
            return slot
        return self.type(slot.get() if slot else 0)

    def __set__(self, instance, value):
        slot = instance._outputs.get(self.name)
        if slot is None:
            return
        values = (value,) if self.count == 1 else tuple(value)
        if len(values) != self.count:
            raise ValueError(f"the output {self.name} has {self.count} numbers, not {len(values)}")
        try:
            for i, v in enumerate(values):
                slot[i] = v
        except (TypeError, ValueError) as wrong:
            raise type(wrong)(f"the output {self.name}: {wrong}") from None

    def to_json(self):
        return {"name": self.name, "unit": self.unit, "help": self.help, "type": _SIGNAL_TYPES[self.type], "count": self.count,
                "direction": self.direction}


class command(output):
    """A signal of a device that a controller or another device sets; the device reads it: self.target."""

    direction = "command"


class truth(output):
    """A signal of a device that it publishes and a real robot cannot measure: controllers read it through groundTruth alone."""

    direction = "truth"


class exactly_one_of:
    """Of these fields, all with the default None, the text must give exactly one: choice = exactly_one_of("A|B")"""

    def __init__(self, names, likely=""):
        self.names, self.likely = names.split("|"), likely

    def to_json(self):
        return {"names": self.names, "likely": self.likely}


def members(kind, of_type):
    """The descriptors of a class in the order of its text, then those of its bases that it does not replace."""
    attributes = {}
    for base in kind.__mro__:
        for attribute, value in vars(base).items():
            attributes.setdefault(attribute, value)
    return [value for value in attributes.values() if isinstance(value, of_type)]


def kind_to_json(kind):
    is_device = issubclass(kind, Device)
    described = {"name": kind.__name__, "role": "device" if is_device else "controller", "help": _first_paragraph(kind),
                 "fields": [f.to_json() for f in members(kind, field)]}
    alternatives = [a.to_json() for a in members(kind, exactly_one_of)]
    if alternatives:
        described["exactly_one_of"] = alternatives
    described["signals"] = [s.to_json() for s in members(kind, output)]
    strange = next((s for s in described["signals"] if s["direction"] != "output"), None)
    if strange and not is_device:
        raise TypeError(f"the {strange['direction']} {strange['name']} is in the controller {kind.__name__}: only devices have some")
    numbers = sum(s["count"] for s in described["signals"])
    if numbers > MOST_PUBLISHED and not is_device:
        raise ValueError(f"{kind.__name__} publishes {numbers} numbers; at most {MOST_PUBLISHED} are possible")
    return described


def _first_paragraph(kind):
    return " ".join((kind.__dict__.get("__doc__") or "").strip().split("\n\n")[0].split())


def kinds_to_json(kinds, sources=()):
    """The description of a module. `sources`: the files that it was read from, as (path, bytes, modified in ns)."""
    return json.dumps({"format": FORMAT, "sdk": VERSION, "interface": list(INTERFACE), "kinds": [kind_to_json(k) for k in kinds],
                       "sources": [list(source) for source in sources]}, indent=2) + "\n"
