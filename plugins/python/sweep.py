"""Bearings of radios from their signal strengths while a robot turns, as controllers/network_navigator/sweep.cpp."""

import math
from typing import NamedTuple

_HALF_WINDOW = 50 * math.pi / 180
_LEAST_SAMPLES = 6
_ROUNDS = 6


class Bearing(NamedTuple):
    heading: float = 0.0  # rad, in (-pi, pi]
    rssi: float = 0.0  # dBm, at the peak


def wrap_angle(angle):
    return math.remainder(angle, 2 * math.pi)


def _fit_parabola(samples, centre):
    """Fits a + b x + c x^2 by least squares. (peak, RSSI there), or None if the samples have no peak."""
    s, t = [0.0] * 5, [0.0] * 3
    for heading, rssi in samples:
        x = wrap_angle(heading - centre)
        if abs(x) > _HALF_WINDOW:
            continue
        power = 1.0
        for i in range(5):
            s[i] += power
            if i < 3:
                t[i] += power * rssi
            power *= x
    if s[0] < _LEAST_SAMPLES:
        return None
    d = s[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * s[3] - s[2] * s[2])
    if abs(d) < 1e-12:
        return None
    a = (t[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (t[1] * s[4] - t[2] * s[3]) + s[2] * (t[1] * s[3] - t[2] * s[2])) / d
    b = (s[0] * (t[1] * s[4] - t[2] * s[3]) - t[0] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * t[2] - s[2] * t[1])) / d
    c = (s[0] * (s[2] * t[2] - s[3] * t[1]) - s[1] * (s[1] * t[2] - s[2] * t[1]) + t[0] * (s[1] * s[3] - s[2] * s[2])) / d
    if c >= -1e-6:
        return None
    peak = min(max(-b / (2 * c), -_HALF_WINDOW), _HALF_WINDOW)
    return peak, a + b * peak + c * peak * peak


class Sweep:
    """Collects RSSI samples of each sender, and finds the bearing of the strongest signal."""

    def __init__(self):
        self.samples = {}

    def clear(self):
        self.samples.clear()

    def add(self, sender, heading, rssi):
        self.samples.setdefault(sender, []).append((heading, rssi))

    def bearing(self, sender):
        """Peak of the parabola through the samples around the strongest one; None if there are too few."""
        samples = self.samples.get(sender, [])
        if len(samples) < _LEAST_SAMPLES:
            return None
        best = max(samples, key=lambda sample: sample[1])
        x = y = 0.0
        for heading, rssi in samples:
            weight = math.pow(10, (rssi - best[1]) / 20)
            x += weight * math.cos(heading)
            y += weight * math.sin(heading)
        centre, rssi = math.atan2(y, x), best[1]
        if abs(wrap_angle(centre - best[0])) > _HALF_WINDOW:
            centre = best[0]
        for _ in range(_ROUNDS):
            fit = _fit_parabola(samples, centre)
            if fit is None:
                return Bearing(wrap_angle(best[0]), best[1])
            peak, rssi = fit
            centre += peak
            if abs(peak) < 1e-4:
                break
        return Bearing(wrap_angle(centre), rssi)
