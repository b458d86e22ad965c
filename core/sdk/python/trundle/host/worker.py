# SPDX-License-Identifier: BSD-2-Clause
"""Handles the requests of a run: loads a module and calls its controllers and devices, as app/host/host_worker.cpp does for C++."""

import atexit
import gc
import io
import json
import mmap
import sys
import time

from .. import description
from ..controller import INFO, WARNING
from ..ports import RobotPorts
from ..signals import Entry, Image, UnknownPort
from .devices import RunningDevice
from .instance import Instance
from .module import Fault, Module
from .outside import DONE, PRINT, SETUP_TICK, UPDATED, ClaimedCommand, Outside
from .wire import Reader, Writer

LOAD, MAP, START, UPDATE, SET, STOP, UNLOAD, SAVE_STATE, LOAD_STATE, START_DEVICE, ACT, SENSE = range(12)  # requests
_PHASES = {LOAD: 1, START: 2, UPDATE: 3, SET: 4, STOP: 5, UNLOAD: 6, SAVE_STATE: 7, LOAD_STATE: 8, START_DEVICE: 2, ACT: 9, SENSE: 10}
CONTROLLER_FAILED, UNKNOWN_PORT, PYTHON_MODULE, INTERNAL = 410, 411, 414, 599
_NO_CONTROLLER = 0xffffffff
_IGNORED = ("print(), logs, cameras and radios of a controller work in its setup() and update() alone: what other threads of the module ask "
            "for is ignored")
# What code may raise to leave: also SystemExit and KeyboardInterrupt.
_ANY = BaseException


class _Console(io.TextIOBase):
    """print() of Python: whole lines go to the console of the run, with the name of the controller that is called, each of which has a
    beginning of a line of its own."""

    _LONGEST = 8192

    def __init__(self, worker, severity, otherwise):
        super().__init__()
        self._worker, self._severity, self._otherwise, self._begun = worker, severity, otherwise, {}

    def writable(self):
        return True

    def write(self, text):
        called = self._worker.called
        *lines, begun = (self._begun.pop(called, "") + text).split("\n")
        for line in lines:
            self._put(called, line)
        if len(begun) > self._LONGEST:
            self._put(called, begun)
        elif begun:
            self._begun[called] = begun
        return len(text)

    def end_line(self):
        """Of the controller that is called, which prints no more."""
        called = self._worker.called
        begun = self._begun.pop(called, "")
        if begun:
            self._put(called, begun)

    def _put(self, called, line):
        if called and self._worker.is_own_thread():
            called.print(self._severity, line)
        elif self._otherwise:
            self._otherwise.write(line + "\n")  # of a thread, or outside of a call

    def flush(self):
        if self._otherwise:
            self._otherwise.flush()


class _RunningController(Instance):
    """A controller of one robot."""

    def __init__(self, reader, link, number, sensors, commands):
        super().__init__()
        offset, seed, self.tick = reader.number("Q"), reader.number("Q"), reader.number("d")
        robot = reader.text()
        controllers = [reader.text() for _ in range(reader.number("Q"))]
        index = reader.number("Q")
        name, self.kind = controllers[index], reader.text()
        self.read_values(reader)
        published = {}
        for _ in range(reader.number("Q")):
            signal, _, published[signal] = reader.text(), reader.number("I"), reader.number("I")
        devices = [(reader.text(), reader.text(), reader.number("d")) for _ in range(reader.number("Q"))]
        entries = []
        for _ in range(reader.number("Q")):
            path, type, direction, count = reader.text(), reader.number("I"), reader.number("I"), reader.number("I")
            entries.append(Entry(path, type, direction, count, offset))
            offset += count
        self.robot = robot
        self.title = f"the controller {self.kind}{f' {name}' if len(controllers) > 1 else ''} of {robot}"
        self.outside = Outside(link, number, self.title, seed, f"{robot}/{name}" if index else robot)
        self.image = Image(robot, name, self.kind, devices, entries, sensors, commands, self.outside.claim, published)

    def start(self, kind):
        self.make(kind)
        for signal in description.members(kind, description.output):
            self.instance._outputs[signal.name] = slot = self.image.published(signal.name)
            slot.whole = signal.type is int
        self.instance.setup(RobotPorts(self.image, self.tick, self.outside))


class Worker:
    def __init__(self, page, link, sensors, commands):
        """`sensors`, `commands`: descriptors of the images, which get their size later."""
        self._page, self._link = page, link
        self._files = sensors, commands
        self._sensors = self._commands = memoryview(b"").cast("d")
        self._controllers = {}
        self._module = None
        self.called = None  # the outside of the controller that is called
        self._said_ignored = False
        sys.stdout = _Console(self, INFO, sys.stderr)
        sys.stderr = _Console(self, WARNING, sys.stderr)

    def run(self):
        handlers = {LOAD: self._load, MAP: self._map, START: self._start, UPDATE: self._update, SET: self._set, STOP: self._stop,
                    UNLOAD: self._unload, SAVE_STATE: self._save_state, LOAD_STATE: self._load_state,
                    START_DEVICE: self._start_device, ACT: lambda reader: self._call_device(ACT, "act", reader),
                    SENSE: lambda reader: self._call_device(SENSE, "sense", reader)}
        while True:
            reader = Reader(self._link.receive())
            handlers[reader.number("I")](reader)

    def _enter(self, request, controller):
        self._page.set_word("controller", controller)
        self._page.set_word("phase", _PHASES[request])

    def is_own_thread(self):
        return self._link.is_own_thread()

    def _done(self, fault=None, more=""):
        if self._link.ignored is not None and not self._said_ignored:
            self._said_ignored = True
            self._link.record(PRINT, self._link.ignored, Writer().number("i", WARNING).bytes(_IGNORED).data())
        writer = Writer().status(fault)
        if fault is None:
            writer.bytes(more)
        else:
            writer.bytes(b"")  # where C++ code threw
        self._page.set_word("phase", 0)
        self._link.record(DONE, 0, writer.data())
        self._link.finish_message()

    def _load(self, reader):
        path = reader.text()
        self._enter(LOAD, _NO_CONTROLLER)
        try:
            self._module = Module(path)
            text = self._module.description(self._module.sources())
        except _ANY as error:
            return self._not_loaded(path, error)
        self._done(more=text)

    def _not_loaded(self, path, error):
        found = Fault(error)
        self._done((PYTHON_MODULE, f"{path} cannot be loaded: {found.text}", found.place))

    def _map(self, reader):
        sensors = mmap.mmap(self._files[0], 0, prot=mmap.PROT_READ)
        commands = mmap.mmap(self._files[1], 0)
        self._sensors, self._commands = memoryview(sensors).cast("d"), memoryview(commands).cast("d")
        self._done()

    def _start(self, reader):
        number = reader.number("I")
        self._enter(START, number)
        if number in self._controllers and self._module:  # it is started again
            try:
                self._module = self._module.as_it_is_now()
            except _ANY as error:
                return self._not_loaded(self._module.path, error)
        running = _RunningController(reader, self._link, number, self._sensors, self._commands)
        self._controllers[number] = running
        kind = self._module.kinds.get(running.kind) if self._module else None
        if kind is None:
            return self._done((413, f"the controller {running.kind} is not in the module"))
        self.called = running.outside
        try:
            running.start(kind)
            fault = (CONTROLLER_FAILED, running.outside.gave_up) if running.outside.gave_up else None
        except UnknownPort as error:
            fault = (UNKNOWN_PORT, str(error), Fault(error).place)
        except ClaimedCommand as error:
            fault = (error.code, str(error))
        except _ANY as error:
            found = Fault(error)
            for file, line, name in found.frames:
                running.outside.print(3, f"  {name} at {file}:{line}")
            fault = (CONTROLLER_FAILED, running.failed("failed in setup", found.text), found.place)
        self.called = None
        self._done(fault)

    def _update(self, reader):
        tick, now = reader.number("Q"), reader.number("d")
        for _ in range(reader.number("Q")):
            number, since_last = reader.number("I"), reader.number("d")
            radios, pending = reader.numbers("I"), reader.numbers("Q")
            running = self._controllers.get(number)
            if running is None or running.instance is None:
                continue
            for radio, count in zip(radios, pending):
                running.outside.radios[radio].pending = count
            self._enter(UPDATE, number)
            self._link.record(UPDATED, number, self._updated(running, tick, now, since_last))
        self._done()

    def _start_device(self, reader):
        number = reader.number("I")
        self._enter(START_DEVICE, number)
        running = self._controllers[number] = RunningDevice(reader, self._link, number)
        kind = self._module.kinds.get(running.kind) if self._module else None
        if kind is None:
            return self._done((413, f"the device {running.kind} is not in the module"))
        phases = []

        def start():
            phases.extend(running.start(kind))
            return running.changes()

        self._device_done(running, "failed in setup", start, lambda: bytes(phases))

    def _call_device(self, request, phase, reader):
        number = reader.number("I")
        running = self._controllers.get(number)
        if running is None or running.instance is None:
            return self._done((INTERNAL, "no such device"))
        self._enter(request, number)
        self._device_done(running, f"failed in {phase}", lambda: running.call(phase, reader))

    def _device_done(self, running, failed, call, more=lambda: b""):
        self.called = running.outside
        fault, data = None, b""
        try:
            own, peers = call()
            data = Writer().bytes(own).bytes(peers).number("d", running.idle_until).bytes(more()).data()
        except _ANY as error:
            found = Fault(error)
            for file, line, name in found.frames:
                running.outside.print(3, f"  {name} at {file}:{line}")
            fault = (CONTROLLER_FAILED, found.text)
        self.called = None
        self._done(fault, data)

    def _updated(self, running, tick, now, since_last):
        """One call of update(), as a record."""
        running.outside.begin_tick(tick, now)
        self.called = running.outside
        begin, fault, gave_up, frames = time.perf_counter(), None, False, []
        try:
            running.instance.update(since_last)
            if running.outside.gave_up:
                fault, gave_up = (CONTROLLER_FAILED, running.outside.gave_up), True
        except _ANY as error:
            found = Fault(error)
            fault, frames = (CONTROLLER_FAILED, running.failed("failed", found.text)), found.frames
        self.called = None
        record = Writer().status(fault).number("B", gave_up).number("d", time.perf_counter() - begin)
        record.bytes("".join(f'  File "{file}", line {line} in {name}\n' for file, line, name in frames))  # as faulthandler writes them
        return record.bytes(b"").data()  # where C++ code threw

    def _set(self, reader):
        number, name = reader.number("I"), reader.text()
        running = self._controllers.get(number)
        if running is None or running.instance is None:
            return self._done((INTERNAL, "no such controller"))
        self._enter(SET, number)
        fault = None
        try:
            fields = {f.name: f for f in description.members(type(running.instance), description.field)}
            if name not in fields or not fields[name].quantity.is_live:
                raise ValueError(f"{name} is no live field")
            running.set(fields[name], reader.value())
        except _ANY as error:
            fault = (CONTROLLER_FAILED, running.failed(f"refuses the value of {name}", Fault(error).text))
        self._done(fault)

    def _save_state(self, reader):
        number = reader.number("I")
        running = self._controllers.get(number)
        if running is None or running.instance is None:
            return self._done()
        self._enter(SAVE_STATE, number)
        fault, text = None, ""
        try:
            state = running.instance.save_state()
            text = "" if state is None else json.dumps(state)
        except _ANY as error:
            fault = (CONTROLLER_FAILED, running.failed("failed in save_state", Fault(error).text))
        self._done(fault, text)

    def _load_state(self, reader):
        number, text = reader.number("I"), reader.text()
        running = self._controllers.get(number)
        if running is None or running.instance is None:
            return self._done((INTERNAL, "no such controller"))
        self._enter(LOAD_STATE, number)
        fault = None
        try:
            running.instance.load_state(json.loads(text))
        except _ANY as error:
            fault = (CONTROLLER_FAILED, running.failed("failed in load_state", Fault(error).text))
        self._done(fault)

    def _stop(self, reader):
        number = reader.number("I")
        self._enter(STOP, number)
        running = self._controllers.pop(number, None)
        if running:
            self.called = running.outside
            running.instance = None
            gc.collect()
            self._end_lines()
            self.called = None
        self._done()

    @staticmethod
    def _end_lines():
        for stream in (sys.stdout, sys.stderr):
            if isinstance(stream, _Console):
                stream.end_line()

    def _unload(self, reader):
        self._enter(UNLOAD, _NO_CONTROLLER)
        self._controllers.clear()
        try:
            atexit._run_exitfuncs()
        except _ANY:
            pass  # Python has printed it
        gc.collect()
        self._end_lines()
        self._done()
