# SPDX-License-Identifier: BSD-2-Clause
"""What all sensors have in common: where they are, when they measure, when the reading appears, and how it errs. As sensor.h in C++, with
the same numbers."""

import collections
import math

from .description import field
from .device import Device
from .quantity import degrees, metres, number, reference, seconds, unit_of


class SensorClock:
    """Times k * period, k = 0, 1, 2 ..., without drift: each is due at the first tick at or after it, and one tick serves all that are
    due."""

    def __init__(self):
        self._count = 0

    def due(self, now, period, tick):
        if not period > 0:
            return True
        slack = 1e-6 * tick
        if now + slack < self._count * period:
            return False
        self._count = max(self._count + 1, math.floor((now + slack) / period) + 1)
        return True

    def next(self, period):
        """The time that is awaited, s."""
        return self._count * period if period > 0 else 0.0


class Sensor(Device):
    """A sensor fixed to a body: it measures when UpdatePeriod says, and what it measured is published Latency later. Override measure and
    publish, and begin instead of setup."""

    body_name = field("Body", "", reference("Body").required(), "The body it is fixed to.")
    position = field("Pos", (0.0, 0.0, 0.0), metres().within(-1e5, 1e5), "Its position in the body.")
    hpr = field("HPR", (0.0, 0.0, 0.0), degrees().within(-1e6, 1e6),
                "Heading, pitch and roll in the body; 0,0,0 faces along x with z up.")
    update_period = field("UpdatePeriod", 0.0, seconds().within(0, 1e6), "Time between two readings; 0: every tick.")
    latency = field("Latency", 0.0, seconds().within(0, 1), "Age of a reading when it is published.")
    power = field("Power", 0.0, unit_of("W").within(0, 1e6), "That it draws from the robot's Battery, if it has one.")

    def begin(self, mount):
        """Called in setup."""

    def measure(self, world):
        """What it measures now; None: this reading is missed. Called only when a reading is due."""
        raise NotImplementedError(f"{type(self).__name__} has no measure(self, world)")

    def publish(self, reading, time):
        """Sets the outputs from a reading that was measured at `time` (s)."""
        raise NotImplementedError(f"{type(self).__name__} has no publish(self, reading, time)")

    def setup(self, mount):
        self.frame = mount.frame(self.body_name, self.position, self.hpr)
        self._clock, self._waiting = SensorClock(), collections.deque()
        self.begin(mount)

    def sense(self, world):
        if not world.supply().powered:
            return  # it has no new readings
        if self.power > 0:
            world.draw(self.power)
        if self._clock.due(world.time, self.update_period, world.tick):
            reading = self.measure(world)
            if reading is not None:
                self._waiting.append((world.time, reading))
        now = world.time + 1e-6 * world.tick
        while self._waiting and self._waiting[0][0] + self.latency <= now:
            time, reading = self._waiting.popleft()
            self.publish(reading, time)
        # Until then a call would do nothing, so the run makes none; what a battery does is followed at each tick.
        times = [self._clock.next(self.update_period)] + [time + self.latency for time, _ in list(self._waiting)[:1]]
        self._idle_until = 0.0 if world.supply().present else min(times)


def _polynomial(coefficients, x):
    value = 0.0
    for c in reversed(coefficients):
        value = value * x + c
    return value


def _portable_log(x):
    m, exponent = math.frexp(x)
    if m < 0.70710678118654752440:
        m, exponent = 2 * m, exponent - 1
    s = (m - 1) / (m + 1)
    s2, total = s * s, 0.0
    for k in range(25, 0, -2):
        total = total * s2 + 1.0 / k
    return 2 * s * total + exponent * 0.69314718055994530942


_NEAR = ((3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3, 1.3731693765509461125e4, 4.5921953931549871457e4,
          6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3),
         (1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3, 2.1213794301586595867e4,
          3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3))
_MIDDLE = ((1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0, 3.64784832476320460504e0,
            1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4),
           (1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1, 1.48103976427480074590e-1,
            1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9))
_FAR = ((6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0, 2.96560571828504891230e-1,
         2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7),
        (1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2, 7.86869131145613259100e-4,
         1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15))


def normal_deviate(bits):
    """A standard normal number made of 64 random bits, the same as in C++: Wichura, "Algorithm AS 241: The Percentage Points of the Normal
    Distribution", Applied Statistics 37 (1988), routine PPND16."""
    p = ((bits >> 12) + 0.5) * 2.0 ** -52
    q = p - 0.5
    if abs(q) <= 0.425:
        r = 0.180625 - q * q
        return q * _polynomial(_NEAR[0], r) / _polynomial(_NEAR[1], r)
    r = math.sqrt(-_portable_log(p if q < 0 else 1 - p))
    over, under = (_polynomial(c, r - (1.6 if r <= 5 else 5)) for c in (_MIDDLE if r <= 5 else _FAR))
    return -(over / under) if q < 0 else over / under


def _rounded_within(value, least, most, step):
    """The multiple of `step` from `least` to `most` that is nearest to a value; with a step of 0 the value itself between the two."""
    value = min(max(value, least), most)
    steps = value / step if step > 0 else 0.0
    near = round(steps) * step if step > 0 and abs(steps) < 2.0 ** 52 else value
    slack = 1e-9 * step
    if near > most + slack and near - step >= least - slack:
        return near - step
    if near < least - slack and near + step <= most + slack:
        return near + step
    return min(max(near, least), most)


class RangeNoise:
    """How a measured distance errs: a second base class of a sensor. Its random numbers depend on (seed, path, tick) and the number of the
    reading in this tick alone."""

    deviation = field("Noise", 0.0, metres().within(0, 1e3), "Standard deviation of a distance.")
    per_metre = field("NoisePerMetre", 0.0, number().within(0, 10), "Grows the standard deviation for each metre of distance.")
    outliers = field("Outliers", 0.0, number().within(0, 1), "Share of readings that are any distance from MinRange to MaxRange.")
    dropouts = field("Dropouts", 0.0, number().within(0, 1), "Share of readings that miss what is there and are MaxRange.")
    resolution = field("Resolution", 0.0, metres().within(0, 1e3), "Readings are multiples of it; 0: exact.")

    def apply(self, distance, least, most, world, index=0):
        """What is read for a true distance: from `least` to `most`, which is also the distance where nothing is hit."""
        if self.outliers > 0 or self.dropouts > 0:
            draw = world.random(3 * index)
            if draw < self.dropouts:
                return most
            if draw < self.dropouts + self.outliers:
                distance = least + (most - least) * world.random(3 * index + 1)
            else:
                distance = self._blurred(distance, most, world, 3 * index + 2)
        else:
            distance = self._blurred(distance, most, world, 3 * index + 2)
        return _rounded_within(distance, least, most, self.resolution) if distance < most else most

    def _blurred(self, distance, most, world, index):
        """Nothing hit stays nothing hit."""
        sigma = self.deviation + self.per_metre * distance
        return distance + sigma * normal_deviate(world.random_bits(index)) if sigma > 0 and distance < most else distance
