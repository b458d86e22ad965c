# SPDX-License-Identifier: BSD-2-Clause
"""The messages through the control page, as in core/control/host/message_link.h. Needs Linux: a futex."""

import ctypes
import mmap
import os
import threading

RUN, HOST = 0, 1
_CAPACITY = 1 << 20
_MACHINE = os.uname().machine
_FUTEX = {"x86_64": 202}.get(_MACHINE, 98)
_WAIT, _WAKE_OP = 0, 5
_SET_TO_RUN = 0  # FUTEX_OP(FUTEX_OP_SET, RUN, FUTEX_OP_CMP_EQ, 0): the same for every field
# Elsewhere a plain read of the turn does not order the reads after it, so each look at the turn is a system call.
_POLLS = 100 if _MACHINE == "x86_64" else 0

_syscall = ctypes.CDLL(None).syscall
_syscall.restype = ctypes.c_long


def _call(number, *arguments):
    return _syscall(ctypes.c_long(number), *[ctypes.c_void_p(a) for a in arguments])


class ControlPage:
    """`offsets`: where its parts are, by name."""

    def __init__(self, descriptor, offsets):
        self._map = mmap.mmap(descriptor, 0)
        self.bytes = memoryview(self._map)
        self._words = self.bytes.cast("I")
        self.offsets = offsets
        self._address = ctypes.addressof(ctypes.c_char.from_buffer(self._map))

    def word(self, name):
        return self._words[self.offsets[name] // 4]

    def set_word(self, name, value):
        self._words[self.offsets[name] // 4] = value

    def give_turn(self):
        """One system call sets the turn and wakes the run; it orders all earlier writes before it."""
        turn = self._address + self.offsets["turn"]
        _call(_FUTEX, turn, _WAKE_OP, 1, 0, turn, _SET_TO_RUN)

    def await_turn(self):
        index = self.offsets["turn"] // 4
        for _ in range(_POLLS):
            if self._words[index] == HOST:
                return
        turn = self._address + self.offsets["turn"]
        self.set_word("hostSleeps", 1)
        while True:
            _call(_FUTEX, turn, _WAIT, RUN, 0, 0, 0)
            if self._words[index] == HOST:
                break
        self.set_word("hostSleeps", 0)


class Link:
    """The host's end. Records of other threads than the one that made it are ignored."""

    def __init__(self, page):
        self._page = page
        self._thread = threading.get_ident()
        self.ignored = None  # the controller of whatever another thread asked for last
        self._out, self._in = page.offsets["toRun"], page.offsets["toHost"]
        self._out_bytes, self._in_bytes = self._out + page.offsets["mailBytes"], self._in + page.offsets["mailBytes"]

    def _word(self, mailbox, name):
        return (mailbox + self._page.offsets[name]) // 4

    def _append(self, data):
        words, size_at = self._page._words, self._word(self._out, "mailSize")
        data = memoryview(data)
        while data:
            used = min(words[size_at], _CAPACITY)
            fits = min(len(data), _CAPACITY - used)
            first = self._out_bytes + used
            self._page.bytes[first:first + fits] = data[:fits]
            words[size_at] = used + fits
            data = data[fits:]
            if not data:
                return
            words[self._word(self._out, "mailMore")] = 1
            self._page.give_turn()
            self._page.await_turn()
            words[size_at] = 0

    def finish_message(self):
        self._page._words[self._word(self._out, "mailMore")] = 0
        self._page.give_turn()

    def receive(self):
        message, words = b"", self._page._words
        while True:
            self._page.await_turn()
            size_at = self._word(self._in, "mailSize")
            size = min(words[size_at], _CAPACITY)
            message += self._page.bytes[self._in_bytes:self._in_bytes + size]
            words[size_at] = 0
            more = words[self._word(self._in, "mailMore")]
            words[self._word(self._out, "mailSize")] = 0
            words[self._word(self._out, "mailMore")] = 0
            if not more:
                return message
            self._page.give_turn()

    def is_own_thread(self):
        return threading.get_ident() == self._thread

    def record(self, kind, controller, data=b""):
        """Adds a record to the message to the run. False: in another thread, whose `controller` is kept in `ignored`."""
        if not self.is_own_thread():
            self.ignored = controller
            return False
        self._append(kind.to_bytes(4, "little") + controller.to_bytes(4, "little") + len(data).to_bytes(8, "little") + data)
        return True

    def ask(self, kind, controller, data=b""):
        """Adds a record and waits for the reply; None in another thread."""
        if not self.record(kind, controller, data):
            return None
        self.finish_message()
        return self.receive()
