# SPDX-License-Identifier: BSD-2-Clause
"""What a controller can reach outside its robot: console, logs, end of the run, random numbers, cameras, radios."""

from ..camera import Picture
from ..controller import fnv1a64, random_bits
from ..radio import Packet
from ..signals import UnknownPort
from .wire import Reader, Writer

DONE, UPDATED, PRINT, WRITE_LOG, FINISH = 1, 2, 3, 4, 5
OPEN_LOG, CAPTURE, SAVE_PICTURE, OBJECT_NAME, FIND_RADIO, SEND_PACKET, RECEIVE_PACKET, CLAIM = range(100, 108)
SETUP_TICK = (1 << 64) - 1  # random numbers drawn in setup differ from those of tick 0
_LONGEST_PIECE = 256 << 10


class ClaimedCommand(Exception):
    """Another controller of the robot has this command."""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


class Radio:
    __slots__ = ("number", "address", "pending")

    def __init__(self, number, address, pending):
        self.number, self.address, self.pending = number, address, pending


class Outside:
    def __init__(self, link, number, title, seed, random_name):
        self._link, self._number, self._title, self._seed = link, number, title, seed
        self._path_hash = fnv1a64(random_name.encode())
        self.time, self.tick, self._draws = 0.0, SETUP_TICK, 0
        self.gave_up = None
        self.radios = {}

    def begin_tick(self, tick, time):
        self.tick, self.time, self._draws = tick, time, 0

    def _ask(self, kind, writer):
        reply = self._link.ask(kind, self._number, writer.data())
        return None if reply is None else Reader(reply)

    def print(self, severity, text):
        return self._link.record(PRINT, self._number, Writer().number("i", severity).bytes(text).data())

    def fail(self, text):
        if self.gave_up is None:
            self.gave_up = f"{self._title} gave up: {text}"

    def finish(self, reason):
        self._link.record(FINISH, self._number, Writer().bytes(reason).data())

    def random_bits(self):
        bits = random_bits(self._seed, self._path_hash, self.tick, self._draws)
        self._draws += 1
        return bits

    def open_log(self, file_name):
        reply = self._ask(OPEN_LOG, Writer().bytes(file_name))
        return reply.number("i") if reply else -1

    def write_log(self, log, data):
        for first in range(0, len(data), _LONGEST_PIECE):
            piece = Writer().number("i", log).bytes(data[first:first + _LONGEST_PIECE])
            self._link.record(WRITE_LOG, self._number, piece.data())

    def capture(self, camera):
        reply = self._ask(CAPTURE, Writer().bytes(camera))
        fault = reply.status() if reply else (0, "pictures are taken in setup and update alone")
        if fault:
            return Picture(error=fault[1])
        width, height = reply.number("I"), reply.number("I")
        reply.number("Q")
        return Picture(width, height, reply.number("d"), reply.bytes(), reply.bytes(), reply.bytes())

    def save_picture(self, camera, file_name):
        """"" or what is wrong."""
        reply = self._ask(SAVE_PICTURE, Writer().bytes(camera).bytes(file_name))
        fault = reply.status() if reply else (0, "pictures are taken in setup and update alone")
        return fault[1] if fault else ""

    def object_name(self, number):
        if not 0 <= number < 1 << 32:
            return ""
        reply = self._ask(OBJECT_NAME, Writer().number("I", number))
        return reply.text() if reply else ""

    def claim(self, command):
        """Reserves a command of a robot with several controllers for this one."""
        reply = self._ask(CLAIM, Writer().bytes(command))
        fault = reply.status() if reply else (0, "ports are bound in setup and update alone")
        if fault:
            raise ClaimedCommand(fault[0], fault[1])

    def find_radio(self, path):
        reply = self._ask(FIND_RADIO, Writer().bytes(path))
        if not reply or not reply.number("B"):
            raise UnknownPort(f"{self._title} has no medium for its radio")
        radio = Radio(reply.number("I"), reply.number("I"), reply.number("Q"))
        return self.radios.setdefault(radio.number, radio)

    def send_packet(self, radio, data, to, power):
        reply = self._ask(SEND_PACKET, Writer().number("I", radio.number).number("I", to).number("d", power).bytes(data))
        return bool(reply and reply.number("B"))

    def receive_packet(self, radio):
        if radio.pending == 0:
            return None
        reply = self._ask(RECEIVE_PACKET, Writer().number("I", radio.number))
        if not reply or not reply.number("B"):
            radio.pending = 0
            return None
        radio.pending -= 1
        time, rssi, lqi = reply.number("d"), reply.number("d"), reply.number("i")
        sender, receiver = reply.number("I"), reply.number("I")
        reply.number("B")
        return Packet(reply.bytes(), rssi, lqi, time, sender, receiver)
