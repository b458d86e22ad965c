"""Controllers that do something bad, for isolated_python_test.cpp."""

import ctypes
import os
import sys
import threading
import time

import trundle


def divide():
    return 1 / 0


def loop():
    while True:
        pass


def segv():
    ctypes.string_at(1)


def abort():
    ctypes.CDLL(None).abort()


def leave():
    os._exit(3)


def kill():
    os.kill(os.getpid(), 9)


def raise_exit():
    sys.exit(5)


def eat_memory():
    return [bytes(1 << 30) for _ in range(1000)]


def recurse():
    return recurse() + 1


def fork():
    os.fork()


def execute():
    os.execv("/bin/true", ["true"])


def kill_parent():
    os.kill(os.getppid(), 9)


def sleep():
    time.sleep(3600)


def print_without_end():
    while True:
        print("x" * 1000)


def thread():
    """Threads may work, but not call the run."""
    def work():
        print("of a thread")
    threads = [threading.Thread(target=work) for _ in range(3)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()


def thread_fails():
    worker = threading.Thread(target=divide)
    worker.start()
    worker.join()


def close_all():
    os.closerange(0, 256)


def change_folder():
    os.chdir("/")


def nothing():
    pass


class Sick(trundle.Controller):
    """Does something bad after a while."""

    action = trundle.field("Action", "nothing", trundle.text(), "The name of a function.")
    phase = trundle.field("Phase", "update", trundle.one_of("setup|update|write sensor|overwrite commands|misspelt signal|word"), "When.")

    def setup(self, robot):
        self.drive = robot.differential_drive("base")
        self.image = robot._image
        if self.phase == "setup":
            globals()[self.action]()

    def update(self, since_last):
        self.drive.move(0.2, 0)
        if self.time < 0.495:
            return
        if self.phase == "write sensor":
            address = ctypes.addressof(ctypes.c_char.from_buffer_copy(self.image._sensors[:1]))
            self.image._sensors[0] = address
        if self.phase == "overwrite commands":
            for i in range(len(self.image._commands)):
                self.image._commands[i] = 1e9
        if self.phase == "misspelt signal":
            self.drive.set("linearVelocty", 1)
        if self.phase == "word":
            self.drive.move("fast", 0)
        if self.phase == "update":
            globals()[self.action]()


class Sound(trundle.Controller):
    """Does nothing bad."""

    def setup(self, robot):
        self.drive = robot.differential_drive("base")

    def update(self, since_last):
        self.drive.move(0.2, 0.1)
