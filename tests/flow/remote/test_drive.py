"""One controller, three robots: simulated in the program, served over TCP by another one, and a robot on a serial line behind its driver."""

import csv
import hashlib
import os
import re
import signal
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
Region yard {{ Size=9,9,1 }}
NoContact=rover,other
PoseLog path {{ Robot=rover Interval=0.02 File=path.csv }}
SignalLog signals {{ Signals="rover/base/*","rover/*Encoder/*","rover/*Motor/*" Interval=0.02 File=signals.csv }}
PoseLog others {{ Robot=other Interval=0.1 File=others.csv }}
EnergyLog energies {{ File=energies.csv }}
ContactLog touches {{ File=touches.csv }}
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
            self.finish("is\\nthere")
'''

EVER = '''
import trundle


class Ever(trundle.Controller):
    """Drives ahead as long as it is called."""

    def setup(self, robot):
        self.base = robot.differential_drive("base")

    def update(self, since_last):
        self.base.move(0.3, 0.0)
'''

COUNTER = '''
import trundle


class Counter(trundle.Controller):
    """Publishes how often it was called."""

    calls = trundle.output("calls", "", "So far.", type=int)

    def setup(self, robot):
        self.count = 0

    def update(self, since_last):
        self.count += 1
        self.calls = self.count
'''


# Robots with a lamp, a camera and a radio each. What they see and receive goes into a log.
POSTS = """Tick = 0.02   Duration = 2   Seed = 7
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule there.py
Static floor {{ Config=OpenFloor }}
RadioMedium air {{ Model=log_distance Shadowing=4 Mac=csma Collisions=true }}
RobotConfig Post {{
  Body hull {{ Box box {{ Size=0.2,0.2,0.1 Pos=0,0,0.06 Mass=1 Material=red Surface=plastic }} }}
  Led lamp {{ Body=hull Pos=0,0,0.12 }}
  Camera eye {{ Body=hull Pos=0.12,0,0.1 Resolution=24,16 Mode={mode} }}
  Transceiver radio {{ Body=hull Pos=0,0,0.15 }}
}}
Robot rover {{ Config=Post Talker brain {{ }} }}
Robot other {{ Config=Post Pos=1,0.1,0 HPR=180,0,0 Answerer brain {{ }} }}
SignalLog signals {{ Signals="rover/lamp/*","rover/radio/*" Interval=0.02 File=signals.csv }}
"""
TALKER = '''
import hashlib
import trundle


class Answerer(trundle.Controller):
    """Answers each packet to its sender."""

    def setup(self, robot):
        self.radio = robot.radio("radio")
        self.lamp = robot.port("lamp")

    def update(self, since_last):
        self.lamp.set("color", 0.5 + 0.5 * (int(self.time / 0.3) % 2), 1)
        while packet := self.radio.receive():
            self.radio.send(b"re: " + packet.bytes, to=packet.sender)


class Talker(trundle.Controller):
    """Sends, changes the color of its lamp, and writes down what it sees and receives."""

    def setup(self, robot):
        self.radio, self.lamp, self.eye = robot.radio("radio"), robot.port("lamp"), robot.camera("eye")
        self.log = self.open_log("seen.csv")
        self.log.write(f"address {self.radio.address}\\n")

    def update(self, since_last):
        tick = round(self.time / 0.02)
        if tick % 5 == 0:
            self.radio.send(f"hello {tick}")
        for element in range(3):
            self.lamp.set("color", (tick % (7 + element)) / 10, element)
        while packet := self.radio.receive():
            self.log.write(f"{self.time} {packet}\\n")
        if tick % 10 == 1:
            picture = self.eye.capture()
            what = hashlib.sha1(bytes(picture.pixels)).hexdigest(), picture.depths and hashlib.sha1(picture.depths.tobytes()).hexdigest()
            names = sorted({self.eye.object_name(n) for n in bytes_of(picture.objects)}) if picture.objects else []
            self.log.write(f"{self.time} {picture.time} {picture.width}x{picture.height} {what} {names} {picture.error}\\n")


def bytes_of(objects):
    return objects.cast("B").cast("I").tolist()
'''
DRIVER = '''
import trundle


class Post(trundle.Driver):
    tick = 0.02
    outputs = {"radio/address": 1, "radio/pending": 1, "eye/frame": 1}
    commands = {"lamp/color": 3, "lamp/on": 1}

    def start(self):
        self.packets, self.colors = [trundle.Packet(b"first", -50.0, 100, 0.5, 9, 4)], []

    def act(self, commands):
        self.colors.append(commands["lamp/color"])

    def sense(self):
        return {"radio/address": 4, "radio/pending": len(self.packets)}

    def image(self, camera):
        return 2, 1, b"\\x01\\x02\\x03\\xff\\xfe\\xfd" if camera == "eye" else b""

    def send(self, radio, data, to, power):
        self.packets.append(trundle.Packet(data[::-1], -60.0, 90, 1.0, to, 4))

    def receive(self, radio):
        return self.packets.pop(0) if self.packets else None

    def stop(self):
        print("colors", *self.colors[:3], flush=True)


Post("rover").main()
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

    def end(self, number=signal.SIGTERM):
        if self.process.returncode is None:
            self.process.send_signal(number)
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
        for name in ("others", "energies", "touches"):  # of another robot, or of what only a simulation knows
            self.assertFalse(os.path.exists(os.path.join(self.logs("drive"), name + ".csv")))
            self.assertRegex(driven.stderr, f"not written: .*{name}")
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

    def test_what_the_controller_publishes_is_its_own_not_that_of_the_one_at_the_other_end(self):
        self.write("counter.py", COUNTER)
        text = TEXT.format(module="counter.py", controller="Counter brain { }")
        file = self.write("my.sim", text + 'SignalLog published { Signals="rover/brain/*" Interval=0.02 File=published.csv }')
        self.served_as_simulated(file, "--trust")
        self.assertIn("\n1,50\n", self.content("run", "published.csv"))
        self.assertEqual(self.content("drive", "published.csv"), self.content("run", "published.csv"))

    def test_the_robot_stands_when_its_controller_has_ended(self):
        self.write("ever.py", EVER)
        ever = {"module": "ever.py", "controller": "Ever brain { }"}
        file = self.write("alone.sim", TEXT.format(**{**ever, "controller": ""}))  # none of its own
        with serve(file, "--trust") as server:
            self.drive(self.experiment(ever), server.port, "--duration", "0.5", "--trust")
            with trundle.connect(int(server.port), TOKEN) as remote:
                self.assertEqual(remote.tick, 25)
                self.assertGreater(remote["rover/pose"][0], 0.05)  # it drove
                remote.step(50)
                self.assertEqual(remote["rover/base/linearVelocity"], 0)
                place = list(remote["rover/pose"])
                remote.step(25)
                for before, now in zip(place, remote["rover/pose"]):
                    self.assertAlmostEqual(before, now, 3)

    def test_lamps_pictures_and_packets_cross(self):
        self.write("there.py", TALKER)
        for mode in ("color", "depth", "segmentation"):
            file = self.write("my.sim", POSTS.format(mode=mode))
            simulated = self.run_cli("run", file, "--log-dir", self.logs("run"), "--trust")
            with serve(file, "--trust") as server:
                driven = self.drive(file, server.port, "--robot", "rover", "--log-dir", self.logs("drive"), "--trust")
            messages = (simulated.stderr + driven.stderr).replace("warning: waiting for", "waiting for")  # a slow machine
            self.assertNotIn("warning", messages)
            seen = self.content("run", "seen.csv")
            self.assertEqual(self.content("drive", "seen.csv"), seen)
            self.assertGreater(seen.count("re: hello"), 5)
            self.assertEqual(seen.count("24x16"), 10)
            self.assertEqual("other/hull/box" in seen, mode == "segmentation", seen)
            self.assertEqual(self.content("drive", "signals.csv"), self.content("run", "signals.csv"))
            self.assertGreater(len(set(line.split(",", 1)[1] for line in self.content("run", "signals.csv").splitlines())), 20)

    def test_a_driver_has_lamps_pictures_and_packets_too(self):
        self.write("there.py", TALKER)
        file = self.write("my.sim", POSTS.format(mode="color"))
        program = self.write("driver.py", DRIVER)
        with Process(sys.executable, program) as driver:
            driven = self.drive(file, driver.port, "--robot", "rover", "--log-dir", self.logs("drive"), "--trust", "--duration", "0.5")
        seen = self.content("drive", "seen.csv")
        self.assertIn("address 4\n", seen)
        self.assertIn("Packet(bytes=b'first', rssi=-50.0, lqi=100, time=0.5, sender=9, receiver=4)", seen)
        self.assertIn("Packet(bytes=b'0 olleh', rssi=-60.0, lqi=90, time=1.0, sender=65535, receiver=4)", seen)
        self.assertIn("2x1 ('" + hashlib.sha1(b"\x01\x02\x03\xff\xfe\xfd").hexdigest(), seen)
        self.assertIn("colors (0.0, 0.0, 0.0) (0.1, 0.1, 0.1) (0.2, 0.2, 0.2)", driver.rest)
        self.assertIn("does not have rover/lamp/lit", driven.stderr)

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

    def test_a_driver_that_is_end_stops_the_robot(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
            with Process(sys.executable, self.write("driver.py", DRIVER)) as driver:
                with trundle.connect(int(driver.port), TOKEN) as remote:
                    remote._request("step", ticks=2)
                    driver.end(number)  # while its client is still connected
            self.assertIn("colors (0.0, 0.0, 0.0) (0.0, 0.0, 0.0)", driver.rest)
            self.assertEqual(driver.process.returncode, 0)

    def test_a_client_without_the_token_does_not_end_a_driver(self):
        with Process(sys.executable, self.write("driver.py", DRIVER)) as driver:
            for _ in range(2):
                with self.assertRaisesRegex(trundle.RemoteError, "token"):
                    trundle.connect(int(driver.port), "wrong")
            trundle.connect(int(driver.port), TOKEN).close()

    def test_what_cannot_be_driven_is_refused(self):
        file = self.experiment()
        with serve(file) as server:
            port = server.port
            for more, code, words in ((("--token", "wrong-token"), 1, "the token is wrong"),
                                      (("--token", ""), 1, "a token is needed, that of the served run"),
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
