// Several controllers on one robot, each with commands of its own: in the program, in host processes, in Python.
#include "app/application.h"
#include "flow/cli.h"

using namespace trundle;

namespace {

const QString kHalves = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/halves");

const char* const kTwoWheels = R"(#import common/materials.sim
#import common/surfaces.sim
#import arenas/open_floor.sim
RobotConfig TwoWheels {
  Body chassis {
    Box hull      { Size=0.30,0.20,0.10  Pos=0,0,0.09  Mass=2  Surface=plastic Material=red }
    Sphere slider { Radius=0.02  Pos=-0.12,0,0.02  Mass=0.05  Surface=slick Material=red }
  }
  Body leftWheel  { Pos=0.06,0.125,0.05  Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 Surface=rubber Material=black } }
  Body rightWheel { Pos=0.06,-0.125,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 Surface=rubber Material=black } }
  Hinge leftAxle  { Parent=chassis Child=leftWheel  Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
  RotaryMotor leftMotor  { Joint=leftAxle  TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
  RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
}
Static floor { Config=OpenFloor }
)";

const char* const kPython = R"(import trundle
from trundle import field, text, volts


class SnakeHalf(trundle.Controller):
    """Drives one motor."""
    motor = field("Motor", "", text(), "The motor.")
    voltage = field("Voltage", 3.0, volts(), "What it commands.")

    def setup(self, robot):
        self.port = robot.motor(self.motor)

    def update(self, since_last):
        self.port.set_voltage(self.voltage)
)";

double commanded(Runner& runner, const std::string& path) {
    const World& world = runner.world();
    const auto entry = world.layout().find(path);
    return entry ? world.block().slots()[entry->offset] : -1;
}

/// An experiment that runs in this program.
struct Running {
    std::shared_ptr<const LoadedProject> loaded;
    std::unique_ptr<Runner> runner;
    std::shared_ptr<QStringList> console = std::make_shared<QStringList>();

    [[nodiscard]] bool tick(int ticks) {
        for (int i = 0; i < ticks; ++i)
            if (!runner->tick().ok()) return false;
        return true;
    }
    /// The command that gives the robot the controller of this name in `from`.
    static SwapCommand comes(const Running& from, const char* name) {
        for (const ControllerSpec& controller : from.loaded->experiment->robots.at(0).controllers)
            if (controller.name == name) return {"r", "", controller, from.loaded->registry->find(controller.kind)->module};
        return {};
    }
};

} // namespace

class SeveralControllersTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// Of an experiment of 1 s with these controllers in its robot.
    Outcome run(const QByteArray& controllers, const QByteArray& isolation = "none") {
        QDir(m_folder.filePath("logs")).removeRecursively();
        const QString path = m_folder.filePath("several.sim");
        if (!writeFile(m_folder.filePath("snake.py"), kPython)) return {};
        if (!writeFile(path, "Duration = 1  Isolation = " + isolation + "\n" + kTwoWheels +
                                 "#loadModule halves\n#loadModule snake.py\nRobot r { Config=TwoWheels\n" + controllers +
                                 " }\nSignalLog s { Signals=\"r/*\" Interval=0.1 }\n"))
            return {};
        return cli({"run", path, "--json", "--quiet", "--modules", kHalves, "--modules", m_folder.path(), "--log-dir",
                    m_folder.filePath("logs")});
    }
    Running start(const QByteArray& controllers, const QByteArray& isolation) {
        static const std::unique_ptr<Application> application = makeApplication(findLocations(), Isolation::None);
        const QString path = m_folder.filePath("running.sim");
        OpenOptions options;
        options.modules = {kHalves.toStdString(), m_folder.path().toStdString()};
        if (!writeFile(m_folder.filePath("snake.py"), kPython)) return {};
        if (!writeFile(path, "Isolation = " + isolation + "\n" + kTwoWheels + "#loadModule halves\n#loadModule snake.py\n" +
                                 "Robot r { Config=TwoWheels " + controllers + " }\n"))
            return {};
        auto opened = application->open(path.toStdString(), options);
        if (!opened) return {};
        Running made{opened.value(), nullptr};
        RunOptions run;
        run.console = [lines = made.console](double, const std::string& who, int, const std::string& text) {
            lines->append(QString::fromStdString(who + ": " + text));
        };
        Diagnostics problems;
        made.runner = application->makeRunner(*made.loaded, std::move(run), problems);
        for (const Diagnostic& problem : problems.all()) qWarning("%s", problem.message.c_str());
        return made;
    }
    static QJsonObject jsonOf(const Outcome& outcome) { return QJsonDocument::fromJson(outcome.out).object(); }
    static QString hashOf(const Outcome& outcome) { return jsonOf(outcome)["state_hash"].toString(); }
    /// The values of a column of the log, from the first row to the last.
    QList<QByteArray> column(const QByteArray& name) const {
        const QList<QByteArray> lines = contentOf(m_folder.filePath("logs/s.csv")).trimmed().split('\n');
        qsizetype at = -1;
        const QList<QByteArray> names = lines[0].split(',');
        for (qsizetype i = 0; i < names.size(); ++i)
            if (names[i].startsWith(name)) at = i;
        QList<QByteArray> values;
        for (qsizetype i = 1; at >= 0 && i < lines.size(); ++i) values.push_back(lines[i].split(',')[at]);
        return values;
    }

private Q_SLOTS:
    void twoHalvesGiveTheBitsOfOne_data() {
        QTest::addColumn<QByteArray>("isolation");
        for (const char* isolation : {"none", "module", "robot"}) QTest::newRow(isolation) << QByteArray(isolation);
    }
    void twoHalvesGiveTheBitsOfOne() {
        QFETCH(QByteArray, isolation);
        const Outcome one = run("Both brain { Left=4 Right=2 }", isolation);
        QVERIFY2(one.code == 0, shown(one));
        const Outcome halves = run("Half left { Motor=leftMotor Voltage=4 }\nHalf right { Motor=rightMotor Voltage=2 }", isolation);
        QVERIFY2(halves.code == 0, shown(halves));
        QCOMPARE(column("r/leftMotor/voltage").last().toDouble(), 4.0);
        QCOMPARE(column("r/rightMotor/voltage").last().toDouble(), 2.0);
        const Outcome swapped = run("Half right { Motor=rightMotor Voltage=2 }\nHalf left { Motor=leftMotor Voltage=4 }", isolation);
        QVERIFY2(swapped.code == 0, shown(swapped));
        const Outcome mixed = run("Half left { Motor=leftMotor Voltage=4 }\nSnakeHalf right { Motor=rightMotor Voltage=2 }", isolation);
        QVERIFY2(mixed.code == 0, shown(mixed));
        const Outcome other = run("Half left { Motor=leftMotor Voltage=4 }\nSnakeHalf right { Motor=rightMotor Voltage=2.5 }", isolation);
        QVERIFY2(other.code == 0, shown(other));
        const QString hash = hashOf(one);
        QVERIFY(!hash.isEmpty());
        QCOMPARE(hashOf(halves), hash);
        QCOMPARE(hashOf(swapped), hash);
        QCOMPARE(hashOf(mixed), hash);
        QVERIFY(hashOf(other) != hash);
    }

    void oneCommandIsThatOfOneController_data() {
        QTest::addColumn<QByteArray>("second");
        QTest::addColumn<QByteArray>("isolation");
        for (const char* isolation : {"none", "module", "robot"}) {
            QTest::addRow("C++, %s", isolation) << QByteArray("Half second { Motor=leftMotor }") << QByteArray(isolation);
            QTest::addRow("Python, %s", isolation) << QByteArray("SnakeHalf second { Motor=leftMotor }") << QByteArray(isolation);
        }
    }
    void oneCommandIsThatOfOneController() {
        QFETCH(QByteArray, second);
        QFETCH(QByteArray, isolation);
        const Outcome both = run("  Half first { Motor=leftMotor }\n  " + second + "\n", isolation);
        QVERIFY2(both.code == 1, shown(both));
        const QJsonArray found = jsonOf(both)["diagnostics"].toArray();
        QVERIFY2(found.size() == 1, shown(both));
        const QString message = found[0]["message"].toString();
        QVERIFY2(message.startsWith("second and first both command r/leftMotor/"), qPrintable(message));
        QVERIFY2(message.endsWith("each controller of a robot needs commands of its own"), qPrintable(message));
        const int line = static_cast<int>(QByteArray(kTwoWheels).count('\n')) + 6;
        QCOMPARE(found[0]["line"].toInt(), line);
    }

    void aFaultStopsOneOfThem_data() {
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<QByteArray>("isolation");
        QTest::newRow("exception, module") << QByteArray("throw") << QByteArray("module");
        QTest::newRow("exception, robot") << QByteArray("throw") << QByteArray("robot");
        QTest::newRow("crash, module") << QByteArray("abort") << QByteArray("module");
    }
    /// Its commands become 0, and the other one goes on, in a new process if theirs has ended.
    void aFaultStopsOneOfThem() {
        QFETCH(QByteArray, end);
        QFETCH(QByteArray, isolation);
        const Outcome faulty = run("Half left { Motor=leftMotor Voltage=4 }\nHalf right { Motor=rightMotor Voltage=2 End=" + end + " }", isolation);
        QVERIFY2(faulty.code == 4, shown(faulty));
        QCOMPARE(column("r/leftMotor/voltage").last().toDouble(), 4.0);
        QCOMPARE(column("r/rightMotor/voltage").at(3).toDouble(), 2.0);
        QCOMPARE(column("r/rightMotor/voltage").last().toDouble(), 0.0);
        const QJsonArray stopped = jsonOf(faulty)["stopped"].toArray();
        QVERIFY2(stopped.size() == 1, shown(faulty));
        QCOMPARE(stopped[0]["controller"].toString(), QString("right"));
        QVERIFY2(stopped[0]["reason"].toString().startsWith("the controller Half right of r"), shown(faulty));
    }

    void anotherOneComesDuringTheRun_data() {
        QTest::addColumn<QByteArray>("first");
        QTest::addColumn<QByteArray>("second");
        QTest::addColumn<QByteArray>("isolation");
        for (const char* isolation : {"none", "module", "robot"}) {
            QTest::addRow("C++ and C++, %s", isolation) << QByteArray("Half") << QByteArray("Half") << QByteArray(isolation);
            QTest::addRow("C++ and Python, %s", isolation)
                << QByteArray("Half") << QByteArray("SnakeHalf") << QByteArray(isolation);
            QTest::addRow("Python and C++, %s", isolation)
                << QByteArray("SnakeHalf") << QByteArray("Half") << QByteArray(isolation);
            QTest::addRow("Python and Python, %s", isolation)
                << QByteArray("SnakeHalf") << QByteArray("SnakeHalf") << QByteArray(isolation);
        }
    }
    /// It drives at once, each has its own commands, and one that claims those of another is stopped while the others continue.
    void anotherOneComesDuringTheRun() {
        QFETCH(QByteArray, first);
        QFETCH(QByteArray, second);
        QFETCH(QByteArray, isolation);
        const QByteArray left = first + " left { Motor=leftMotor Voltage=4 } ",
                         right = second + " right { Motor=rightMotor Voltage=2 } ",
                         rival = second + " rival { Motor=leftMotor Voltage=1 } ";
        Running both = start(left + right, isolation), withRival = start(left + right + rival, "none"),
                one = start(left, isolation);
        QVERIFY(both.runner && !withRival.runner && withRival.loaded && one.runner && both.tick(200));
        one.runner->command(Running::comes(both, "right"));
        QVERIFY2(one.tick(200), qPrintable(one.console->join('\n')));
        QCOMPARE(one.console->filter("r: the controller right is " + second + " now").size(), qsizetype(1));
        QCOMPARE(one.runner->world().stateHash(), both.runner->world().stateHash()); // it came before the first tick
        QCOMPARE(one.runner->controllerCosts().size(), std::size_t(2));

        one.runner->command(Running::comes(withRival, "rival"));
        QVERIFY(one.tick(50));
        QCOMPARE(one.runner->stoppedControllers().size(), std::size_t(1));
        const StoppedController stopped = one.runner->stoppedControllers().front();
        QCOMPARE(stopped.controller, std::string("rival"));
        QVERIFY2(stopped.fault.reason.starts_with("rival and left both command r/leftMotor/"), stopped.fault.reason.c_str());
        QCOMPARE(commanded(*one.runner, "r/leftMotor/voltage"), 4.0);
        QCOMPARE(commanded(*one.runner, "r/rightMotor/voltage"), 2.0);

        one.runner->command(SwapCommand{"r", "left", {}, {}});
        QVERIFY(one.tick(1));
        QCOMPARE(commanded(*one.runner, "r/leftMotor/voltage"), 0.0);
        QCOMPARE(commanded(*one.runner, "r/rightMotor/voltage"), 2.0);
        one.runner->command(RestartCommand{"r", "rival"}); // now the command is free
        QVERIFY(one.tick(2));
        QVERIFY(one.runner->stoppedControllers().empty());
        QCOMPARE(commanded(*one.runner, "r/leftMotor/voltage"), 1.0);
        QCOMPARE(commanded(*one.runner, "r/rightMotor/voltage"), 2.0);
        one.runner->command(Running::comes(both, "left"));
        one.runner->command(Running::comes(both, "right"));
        QVERIFY(one.tick(1));
        QCOMPARE(one.console->filter("command refused: r has a controller right already").size(), qsizetype(1));
        QCOMPARE(one.runner->stoppedControllers().size(), std::size_t(1)); // left: rival has its command
        QCOMPARE(commanded(*one.runner, "r/leftMotor/voltage"), 1.0);
    }

    void eachDrawsItsOwnRandomNumbers() {
        const Outcome one = run("Half left { Motor=leftMotor Noise=2 }");
        QVERIFY2(one.code == 0, shown(one));
        const QList<QByteArray> alone = column("r/left/drawn");
        for (const char* isolation : {"none", "module"}) {
            const Outcome two = run("Half left { Motor=leftMotor Noise=2 }\nHalf right { Motor=rightMotor Noise=2 }", isolation);
            QVERIFY2(two.code == 0, shown(two));
            QCOMPARE(column("r/left/drawn"), alone); // the second one changes nothing for the first
            const QList<QByteArray> other = column("r/right/drawn");
            QCOMPARE(other.size(), alone.size());
            for (qsizetype i = 1; i < other.size(); ++i) QVERIFY(other[i] != alone[i]);
        }
    }
};

QTEST_GUILESS_MAIN(SeveralControllersTest)
#include "several_controllers_test.moc"
