# SPDX-License-Identifier: BSD-2-Clause
"""A run in another process: stepped, read and commanded over a socket. The guide page remote.md describes the protocol."""

import json
import math
import socket
import struct
import sys
from collections import deque

from .camera import Picture
from .ports import RobotPorts
from .radio import Packet
from .signals import COMMAND, OUTPUT, TRUTH, Entry, Image

PROTOCOL = 1
_MOST_BYTES = 1 << 28  # of a reply; more is an error of the stream
_MOST_AT_ONCE = 1 << 20
_MOST_EVENTS = 10000  # that wait to be fetched; older ones are dropped
_LARGEST = sys.float_info.max
_DIRECTIONS = {"output": OUTPUT, "command": COMMAND, "truth": TRUTH}
_TYPES = {"real": 1, "integer": 2, "boolean": 3}


class RemoteError(RuntimeError):
    """A request was refused. `code`: bad_request, no_such_path, owned, busy, ended, refused, failed ...; `reply`: the whole answer."""

    def __init__(self, code, message, reply=None):
        super().__init__(message)
        self.code, self.reply = code, reply or {}

    @property
    def diagnostics(self):
        """Errors of the text or the run: dicts with severity, code, message, file, line, column."""
        return self.reply.get("diagnostics", [])


class TextError(RemoteError):
    """The experiment cannot be built: its message begins with file, line and column of the first error."""

    def __init__(self, diagnostics):
        def located(d):
            place = f"{d['file']}:{d['line']}:{d['column']}: " if d["line"] else ""
            return f"{place}{d['severity']} {d['code']}: {d['message']}"

        errors = [d for d in diagnostics if d["severity"] == "error"] or diagnostics
        super().__init__("failed", "\n".join(located(d) for d in errors) or "the experiment cannot be built", {"diagnostics": diagnostics})


class Disconnected(RemoteError, ConnectionError):
    """The other end has gone."""

    def __init__(self, message):
        super().__init__("disconnected", message)


def _plain(value):
    """Numbers and arrays of numpy as Python's own."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} cannot be sent")


def _json(message):
    try:
        return json.dumps(message, allow_nan=False, separators=(",", ":"), default=_plain)
    except ValueError:
        for name, value in message.items():  # which one it is
            try:
                json.dumps(value, allow_nan=False, default=_plain)
            except ValueError:
                raise ValueError(f"{name} was given a value that is no finite number") from None
        raise


class _Frames:
    """JSON objects and bytes over a stream socket: both sizes as 4 bytes each, little-endian, then both."""

    def __init__(self, stream):
        self._socket, self._received = stream, bytearray()

    def _check_open(self):
        if self._socket.fileno() < 0:
            raise Disconnected("the connection is closed")

    def send(self, message, data=b""):
        self._check_open()
        text = _json(message).encode()
        self._socket.sendall(struct.pack("<II", len(text), len(data)) + text + data)

    def receive(self):
        self._check_open()
        self._await(8)
        text_size, data_size = struct.unpack_from("<II", self._received)
        if text_size > _MOST_BYTES or data_size > _MOST_BYTES:
            raise Disconnected("the other end does not speak this protocol")
        end = 8 + text_size + data_size
        self._await(end)
        text, data = self._received[8:8 + text_size], self._received[8 + text_size:end]
        del self._received[:end]
        return json.loads(text), data

    def _await(self, size):
        """What was received is kept if an exception, such as KeyboardInterrupt, leaves this."""
        while len(self._received) < size:
            got = self._socket.recv(_MOST_AT_ONCE)
            if not got:
                raise Disconnected("the connection was closed by the other end")
            self._received += got

    def close(self):
        try:
            self._socket.shutdown(socket.SHUT_RDWR)  # forked processes may have it open, too
        except OSError:
            pass  # it is not connected any more
        self._socket.close()


class Reading:
    """The values of subscribed signals after one tick: reading["rover/base/odometry"]."""

    def __init__(self, tick, time, signals, data, skipped=0):
        self.tick, self.time, self.skipped = tick, time, skipped
        self._places, at = {}, 0
        for path, count in signals:
            self._places[path] = (at, count)
            at += count
        self._values = memoryview(data).toreadonly().cast("d")

    def __getitem__(self, path):
        at, count = self._places[path]
        return self._values[at] if count == 1 else self._values[at:at + count]

    def __iter__(self):
        return iter(self._places)

    def __len__(self):
        return len(self._places)


class _Radio:
    __slots__ = ("path", "address")

    def __init__(self, path, address):
        self.path, self.address = path, address


class _Outside:
    """What ports of a robot reach beside signals."""

    def __init__(self, remote, robot):
        self._remote, self._robot = remote, robot
        self._names = None

    def capture(self, camera):
        try:
            return self._remote.image(f"{self._robot}/{camera}")
        except RemoteError as refused:
            return Picture(error=str(refused))

    def save_picture(self, camera, file_name):
        return "images of a served run are not saved by it; take them with capture()"

    def object_name(self, number):
        if self._names is None:
            self._names = self._remote._request("objects")[0]["objects"]
        return self._names[number] if 0 <= number < len(self._names) else ""

    def find_radio(self, path):
        return _Radio(path, int(self._remote[f"{path}/address"]))

    def send_packet(self, radio, data, to, power):
        try:
            self._remote._request("send", data, device=radio.path, to=to, power=power)
        except RemoteError as refused:
            if refused.code == "refused":
                return False
            raise
        return True

    def receive_packet(self, radio):
        reply, data = self._remote._request("receive", device=radio.path)
        if not reply["received"]:
            return None
        return Packet(bytes(data), reply["rssi"], reply["lqi"], reply["time"], reply["from"], reply["to"])


class Remote:
    """A served run: see connect() and Simulation. Used by one thread."""

    def __init__(self, stream, token="", console=None):
        self._frames = _Frames(stream)
        self._number = 0
        self._awaited, self._replies = set(), {}  # numbers of requests; a console callback may make some while another one waits
        self._console = console
        self._subscriptions = {}  # number: (signals, queue)
        self._tick = self._time = 0
        self._state, self._reason = "paused", ""
        self._seed = self._tick_s = self._layout = None
        self._forget_robots()
        try:
            self.experiment = self._request("hello", token=token, protocol=PROTOCOL)[0]["experiment"]
            self._read_status()
            self._request("console", on=console is not None)
        except BaseException:
            self.close()
            raise

    # --- the run ---

    @property
    def time(self):
        """Simulated time at the last answer, s."""
        return self._time

    @property
    def tick(self):
        """Completed ticks at the last answer."""
        return self._tick

    @property
    def state(self):
        """"paused", "running" or "ended" at the last answer."""
        return self._state

    @property
    def end_reason(self):
        """Why it has ended, or paused by itself; "" otherwise."""
        return self._reason

    def status(self):
        """tick, time, state, tick_s, duration_s, seed, speed, layout; in "stopped" the controllers that a fault has stopped, in "ended"
        the robots that have ended by a fault of their own."""
        return self._read_status()

    def step(self, ticks=1):
        """Sends what ports and signals have set, runs so many ticks and reads all robots that are in use. Raises RemoteError "ended" if
        the run is over. Returns the number of ticks executed, fewer if it ended or another client interrupted it."""
        members = {"ticks": ticks}
        self._add_changes(members)
        return self._exchange("step", members)["ticks"]

    def update(self):
        """The same without ticks, for a run that is running: sends what was set, and reads."""
        changes = {}
        self._add_changes(changes)
        if changes:
            self._send_changes(changes)
        if self._watch is None:
            self._read_status()
        else:
            self._exchange("read", {})

    def run(self, speed=1.0):
        """Lets it run: 1 is real time, 0 as fast as possible. It pauses once at the text's Duration."""
        self._request("run", speed=speed)

    def pause(self):
        self._request("pause")

    def reset(self, seed=None):
        """Starts again at tick 0, with another seed if given. Ports stay valid unless the seed changes what is in the world: then get them
        again. Raises TextError if it cannot be built."""
        try:
            self._request("reset", **({} if seed is None else {"seed": seed}))
        except RemoteError as refused:
            if refused.code == "failed":
                raise TextError(refused.diagnostics) from None
            raise
        former = self._layout
        self._read_status()
        self._pending = {}
        if self._layout != former:  # robots are others
            self._forget_robots()
        elif self._watch is not None:
            self._exchange("read", {})

    @property
    def seed(self):
        return self._seed

    @property
    def tick_length(self):
        """s."""
        return self._tick_s

    def hash(self):
        """16 hexadecimal digits of the state of all bodies, as in `trundle-cli run --hash`."""
        return self._request("hash")[0]["hash"]

    # --- robots and signals ---

    def robots(self):
        """Name: its controller's kind or None, and its devices with kind and interface, as dicts."""
        return {robot.pop("robot"): robot for robot in self._request("list")[0]["robots"]}

    def describe(self, robot):
        """Devices with their interfaces, and signals with unit, type and direction, as a dict."""
        return self._request("describe", robot=robot)[0]

    def robot(self, name):
        """The ports of a robot, the same as in a controller: robot("rover").differential_drive("base"). They are read at each step() or
        update(), and what is set there is sent with the next one."""
        if name not in self._robots:
            self._watch_robot(name)
        return self._robots[name]

    def __getitem__(self, path):
        """The current value of a signal: a number, a boolean, or a list. Cannot be infinite: that is None."""
        values = self._request("read", signals=[path])[0]["values"]
        return values if path not in values else values[path]

    def __setitem__(self, path, value):
        """Sets a command signal from the coming tick on: a number, or a sequence where it has several."""
        values = value if isinstance(value, (int, float)) else _plain(value) if hasattr(value, "tolist") else [
            _plain(each) if hasattr(each, "tolist") else each for each in value]
        for number in values if isinstance(values, list) else [values]:
            if not isinstance(number, (int, float)):
                raise TypeError(f"{path} takes numbers, not {number!r}")
            if not abs(number) <= _LARGEST:  # also if it is none
                raise ValueError(f"{path} was given a value that is no finite number")
        self._request("command", signals={path: values})
        for own, at, count in self._slots:  # the last value given counts
            if own == path:
                self._views[1].restore(at, values if isinstance(values, list) else [values])
                self._pending.update((slot, self._tick) for slot in range(at, at + count))
                for slot in range(at, at + count):
                    self._views[2][slot] = self._views[1][slot]

    def read(self, *patterns):
        """The values of all signals that match, * and ? being wildcards, as a dict."""
        return self._request("read", signals=list(patterns))[0]["values"]

    def device(self, path):
        """What a device measures, by the names of its Player interface: {"pos": [...]}."""
        return self._request("read", device=path)[0]["data"]

    def command(self, device, **values):
        """Commands a device by its Player interface: command("rover/base", vel=[0.3, 0])."""
        self._request("command", device=device, **values)

    def image(self, camera):
        """The current Picture of "rover/eye"."""
        reply, data = self._request("image", camera=camera)
        view = memoryview(data).toreadonly()
        pixels, depth = reply["pixels"], reply["pixels"] + reply["depth"]
        picture = Picture(reply["width"], reply["height"], reply["time"], view[:pixels], view[pixels:depth], view[depth:])
        picture.names = dict(reply.get("names", ()))
        return picture

    # --- the simulation itself ---

    def hold(self, robot, held=True):
        """Stops calling the robot's controller, so that its commands can be set from here; or calls it again."""
        self._request("hold", robot=robot, held=held)
        if self._watch is not None:
            self._exchange("read", {})

    def place(self, robot, position, heading=0.0):
        """Moves a robot, with zero velocity, in the coming tick: m, rad."""
        self._request("place", robot=robot, position=list(position), heading=heading)

    def push(self, body, force, point):
        """Pushes the body "rover/chassis" with a force (N) at a point of the world (m), in the coming tick; all pushes act."""
        self._request("push", body=body, force=list(force), point=list(point))

    def restart(self, robot):
        """Starts the robot's controller again."""
        self._request("restart", robot=robot)

    # --- subscriptions ---

    def subscribe(self, *patterns, every=1):
        """Lets the values of matching signals be sent after each `every` ticks. Returns the number for next() and unsubscribe()."""
        reply = self._request("subscribe", signals=list(patterns), every=every)[0]
        self._subscriptions[reply["subscription"]] = ([tuple(s) for s in reply["signals"]], deque(maxlen=_MOST_EVENTS))
        return reply["subscription"]

    def unsubscribe(self, subscription):
        self._request("unsubscribe", subscription=subscription)
        self._subscriptions.pop(subscription, None)

    def next(self, subscription):
        """The oldest Reading that was not fetched; waits for one. One that is late has `skipped` > 0: as many were left out before it."""
        queue = self._subscriptions[subscription][1]
        while not queue:
            self._take(*self._receive())
        return queue.popleft()

    # --- end ---

    def close(self):
        self._frames.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # --- inside ---

    def _receive(self):
        return self._frames.receive()

    def _request(self, operation, data=b"", /, **members):
        self._number += 1
        number = self._number
        try:
            self._frames.send({"id": number, "op": operation, **members}, data)
        except (BrokenPipeError, ConnectionResetError):
            pass  # what the other end sent before it went is read below
        try:
            reply, data = self._receive_reply(number)
        except ConnectionResetError:
            raise Disconnected("the connection was closed by the other end") from None
        except KeyboardInterrupt:
            if operation == "step":  # else it would go on in the background
                self._number += 1
                self._frames.send({"id": self._number, "op": "pause"})
            raise
        if not reply["ok"]:
            raise RemoteError(reply["error"], reply["message"], reply)
        self._take_state(reply)
        return reply, data

    def _receive_reply(self, number):
        """The reply to a request; those to earlier ones, which an interrupt has left, are skipped."""
        self._awaited.add(number)
        try:
            while number not in self._replies:
                message, data = self._receive()
                if self._take(message, data):
                    continue
                answered = number if message["id"] is None else message["id"]
                if answered in self._awaited:
                    self._replies[answered] = message, data
            return self._replies.pop(number)
        finally:
            self._awaited.discard(number)
            self._replies.pop(number, None)

    def _take_state(self, message):
        if "tick" in message and "state" in message:
            self._tick, self._time, self._state = message["tick"], message["time"], message["state"]
            self._reason = message.get("reason", "")

    def _take(self, message, data):
        """Handles an event; False: it is a reply."""
        event = message.get("event")
        if event == "signals" and message["subscription"] in self._subscriptions:
            signals, queue = self._subscriptions[message["subscription"]]
            queue.append(Reading(message["tick"], message["time"], signals, data, message.get("skipped", 0)))
        elif event == "console" and self._console:
            self._console(message["time"], message["who"], message["severity"], message["text"])
        elif event == "failed":
            raise TextError(message["diagnostics"])
        elif event in ("state", "reset"):
            self._take_state(message)
        return event is not None

    def _read_status(self):
        status = self._request("status")[0]
        if "layout" in status:  # not while there is no run, after a reset that failed
            self._seed, self._tick_s, self._layout = status["seed"], status["tick_s"], status["layout"]
        return status

    def _forget_robots(self):
        self._robots, self._watch, self._spans, self._slots, self._pending = {}, None, [], [], {}
        self._views = None

    def _watch_robot(self, name):
        """Makes the image of one more robot, and subscribes to its signals with those of the others."""
        robot = self.describe(name)
        if self._watch is not None:
            self._request("unsubscribe", subscription=self._watch)
        self._watch = self._request("subscribe", signals=[each + "/*" for each in [*self._robots, name]], every=0)[0]["subscription"]
        if self._views is None:
            image = bytes(8 * robot["slots"])
            self._views = memoryview(bytearray(image)).cast("d"), _Commands(robot["slots"]), memoryview(bytearray(image)).cast("d")
        values, commands, _ = self._views
        entries = [Entry(s["path"], _TYPES[s["type"]], _DIRECTIONS[s["direction"]], s["count"], s["offset"]) for s in robot["signals"]]
        self._slots += [(e.path, e.offset, e.count) for e in entries if e.direction == COMMAND]
        self._spans = _joined(sorted(self._spans + [(e.offset, e.count) for e in entries]))
        controller = robot["controller"] or {"name": "", "kind": ""}
        devices = [(d["kind"], d["name"], d["update_period"]) for d in robot["devices"]]
        image = Image(name, controller["name"], controller["kind"], devices, entries, values.toreadonly(), commands)
        self._robots[name] = RobotPorts(image, self._tick_s, _Outside(self, name))
        self._exchange("read", {})

    def _add_changes(self, members):
        """What ports have set since the last exchange, be it what was sent before: somebody else may have set something else since."""
        if self._views is None:
            return
        _, commands, sent = self._views
        changes = {}
        for path, at, count in self._slots:
            if commands.changed.isdisjoint(range(at, at + count)):
                continue
            values = commands[at:at + count].tolist()
            if not all(map(math.isfinite, values)):
                commands.restore(at, sent[at:at + count])
                raise ValueError(f"{path} was given a value that is no finite number")
            changes[path] = values[0] if count == 1 else values
        if changes:
            members["signals"] = changes

    def _send_changes(self, members):
        self._exchange("command", members, reads=False)
        _, commands, sent = self._views
        for path, first, count in self._slots:
            if path in members["signals"]:
                for at in range(first, first + count):
                    sent[at] = commands[at]
                    self._pending[at] = self._tick

    def _exchange(self, operation, members, reads=True):
        """A request whose reply has the values of all watched robots."""
        if reads and self._watch is not None:
            members["subscription"] = self._watch
        sends = "signals" in members and self._views is not None
        if sends:
            self._views[1].changed = set()  # what a callback sets meanwhile is for the next one
        try:
            reply, data = self._request(operation, **members)
        except RemoteError:
            if sends:
                for _, at, count in self._slots:  # what was refused is not sent again
                    self._views[1].restore(at, self._views[2][at:at + count])
            raise
        if reads and self._watch is not None:
            self._take_values(data)
        return reply

    def _take_values(self, data):
        """Commands become those of the world, as another client may have set them, except what waits for the coming tick, and what is not
        sent yet."""
        received, at = memoryview(data).cast("d"), 0
        values, commands, sent = self._views
        waiting = {slot: sent[slot] for slot, tick in self._pending.items() if tick >= self._tick}
        unsent = {slot: commands[slot] for slot in commands.changed}
        for offset, count in self._spans:
            piece = received[at:at + count]
            values[offset:offset + count] = sent[offset:offset + count] = piece
            commands.restore(offset, piece, keeps=True)
            at += count
        for slot, value in waiting.items():
            sent[slot] = value
        for slot, value in {**waiting, **unsent}.items():
            commands.restore(slot, [value], keeps=True)
        self._pending = {slot: tick for slot, tick in self._pending.items() if slot in waiting}


class _Commands:
    """Doubles that remember which of them ports have set and that are not sent yet."""

    def __init__(self, count):
        self._values = memoryview(bytearray(8 * count)).cast("d")
        self.changed = set()

    def __getitem__(self, at):
        return self._values[at]

    def __setitem__(self, at, value):
        self._values[at] = value
        self.changed.add(at)

    def restore(self, first, values, keeps=False):
        """Sets values from `first` on that are those of the world. `keeps`: what is marked as changed stays so."""
        for at, value in enumerate(values, first):
            self._values[at] = value
        if not keeps:
            self.changed.difference_update(range(first, first + len(values)))


def _joined(spans):
    joined = []
    for offset, count in spans:
        if joined and joined[-1][0] + joined[-1][1] == offset:
            joined[-1] = (joined[-1][0], joined[-1][1] + count)
        else:
            joined.append((offset, count))
    return joined


def print_line(time, who, severity, text):
    """How lines of the console are shown: [0.42 rover] touch."""
    name = f" {who}" if who else ""
    mark = "" if severity == "info" else f"{severity}: "
    print(f"[{time:.2f}{name}] {mark}{text}", file=sys.stderr)


def connect(port, token, host="127.0.0.1", console=None, timeout=None):
    """Connects to `trundle-cli serve FILE`. `token`: as it printed it. `console(time, who, severity, text)` gets what controllers print;
    `timeout`: seconds to wait for any answer, None for ever."""
    stream = socket.create_connection((host, port), timeout)
    stream.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return Remote(stream, token, console)
