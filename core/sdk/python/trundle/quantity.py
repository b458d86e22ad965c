# SPDX-License-Identifier: BSD-2-Clause
"""The unit, limits and flags of a field, as in quantity.h."""

import dataclasses
import math


@dataclasses.dataclass(frozen=True)
class Quantity:
    """Unit and limits of a field. The controller receives SI units and radians; limits are given in the text's unit."""

    unit: str = ""
    scale: float = 1.0
    minimum: float = -math.inf
    maximum: float = math.inf
    min_exclusive: bool = False
    max_exclusive: bool = False
    is_required: bool = False
    is_live: bool = False
    choices: tuple = ()
    type: str = ""  # "": from the default's type
    counts: tuple = ()  # least and largest number of elements; (): from the default's type

    def _with(self, **changes):
        return dataclasses.replace(self, **changes)

    def within(self, low, high):
        return self._with(minimum=float(low), maximum=float(high))

    def at_least(self, low):
        return self._with(minimum=float(low))

    def above(self, low):
        return self._with(minimum=float(low), min_exclusive=True)

    def at_most(self, high):
        return self._with(maximum=float(high))

    def below(self, high):
        return self._with(maximum=float(high), max_exclusive=True)

    def required(self):
        """The text must give the field; its default is not used."""
        return self._with(is_required=True)

    def live(self):
        """The field may be changed during a run, with immediate effect."""
        return self._with(is_live=True)

    def counted(self, low, high):
        return self._with(counts=(int(low), int(high)))


def unit_of(unit, scale=1.0):
    """A unit of your own; `scale` converts a number in the text to SI."""
    return Quantity(unit=unit, scale=float(scale))


def _maker(name, unit, scale=1.0):
    def make():
        return unit_of(unit, scale)

    make.__name__ = make.__qualname__ = name
    return make


number = _maker("number", "")
metres = _maker("metres", "m")
kilograms = _maker("kilograms", "kg")
seconds = _maker("seconds", "s")
milliseconds = _maker("milliseconds", "ms", 1e-3)
degrees = _maker("degrees", "deg", math.pi / 180)  # radians in the controller
newtons = _maker("newtons", "N")
newton_metres = _maker("newton_metres", "Nm")
metres_per_second = _maker("metres_per_second", "m/s")
metres_per_second_squared = _maker("metres_per_second_squared", "m/s^2")
radians_per_second = _maker("radians_per_second", "rad/s")
radians_per_second_squared = _maker("radians_per_second_squared", "rad/s^2")
volts = _maker("volts", "V")
amperes = _maker("amperes", "A")
ohms = _maker("ohms", "ohm")
hertz = _maker("hertz", "Hz")
decibels = _maker("decibels", "dB")
decibel_milliwatts = _maker("decibel_milliwatts", "dBm")


def flag():
    """true or false."""
    return Quantity(type="boolean")


def text():
    return Quantity(type="text")


def _words(words):
    return tuple(words.split("|"))


def one_of(words):
    """One of the words in "left|right"."""
    return Quantity(type="choice", choices=_words(words))


def file(endings):
    """A file with one of the extensions "png|jpg"."""
    return Quantity(type="file", choices=_words(endings))


def reference(kinds):
    """The name of an object of one of the kinds or roles "Hinge|Slider"."""
    return Quantity(type="reference", choices=_words(kinds))


def needs(kinds):
    """Names of devices of the robot, without which setup fails. `kinds` are those of the ports that setup binds, separated by "|"; an empty
    name needs nothing. The check of a model reports a robot that lacks one of them."""
    return Quantity(type="text", choices=_words(kinds))
