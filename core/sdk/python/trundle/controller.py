# SPDX-License-Identifier: BSD-2-Clause
"""The base class of controllers."""

INFO, WARNING, ERROR = 1, 2, 3
_MASK = (1 << 64) - 1


def fnv1a64(data):
    """The 64-bit hash that Trundle makes of names."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & _MASK
    return value


def _mix(x):
    x = x + 0x9e3779b97f4a7c15 & _MASK
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9 & _MASK
    x = (x ^ x >> 27) * 0x94d049bb133111eb & _MASK
    return x ^ x >> 31


def random_bits(seed, path_hash, tick, index):
    """64 well-mixed bits of (seed, path, tick, index), the same as in C++."""
    return _mix(_mix(_mix(_mix(seed) ^ path_hash) ^ tick) ^ index)


class Log:
    """A file in the run's log folder."""

    def __init__(self, outside=None, number=-1):
        self._outside, self._number = outside, number

    @property
    def open(self):
        """False if the path is outside the log folder, the file is in use, or the run has no logs."""
        return self._number >= 0

    def write(self, data):
        if not isinstance(data, (str, bytes, bytearray, memoryview)):
            raise TypeError(f"a log is written as text or bytes, not as {type(data).__name__}: write(f\"{{value}}\\n\")")
        if self.open:
            self._outside.write_log(self._number, data.encode() if isinstance(data, str) else bytes(data))


class Controller:
    """Controls one robot. Created before the run, then its fields are set, setup is called once and update periodically, all on one
    thread. An exception that leaves setup or update stops the controller, with its file and line in the report. A class whose name
    begins with _ is no kind of its own."""

    def __init__(self):
        pass

    def __new__(cls, *arguments, **more):
        made = super().__new__(cls)
        made._outside, made._outputs = None, {}
        return made

    def setup(self, robot):
        """Binds the ports. Called once before the run."""

    def update(self, since_last):
        """Called before a tick of the world. `since_last`: simulated seconds since the last call, 0 in the first."""
        raise NotImplementedError(f"{type(self).__name__} has no update()")

    def save_state(self):
        """What a new version of its code continues from: called when that is loaded during a run. Anything that json can write; None: it
        starts as in a new run. After an exception, which is reported, no state is handed over."""

    def load_state(self, state):
        """Called after setup with what the old code saved, which may be an older version of it. After an exception it is made and set up
        again."""

    @property
    def time(self):
        """Simulated time, s; 0 in the first update."""
        return self._outside.time if self._outside else 0.0

    def print(self, *parts):
        """Prints a line on the console, prefixed with the robot's name and the time. print() of Python does the same."""
        self._say(INFO, parts)

    def warn(self, *parts):
        self._say(WARNING, parts)

    def fail(self, text):
        """Reports an error from which the controller cannot continue: the run ends with this text after this update."""
        if self._outside:
            self._outside.fail(str(text))

    def finish(self, reason):
        """Ends the experiment: the run ends after this tick with complete logs and exit code 0. The first call in a run counts."""
        if self._outside:
            self._outside.finish(str(reason))

    def random_bits(self):
        """Random numbers that depend only on the experiment's seed, the robot, the tick and the number of calls in this tick."""
        return self._outside.random_bits() if self._outside else 0

    def random(self, low=0.0, high=1.0):
        """In [low, high)."""
        unit = (self.random_bits() >> 11) * 2.0 ** -53
        return low + (high - low) * unit

    def open_log(self, file_name):
        """Opens a log file of this controller in the run's log folder. The name may contain subfolders."""
        return Log(self._outside, self._outside.open_log(file_name)) if self._outside else Log()

    def _say(self, severity, parts):
        if self._outside:
            self._outside.print(severity, "".join(str(part) for part in parts))
