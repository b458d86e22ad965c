# SPDX-License-Identifier: BSD-2-Clause
"""Values as bytes in the messages between a run and its host processes, as in core/control/host/wire.h."""

import struct

NO_PLACE = "", 0


class Writer:
    def __init__(self):
        self._parts = []

    def number(self, format, value):
        self._parts.append(struct.pack("=" + format, value))
        return self

    def bytes(self, data):
        data = data.encode("utf-8", "replace") if isinstance(data, str) else data
        self._parts += [struct.pack("=Q", len(data)), data]
        return self

    def doubles(self, count, values):
        values = tuple(values)
        if len(values) != count:
            raise ValueError(f"{count} numbers are wanted, not {len(values)}")
        self._parts.append(struct.pack(f"={count}d", *values))
        return self

    def status(self, fault=None):
        """`fault`: None, or (code, message), or (code, message, place), whose place in the source is a file and a line."""
        self.number("B", fault is None)
        if fault is not None:
            code, message, (file, line) = fault if len(fault) == 3 else (*fault, NO_PLACE)
            self.number("i", code).bytes(message).bytes(file).number("i", line)
        return self

    def data(self):
        return b"".join(self._parts)


class Reader:
    def __init__(self, data):
        self._data, self._at = data, 0

    def number(self, format):
        (value,) = struct.unpack_from("=" + format, self._data, self._at)
        self._at += struct.calcsize("=" + format)
        return value

    def doubles(self, count):
        values = struct.unpack_from(f"={count}d", self._data, self._at)
        self._at += 8 * count
        return values

    def bytes(self):
        count = self.number("Q")
        data = self._data[self._at:self._at + count]
        self._at += count
        return bytes(data)

    def text(self):
        return self.bytes().decode("utf-8", "replace")

    def numbers(self, format):
        return [v for (v,) in struct.iter_unpack("=" + format, self.bytes())]

    def value(self):
        """A property's value as (numbers, texts)."""
        self.number("I")
        numbers = self.numbers("d")
        return numbers, [self.text() for _ in range(self.number("Q"))]

    def status(self):
        """None, or (code, message, place)."""
        if self.number("B"):
            return None
        return self.number("i"), self.text(), (self.text(), self.number("i"))
