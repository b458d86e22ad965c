"""The remote control end to end: the real trundle-cli, the real Python client. Started by ctest with TRUNDLE_CLI and PYTHONPATH."""

import json
import math
import os
import random
import re
import select
import socket
import struct
import subprocess
import sys
import tempfile
import unittest

import trundle

CLI = os.environ["TRUNDLE_CLI"]
SOURCE = os.environ["TRUNDLE_SOURCE_DIR"]
EXPERIMENTS = os.path.join(SOURCE, "configs", "experiments")
TWO = """Tick = 0.01   Seed = 4
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule controllers/linear_motion
Static floor { Config=OpenFloor }
Robot rover { Config=SimpleRobot }
Robot other { Config=SimpleRobot Pos=0,2,0 LinearMotion brain { Distance=0.2 Speed=0.2 } }
"""


def hash_of_run(file, ticks, tick=0.01, *more):
    out = subprocess.run([CLI, "run", file, "--duration", repr(ticks * tick), "--hash", "--quiet", "--log-dir", tempfile.mkdtemp(dir=FOLDER.name),
                          *more], check=True, capture_output=True, text=True).stdout
    found = re.search(r"state-hash (\w+) tick (\d+)", out)
    assert int(found[2]) == ticks, out
    return found[1]


def write(name, text):
    path = os.path.join(FOLDER.name, name)
    with open(path, "w") as file:
        file.write(text)
    return path


def setUpModule():
    global FOLDER
    FOLDER = tempfile.TemporaryDirectory()
    write("two.sim", TWO)


def tearDownModule():
    FOLDER.cleanup()


def two():
    return os.path.join(FOLDER.name, "two.sim")


class Server:
    """trundle-cli serve as a process."""

    def __init__(self, file, *more, environment=None):
        self.process = subprocess.Popen([CLI, "serve", file, *more], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                        env={**os.environ, **(environment or {})})
        first = self.process.stdout.readline()
        found = re.fullmatch(r"serving .* at (.+):(\d+)\n", first)
        assert found, first
        self.host, self.port = found[1], int(found[2])
        self.token = self.process.stdout.readline().removeprefix("token ").strip()

    def connect(self, **more):
        return trundle.connect(self.port, self.token, **more)

    def raw(self):
        return socket.create_connection((self.host, self.port))

    def stop(self):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()
        return self.process.returncode

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()


def frame(message, data=b""):
    text = message if isinstance(message, bytes) else json.dumps(message).encode()
    return struct.pack("<II", len(text), len(data)) + text + data


def read_exactly(stream, size):
    data = b""
    while len(data) < size:
        got = stream.recv(size - len(data))
        if not got:
            return data
        data += got
    return data


def read_frame(stream):
    sizes = struct.unpack("<II", read_exactly(stream, 8))
    return json.loads(read_exactly(stream, sizes[0])), read_exactly(stream, sizes[1])


class SimulationTest(unittest.TestCase):
    def test_gives_the_same_bits_as_a_run(self):
        for name, ticks in (("linear_motion", 600), ("python/turn_angle", 400), ("network_navigation", 300), ("swarm", 50)):
            with self.subTest(name), trundle.Simulation(os.path.join(EXPERIMENTS, name + ".sim"), console=None) as sim:
                expected = hash_of_run(os.path.join(EXPERIMENTS, name + ".sim"), ticks, sim.tick_length)
                for _ in range(2):
                    done = 0
                    for step in (1, 2, 7, 40):
                        done += sim.step(step)
                    done += sim.step(ticks - done)
                    self.assertEqual((done, sim.tick, sim.time), (ticks, ticks, round(ticks * sim.tick_length, 9)))
                    self.assertEqual(sim.hash(), expected)
                    sim.reset()

    def test_ports_drive_a_robot_without_a_controller(self):
        with trundle.Simulation(two(), console=None) as sim:
            base, touch = sim.robot("rover").differential_drive("base"), sim.robot("rover").touch("frontTouch")
            truth = sim.robot("rover").ground_truth()
            base.move(0.2, 0)
            sim.step(300)
            driven = base.odometry().x
            self.assertTrue(0.5 < driven < 0.6, driven)
            self.assertAlmostEqual(truth.pose().position[0], driven, 2)
            self.assertFalse(touch.pressed())
            base.turn(1.0, math.pi / 2)
            while not base.done():
                self.assertEqual(sim.step(), 1)
            self.assertAlmostEqual(base.odometry().heading, math.pi / 2, 1)
            # The robot beside it had its own controller all the time.
            self.assertAlmostEqual(sim["other/base/odometry"][0], 0.2, 2)
            first = sim.hash()
            sim.reset()
            self.assertEqual(base.odometry().x, 0)
            base.move(0.2, 0)
            sim.step(300)
            self.assertEqual(base.odometry().x, driven)
            base.turn(1.0, math.pi / 2)
            while not base.done():
                sim.step()
            self.assertEqual(sim.hash(), first)

    def test_no_turn_a_reset_and_numbers_that_are_none(self):
        with trundle.Simulation(two()) as sim:
            base = sim.robot("rover").differential_drive("base")
            base.turn(1, 0)
            sim.step(50)
            self.assertAlmostEqual(sim["rover/chassis/pose"][6], 0, places=6)
            base.drive(0.2, 0, 1, 0)
            sim.step(10)
            self.assertFalse(base.done())
            sim.reset()
            self.assertTrue(base.done())
            base.move(float("nan"), 0)
            with self.assertRaisesRegex(ValueError, "rover/base/linearVelocity was given a value that is no finite number"):
                sim.step()
            with self.assertRaisesRegex(ValueError, "position was given a value that is no finite number"):
                sim.place("rover", (0, float("nan"), 0))
            sim.step()
            base.drive(0.2, 0, 1, 0)
            self.assertFalse(base.done())

    def test_numbers_like_those_of_numpy(self):
        class Number:
            def __init__(self, value):
                self.value = value

            def tolist(self):
                return self.value

        with trundle.Simulation(two()) as sim:
            sim["rover/base/linearVelocity"] = Number(0.3)
            sim.step(Number(3))
            self.assertAlmostEqual(sim["rover/base/linearVelocity"], 0.3)
            sim.place("rover", [Number(1), 2, Number(0)])
            sim.step()
            self.assertAlmostEqual(sim["rover/pose"][1], 2, places=3)
            sim.reset(seed=Number(4))

    def test_player_interfaces(self):
        with trundle.Simulation(two(), console=None) as sim:
            devices = {d["device"]: d["interface"] for d in sim.robots()["rover"]["devices"]}
            self.assertEqual(devices["rover/base"], "position2d")
            self.assertEqual(devices["rover/leftEncoder"], "position1d")
            self.assertEqual(devices["rover/frontTouch"], "bumper")
            sim.command("rover/base", vel=[0.1, 0.5])
            sim.step(200)
            pose = sim.device("rover/base")["pos"]
            self.assertTrue(pose[2] > 0.8, pose)
            self.assertEqual(sim.device("rover/frontTouch"), {"bumped": False, "force": 0.0, "count": 0})
            sim.command("rover/leftMotor", vel=1.0)  # the drive, which acts later, has the last word
            described = sim.describe("rover")
            self.assertEqual(next(d for d in described["devices"] if d["name"] == "base")["commands"], {"vel": 2})

    def test_a_controller_owns_the_commands_of_its_robot(self):
        with trundle.Simulation(two(), console=None) as sim:
            base = sim.robot("other").differential_drive("base")
            with self.assertRaisesRegex(trundle.RemoteError, "the controller brain of other owns other/base/linearVelocity; hold other first") as refused:
                sim["other/base/linearVelocity"] = 1
            self.assertEqual(refused.exception.code, "owned")
            base.move(0.1, 0.1)
            with self.assertRaises(trundle.RemoteError):
                sim.step()
            self.assertEqual(sim.tick, 0)
            sim.step(100)  # what was refused is forgotten
            self.assertTrue(sim["other/base/odometry"][0] > 0.1)
            sim.hold("other")
            base.stop()
            sim.step(50)
            still = sim["other/base/odometry"][0]
            sim.step(100)
            self.assertEqual(sim["other/base/linearVelocity"], 0)
            self.assertAlmostEqual(sim["other/base/odometry"][0], still, 6)
            sim.hold("other", False)
            with self.assertRaises(trundle.RemoteError):
                sim["other/base/linearVelocity"] = 0

    def test_seeds(self):
        with trundle.Simulation(os.path.join(EXPERIMENTS, "swarm.sim"), console=None) as sim:
            seed = sim.seed
            sim.step(20)
            first = sim.hash()
            sim.reset(seed=99)
            self.assertEqual(sim.seed, 99)
            sim.step(20)
            self.assertEqual(sim.hash(), hash_of_run(os.path.join(EXPERIMENTS, "swarm.sim"), 20, sim.tick_length, "--seed", "99"))
            sim.reset()
            self.assertEqual(sim.seed, 99)
            sim.reset(seed=seed)
            sim.step(20)
            self.assertEqual(sim.hash(), first)
        with trundle.Simulation(two(), seed=7, console=None) as sim:
            self.assertEqual(sim.seed, 7)

    def test_values_of_python_are_set(self):
        sets = {"rover.Pos": (1, 0.5, 0), "other.Pos": [0, -1, 0], "rover.SelfCollision": False, "other.SelfCollision": True,
                "Title": 'two "fast" rovers', "Tick": "20 ms", "Duration": 1e-5, "Description": "\u00c4nne"}
        with trundle.Simulation(two(), console=None, sets=sets) as sim:
            self.assertEqual((list(sim["rover/pose"][:2]), list(sim["other/pose"][:2])), ([1, 0.5], [0, -1]))
            self.assertEqual(sim.tick_length, 0.02)
        with trundle.Simulation(two(), console=None, sets={"rover.Pos": "1,0.5,0"}) as sim:
            self.assertEqual(list(sim["rover/pose"][:2]), [1, 0.5])

    def test_nothing_can_be_asked_after_close(self):
        sim = trundle.Simulation(two(), console=None)
        readings = sim.subscribe("rover/pose")
        sim.close()
        for ask in (sim.step, sim.hash, lambda: sim.next(readings), lambda: sim["rover/pose"]):
            with self.assertRaisesRegex(trundle.Disconnected, "closed"):
                ask()

    def test_a_changed_file_does_not_change_the_run(self):
        path = write("changed.sim", TWO)
        with trundle.Simulation(path, console=None) as sim:
            sim.step(10)
            first = sim.hash()
            write("changed.sim", "no { text")
            sim.reset(seed=4)
            sim.step(10)
            self.assertEqual(sim.hash(), first)

    def test_errors_have_their_place(self):
        path = write("broken.sim", "Tick = 0.01\nRobot r { Config=Nope }\n")
        with self.assertRaises(trundle.TextError) as failed:
            trundle.Simulation(path)
        self.assertIn(f"{path}:2:18: error E208: Config names Nope", str(failed.exception))
        self.assertEqual([(d["line"], d["column"], d["code"]) for d in failed.exception.diagnostics], [(2, 18, "E208")])
        with self.assertRaisesRegex(trundle.TextError, "none.sim does not exist"):
            trundle.Simulation(os.path.join(FOLDER.name, "none.sim"))
        with self.assertRaisesRegex(trundle.Disconnected, "exit code 2:\n.*--modules: Directory does not exist"):
            trundle.Simulation(two(), modules="/no/such/folder")
        with self.assertRaisesRegex(trundle.TextError, "error E201: "):
            trundle.Simulation(two(), sets={"other.brain.Sped": 1})
        with self.assertRaises(FileNotFoundError):
            trundle.Simulation(two(), program="/no/such/program")

    def test_the_end_of_a_run(self):
        with trundle.Simulation(os.path.join(EXPERIMENTS, "line_follow.sim"), console=None, sets={"Duration": 0}) as sim:
            while sim.state != "ended":
                sim.step(2000)
                self.assertTrue(sim.time < 600)
            self.assertRegex(sim.end_reason, "the controller .* finished it: ")
            with self.assertRaises(trundle.RemoteError) as over:
                sim.step()
            self.assertEqual(over.exception.code, "ended")
            sim.reset()
            self.assertEqual((sim.state, sim.step(3)), ("paused", 3))

    def test_a_fault_of_a_controller_stays_with_its_robot(self):
        path = write("sick.sim", TWO + '#loadModule sick.py\nRobot bad { Config=SimpleRobot Pos=0,-2,0 Sick brain { Action=abort } }\n')
        lines = []
        with trundle.Simulation(path, modules=os.path.join(SOURCE, "tests", "flow", "python"),
                                console=lambda time, who, severity, text: lines.append((who, severity, text))) as sim:
            self.assertEqual(sim.step(150), 150)
            stopped = sim.status()["stopped"]
            self.assertEqual([s["robot"] for s in stopped], ["bad"])
            self.assertIn("crashed in update: Aborted", stopped[0]["reason"])
            self.assertAlmostEqual(sim["other/base/odometry"][0], 0.2, 2)
            self.assertTrue(any(severity == "error" or "Aborted" in text for _, severity, text in lines), lines)
            self.assertTrue(any(who == "other" for who, _, _ in lines), lines)

    def test_a_restart_reads_the_file_again(self):
        """Also after an exception, which leaves the process as it was. The other robot of the file keeps its code."""
        def mine(update, field="1.0"):
            write("parts.py", f"def update(controller):\n    {update}\n")
            write("mine.py", "import trundle\nimport parts\n\n\nclass Mine(trundle.Controller):\n    "
                  f"speed = trundle.field('Speed', {field}, trundle.number(), 'x')\n    count = trundle.output('count', '', 'x')\n\n"
                  "    def update(self, since_last):\n        parts.update(self)\n")

        mine("controller.count += controller.speed if controller.speed == 2 else 1 / 0")
        path = write("restarted.sim", TWO + "#loadModule mine.py\nRobot bad { Config=SimpleRobot Pos=0,-2,0 Mine brain { } }\n"
                     "Robot good { Config=SimpleRobot Pos=0,-3,0 Mine brain { Speed=2 } }\n")

        with trundle.Simulation(path, console=None, trust=True) as sim:
            def restart():
                sim.restart("bad")
                sim.step(2)
                return [stopped["reason"] for stopped in sim.status()["stopped"]]

            sim.step(2)
            self.assertIn("ZeroDivisionError", sim.status()["stopped"][0]["reason"])
            self.assertIn("ZeroDivisionError", restart()[0])
            mine("no python")
            self.assertRegex(restart()[0], "mine.py cannot be loaded: SyntaxError: .* at parts.py:2")
            mine("pass", field="'a'")
            self.assertIn("it has other properties or published values now: reset the run to use it", restart()[0])
            mine("controller.count = 7")
            self.assertEqual(restart(), [])
            self.assertEqual((sim["bad/brain/count"], sim["good/brain/count"]), (7, 2 * sim.tick))

    def test_a_tick_that_fails_is_no_step(self):
        path = write("fails.sim", TWO + "#loadModule fails.py\nRobot bad { Config=SimpleRobot Pos=0,-2,0 Fails brain { } }\n")
        write("fails.py", "import trundle\n\n\nclass Fails(trundle.Controller):\n    def update(self, since_last):\n"
              "        if self.time > 0.195:\n            self.fail('enough')\n")
        with trundle.Simulation(path, console=None, trust=True) as sim:
            self.assertEqual((sim.step(100), sim.tick, sim.state), (20, 20, "ended"))
            self.assertEqual(sim.end_reason, "at t = 0.2 s the controller Fails of bad gave up: enough")
            for change in (lambda: sim.place("rover", (1, 1, 0)), lambda: sim.push("rover/chassis", (1, 0, 0), (0, 0, 0)), sim.step,
                           lambda: sim.hold("other"), lambda: sim.restart("bad"), lambda: sim.run(),
                           lambda: sim.command("rover/base", vel=[0.1, 0])):
                with self.assertRaisesRegex(trundle.RemoteError, "the run is over, reset it: at t = 0.2 s") as over:
                    change()
                self.assertEqual(over.exception.code, "ended")
            self.assertEqual(sim.status()["state"], "ended")

    def test_ctrl_c_ends_a_step(self):
        def interrupt(time, who, severity, text):
            raise KeyboardInterrupt  # as it would be if Ctrl+C came here

        with trundle.Simulation(two(), console=interrupt) as sim:
            with self.assertRaises(KeyboardInterrupt):
                sim.step(10 ** 9)
            tick = sim.status()["tick"]
            self.assertTrue(100 < tick < 10 ** 8, tick)
            self.assertEqual((sim.step(5), sim.tick), (5, tick + 5))

    def test_radios(self):
        """Without a medium of walls or noise: what one sends, the other one has received some ticks later."""
        radios = "".join(f"Robot m{i} {{ Config=TmoteSky Pos={i},0,0 }}\n" for i in range(2))
        path = write("radios.sim", "Tick = 0.01\n#import robots/tmote_sky.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                     "RadioMedium air { Model=ideal }\n#loadModule controllers/mote\n" + radios + "Robot owned { Config=TmoteSky Pos=0,1,0 Mote brain { } }\n")
        with trundle.Simulation(path, console=None) as sim:
            name = next(d["device"] for d in sim.robots()["m0"]["devices"] if d["interface"] == "wsn").split("/")[1]
            first, second = (sim.robot(robot).radio(name) for robot in ("m0", "m1"))
            self.assertNotEqual(first.address, second.address)
            self.assertTrue(first.send("hello", to=second.address))
            self.assertFalse(first.send("x" * 117))
            sim.step(10)
            packet = second.receive()
            while packet and packet.sender != first.address:  # a beacon of the third
                packet = second.receive()
            self.assertEqual((packet.bytes, packet.sender, packet.receiver), (b"hello", first.address, second.address))
            self.assertTrue(-60 < packet.rssi < -20 and 0 < packet.time < 0.1, packet)
            self.assertEqual(sim[f"m0/{name}/sent"], 1)
            with self.assertRaises(trundle.RemoteError) as owned:
                sim.robot("owned").radio(name).send("x")
            self.assertEqual(owned.exception.code, "owned")
            while second.receive():
                pass
            self.assertIsNone(second.receive())

    def test_images(self):
        path = write("camera.sim", TWO.replace("simple_robot", "camera_robot").replace("SimpleRobot", "CameraRobot"))
        with trundle.Simulation(path, console=None) as sim:
            picture = sim.robot("rover").camera("eye").capture()
            self.assertTrue(picture, picture.error)
            self.assertEqual(len(picture.pixels.tobytes()), picture.width * picture.height * 3)
            self.assertTrue(len({picture.at(0, y) for y in range(picture.height)}) > 2)

    def test_the_process_ends_with_the_one_that_started_it(self):
        for end in ("os.kill(os.getpid(), 9)", "sys.exit()", "sim.step(0); os._exit(1)"):
            parent = subprocess.run([sys.executable, "-c", f"import os, sys, trundle\nsim = trundle.Simulation({two()!r}, console=None)\n"
                                     f"print(sim._process.pid, flush=True)\n{end}"], capture_output=True, text=True)
            try:
                child = os.pidfd_open(int(parent.stdout))
            except ProcessLookupError:
                continue
            self.assertTrue(select.select([child], [], [], 60)[0], end)
            os.close(child)


class ServerTest(unittest.TestCase):
    def test_the_same_bits_over_tcp(self):
        file = os.path.join(EXPERIMENTS, "linear_motion.sim")
        with Server(file) as server, server.connect() as remote:
            self.assertEqual(remote.step(250), 250)
            self.assertEqual(remote.hash(), hash_of_run(file, 250))
            self.assertEqual(remote.experiment, "linear_motion")

    def test_without_the_token_there_is_nothing(self):
        with Server(two()) as server:
            self.assertRegex(server.token, "^[0-9a-f]{32}$")
            for token in ("", "0" * 32, server.token[:-1], server.token + "0", server.token.upper() + "x"):
                with self.assertRaises(trundle.RemoteError) as refused:
                    trundle.connect(server.port, token)
                words = "the token is wrong" if token else "a token is needed, that of the served run"
                self.assertEqual((refused.exception.code, str(refused.exception)), ("unauthorized", words))
            for operation in ("status", "step", "run", "reset", "list"):
                with server.raw() as stream:
                    stream.sendall(frame({"id": 1, "op": operation}))
                    self.assertEqual(read_frame(stream)[0]["error"], "unauthorized")
                    self.assertEqual(stream.recv(1), b"")  # closed
            with server.connect() as remote:
                self.assertEqual((remote.tick, remote.state), (0, "paused"))

    def test_the_token_is_kept_secret(self):
        path = os.path.join(FOLDER.name, "my.token")
        with subprocess.Popen([CLI, "serve", two(), "--token-file", path], stdout=subprocess.PIPE, text=True, stderr=subprocess.DEVNULL) as process:
            port = int(process.stdout.readline().rsplit(":", 1)[1])
            self.assertEqual(os.stat(path).st_mode & 0o777, 0o600)
            with open(path) as file:
                trundle.connect(port, file.read().strip()).close()
            again = subprocess.run([CLI, "serve", two(), "--token-file", path], capture_output=True, text=True)
            self.assertEqual(again.returncode, 2)
            self.assertIn("cannot create " + path, again.stderr)
            process.terminate()
            self.assertEqual(process.stdout.read(), "")
        self.assertFalse(os.path.exists(path))
        with Server(two(), environment={"TRUNDLE_TOKEN": "a token of mine"}) as server:
            trundle.connect(server.port, "a token of mine").close()
        short = subprocess.run([CLI, "serve", two(), "--token", "short"], capture_output=True, text=True)
        self.assertEqual(short.returncode, 2)
        self.assertIn("a token has at least 8 characters", short.stderr)

    def test_listens_on_loopback_unless_told_otherwise(self):
        with Server(two()) as server:
            self.assertEqual(server.host, "127.0.0.1")
            with open("/proc/net/tcp") as table:
                local = [line.split()[1] for line in table if line.split()[3] == "0A"]
            self.assertIn(f"0100007F:{server.port:04X}", local)
            self.assertNotIn(f"00000000:{server.port:04X}", local)
            busy = subprocess.run([CLI, "serve", two(), "--port", str(server.port)], capture_output=True, text=True)
            self.assertEqual(busy.returncode, 2)
            self.assertIn(f"cannot listen at 127.0.0.1:{server.port}: Address already in use", busy.stderr)
        named = subprocess.run([CLI, "serve", two(), "--host", "example.org"], capture_output=True, text=True)
        self.assertIn("it is not a numeric address", named.stderr)

    def test_two_clients(self):
        with Server(two()) as server, server.connect() as driver, server.connect() as watcher:
            odometry = watcher.subscribe("rover/base/odometry", "rover/pose", every=10)
            driver["rover/base/linearVelocity"] = 0.2
            driver.step(100)
            seen = [watcher.next(odometry) for _ in range(10)]
            self.assertEqual([r.tick for r in seen], list(range(10, 101, 10)))
            self.assertEqual(list(seen[9]["rover/base/odometry"]), driver["rover/base/odometry"])
            self.assertEqual(len(seen[9]["rover/pose"]), 7)
            self.assertEqual(watcher["rover/base/linearVelocity"], 0.2)
            driver.reset()
            self.assertEqual(watcher.status()["tick"], 0)
            watcher.step(3)
            self.assertEqual(driver.status()["tick"], 3)

    def test_free_running(self):
        with Server(two(), "--free-run", "--speed", "0") as server, server.connect() as remote:
            self.assertEqual(remote.state, "running")
            with self.assertRaises(trundle.RemoteError) as busy:
                remote.step()
            self.assertEqual(busy.exception.code, "busy")
            base = remote.robot("rover").differential_drive("base")
            base.move(0.2, 0)
            remote.update()
            readings = remote.subscribe("rover/base/linearVelocity")
            while remote.next(readings)["rover/base/linearVelocity"] != 0.2:
                pass
            remote.update()
            self.assertEqual(base.get("linearVelocity"), 0.2)
            remote.pause()
            tick = remote.tick
            self.assertEqual(remote.status()["tick"], tick)
            remote.run(speed=1)
            remote.unsubscribe(readings)
            readings = remote.subscribe("rover/base/odometry")
            self.assertTrue(remote.next(readings).tick > tick)

    def test_a_free_run_pauses_at_its_duration(self):
        path = write("short.sim", TWO + "Duration = 0.5\n")
        with Server(path) as server, server.connect() as remote:
            readings = remote.subscribe("rover/base/odometry")
            remote.run(speed=0)
            while remote.next(readings).tick < 50:
                pass
            status = remote.status()
            self.assertEqual((status["tick"], status["state"]), (50, "paused"))
            self.assertEqual(remote.hash(), hash_of_run(path, 50))
            remote.step(5)
            self.assertEqual(remote.tick, 55)

    def test_a_slow_reader_does_not_hold_the_clock(self):
        with Server(two()) as server, server.connect() as slow, server.connect() as quick:
            everything = slow.subscribe("*")
            quick.step(20000)  # without slow reading anything
            self.assertEqual(quick.tick, 20000)
            self.assertEqual(quick.hash(), hash_of_run(two(), 20000))
            skipped, tick = 0, 0
            while tick < 20000:
                reading = slow.next(everything)
                self.assertEqual(reading.tick, tick + reading.skipped + 1)
                skipped, tick = skipped + reading.skipped, reading.tick
            self.assertTrue(skipped > 0)

    def test_what_is_no_frame(self):
        with Server(two()) as server, server.connect() as healthy:
            values = random.Random(18)
            hello = frame({"id": 1, "op": "hello", "token": server.token})
            step = frame({"id": 2, "op": "step", "ticks": 5})
            for cut in range(0, len(hello + step), 3):
                with server.raw() as stream:
                    stream.sendall((hello + step)[:cut])  # gone in the middle
            with server.raw() as stream:
                stream.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
                reply = read_frame(stream)[0]
                self.assertEqual(reply["error"], "bad_frame")
                self.assertIn("is too large", reply["message"])
                self.assertEqual(stream.recv(1), b"")
            for _ in range(200):
                with server.raw() as stream:
                    stream.sendall((hello if values.random() < 0.5 else b"") + values.randbytes(values.randrange(2000)))
            with server.raw() as stream:
                stream.sendall(hello + frame(b"{") + frame(b"\xff\xfe") + frame(b"[" * 100000) + step)
                replies = [read_frame(stream)[0] for _ in range(5)]
                self.assertEqual([r.get("error") for r in replies], [None] + ["bad_request"] * 3 + [None])
            self.assertTrue(healthy.step(10) == 10 and healthy.tick >= 15)

    def test_too_many_clients(self):
        with Server(two()) as server:
            clients = [server.connect() for _ in range(16)]
            with self.assertRaises(trundle.RemoteError) as full:
                server.connect()
            self.assertEqual(full.exception.code, "full")
            clients.pop().close()
            clients[0].status()  # by then it was seen that one has gone
            clients[0].status()
            clients.append(server.connect())
            self.assertEqual(clients[-1].step(), 1)
            for client in clients:
                client.close()

    def test_the_example_of_the_guide(self):
        with open(os.path.join(SOURCE, "resources", "guide", "remote.md")) as page:
            text = page.read()
        example = write("watch.py", re.search("```python watch.py\n(.*?)```", text, re.DOTALL)[1])
        with Server(two()) as server:
            shown = subprocess.run([sys.executable, example, str(server.port), server.token], capture_output=True, text=True, check=True).stdout
        times = [float(line.split()[0]) for line in shown.splitlines()]
        self.assertEqual(times, [round(0.1 * i, 1) for i in range(1, 11)])

    def test_ends_in_order(self):
        logs = os.path.join(FOLDER.name, "logs")
        server = Server(write("logged.sim", TWO + "PoseLog path { Robot=rover }\n"), "--log-dir", logs)
        remote = server.connect()
        remote.step(100)
        self.assertEqual(server.stop(), 0)
        with self.assertRaises(trundle.Disconnected):
            remote.status()
        remote.close()
        with open(os.path.join(logs, "path.csv")) as log:
            self.assertEqual(len(log.readlines()), 102)

    def test_a_text_with_errors_is_not_served(self):
        failed = subprocess.run([CLI, "serve", write("bad.sim", "Robot r { Config=Nope }\n")], capture_output=True, text=True)
        self.assertEqual((failed.returncode, failed.stdout), (1, ""))
        self.assertIn("bad.sim:1:18: error E208", failed.stderr)


if __name__ == "__main__":
    unittest.main()
