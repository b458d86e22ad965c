# SPDX-License-Identifier: BSD-2-Clause
"""Loading a user's file, and the words for what goes wrong in it."""

import importlib.util
import inspect
import os
import sys
import traceback

from ..controller import Controller
from ..description import kinds_to_json
from ..device import Device
from ..sensor import Sensor

PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_LIBRARY = os.path.dirname(os.__file__) + os.sep
_MOST_FRAMES = 40


class Fault:
    """An exception of a user's code: `text` has its file and line, `frames` the calls, innermost first, as (file, line, function)."""

    def __init__(self, error):
        self.frames = []
        place = ""
        for frame in reversed(traceback.extract_tb(error.__traceback__)):
            if frame.filename.startswith((PACKAGE + os.sep, "<frozen")):
                continue
            if len(self.frames) < _MOST_FRAMES:
                self.frames.append((frame.filename, frame.lineno, frame.name))
            if not place and not frame.filename.startswith((_LIBRARY, "/usr/lib/", "<")):
                place = f", in {frame.name} at {os.path.basename(frame.filename)}:{frame.lineno}"
        what = type(error).__name__
        try:
            words = str(error)
        except BaseException:  # of a class of the user's
            words = "its text cannot be read"
        if isinstance(error, SyntaxError) and error.filename:
            words = str(error.msg)
            place = f", at {os.path.basename(error.filename)}:{error.lineno}"
        self.text = (f"{what}: {words}" if words else what) + place


def _methods(kind):
    """Those that are called, with their arguments."""
    if not issubclass(kind, Device):
        if kind.update is Controller.update:
            raise TypeError(f"{kind.__name__} has no update(self, since_last)")
        return (kind.setup, ("robot",)), (kind.update, ("since_last",)), (kind.load_state, ("state",)), (kind.save_state, ())
    if kind.act is Device.act and kind.sense is Device.sense:
        raise TypeError(f"{kind.__name__} has neither act(self, world) nor sense(self, world)")
    calls = (kind.setup, ("mount",)), (kind.act, ("world",)), (kind.sense, ("world",))
    if issubclass(kind, Sensor):
        for method, text in ((Sensor.measure, "measure(self, world)"), (Sensor.publish, "publish(self, reading, time)")):
            if getattr(kind, method.__name__) is method:
                raise TypeError(f"{kind.__name__} has no {text}")
        calls += (kind.begin, ("mount",)), (kind.measure, ("world",)), (kind.publish, ("reading", "time"))
    return calls


def _check_calls(kind):
    """Raises TypeError where a method cannot be called as it will be."""
    for method, arguments in _methods(kind):
        name = method.__name__
        try:
            inspect.signature(method).bind(None, *arguments)
        except TypeError:
            wanted = ", ".join(("self",) + arguments)
            raise TypeError(f"{kind.__name__}.{name} is called as {name}({wanted}), and does not take that") from None


class Module:
    """A loaded file: its controllers and devices, by kind."""

    def __init__(self, path):
        self.path = path
        folder = os.path.dirname(path)
        if folder not in sys.path:
            sys.path.insert(0, folder)
        name = os.path.splitext(os.path.basename(path))[0]
        spec = importlib.util.spec_from_file_location(name, path)
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
        self.kinds = {kind.__name__: kind for kind in vars(module).values()
                      if isinstance(kind, type) and issubclass(kind, (Controller, Device)) and kind.__module__ == name
                      and not kind.__name__.startswith("_")}

        if not self.kinds:
            raise TypeError("it has no class that is derived from trundle.Controller or trundle.Device")
        for kind in self.kinds.values():
            _check_calls(kind)

    def sources(self):
        """The files from its folder that it consists of, with what shows that one has changed."""
        folder = os.path.dirname(self.path) + os.sep
        files = {self.path}
        for module in list(sys.modules.values()):
            file = getattr(module, "__file__", None)
            if file and file.startswith(folder):
                files.add(file)
        found = []
        for file in sorted(files):
            status = os.stat(file)
            found.append((file, status.st_size, status.st_mtime_ns))
        return found

    def description(self, sources):
        return kinds_to_json(self.kinds.values(), sources)
