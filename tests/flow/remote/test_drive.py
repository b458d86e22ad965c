"""One controller, three robots: simulated in the program, served over TCP by another one, and a robot on a serial line behind its driver."""

import csv
import os
import re
import socket
import subprocess
import sys
import tempfile
import threading
import unittest

import trundle

CLI = os.environ["TRUNDLE_CLI"]
SOURCE = os.environ["TRUNDLE_SOURCE_DIR"]
DRIVERS = os.path.join(SOURCE, "plugins", "drivers", "serial_robot")
TOKEN = "0123456789abcdef"
TEXT = """Tick = 0.02   Duration = 4
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule {module}
Static floor {{ Config=OpenFloor }}
Robot rover {{ Config=SimpleRobot Pos=0,-1,0 {controller} }}
Robot other {{ Config=SimpleRobot Pos=0,1,0 }}
PoseLog path {{ Robot=rover Interval=0.02 File=path.csv }}
SignalLog signals {{ Signals="rover/base/*","rover/*Encoder/*","rover/*Motor/*" Interval=0.02 File=signals.csv }}
PoseLog others {{ Robot=other Interval=0.1 File=others.csv }}
"""
STRAIGHT = {"module": "controllers/linear_motion", "controller": "LinearMotion brain { Distance=0.4 Speed=0.3 }"}
PYTHON = '''
import trundle


class There(trundle.Controller):
    """Drives for 0.4 m and ends the run."""

    started = False

    def setup(self, robot):
        self.base = robot.differential_drive("base")

    def update(self, since_last):
        if not self.started:
            self.started = True
            self.base.drive(0.3, 0.0, 0.4, 0.0)
        elif self.base.done():
            print(f"at {self.base.odometry().x:.3f}")
            self.finish("is there")
'''


class Process:
    """A process that prints a first line when it is ready."""

    def __init__(self, *command):
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, "TRUNDLE_TOKEN": TOKEN, "PYTHONDONTWRITEBYTECODE": "1"})
        self.first = self.process.stdout.readline()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self):
        self.process.terminate()
        self.rest = self.process.communicate(timeout=60)[0]

    @property
    def port(self):
        return re.search(r":(\d+)$", self.first)[1]


def serve(*arguments):
    return Process(CLI, "serve", *arguments)


class DriveTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def experiment(self, what=STRAIGHT):
        return self.write("my.sim", TEXT.format(**what))

    def logs(self, name):
        return os.path.join(self.folder, name)

    def content(self, logs, name):
        with open(os.path.join(self.logs(logs), name)) as file:
            return file.read()

    def run_cli(self, *arguments, code=0):
        done = subprocess.run([CLI, *arguments], capture_output=True, text=True, timeout=120, env={**os.environ, "TRUNDLE_TOKEN": TOKEN})
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def drive(self, file, port, *more, code=0):
        return self.run_cli("drive", file, "--at", str(port), *more, code=code)

    def served_as_simulated(self, file, *more):
        simulated = self.run_cli("run", file, "--log-dir", self.logs("run"), *more)
        with serve(file, *more) as server:
            driven = self.drive(file, server.port, "--log-dir", self.logs("drive"), *more)
        for name in ("path.csv", "signals.csv"):
            self.assertGreater(self.content("run", name).count("\n"), 50)
            self.assertEqual(self.content("drive", name), self.content("run", name))
        self.assertFalse(os.path.exists(os.path.join(self.logs("drive"), "others.csv")))
        self.assertIn("others", driven.stderr)  # that it is left out
        return simulated, driven

    def test_a_served_robot_is_driven_to_the_last_bit_as_in_simulation(self):
        simulated, driven = self.served_as_simulated(self.experiment())
        line = re.search(r"done: drove .*", simulated.stderr)[0]
        self.assertIn(line, driven.stderr)
        self.assertIn("drove rover for 4 s, 200 ticks", driven.stdout)

    def test_so_it_is_by_a_controller_in_python(self):
        self.write("there.py", PYTHON)
        _, driven = self.served_as_simulated(self.experiment({"module": "there.py", "controller": "There brain { }"}), "--trust")
        self.assertIn("finished: is there", driven.stdout)

    def test_a_robot_on_a_serial_line(self):
        with Process(sys.executable, os.path.join(DRIVERS, "fake_robot.py")) as robot:
            with Process(sys.executable, os.path.join(DRIVERS, "serial_robot.py"), "rover", robot.first.strip()) as driver:
                driven = self.drive(self.experiment(), driver.port, "--log-dir", self.logs("drive"))
            self.assertRegex(driven.stderr, r"done: drove 0\.(39[6-9]|40[0-4])\d* m of 0\.4 m")
            self.assertIn("does not have rover/leftMotor/", driven.stderr)
        x, y, _ = (float(word) for word in re.search(r"at (.*)", robot.rest)[1].split())
        self.assertAlmostEqual(x, 0.4, delta=0.004)  # 1 %
        self.assertEqual(y, 0)
        rows = list(csv.reader(self.content("drive", "path.csv").splitlines()))
        self.assertAlmostEqual(float(rows[-1][2]), x, delta=0.004)  # its odometry, from where the text has it
        self.assertAlmostEqual(float(rows[-1][3]), -1, delta=1e-9)

    def test_the_driver_stops_the_robot_when_its_client_is_gone(self):
        with Process(sys.executable, os.path.join(DRIVERS, "fake_robot.py")) as robot:
            with Process(sys.executable, os.path.join(DRIVERS, "serial_robot.py"), "rover", robot.first.strip()) as driver:
                with trundle.connect(int(driver.port), TOKEN) as remote:
                    remote["rover/base/linearVelocity"] = 0.3
                    remote._request("step", ticks=20)
                with trundle.connect(int(driver.port), TOKEN) as remote:  # the next client finds it at rest
                    self.assertEqual(remote.tick, 0)
                    number = remote._request("subscribe", signals=["rover/base/odometry"], every=0)[0]["subscription"]
                    remote._request("step", ticks=25)
                    first = bytes(remote._request("step", ticks=1, subscription=number)[1])
                    self.assertEqual(bytes(remote._request("step", ticks=5, subscription=number)[1]), first)

    def test_what_cannot_be_driven_is_refused(self):
        file = self.experiment()
        with serve(file) as server:
            port = server.port
            for more, code, words in ((("--token", "wrong-token"), 1, "the token is wrong"),
                                      (("--robot", "other"), 2, "there is no robot other with a controller"),
                                      (("--set", "Tick=0.01"), 1, "try --set Tick=0.02")):
                self.assertIn(words, self.drive(file, port, "--log-dir", self.logs("drive"), *more, code=code).stderr)
            with trundle.connect(int(port), TOKEN) as remote:
                remote.run(1)
                self.assertIn("has to be paused", self.drive(file, port, "--log-dir", self.logs("drive"), code=1).stderr)
        self.assertIn(f"cannot connect to 127.0.0.1:{port}", self.drive(file, port, "--log-dir", self.logs("drive"), code=1).stderr)
        self.assertIn("give a port", self.drive(file, "nonsense", code=2).stderr)

    def test_another_end_that_speaks_something_else_or_nothing(self):
        file = self.experiment()
        for answer, words in ((b"HTTP/1.1 400 Bad Request\r\n\r\n" * 4, "too large"), (b"\x02\0\0\0\0\0\0\0[]", "not the protocol"),
                              (b"", "no answer for"), (None, "closed")):
            with socket.create_server(("127.0.0.1", 0)) as listener:
                over = threading.Event()

                def other_end():
                    stream, _ = listener.accept()
                    with stream:
                        if answer is not None:
                            stream.sendall(answer)
                            over.wait(60)

                thread = threading.Thread(target=other_end)
                thread.start()
                done = self.drive(file, listener.getsockname()[1], "--timeout", "0.5", "--log-dir", self.logs("drive"), code=1)
                over.set()
                thread.join()
                self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
