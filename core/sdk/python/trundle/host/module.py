# SPDX-License-Identifier: BSD-2-Clause
"""Loading a user's file, and the words for what goes wrong in it."""

import importlib
import importlib.util
import inspect
import os
import sys
import traceback

from ..controller import Controller
from ..description import kinds_to_json
from ..device import Device
from ..sensor import Sensor
from .wire import NO_PLACE

PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_LIBRARY = os.path.dirname(os.__file__) + os.sep
_MOST_FRAMES, _MOST_LINES = 40, 2 ** 31 - 1


class Fault:
    """An exception of a user's code: `place` is its file and line, which `text` ends with; `frames` are the calls, innermost first, as
    (file, line, function)."""

    def __init__(self, error):
        self.frames = []
        self.place = error.place if isinstance(error, _Unfit) else NO_PLACE
        where = ", at" if self.place[0] else ""
        for frame in reversed(traceback.extract_tb(error.__traceback__)):
            if frame.filename.startswith((PACKAGE + os.sep, "<frozen")):
                continue
            if len(self.frames) < _MOST_FRAMES:
                self.frames.append((frame.filename, frame.lineno, frame.name))
            if not where and not frame.filename.startswith((_LIBRARY, "/usr/lib/", "<")):
                self.place, where = (frame.filename, frame.lineno), f", in {frame.name} at"
        what = "TypeError" if isinstance(error, _Unfit) else type(error).__name__
        try:
            words = str(error)
        except BaseException:  # of a class of the user's
            words = "its text cannot be read"
        if isinstance(error, SyntaxError) and error.filename:
            words = str(error.msg)
            line = error.lineno if isinstance(error.lineno, int) else 0
            self.place, where = (str(error.filename), min(max(line, 0), _MOST_LINES)), ", at"
        self.text = f"{what}: {words}" if words else what
        if where:
            self.text += f"{where} {os.path.basename(self.place[0])}:{self.place[1]}"


class _Unfit(TypeError):
    """Of a class or a method that cannot be used as it is written."""

    def __init__(self, code, words):
        super().__init__(words)
        try:
            self.place = inspect.getsourcefile(code), inspect.getsourcelines(code)[1]
        except Exception:  # made by other code
            self.place = NO_PLACE


def _methods(kind):
    """Those that are called, with their arguments."""
    if not issubclass(kind, Device):
        if kind.update is Controller.update:
            raise _Unfit(kind, f"{kind.__name__} has no update(self, since_last)")
        return (kind.setup, ("robot",)), (kind.update, ("since_last",)), (kind.load_state, ("state",)), (kind.save_state, ())
    if kind.act is Device.act and kind.sense is Device.sense:
        raise _Unfit(kind, f"{kind.__name__} has neither act(self, world) nor sense(self, world)")
    calls = (kind.setup, ("mount",)), (kind.act, ("world",)), (kind.sense, ("world",))
    if issubclass(kind, Sensor):
        for method, text in ((Sensor.measure, "measure(self, world)"), (Sensor.publish, "publish(self, reading, time)")):
            if getattr(kind, method.__name__) is method:
                raise _Unfit(kind, f"{kind.__name__} has no {text}")
        calls += (kind.begin, ("mount",)), (kind.measure, ("world",)), (kind.publish, ("reading", "time"))
    return calls


def _check_calls(kind):
    """Raises TypeError where a method cannot be called as it will be."""
    for method, arguments in _methods(kind):
        name = method.__name__
        if inspect.isgeneratorfunction(method) or inspect.iscoroutinefunction(method) or inspect.isasyncgenfunction(method):
            raise _Unfit(method, f"{kind.__name__}.{name} would not run when it is called: it has a yield or is async")
        try:
            inspect.signature(method).bind(None, *arguments)
        except TypeError:
            wanted = ", ".join(("self",) + arguments)
            raise _Unfit(method, f"{kind.__name__}.{name} is called as {name}({wanted}), and does not take that") from None


class Module:
    """A loaded file: its controllers and devices, by kind."""

    def __init__(self, path):
        self.path = path
        folder = os.path.dirname(path)
        if folder not in sys.path:
            sys.path.insert(0, folder)
        name = os.path.splitext(os.path.basename(path))[0]
        if name == "trundle":
            raise TypeError("it would be loaded in place of the package trundle: give it another name")
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
        self._loaded = self.sources()

    def _parts(self):
        """What Python has loaded from its folder, by name: packages that are installed there are no parts of it."""
        folder, installed = os.path.dirname(self.path) + os.sep, f"{os.sep}site-packages{os.sep}"
        files = ((name, getattr(module, "__file__", None) or "") for name, module in list(sys.modules.items()))
        return {name: file for name, file in files
                if file.startswith(folder) and not file.startswith(PACKAGE + os.sep) and installed not in file}

    def sources(self):
        """The files from its folder that it consists of, with what shows that one has changed."""
        found = []
        for file in sorted({self.path, *self._parts().values()}):
            status = os.stat(file)
            found.append((file, status.st_size, status.st_mtime_ns))
        return found

    def as_it_is_now(self):
        """Loads its files again if one has changed. What was made of this one keeps its code."""
        try:
            if self.sources() == self._loaded:
                return self
        except FileNotFoundError:  # a part, which the file may need no more
            pass
        former = {name: sys.modules.pop(name) for name in self._parts()}
        importlib.invalidate_caches()
        try:
            now = Module(self.path)
            if now.description(()) != self.description(()):
                raise TypeError("it has other properties or published values now: reset the run to use it")
        except BaseException:
            sys.modules.update(former)
            raise
        return now

    def description(self, sources):
        return kinds_to_json(self.kinds.values(), sources)
