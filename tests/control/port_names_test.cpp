// Names of ports: what is meant by a misspelt one is of the kind that was asked for, and among the robot's own.
#include "control/port_names.h"

#include <QtTest>

using namespace trundle;

namespace {

/// Two robots; the devices of the first have names that begin alike and are of several kinds.
struct Ports {
    Ports() {
        auto config = std::make_shared<RobotConfigSpec>();
        for (const auto& [name, kind] : {std::pair{"scan", "Lidar"},
                                         {"scanner", "RangeSensor"},
                                         {"scan2", "Lidar"},
                                         {"eye", "Camera"},
                                         {"base", "SkidDrive"},
                                         {"arm", "Servo"}})
            config->devices.push_back({kind, name, {}, {}, {}});
        robot.name = "rover";
        robot.config = config;
        layout.beginRobot("rover");
        layout.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        layout.add("scan/ranges", "m", SignalType::Real, SignalDirection::Output, 5);
        layout.add("scan/pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        layout.add("scanner/range", "m", SignalType::Real, SignalDirection::Output);
        layout.add("scan2/ranges", "m", SignalType::Real, SignalDirection::Output, 3);
        layout.add("base/linearVelocity", "m/s", SignalType::Real, SignalDirection::Command);
        layout.add("brain/seen", "", SignalType::Real, SignalDirection::Output, 2);
        layout.beginRobot("rover2");
        layout.add("scan/ranges", "m", SignalType::Real, SignalDirection::Output, 9);
        layout.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        controller.kind = "Seeker";
        controller.name = "brain";
        controller.published = {{"seen", "", "", TRUNDLE_REAL_SIGNAL, 2, TRUNDLE_OUTPUT, {}},
                                {"lost", "", "", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT, {}}};
    }
    [[nodiscard]] PortNames names() const { return {robot, &controller, layout}; }

    RobotSpec robot;
    ControllerSpec controller;
    SignalLayout layout;
};

std::string reportOf(const Result<SignalEntry>& bound) { return bound ? "bound " + bound.value().path : bound.error().message; }

} // namespace

class PortNamesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void binds_data() {
        QTest::addColumn<std::string>("kind");
        QTest::addColumn<std::string>("device");
        QTest::addColumn<std::string>("signal");
        QTest::addColumn<std::string>("said");
        const auto row = [](const char* name, const char* kind, const char* device, const char* signal, const char* said) {
            QTest::newRow(name) << std::string(kind) << std::string(device) << std::string(signal) << std::string(said);
        };
        row("its own", "Lidar", "scan", "ranges", "bound rover/scan/ranges");
        row("of any kind", "", "scanner", "range", "bound rover/scanner/range");
        row("a kind with the same signals", "DifferentialDrive", "base", "linearVelocity", "bound rover/base/linearVelocity");
        row("the kind with fewer signals", "TrackDrive", "base", "linearVelocity",
            "rover has no TrackDrive port 'base': that is of kind SkidDrive (its ports: scan (Lidar), scanner (RangeSensor), "
            "scan2 "
            "(Lidar), eye (Camera), base (SkidDrive), arm (Servo))");
        row("misspelt, beside a nearer name of another kind", "Lidar", "scanne", "ranges",
            "rover has no Lidar port 'scanne'; did you mean 'scan'? (its Lidar ports: scan, scan2)");
        row("the same of the other kind", "RangeSensor", "scanne", "range",
            "rover has no RangeSensor port 'scanne'; did you mean 'scanner'? (its RangeSensor ports: scanner)");
        row("the same of any kind", "", "scanne", "range",
            "rover has no port 'scanne'; did you mean 'scanner'? (its ports: scan (Lidar), scanner (RangeSensor), scan2 (Lidar), "
            "eye (Camera), base (SkidDrive), arm (Servo))");
        row("misspelt, near to another kind alone", "Servo", "eyes", "target",
            "rover has no Servo port 'eyes' (its Servo ports: arm)");
        row("of another kind", "Lidar", "scanner", "ranges",
            "rover has no Lidar port 'scanner': that is of kind RangeSensor (its Lidar ports: scan, scan2)");
        row("a signal that it has not", "Lidar", "scan", "range",
            "rover has no signal 'scan/range'; the signals of scan: ranges");
        row("a measurement of the truth", "Lidar", "scan", "pose",
            "rover gives 'scan/pose' through the port groundTruth alone: a real robot cannot measure it");
        row("the truth of a device", "GroundTruth", "groundTruth", "scan/pose", "bound rover/scan/pose");
        row("no truth", "GroundTruth", "groundTruth", "scan/ranges",
            "rover has no ground truth 'scan/ranges'; there is: pose, scan/pose");
        row("the truth by another name", "GroundTruth", "truth", "pose",
            "rover has no port 'truth'; ground truth is the port groundTruth");
    }
    void binds() {
        QFETCH(std::string, kind);
        QFETCH(std::string, device);
        QFETCH(std::string, signal);
        QFETCH(std::string, said);
        const Ports ports;
        const Result<SignalEntry> bound = ports.names().bind(kind, device, signal);
        QCOMPARE(reportOf(bound), said);
        if (!bound) QCOMPARE(bound.error().code, Code::UnknownPort);
    }

    void publishes() {
        const Ports ports;
        QCOMPARE(reportOf(ports.names().published("seen")), std::string("bound rover/brain/seen"));
        QCOMPARE(reportOf(ports.names().published("sen")),
                 std::string("rover cannot publish 'sen'; did you mean 'seen'? (describe() of Seeker names as outputs: seen)"));
        QCOMPARE(reportOf(PortNames(ports.robot, nullptr, ports.layout).published("seen")),
                 std::string("rover has no controller in its text that could publish 'seen'"));
    }

    /// Of this robot, not of one whose name begins with its own; any signal of a device, not of one whose name begins alike.
    void looks() {
        const Ports ports;
        const PortNames names = ports.names();
        QCOMPARE(names.look("scan", "ranges")->count, 5u);
        QCOMPARE(names.look("", "pose")->path, std::string("rover/pose"));
        QCOMPARE(names.look("scan2", "")->path, std::string("rover/scan2/ranges"));
        QCOMPARE(names.look("scan", "")->path, std::string("rover/scan/ranges"));
        for (const auto& [device, signal] :
             {std::pair{"scan3", "ranges"}, {"scan", "range"}, {"eye", ""}, {"", "seen"}, {"brain", "seen"}, {"none", ""}})
            QVERIFY(!names.look(device, signal));
    }
    /// Of many names the first thirty.
    void manyNamesAreCut() {
        Ports ports;
        auto config = std::make_shared<RobotConfigSpec>();
        const auto text = [&](std::size_t count) {
            config->devices.clear();
            for (std::size_t i = 0; i < count; ++i) config->devices.push_back({"Led", "l" + std::to_string(i), {}, {}, {}});
            ports.robot.config = config;
            return ports.names().bind("Led", "none", "lit").error().message;
        };
        const std::string whole = text(30), cut = text(31);
        QVERIFY2(whole.ends_with("l28, l29)"), whole.c_str());
        QVERIFY2(cut.ends_with("l28, l29 ...)"), cut.c_str());
    }
};

QTEST_APPLESS_MAIN(PortNamesTest)
#include "port_names_test.moc"
