# SPDX-License-Identifier: BSD-2-Clause
"""Starts a worker on the descriptors of a host process: 3 the control page, 4 the sensors, read-only, 5 the commands."""

import ctypes
import faulthandler
import os
import signal
import sys

from .link import ControlPage, Link
from .worker import Worker

_CONTROL, _SENSORS, _COMMANDS = 3, 4, 5
_NO_NEW_PRIVILEGES, _SET_FILTER, _FILTER = 38, 22, 2


class _Program(ctypes.Structure):  # struct sock_fprog
    _fields_ = [("count", ctypes.c_ushort), ("instructions", ctypes.c_char_p)]


def _confine(instructions):
    """Installs the filter of system calls that the program made: no other processes, programs, signals. See confinement.h."""
    program = _Program(len(instructions) // 8, instructions)
    prctl = ctypes.CDLL(None).prctl
    prctl(_NO_NEW_PRIVILEGES, ctypes.c_ulong(1), ctypes.c_ulong(0), ctypes.c_ulong(0), ctypes.c_ulong(0))
    prctl(_SET_FILTER, ctypes.c_ulong(_FILTER), ctypes.byref(program))


def _report_crashes(offset):
    """Tracebacks go to the end of the control page: of a crash, of os._exit(), and on a signal of the run, which stops the process
    then."""
    os.lseek(_CONTROL, offset, os.SEEK_SET)
    faulthandler.enable(_CONTROL, all_threads=False)
    faulthandler.register(signal.SIGUSR1, _CONTROL, all_threads=False)
    leave = os._exit

    def exit_with_report(code):
        faulthandler.dump_traceback(_CONTROL, all_threads=False)
        leave(code)

    os._exit = exit_with_report


def main(arguments):
    layout, instructions = arguments
    offsets = {name: int(at) for name, at in (part.split("=") for part in layout.split(","))}
    page = ControlPage(_CONTROL, offsets)
    _report_crashes(offsets["report"])
    _confine(bytes.fromhex(instructions))
    sys.argv = [sys.argv[0]]
    Worker(page, Link(page), _SENSORS, _COMMANDS).run()
