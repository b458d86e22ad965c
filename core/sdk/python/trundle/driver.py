# SPDX-License-Identifier: BSD-2-Clause
"""A driver: makes a real robot, or anything else that moves, look to `trundle-cli drive` as a served run does. It speaks a part of the
protocol on the guide's page remote.md, for one robot and one client at a time."""

import argparse
import fnmatch
import math
import os
import secrets
import signal
import socket
import struct
import time

from .remote import PROTOCOL, Disconnected, _Frames


class Refused(Exception):
    """The answer to a request: a code for programs, a text for people."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


class Driver:
    """One robot. A subclass says what it has and moves it:

        class MyRobot(trundle.Driver):
            outputs = {"base/odometry": 3, "frontTouch/pressed": 1}   # signal: how many numbers
            commands = {"base/linearVelocity": 1, "base/angularVelocity": 1}

            def act(self, commands):
                self.wheels.set(commands["base/linearVelocity"], commands["base/angularVelocity"])

            def sense(self):
                return {"base/odometry": self.wheels.pose(), "frontTouch/pressed": self.bumper()}

            def stop(self):
                self.wheels.set(0, 0)

        if __name__ == "__main__":
            MyRobot("rover").main()

    Names and units of signals are those of the devices in the text of the robot, `trundle-cli describe DifferentialDrive` lists them; a
    command of several numbers, such as "lamp/color": 3, comes as a tuple. An exception in act or sense is the answer to the step, with its text."""

    outputs = {}
    commands = {}
    tick = 0.02  # s from one step to the next; in the text: Tick

    def __init__(self, robot, tick=None):
        self.robot = robot
        self.tick = tick or self.tick

    def start(self):
        """A client has connected: the commands are 0 again."""

    def act(self, commands):
        """Called at the start of each tick, with the latest value of each command."""
        raise NotImplementedError(f"{type(self).__name__} has no act()")

    def sense(self):
        """Called at the end of each tick, and once before the first. Returns the outputs that are new; the others keep their values."""
        raise NotImplementedError(f"{type(self).__name__} has no sense()")

    def stop(self):
        """The client has gone, or this process ends: whatever moves has to stop. May be called more than once."""

    def image(self, camera):
        """The current picture of a camera, by its device's name: width, height, and 3 * width * height bytes of red, green, blue by rows
        from the top."""
        raise Refused("no_such_path", f"there is no camera {self.robot}/{camera}")

    def send(self, radio, data, to, power):
        """Sends a packet (bytes) to an address, with so much power (dBm). The radio is a device with the outputs address and pending."""
        raise Refused("no_such_path", f"there is no radio {self.robot}/{radio}")

    def receive(self, radio):
        """The oldest packet that has not been read, a trundle.Packet; None: there is none."""
        raise Refused("no_such_path", f"there is no radio {self.robot}/{radio}")

    # --- serving ---

    def main(self):
        """Serves as the command line says, until Ctrl+C, SIGTERM or the terminal's end; the robot is stopped then."""
        parser = argparse.ArgumentParser(description=type(self).__doc__)
        parser.add_argument("--port", type=int, default=0, help="by default a free one, which is printed")
        parser.add_argument("--token-file", help="write the token into this new file, which only you can read, and do not print it")
        arguments = parser.parse_args()
        token = os.environ.pop("TRUNDLE_TOKEN", "") or secrets.token_hex(16)
        for number in (signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self._end)
        try:
            self.serve(arguments.port, token, arguments.token_file)
        except KeyboardInterrupt:
            pass

    @staticmethod
    def _end(*_):
        for number in (signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)
        raise KeyboardInterrupt

    def serve(self, port, token, token_file=None):
        """Listens on this machine; a client must give the token. One client after the other."""
        with socket.create_server(("127.0.0.1", port)) as listener:
            if token_file:
                with open(os.open(token_file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
                    file.write(token + "\n")
            try:
                print(f"serving {self.robot} at 127.0.0.1:{listener.getsockname()[1]}", flush=True)
                if not token_file:
                    print("token", token, flush=True)
                while True:
                    stream, _ = listener.accept()
                    stream.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    with stream:
                        session = _Session(self, stream, token)
                        try:
                            session.serve()
                        except KeyboardInterrupt:
                            session.end()  # once more: it may have been stop() that was interrupted
                            raise
            finally:
                if token_file:
                    os.unlink(token_file)


class DriveAmounts:
    """The amounts of a DifferentialDrive for robots that know only velocities: turns its commands into speeds, and says when an amount is
    driven. `base`: the device's name."""

    SIGNALS = {"linearVelocity": 1, "angularVelocity": 1, "linearAmount": 1, "angularAmount": 1, "sequence": 1}

    NEAR = 1e-3, 5e-3  # m, rad: so near to its end, and at rest, an amount is driven

    def __init__(self, base="base", acceleration=0.5, angular_acceleration=2.0):
        """m/s^2 and rad/s^2 with which it comes to rest at an amount's end."""
        self.base, self.slowing = base, (acceleration, angular_acceleration)
        self.reset()

    def reset(self):
        self.way = self.angle = 0.0  # driven since the start, m, rad
        self.last = 0.0, 0.0  # of these, in the last tick
        self.begun, self.finished, self.ends = 0, 0, None

    def moved(self, way, angle):
        """Since the last call, by the wheels: m forwards, rad to the left."""
        self.way += way
        self.angle += angle
        self.last = way, angle

    def speeds(self, commands, tick):
        """m/s and rad/s for the coming tick."""
        get = lambda signal: commands[f"{self.base}/{signal}"]
        wanted = get("linearVelocity"), get("angularVelocity")
        amounts = get("linearAmount"), get("angularAmount")
        if get("sequence") != self.begun:
            self.begun = get("sequence")
            self.ends = [at + amount if amount else None for at, amount in zip((self.way, self.angle), amounts)]
            if any(a and a * w <= 0 for a, w in zip(amounts, wanted)):
                self.ends, self.finished = None, self.begun
                return 0.0, 0.0
        if amounts == (0, 0):  # also while an amount is driven, which ends with that
            self.ends, self.finished = None, self.begun
            return wanted
        if self.ends is None:
            return 0.0, 0.0
        left = [end - at if end is not None else None for end, at in zip(self.ends, (self.way, self.angle))]
        speeds = [self._towards(rest, abs(most), slowing, tick) if rest is not None else most
                  for rest, most, slowing in zip(left, wanted, self.slowing)]
        if all(rest is None or (abs(rest) < near and abs(last) < near / 2) for rest, last, near in zip(left, self.last, self.NEAR)):
            self.ends, self.finished = None, self.begun
            return 0.0, 0.0
        return tuple(speeds)

    @staticmethod
    def _towards(rest, most, slowing, tick):
        return math.copysign(min(most, math.sqrt(2 * slowing * abs(rest)), abs(rest) / tick), rest)

    def outputs(self):
        """done, busy and finished of the device."""
        busy = self.ends is not None
        return {f"{self.base}/done": not busy, f"{self.base}/busy": busy, f"{self.base}/finished": self.finished}


class _Session:
    """One client of a driver."""

    def __init__(self, driver, stream, token):
        self.driver, self.frames, self.token = driver, _Frames(stream), token
        self.authorized = False
        self.commands = {path: 0.0 if count == 1 else (0.0,) * count for path, count in driver.commands.items()}
        self.values = {path: [0.0] * count for path, count in driver.outputs.items()}
        self.subscriptions = {}
        self.ticks, self.next = 0, None

    def serve(self):
        try:
            while True:
                message, data = self.frames.receive()
                if not isinstance(message, dict):
                    break
                self.answer(message, bytes(data))
        except (Disconnected, OSError, ValueError, UnicodeDecodeError):
            pass
        finally:
            self.end()

    def end(self):
        if self.authorized:  # who never was has moved nothing
            self.driver.stop()

    def answer(self, message, data):
        number, operation = message.pop("id", None), message.pop("op", None)
        try:
            if not self.authorized and operation != "hello":
                raise Refused("unauthorized", "the first request must be hello, with the token")
            handler = getattr(self, f"on_{operation}", None) if isinstance(operation, str) else None
            if not handler:
                raise Refused("unknown_operation", f"a driver does not know {operation!r}")
            members, data = handler(**message, data=data) if operation == "send" else handler(**message)
        except Refused as refused:
            self.frames.send({"id": number, "ok": False, "error": refused.code, "message": str(refused)})
            if refused.code == "unauthorized":
                raise Disconnected("unauthorized") from None
        except Exception as fault:  # of the driver: a cable that is out, a member that is not there
            self.frames.send({"id": number, "ok": False, "error": "failed", "message": f"{type(fault).__name__}: {fault}"})
        else:
            self.frames.send({"id": number, "ok": True, **members}, data)

    # --- the run ---

    def state(self):
        return {"tick": self.ticks, "time": self.ticks * self.driver.tick, "state": "paused"}

    def take(self, new):
        for path, value in (new or {}).items():
            if path not in self.driver.outputs:
                raise ValueError(f"{path} is not one of the driver's outputs")
            value = value.tolist() if hasattr(value, "tolist") else value  # of numpy
            values = list(value) if isinstance(value, (tuple, list)) else [value]
            if len(values) != self.driver.outputs[path]:
                raise ValueError(f"{path} has {self.driver.outputs[path]} numbers, not {len(values)}")
            self.values[path] = [float(v) for v in values]

    def set(self, signals):
        name = self.driver.robot + "/"
        for path, value in signals.items():
            if not path.startswith(name) or path[len(name):] not in self.commands:
                raise Refused("no_such_path", f"there is no command {path}")
            numbers, count = value if isinstance(value, list) else [value], self.driver.commands[path[len(name):]]
            if len(numbers) != count or not all(type(n) in (int, float) and math.isfinite(n) for n in numbers):
                raise Refused("bad_request", f"{path} is {'a finite number' if count == 1 else f'{count} finite numbers'}")
        for path, value in signals.items():
            path = path[len(name):]
            numbers = value if isinstance(value, list) else [value]
            self.commands[path] = float(numbers[0]) if self.driver.commands[path] == 1 else tuple(float(n) for n in numbers)

    def data(self, subscription):
        if subscription not in self.subscriptions:
            raise Refused("no_such_path", "there is no such subscription")
        numbers = []
        for path in self.subscriptions[subscription]:
            value = self.values[path] if path in self.values else self.commands[path]
            numbers += [value] if isinstance(value, float) else value
        return struct.pack(f"<{len(numbers)}d", *numbers)

    # --- requests ---

    def on_hello(self, token="", protocol=PROTOCOL):
        if not secrets.compare_digest(str(token).encode(), self.token.encode()):
            raise Refused("unauthorized", "the token is wrong")
        if protocol != PROTOCOL:
            raise Refused("unauthorized", f"the protocol's version is {PROTOCOL}")
        self.authorized = True
        self.driver.start()
        self.take(self.driver.sense())
        return {"program": "trundle-driver", "protocol": PROTOCOL, "experiment": type(self.driver).__name__, **self.state()}, b""

    def on_status(self):
        return {**self.state(), "tick_s": self.driver.tick, "duration_s": 0, "seed": 0, "speed": 1, "layout": "", "stopped": [],
                "ended": []}, b""

    def on_console(self, on=True):
        return {}, b""

    def on_list(self):
        return {"interface": "simulation", "robots": [{"robot": self.driver.robot, "controller": None, "held": False, "devices": []}]}, b""

    def on_describe(self, robot):
        if robot != self.driver.robot:
            raise Refused("no_such_path", f"there is no robot {robot}; this is {self.driver.robot}")
        signals, offset = [], 0
        for direction, all_of_it in (("output", self.driver.outputs), ("command", self.driver.commands)):
            for path, count in all_of_it.items():
                signals.append({"path": f"{robot}/{path}", "unit": "", "type": "real", "direction": direction, "count": count,
                                "offset": offset})
                offset += count
        return {"robot": robot, "controller": None, "held": False, "slots": offset, "devices": [], "signals": signals}, b""

    def on_subscribe(self, signals, every=0):
        every_path = [*self.driver.outputs, *self.driver.commands]
        found = [p for p in every_path if any(fnmatch.fnmatchcase(f"{self.driver.robot}/{p}", pattern) for pattern in signals)]
        if every or not found or len(self.subscriptions) >= 64:
            raise Refused("refused", "a driver sends signals only in replies (every = 0), and something has to match")
        number = len(self.subscriptions) + 1
        self.subscriptions[number] = found
        counts = {**self.driver.outputs, **self.driver.commands}
        return {"subscription": number, "signals": [[f"{self.driver.robot}/{p}", counts[p]] for p in found]}, b""

    def on_read(self, subscription):
        return self.state(), self.data(subscription)

    def on_command(self, signals):
        self.set(signals)
        return {}, b""

    def device(self, path):
        if not path.startswith(self.driver.robot + "/"):
            raise Refused("no_such_path", f"there is no device {path}")
        return path[len(self.driver.robot) + 1:]

    def on_image(self, camera):
        width, height, pixels = self.driver.image(self.device(camera))
        pixels = bytes(pixels)
        if len(pixels) != 3 * width * height:
            raise ValueError(f"an image of {width} x {height} has {3 * width * height} bytes, not {len(pixels)}")
        return {"width": width, "height": height, **self.state(), "pixels": len(pixels), "depth": 0, "objects": 0}, pixels

    def on_send(self, device, to=0xffff, power=1000.0, data=b""):
        self.driver.send(self.device(device), data, to, power)
        return {}, b""

    def on_receive(self, device):
        packet = self.driver.receive(self.device(device))
        if packet is None:
            return {"received": False}, b""
        return {"received": True, "time": packet.time, "rssi": packet.rssi, "lqi": packet.lqi, "from": packet.sender, "to": packet.receiver}, packet.bytes

    def on_step(self, ticks=1, signals=None, subscription=None):
        """In real time: a step returns when its last tick is over. Who comes late does not get the lost time back."""
        self.set(signals or {})
        if not isinstance(ticks, int) or ticks < 1:
            raise Refused("bad_request", "ticks is a whole number from 1 on")
        for _ in range(ticks):
            now = time.monotonic()
            self.next = now if self.next is None or now > self.next + self.driver.tick else self.next
            self.next += self.driver.tick
            self.driver.act(dict(self.commands))
            time.sleep(max(0.0, self.next - time.monotonic()))
            self.take(self.driver.sense())
            self.ticks += 1
        return {"ticks": ticks, **self.state()}, self.data(subscription) if subscription is not None else b""
