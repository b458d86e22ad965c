// Components in Python: the same numbers as in C++, all that they reach, their faults, their descriptions.
#include "flow/cli.h"

namespace {

const QString kPython = QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/flow/python");

const QByteArray kRoom =
    "StaticConfig Room { Plane floor { Surface=ground Material=concrete } Box east { Pos=1.5,0,0.2 Size=0.1,4,0.4 }\n"
    "  Box west { Pos=-1.5,0,0.2 Size=0.1,4,0.4 } Cylinder pillar { Pos=0.5,1,0.2 Radius=0.2 Length=0.4 }\n"
    "  Box south { Pos=0,-1.5,0.2 Size=4,0.1,0.4 } Box north { Pos=0,1.9,0.2 Size=4,0.1,0.4 } }\n"
    "Static room { Config=Room }\n";

QJsonObject jsonOf(const Outcome& outcome) { return QJsonDocument::fromJson(outcome.out).object(); }

} // namespace

class PythonComponentsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString at(const QString& name) const { return m_folder.filePath(name); }
    Outcome run(const QByteArray& text, const QStringList& more = {}) {
        QDir(at("logs")).removeRecursively();
        if (!writeFile(at("it.sim"),
                       "Tick=0.01 Duration=2 Seed=4\n#import common/materials.sim\n#import common/surfaces.sim\n" + text))
            return {};
        return cli(QStringList{"run", at("it.sim"), "--json", "--trust", "--log-dir", at("logs")} + more);
    }
    /// The shipped robot with one more device, twice, as wanderers in a room.
    QByteArray wanderers(const QByteArray& device, const QByteArray& signal) const {
        QByteArray robot = contentOf(configPath("robots/simple_robot.sim"));
        robot.replace("SimpleRobot", "Eyed");
        robot.insert(robot.lastIndexOf('}'), "  " + device + "\n");
        return robot + kRoom + "#loadModule controllers/random_drive\n" +
               "Robot a { Config=Eyed RandomDrive brain { Speed=0.3 TurnRate=1 Period=1 } }\n"
               "Robot b { Config=Eyed Pos=-0.8,0.3,0 RandomDrive brain { Speed=0.3 TurnRate=1 Period=1 } }\n"
               "SignalLog seen { Signals=a/eye/" +
               signal + ",b/eye/" + signal + " Interval=0 File=seen.csv }\n";
    }
    /// A robot with a device of the class Mine in mine.py.
    Outcome runMine(const QByteArray& python) {
        if (!writeFile(at("mine.py"),
                       "import os\nimport trundle\n\n\nclass Mine(trundle.Device):\n    \"\"\"It.\"\"\"\n" + python))
            return {};
        return run(
            "#loadModule mine.py\nRobotConfig R { Body body { Sphere ball { Radius=0.1 Mass=1 Surface=ground Material=red } }\n"
            "  Mine device { } }\nRobot r { Config=R Pos=0,0,1 }\n");
    }

private Q_SLOTS:
    /// The template, with every error of a range, beside a lidar of one beam.
    void aSensorMeasuresAsInCpp() {
        const Outcome made = cli({"new", "component", "Eye", "--python", "--in", m_folder.path()});
        QVERIFY2(made.code == 0 && made.out.contains("#loadModule eye/eye.py") && !made.out.contains("cmake"), shown(made));
        const QByteArray rest =
            " Body=chassis Pos=0.17,0,0.05 HPR=0,5,0 Noise=0.01 NoisePerMetre=0.02 Outliers=0.05 Dropouts=0.05 "
            "Resolution=0.001 UpdatePeriod=0.03 Latency=0.02 Power=0.1 MaxRange=2 }";
        const Outcome python = run("#loadModule eye/eye.py\n" + wanderers("Eye eye {" + rest, "distance"), {"--duration", "10"});
        QVERIFY2(python.code == 0, shown(python).right(3000));
        const QList<QByteArray> ours = contentOf(at("logs/seen.csv")).split('\n');
        const Outcome cpp = run(wanderers("Lidar eye { Beams=1 MinRange=0" + rest, "ranges"), {"--duration", "10"});
        QVERIFY2(cpp.code == 0, shown(cpp).right(3000));
        const QList<QByteArray> theirs = contentOf(at("logs/seen.csv")).split('\n');
        QCOMPARE(ours[0], QByteArray("time [s],a/eye/distance [m],b/eye/distance [m]"));
        QCOMPARE(theirs[0], QByteArray("time [s],a/eye/ranges [m],b/eye/ranges [m]"));
        QVERIFY(ours.size() == theirs.size() && ours.size() > 1000);
        QSet<QByteArray> seen;
        for (int i = 1; i + 1 < ours.size(); ++i) {
            const QList<QByteArray> a = ours[i].split(','), b = theirs[i].split(',');
            QCOMPARE((QList<QByteArray>{a[0], a[1], a[2]}), (QList<QByteArray>{b[0], b[1], b[2]}));
            seen << a[1];
        }
        QVERIFY(seen.size() > 100);
    }

    void anActuatorDrivesAsInCpp() {
        QVERIFY(writeFile(at("feed.py"), "import trundle\n\n\nclass Feeder(trundle.Controller):\n    def setup(self, robot):\n"
                                         "        self.line = robot.port('line')\n\n    def update(self, since_last):\n"
                                         "        self.line.set('steps', 2)\n"));
        QString first;
        for (const char* module : {"components/conveyor", "index_conveyor.py"}) {
            const Outcome outcome =
                run(QByteArray("#loadModule ") + module +
                        "\n#loadModule feed.py\nStaticConfig Plant { Box deck { Size=4,0.5,0.1 Pos=1,0,-0.05 }\n"
                        "  IndexConveyor line { Geom=deck Pitch=0.4 MaxSpeed=0.5 MaxAcceleration=1 } }\n"
                        "Static plant { Config=Plant Feeder brain { } }\nRobotConfig Crate { Body body { Box box { "
                        "Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 } } }\nRobot crate { Config=Crate }\n",
                    {"--modules", kPython, "--duration", "4"});
            QVERIFY2(outcome.code == 0, shown(outcome).right(3000));
            const QJsonObject crate = jsonOf(outcome)["robots"].toObject()["crate"].toObject();
            QVERIFY2(std::abs(crate["pos"].toArray()[0].toDouble() - 0.8) < 0.01, outcome.out.right(3000));
            const QString hash = jsonOf(outcome)["state_hash"].toString();
            if (first.isEmpty()) first = hash;
            QCOMPARE(hash, first);
        }
    }

    /// Discs of 0.01 kg m^2, each driven by one call of act: rates at once and after 2 s, as by the equation of motion.
    void eachWayToDriveAJoint() {
        QVERIFY(
            writeFile(at("turn.py"),
                      "import trundle\n\n\nclass Turn(trundle.Device):\n    \"\"\"It.\"\"\"\n"
                      "    how = trundle.field('How', '', trundle.text(), 'Call.')\n"
                      "    numbers = trundle.field('Numbers', [], trundle.number(), 'Its arguments.')\n"
                      "    rate = trundle.output('rate', 'rad/s', 'Of the disc.')\n\n"
                      "    def setup(self, mount):\n        self.joint, self.disc = mount.joint('pivot'), mount.body('disc')\n\n"
                      "    def act(self, world):\n"
                      "        if self.how == 'body_force':\n"
                      "            x, y, z = world.body(self.disc).pose.position\n"
                      "            world.body_force(self.disc, tuple(self.numbers), (x + 0.1, y, z))\n"
                      "        else:\n            getattr(world, self.how)(self.joint, *self.numbers)\n\n"
                      "    def sense(self, world):\n        self.rate = world.joint(self.joint).rate\n"));
        QByteArray text =
            "#loadModule turn.py\nRobotConfig R { Body disc { Cylinder c { Radius=0.1 Length=0.02 Mass=2 } }\n"
            "  Hinge pivot { Parent=world Child=disc Axis=0,0,1 }\n  Turn turn { How=joint_torque Numbers=0,0 } }\n";
        struct Case {
            const char *robot, *call, *numbers;
            double first, last; ///< rad/s, after 0.01 s and 2 s
        };
        const double e4 = std::exp(-4.);
        const Case cases[] = {
            {"servo", "servo_row", "100,0.5,0.02", 0.5, 25 * (1 - e4)}, // 0.5 N m - 0.02 rate, which reaches 25 rad/s
            {"back", "servo_row", "-100,0.5,0.02", -0.5, -25 * (1 - e4)},
            {"holds", "servo_row", "0.3,0.5,0.02", 0.3, 0.3},
            {"motor", "motor_row", "8,40,0.1", 0.1, 8 - 4 * e4}, // 0.1 N m up to 4 rad/s, then (8 - rate) / 40
            {"torque", "joint_torque", "-0.03", -0.03, -6},
            {"force", "body_force", "0.7,0.4,0", 0.04, 8}}; // 0.1 m from the axis
        double x = 0;
        for (const Case& c : cases)
            text += QByteArray("Robot ") + c.robot + " { Config=R Pos=" + QByteArray::number(x += 1) + ",0,1 turn.How=" + c.call +
                    " turn.Numbers=" + c.numbers + " }\n";
        for (const bool once : {true, false}) {
            const Outcome outcome = run(text, {"--duration", once ? "0.01" : "2"});
            QVERIFY2(outcome.code == 0, shown(outcome).right(3000));
            const QJsonObject robots = jsonOf(outcome)["robots"].toObject();
            for (const Case& c : cases) {
                const double rate = robots[c.robot].toObject()["signals"].toObject()["turn/rate"].toDouble();
                const double expected = once ? c.first : c.last;
                QVERIFY2(std::abs(rate - expected) < 0.025 * std::abs(expected),
                         (QByteArray(c.robot) + ' ' + QByteArray::number(rate) + ' ' + QByteArray::number(expected)).constData());
            }
        }
    }

    /// probe.py compares all that a device can read with what must be.
    void reachesAllOfIts() {
        const QByteArray text =
            "#loadModule probe.py\nStaticConfig Room { Plane floor { Material=concrete Surface=ground }\n"
            "  Box wall { Pos=0,1,0.5 Size=4,0.1,1 Material=white Surface=wall } }\nStatic room { Config=Room }\n"
            "RobotConfig Stand {\n  Body base { Box block { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=2 Material=red Surface=rubber }\n"
            "    Sphere eye { Radius=0.01 Pos=0,0,0.22 Mass=0.01 } }\n"
            "  Body arm  { Pos=0,0,0.3 Box bar { Size=0.1,0.02,0.02 Mass=0.1 } }\n"
            "  Body knob { Pos=0,0.05,0.25 Sphere ball { Radius=0.02 Mass=0.5 } }\n"
            "  Hinge pivot { Parent=base Child=arm Axis=0,0,1 }\n  Fixed weld { Parent=base Child=knob }\n"
            "  RotaryMotor motor { Joint=pivot TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }\n"
            "  Encoder turns { Joint=pivot CountsPerRevolution=1000 }\n"
            "  Probe probe { Body=base Geoms=base.block,base.eye Weight=25.6 Size=1,2,3 }\n}\nRobot r { Config=Stand }\n";
        const Outcome outcome = run(text, {"--modules", kPython});
        QVERIFY2(outcome.code == 0, shown(outcome).right(3000));
        const QJsonObject signals_ = jsonOf(outcome)["robots"].toObject()["r"].toObject()["signals"].toObject();
        QCOMPARE(signals_["probe/ticks"].toInt(), 201); // also before the first tick
        const QJsonArray seen = signals_["probe/seen"].toArray();
        QVERIFY(std::abs(seen[0].toDouble() - 0.95) < 1e-3 && seen[1].toDouble() > 1 && seen[2].toDouble() == -1);
        QCOMPARE(jsonOf(run(text, {"--modules", kPython}))["state_hash"], jsonOf(outcome)["state_hash"]);
    }

    void aFaultSaysWhere_data() {
        QTest::addColumn<QByteArray>("python");
        QTest::addColumn<QByteArray>("said");
        const QByteArray sense = "    def sense(self, world):\n        if world.time > 0.5:\n            ",
                         stopped = "the simulation stopped at t = 0.51 s: r/device: ";
        QTest::newRow("exception") << sense + "raise ValueError('no echo')\n"
                                   << stopped + "ValueError: no echo, in sense at mine.py:9";
        QTest::newRow("abort") << sense + "os.abort()\n"
                               << stopped + "the device Mine (" + at("mine.py").toUtf8() +
                                      ") crashed in sense: Aborted, in sense at mine.py:9";
        QTest::newRow("exit") << sense + "os._exit(3)\n"
                              << stopped + "the device Mine (" + at("mine.py").toUtf8() +
                                     ") ended its process in sense with exit code 3, in sense at mine.py:9";
        QTest::newRow("fork") << sense + "os.fork()\n" << stopped + "BlockingIOError: ";
        QTest::newRow("memory") << sense + "bytearray(8 << 30)\n" << stopped + "MemoryError, in sense at mine.py:9";
        QTest::newRow("handle") << sense + "world.joint('a')\n" << stopped + "TypeError: 'a' is no joint, in sense at mine.py:9";
        QTest::newRow("unknown handle") << QByteArray(sense).replace("sense(self", "act(self") + "world.joint_torque(7, 1)\n"
                                        << QByteArray(
                                               "NotFound: 7 is no joint of the device: setup finds them, in act at mine.py:9");
        QTest::newRow("not finite") << sense + "self.x = world.cast(self.f, float('nan'))\n    def setup(self, mount):\n        "
                                               "self.f = mount.frame('body')\n"
                                    << stopped + "ValueError: World.cast(): range is nan, it must be a finite number above 0, in "
                                                 "sense at mine.py:9";
        QTest::newRow("mount later") << QByteArray("    def setup(self, mount):\n        self.m = mount\n") + sense +
                                            "self.m.body('body')\n"
                                     << stopped + "NotFound: it is found in setup alone";
        const QByteArray setup = "    def act(self, world):\n        pass\n\n    def setup(self, mount):\n        ";
        QTest::newRow("no joint") << setup + "mount.joint('axel')\n"
                                  << QByteArray("r/device: there is no joint axel (there are: none)");
        QTest::newRow("no body") << setup + "mount.frame('bod')\n"
                                 << QByteArray("r/device: there is no body bod, did you mean body? (there are: body)");
        QTest::newRow("no body of a geom") << setup + "mount.geom('body')\n"
                                           << QByteArray("r/device: there is no geom body, it is named with its body: body.geom");
        QTest::newRow("setup") << setup + "1 / 0\n"
                               << QByteArray("r/device: ZeroDivisionError: division by zero, in setup at mine.py:11");
        QTest::newRow("nothing") << QByteArray("    pass\n")
                                 << QByteArray("TypeError: Mine has neither act(self, world) nor sense(self, world)");
        QTest::newRow("signature") << QByteArray("    def sense(self):\n        pass\n")
                                   << QByteArray("Mine.sense is called as sense(self, world), and does not take that");
    }
    void aFaultSaysWhere() {
        QFETCH(QByteArray, python);
        QFETCH(QByteArray, said);
        const Outcome outcome = runMine(python);
        QVERIFY2(outcome.err.contains(said), outcome.err);
        const QByteArray row = QTest::currentDataTag();
        QCOMPARE(outcome.code, row == "nothing" || row == "signature" ? 1 : 4); // no component, or one that failed
    }

    void onlyDevicesHaveCommands() {
        QVERIFY(writeFile(at("mine.py"),
                          "import trundle\n\n\nclass Mine(trundle.Controller):\n    go = trundle.command('go', '', 'x')\n\n"
                          "    def update(self, since_last):\n        pass\n"));
        const Outcome outcome = cli({"describe", "Mine", "--modules", m_folder.path()});
        const QByteArray why = "mine.py cannot be loaded: TypeError: the command go is in the controller Mine";
        QVERIFY2(outcome.code != 0 && outcome.err.contains(why), shown(outcome));
        const Outcome asked = cli({"describe", "Mine", "--json", "--modules", m_folder.path()});
        QVERIFY2(asked.out.contains(why), shown(asked));
        const Outcome used = run("#loadModule mine.py\n");
        QVERIFY2(used.err.contains("TypeError: the command go is in the controller Mine: only devices have some"), shown(used));
    }
};

QTEST_GUILESS_MAIN(PythonComponentsTest)
#include "python_components_test.moc"
