"""What ports of a served run send, and what they show: several clients, resets, callbacks. Started by ctest with TRUNDLE_CLI and PYTHONPATH."""

import os
import signal
import tempfile
import threading
import unittest

import trundle

ROBOTS = """Tick = 0.01   Seed = 4   Duration = 0.05
#import robots/simple_robot.sim
#import arenas/open_floor.sim
#loadModule controllers/linear_motion
Static floor { Config=OpenFloor }
Robot rover { Config=SimpleRobot }
Robot two { Config=SimpleRobot Pos=0,1,0 }
Robot other { Config=SimpleRobot Pos=0,2,0 LinearMotion brain { Distance=0.5 Speed=0.1 } }
"""
SPEED = "rover/base/linearVelocity"


class PortsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def start(self, text=ROBOTS, **more):
        sim = trundle.Simulation(self.write("robots.sim", text), console=more.pop("console", None), **more)
        self.addCleanup(sim.close)
        return sim

    def driven(self, act):
        """How far the robot drives along x in a second, if `act` is given the simulation and the port of its drive before it."""
        sim = self.start()
        base = sim.robot("rover").differential_drive("base")
        act(sim, base)
        sim.step(100)
        return base.odometry().x

    def test_what_is_set_is_sent_with_the_next_step(self):
        expected = self.driven(lambda sim, base: base.move(0.3, 0))
        self.assertGreater(expected, 0.2)
        between = {"another robot": lambda sim: sim.robot("two"), "a read": lambda sim: sim[SPEED], "a hold": lambda sim: sim.hold("other"),
                   "a hold that ends": lambda sim: sim.hold("other", False), "the same": lambda sim: sim.robot("rover")}
        for name, act in between.items():
            with self.subTest(name):
                self.assertEqual(self.driven(lambda sim, base: (base.move(0.3, 0), act(sim))), expected)

    def test_the_last_value_counts(self):
        fast, slow = (self.driven(lambda sim, base: base.move(v, 0)) for v in (0.3, 0.1))

        def set_by_path(sim, base):
            base.move(0.3, 0)
            sim[SPEED] = 0.1

        def set_by_port(sim, base):
            sim[SPEED] = 0.1
            base.move(0.3, 0)

        self.assertEqual(self.driven(set_by_path), slow)
        self.assertEqual(self.driven(set_by_port), fast)

    def test_the_same_value_again_counts_too(self):
        """Somebody else has set another one since."""
        def others(sim, base):
            base.move(0.3, 0)
            sim.step(1)
            sim[SPEED] = 0.1
            base.move(0.3, 0)

        self.assertAlmostEqual(self.driven(others), 0.3, delta=0.05)

        def reset(sim, base):
            base.move(0.3, 0)
            sim.step(10)
            sim.reset()
            base.move(0.3, 0)

        self.assertEqual(self.driven(reset), self.driven(lambda sim, base: base.move(0.3, 0)))

    def test_values_that_are_none(self):
        sim = self.start()
        for value in (float("nan"), float("inf"), 10 ** 400, (0.1, float("-inf"))):
            with self.assertRaisesRegex(ValueError, SPEED):
                sim[SPEED] = value
        with self.assertRaisesRegex(TypeError, SPEED):
            sim[SPEED] = "fast"
        base = sim.robot("rover").differential_drive("base")
        base.move(float("nan"), 0)
        with self.assertRaisesRegex(ValueError, SPEED):
            sim.step()
        base.move(0.3, 0)
        self.assertEqual(sim.step(2), 2)

    def test_ports_outlive_a_reset_that_failed(self):
        good = "import trundle\nclass Idle(trundle.Controller):\n    def update(self, dt):\n        pass\n"
        module = self.write("idle.py", good)
        sim = self.start(ROBOTS.replace("#loadModule controllers", "#loadModule idle.py\n#loadModule controllers") +
                         "Robot third { Config=SimpleRobot Pos=0,3,0 Idle brain {} }\n", modules=[self.folder])
        base = sim.robot("rover").differential_drive("base")
        self.write("idle.py", "class Idle(\n")
        with self.assertRaises(trundle.TextError):
            sim.reset()
        sim.status()
        self.write("idle.py", good)
        os.utime(module, ns=(1, 1))
        sim.reset()
        base.move(0.3, 0)
        sim.step(100)
        self.assertGreater(base.odometry().x, 0.2)

    def test_a_refused_reset_changes_nothing(self):
        sim, refused = self.start(), []
        sim.robot("rover")

        def reset_wrongly():
            for seed in (-1, 0.5):
                try:
                    sim._request("reset", seed=seed)
                except trundle.RemoteError as error:
                    refused.append(error.code)

        sim.step(3)
        subscription = sim.subscribe("rover/base/odometry")
        reset_wrongly()
        self.assertEqual(refused, ["bad_request"] * 2)
        self.assertEqual((sim.step(4), sim.tick), (4, 7))
        self.assertEqual([sim.next(subscription).tick for _ in range(4)], [4, 5, 6, 7])

    def test_a_callback_may_ask(self):
        source = ("import trundle\nclass Talks(trundle.Controller):\n    def setup(self, robot):\n        self.robot = robot\n"
                  "    def update(self, dt):\n        self.robot.print('at', self.robot.time)\n")
        self.write("talks.py", source)
        seen = []
        sim = self.start(ROBOTS.replace("#loadModule controllers", "#loadModule talks.py\n#loadModule controllers") +
                         "Robot third { Config=SimpleRobot Pos=0,3,0 Talks brain {} }\n", modules=[self.folder],
                         console=lambda *_: seen.append(sim["rover/base/odometry"]))
        self.assertEqual(sim.step(5), 5)
        self.assertTrue(seen and all(len(each) == 3 for each in seen))
        self.assertEqual(sim.step(2), 2)

    def test_why_it_pauses(self):
        sim = self.start()
        sim.run(0)
        while sim.state == "running":
            sim.update()
        self.assertEqual(sim.tick, 5)
        self.assertIn("Duration", sim.end_reason)
        sim.status()
        self.assertIn("Duration", sim.end_reason)
        sim.step()
        self.assertEqual(sim.end_reason, "")

    def test_the_slowest_speeds(self):
        sim = self.start()
        for speed in (1e-9, 1e-12, 1e-300):
            sim.run(speed)
            sim.update()
            sim.pause()
            self.assertEqual(sim.tick, 0)

    def test_a_forked_process_does_not_hold_it(self):
        sim = self.start()
        child = os.fork()
        if child == 0:
            signal.pause()
            os._exit(0)
        try:
            sim.close()
            self.assertEqual(sim._process.returncode, 0)  # not ended by force, after 10 s
        finally:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)

    def test_another_thread_may_close_it(self):
        sim, caught = self.start(ROBOTS.replace("Duration = 0.05", "")), []
        waiter = threading.Thread(target=lambda: caught.append(self._error_of(lambda: sim.step(10 ** 9))))
        waiter.start()
        while not sim._awaited:
            pass
        sim.close()
        waiter.join()
        self.assertIsInstance(caught[0], trundle.Disconnected)

    @staticmethod
    def _error_of(act):
        try:
            act()
        except Exception as error:  # whatever it is
            return error
        return None

    def test_numbers_of_sensors_have_names_without_a_picture(self):
        sim = self.start(ROBOTS + """
RobotConfig Eye {
  Body b { Box b { Size=0.02,0.02,0.02 Mass=1 } }
  Fixed f { Parent=world Child=b }
  RangeSensor r { Body=b MaxRange=9 }
}
StaticConfig Screen { Box seen { Size=0.1,1,1 } Box unseen { Size=0.1,1,1 Pos=0,2,0 Visible=false } }
Static screen { Config=Screen Pos=4,-5,0.5 }
Robot left { Config=Eye Pos=0,-5,0.5 }
Robot right { Config=Eye Pos=0,-3,0.5 }
""")
        sim.step()
        for robot, name in (("left", "screen/seen"), ("right", "screen/unseen")):
            port = sim.robot(robot)
            self.assertEqual(port.object_name(int(sim[f"{robot}/r/object"])), name)
            self.assertEqual([port.object_name(n) for n in (0, -1, 10_000)], ["", "", ""])

    def test_resets_take_no_memory(self):
        sim = self.start("\n".join([ROBOTS] + [f"Robot r{i} {{ Config=SimpleRobot Pos=2,{i},0 }}" for i in range(20)]))

        def resident():
            with open(f"/proc/{sim._process.pid}/statm") as file:
                return int(file.read().split()[1]) * 4096

        for _ in range(100):
            sim.reset()
        before = resident()
        for _ in range(200):
            sim.reset()
        self.assertLess(resident() - before, 2_000_000)  # it was 28 kB for each of them

    def test_commands_take_no_memory(self):
        sim = self.start(ROBOTS.replace("Duration = 0.05", ""))
        base = sim.robot("rover").differential_drive("base")

        def resident():
            with open(f"/proc/{sim._process.pid}/statm") as file:
                return int(file.read().split()[1]) * 4096

        def drive(steps):
            for i in range(steps):
                base.move(0.1 * (i % 3), 0.2)
                sim.step()

        drive(500)
        before = resident()
        drive(3000)
        self.assertLess(resident() - before, 400_000)  # it was 320 B for each of them


if __name__ == "__main__":
    unittest.main()
