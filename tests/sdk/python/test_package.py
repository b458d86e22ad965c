"""The Python package for controllers, without a run: python3 -m unittest discover, with core/sdk/python in PYTHONPATH."""

import array
import json
import math
import mmap
import os
import re
import threading
import unittest

import trundle
from trundle.description import INTERFACE, kind_to_json, kinds_to_json
from trundle.device import Peer
from trundle.host import link as link_module
from trundle.host.link import HOST, ControlPage, Link
from trundle.host.module import Fault
from trundle.host.wire import Reader, Writer
from trundle.ports import RobotPorts
from trundle.signals import COMMAND, OUTPUT, SAME_SIGNALS, TRUTH, Entry, Image


class Base(trundle.Controller):
    shared = trundle.field("Shared", 2, trundle.number().within(1, 9), "Of the base.")


class Sample(Base):
    """What it does,
    in short.

    More that is not shown."""

    angle = trundle.field("Angle", math.pi, trundle.degrees().above(0).at_most(360).live(), "Positive turns left.")
    names = trundle.field("Names", ["a"], trundle.text(), "Any number.")
    pair = trundle.field("Pair", (1.0, 2.0), trundle.metres(), "Two.")
    side = trundle.field("Side", "left", trundle.one_of("left|right"), "Where.")
    must = trundle.field("Must", 0.0, trundle.seconds().required(), "Needed.")
    maybe = trundle.field("Maybe", None, trundle.volts(), "Or not.", type=float)
    turns = trundle.output("turns", "", "So far.", type=int)
    goal = trundle.output("goal", "m", "Where.", count=2)


class DescriptionTest(unittest.TestCase):
    def test_kind(self):
        kind = kind_to_json(Sample)
        self.assertEqual((kind["name"], kind["role"], kind["help"]), ("Sample", "controller", "What it does, in short."))
        fields = {f["name"]: f for f in kind["fields"]}
        self.assertEqual(list(fields), ["Angle", "Names", "Pair", "Side", "Must", "Maybe", "Shared"])  # a base's come last
        angle = fields["Angle"]
        self.assertEqual((angle["type"], angle["unit"], angle["default"], angle["count"]), ("number", "deg", [math.pi], [1, 1]))
        self.assertEqual((angle["minimum"], angle["min_exclusive"], angle["maximum"], angle["live"]), (0, True, 360, True))
        self.assertEqual((fields["Names"]["type"], fields["Names"]["count"]), ("text", [0, 100000]))
        self.assertEqual((fields["Pair"]["count"], fields["Pair"]["default"], fields["Pair"]["minimum"]), ([2, 2], [1, 2], None))
        self.assertEqual((fields["Side"]["type"], fields["Side"]["choices"]), ("choice", ["left", "right"]))
        self.assertNotIn("default", fields["Must"])
        self.assertNotIn("default", fields["Maybe"])
        self.assertEqual(fields["Shared"]["type"], "integer")
        self.assertEqual([(s["name"], s["type"], s["count"]) for s in kind["signals"]], [("turns", "integer", 1), ("goal", "real", 2)])
        module = json.loads(kinds_to_json([Sample], [("/a.py", 1, 2)]))
        self.assertEqual((module["format"], module["sources"]), (1, [["/a.py", 1, 2]]))

    def test_refuses_wrong_descriptions(self):
        with self.assertRaises(TypeError):
            trundle.field("A", 1.0, "m", "No quantity.")
        with self.assertRaises(TypeError):
            trundle.field("A", None, trundle.metres(), "No type.")
        with self.assertRaises(TypeError):
            trundle.field("A", {}, trundle.metres(), "No value.")

        for value in (math.nan, math.inf, [1.0, -math.inf]):
            with self.assertRaisesRegex(ValueError, "Far .* no finite number"):
                trundle.field("Far", value, trundle.metres(), "No number.")

        class Much(trundle.Controller):
            all = trundle.output("all", "", "Too many.", count=1001)
        with self.assertRaises(ValueError):
            kind_to_json(Much)

    def test_whole_numbers_of_a_scaled_unit_are_numbers(self):
        """90 degrees and 2500 ms are no whole number of radians and seconds."""
        for value in (0, 1, None):
            more = {"type": int} if value is None else {}
            angle = trundle.field("Angle", value, trundle.degrees(), "Of the arm.", **more)
            self.assertEqual((angle.type, angle.to_python([math.pi / 2], [])), ("number", math.pi / 2))
            wait = trundle.field("Wait", value, trundle.milliseconds(), "At the start.", **more)
            self.assertEqual((wait.to_json()["type"], wait.to_python([2.5], [])), ("number", 2.5))
            count = trundle.field("Count", value, trundle.number(), "Of laps.", **more)
            self.assertEqual((count.type, count.to_python([3.0], [])), ("integer", 3))

    def test_lists_of_texts_and_flags(self):
        names = trundle.field("Names", [], trundle.text(), "Of friends.")
        self.assertEqual((names.to_json()["type"], names.to_python([], ["a", "b"])), ("text", ["a", "b"]))
        flags = trundle.field("Flags", (True, False), trundle.flag(), "Of the sides.")
        self.assertEqual((flags.to_json()["type"], flags.to_json()["count"], flags.to_python([0.0, 1.0], [])), ("boolean", [2, 2], (False, True)))

    def test_values_become_attributes(self):
        sample = Sample()
        self.assertEqual((sample.angle, sample.pair, sample.maybe), (math.pi, (1.0, 2.0), None))
        sample.names.append("b")
        self.assertEqual(sample.names, ["a"])  # the default is not changed
        self.assertEqual(Sample.names.to_python([], ["x", "y"]), ["x", "y"])
        self.assertEqual(Sample.pair.to_python([3.0, 4.0], []), (3.0, 4.0))
        self.assertIs(type(Base.shared.to_python([3.0], [])), int)
        with self.assertRaises(ValueError):
            Sample.pair.to_python([3.0], [])


class RandomTest(unittest.TestCase):
    def test_numbers_of_cpp(self):
        """Expected: printed by randomBits() of core/base/rng.cpp."""
        self.assertEqual(trundle.fnv1a64(b""), 0xcbf29ce484222325)
        self.assertEqual(trundle.fnv1a64(b"a"), 0xaf63dc4c8601ec8c)
        self.assertEqual(trundle.random_bits(1, trundle.fnv1a64(b"robot0"), 2, 3), 0xc152c36ccd5bd2bb)
        self.assertEqual(trundle.random_bits(20261122, trundle.fnv1a64(b"r"), (1 << 64) - 1, 0), 0x56a1cbbff6db7048)
        bits = {trundle.random_bits(seed, 7, tick, index) for seed in range(4) for tick in range(4) for index in range(4)}
        self.assertEqual(len(bits), 64)
        self.assertTrue(all(0 <= b < 1 << 64 for b in bits))


def robot_image(drive="DifferentialDrive"):
    entries = [Entry("r/base/linearVelocity", 1, COMMAND, 1, 0), Entry("r/base/angularVelocity", 1, COMMAND, 1, 1),
               Entry("r/base/linearAmount", 1, COMMAND, 1, 2), Entry("r/base/angularAmount", 1, COMMAND, 1, 3),
               Entry("r/base/sequence", 2, COMMAND, 1, 4), Entry("r/base/finished", 2, OUTPUT, 1, 5),
               Entry("r/base/odometry", 1, OUTPUT, 3, 6), Entry("r/base/pose", 1, TRUTH, 3, 9),
               Entry("r/scan/ranges", 1, OUTPUT, 4, 12), Entry("r/scan/time", 1, OUTPUT, 1, 16),
               Entry("r/brain/turns", 2, OUTPUT, 1, 17), Entry("r/brain/goal", 1, OUTPUT, 2, 18)]
    sensors, commands = memoryview(bytearray(8 * 20)).cast("d"), memoryview(bytearray(8 * 20)).cast("d")
    devices = [(drive, "base", 0.0), ("Lidar", "scan", 0.1)]
    return Image("r", "brain", "Sample", devices, entries, sensors.toreadonly(), commands), sensors, commands


class PortsTest(unittest.TestCase):
    def setUp(self):
        self.image, self.sensors, self.commands = robot_image()
        self.robot = RobotPorts(self.image, 0.01, None)

    def test_drive(self):
        drive = self.robot.differential_drive("base")
        drive.turn(2.0, -1.0)
        self.assertEqual(self.commands[:5].tolist(), [0, -2, 0, -1, 1])
        self.assertFalse(drive.done())
        self.sensors[5] = 1
        self.assertTrue(drive.done())
        self.sensors[6:9] = memoryview(bytearray(24)).cast("d")
        self.sensors[8] = 0.5
        self.assertEqual(drive.odometry().heading, 0.5)

    def test_ranges_are_in_place_and_read_only(self):
        lidar = self.robot.lidar("scan")
        ranges = lidar.ranges()
        self.sensors[13] = 2.5
        self.assertEqual(list(ranges), [0, 2.5, 0, 0])
        with self.assertRaises(TypeError):
            ranges[0] = 1.0
        self.assertTrue(lidar.fresh())
        self.assertFalse(lidar.fresh())

    def test_names(self):
        for bind, words in ((lambda: self.robot.differential_drive("bass"), "did you mean 'base'?"),
                            (lambda: self.robot.lidar("base"), "that is of kind DifferentialDrive"),
                            (lambda: self.robot.signal("base", "pose"), "through the port groundTruth alone"),
                            (lambda: self.robot.signal("base", "speed"), "the signals of base: linearVelocity,"),
                            (lambda: self.image.published("goals"), "the outputs of Sample: turns, goal")):
            with self.assertRaises(trundle.UnknownPort) as raised:
                bind()
            self.assertIn(words, str(raised.exception))
        self.assertTrue(self.robot.has("scan", "ranges") and self.robot.has("scan"))
        self.assertFalse(self.robot.has("scan", "range") or self.robot.has("eye"))
        self.assertEqual(self.robot.ground_truth("base/pose").count, 3)

    def test_a_port_binds_kinds_with_the_same_signals(self):
        for kind in ("SkidDrive", "TrackDrive"):
            image, _, commands = robot_image(kind)
            RobotPorts(image, 0.01, None).differential_drive("base").move(0.2, 0.1)
            self.assertEqual(commands[:2].tolist(), [0.2, 0.1])
            RobotPorts(image, 0.01, None).port("base", "DifferentialDrive").set("linearVelocity", 0.5)
            self.assertEqual(commands[0], 0.5)
        with self.assertRaisesRegex(trundle.UnknownPort, "that is of kind DifferentialDrive"):
            self.robot.skid_drive("base")
        path = os.path.join(os.path.dirname(trundle.__file__), "..", "..", "..", "model", "port_kinds.cpp")
        with open(path, encoding="utf-8") as file:
            pairs = re.findall(r'\{"(\w+)", "(\w+)"\}', file.read())
        self.assertEqual(sorted(pairs), sorted(SAME_SIGNALS))

    def test_only_commands_are_written(self):
        self.robot.signal("base", "finished").set(7)
        self.assertEqual(self.sensors[5], 0)
        self.robot.signal("base", "sequence").set(7)
        self.assertEqual(self.commands[4], 7)

    def test_outputs(self):
        sample = Sample()
        sample.turns = 3  # ignored: not bound
        self.assertEqual(sample.turns, 0)
        sample._outputs = {name: self.image.published(name) for name in ("turns", "goal")}
        sample.turns += 2
        sample.goal = (1, 2)
        sample.goal[1] = 5
        self.assertEqual(self.commands[17:20].tolist(), [2, 1, 5])
        with self.assertRaises(ValueError):
            sample.goal = (1, 2, 3)
        for name, value in (("turns", 10 ** 400), ("goal", (1, 10 ** 400))):
            with self.assertRaisesRegex(ValueError, f"the output {name}: a signal takes no number as large as this"):
                setattr(sample, name, value)


class DriveAmountsTest(unittest.TestCase):
    def setUp(self):
        image, _, self.commands = robot_image()
        self.drive = RobotPorts(image, 0.01, None).differential_drive("base")
        self.amounts = trundle.DriveAmounts()

    def speeds(self):
        return self.amounts.speeds({f"base/{name}": self.commands[i] for i, name in enumerate(trundle.DriveAmounts.SIGNALS)}, 0.02)

    def test_a_move_cancels_an_amount(self):
        for command, speeds in ((lambda: self.drive.move(-0.2, 0.0), (-0.2, 0)), (self.drive.stop, (0, 0)),
                                (lambda: self.drive.drive(0.1, 0.2, 0.0, 0.0), (0.1, 0.2))):
            self.drive.drive(0.3, 0.0, 1.0, 0.0)
            self.assertEqual(self.speeds(), (0.3, 0))
            self.amounts.moved(0.006, 0.0)
            self.assertTrue(self.amounts.outputs()["base/busy"])
            command()
            self.assertEqual(self.speeds(), speeds)
            outputs = self.amounts.outputs()
            self.assertEqual((outputs["base/done"], outputs["base/busy"], outputs["base/finished"]), (True, False, self.commands[4]))

    def test_an_amount_against_its_speed_is_refused(self):
        self.drive.drive(0.3, 0.0, -1.0, 0.0)
        for _ in range(2):
            self.assertEqual(self.speeds(), (0, 0))
            self.assertEqual(self.amounts.outputs()["base/finished"], 1)


class PictureTest(unittest.TestCase):
    def test_pixels(self):
        picture = trundle.Picture(2, 1, 0.5, bytes(range(6)), memoryview(bytearray(8)).cast("f"), b"\1\0\0\0\2\0\0\0")
        self.assertTrue(picture)
        self.assertEqual(picture.pixels.shape, (1, 2, 3))
        self.assertEqual((picture.pixels[0, 1, 2], picture.at(1, 0), picture.at(2, 0)), (5, (3, 4, 5), (0, 0, 0)))
        self.assertEqual((picture.object(1, 0), picture.depth(0, 0), picture.depth(9, 0)), (2, 0.0, math.inf))
        with self.assertRaises(TypeError):
            picture.pixels[0, 0, 0] = 1
        self.assertFalse(trundle.Picture(error="none"))


class PeerTest(unittest.TestCase):
    def test_commands_alone_are_set(self):
        numbers = array.array("d", [1.5, 2.5])
        measured, commanded = Peer(numbers, 0, "motor/current", False), Peer(numbers, 1, "motor/voltage", True)
        with self.assertRaisesRegex(AttributeError, "motor/current is measured, not commanded"):
            measured.value = 77
        commanded.value = 3
        self.assertEqual((measured.value, commanded.value, numbers.tolist()), (1.5, 3.0, [1.5, 3.0]))


class MessagesTest(unittest.TestCase):
    def test_wire(self):
        data = Writer().number("I", 7).bytes("väl").status((410, "why")).status((414, "it", ("/a b.py", 7))).status().bytes(b"\0" * 16).data()
        reader = Reader(data)
        self.assertEqual((reader.number("I"), reader.text()), (7, "väl"))
        self.assertEqual([reader.status() for _ in range(3)], [(410, "why", ("", 0)), (414, "it", ("/a b.py", 7)), None])
        self.assertEqual(reader.numbers("d"), [0.0, 0.0])

    def test_long_messages_cross_in_parts(self):
        """Both ends in this process: the run's end is written out here."""
        capacity = 1 << 20
        offsets = {"turn": 0, "hostSleeps": 4, "phase": 8, "controller": 12, "toHost": 64, "toRun": 128 + capacity,
                   "mailSize": 0, "mailMore": 4, "mailBytes": 64}
        file = os.memfd_create("page")
        os.ftruncate(file, 256 + 2 * capacity)
        page, words = ControlPage(file, offsets), memoryview(mmap.mmap(file, 0)).cast("I")
        words[0] = HOST
        sent, parts = bytes(range(256)) * 10000, []

        def run():
            while True:
                while words[0] == HOST:
                    pass
                size, more = words[offsets["toRun"] // 4], words[offsets["toRun"] // 4 + 1]
                first = offsets["toRun"] + 64
                parts.append(bytes(page.bytes[first:first + size]))
                words[offsets["toRun"] // 4] = 0
                if not more:
                    return
                words[0] = HOST
                link_module._call(link_module._FUTEX, page._address, 1, 1, 0, 0, 0)  # FUTEX_WAKE
        other = threading.Thread(target=run)
        other.start()
        link = Link(page)
        self.assertTrue(link.record(3, 1, sent))
        link.finish_message()
        other.join()
        got = b"".join(parts)
        self.assertEqual(len(parts), 3)
        self.assertEqual(int.from_bytes(got[8:16], "little"), len(sent))
        self.assertEqual(got[16:], sent)

    def test_other_threads_send_nothing(self):
        page = ControlPage.__new__(ControlPage)
        page.offsets = {"toRun": 0, "toHost": 0, "mailBytes": 0}
        link, sent = Link(page), []
        thread = threading.Thread(target=lambda: sent.append(link.record(3, 0, b"x")))
        thread.start()
        thread.join()
        self.assertEqual(sent, [False])


class VersionTest(unittest.TestCase):
    def test_is_that_of_the_headers(self):
        """Otherwise no description would be remembered."""
        header = os.path.join(os.path.dirname(trundle.__file__), "..", "..", "include", "trundle", "abi.h")
        with open(header, encoding="utf-8") as file:
            defined = dict(re.findall(r'#define TRUNDLE_(SDK_VERSION|ABI_MAJOR|ABI_MINOR) "?([0-9.]+)', file.read()))
        self.assertEqual(trundle.__version__, defined["SDK_VERSION"])
        self.assertEqual(INTERFACE, (int(defined["ABI_MAJOR"]), int(defined["ABI_MINOR"])))


class FaultTest(unittest.TestCase):
    def test_names_file_and_line(self):
        def fail():
            return {}["key"]
        try:
            fail()
        except KeyError as error:
            fault = Fault(error)
        self.assertRegex(fault.text, r"^KeyError: 'key', in fail at test_package\.py:\d+$")
        file, line, function = fault.frames[0]
        self.assertEqual((os.path.abspath(file), function), (os.path.abspath(__file__), "fail"))
        self.assertRegex(fault.text, rf"test_package\.py:{line}$")


if __name__ == "__main__":
    unittest.main()
