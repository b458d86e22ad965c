// Running controllers of modules on the signals of a robot.
#include "control/in_process_backend.h"
#include "control/published.h"

#include <QtTest>

using namespace trundle;

namespace {
const std::string kModules = std::string(TRUNDLE_BINARY_DIR) + "/tests/modules/";

std::span<double> valuesOf(SignalBlock& block) { return block.slots(); }

ResolvedValue number(double value) { return {{PropertyType::Number, {value}, {}}, {}, Origin::Config}; }
ResolvedValue text(const std::string& value) { return {{PropertyType::Text, {}, {value}}, {}, Origin::Config}; }

/// A robot with the devices of simple_robot, as its signals alone, and a controller.
struct Stage {
    Stage(const std::string& kind, std::map<std::string, ResolvedValue, std::less<>> values, const std::string& name = "robot0") {
        auto config = std::make_shared<RobotConfigSpec>();
        for (const auto& [device, deviceKind] :
             {std::pair{"base", "DifferentialDrive"}, {"frontTouch", "TouchSensor"}, {"leftEncoder", "Encoder"}})
            config->devices.push_back({deviceKind, device, {}, {}, {}});
        for (const char* camera : {"still", "stream"}) config->devices.push_back({"Camera", camera, {}, {}, {}});
        config->devices.back().values["UpdatePeriod"] = number(0.1);
        robot.name = name;
        robot.config = config;
        robot.controllers = {{{kind, "brain", std::move(values), {}, {}}, {}}};
        layout.beginRobot(name);
        const auto add = [&](const char* path, SignalDirection direction, std::uint32_t count = 1) {
            layout.add(path, "", SignalType::Real, direction, count);
        };
        add("pose", SignalDirection::Truth, 7);
        add("velocity", SignalDirection::Truth, 6);
        for (const char* s : {"linearVelocity", "angularVelocity", "linearAmount", "angularAmount", "sequence"})
            add((std::string("base/") + s).c_str(), SignalDirection::Command);
        add("base/pose", SignalDirection::Truth, 3);
        add("base/odometry", SignalDirection::Output, 3);
        for (const char* s :
             {"base/done", "base/busy", "base/finished", "frontTouch/pressed", "frontTouch/force", "frontTouch/count",
              "leftEncoder/count", "leftEncoder/angle", "leftEncoder/rate", "leftEncoder/index", "leftEncoder/missed",
              "still/frame", "still/time", "stream/frame", "stream/time"})
            add(s, SignalDirection::Output);
    }
    Status start(const char* library = "controllers/libgood.so", std::size_t controller = 0) {
        auto loaded = store.load(kModules + library);
        if (!loaded) return loaded.error();
        for (const Kind& kind : loaded.value()->kinds)
            if (kind.name == robot.controllers[0].kind) addPublished(kind, robot, layout);
        block = std::make_unique<SignalBlock>(layout);
        auto made = makeInProcessBackend(robot, controller, settings, store);
        if (!made) return made.error();
        backend = std::move(made).value();
        ControllerOutputs outputs;
        outputs.print = [this](int severity, const std::string& line) {
            console.push_back((severity == TRUNDLE_WARNING ? "warning: " : "") + line);
        };
        outputs.openLog = [this](const std::string& file) {
            logs.push_back(file + ":");
            return static_cast<int>(logs.size()) - 1;
        };
        outputs.writeLog = [this](int log, std::string_view bytes) { logs[static_cast<std::size_t>(log)] += bytes; };
        outputs.finish = [this](const std::string& reason) { finished.push_back(reason); };
        outputs.capture = [this](const std::string&) { return Result<const CameraImage*>(&frame); };
        return backend->start(layout, *block, outputs);
    }
    double& at(const std::string& path, std::uint32_t i = 0) {
        return valuesOf(*block)[layout.find(robot.name + "/" + path)->offset + i];
    }

    ModuleStore store; // outlives the backend
    RobotSpec robot;
    SettingsSpec settings;
    SignalLayout layout;
    std::unique_ptr<SignalBlock> block;
    std::unique_ptr<ControllerBackend> backend;
    CameraImage frame{1, 1, 0, 0, {1, 2, 3}, {}, {}};
    std::vector<std::string> console, logs, finished;
};
} // namespace

class BackendTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aControllerReadsAndWritesItsPorts() {
        Stage stage("Driver", {{"Speed", number(.5)}});
        const Status started = stage.start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QCOMPARE(stage.at("base/linearVelocity"), .5);
        stage.at("frontTouch/pressed") = 1;
        QVERIFY(stage.backend->tick(1, .01, .01).ok());
        QCOMPARE(stage.at("base/linearVelocity"), 0.);
        QCOMPARE(stage.at("base/odometry"), 0.); // a controller cannot write an output
        QCOMPARE(stage.at("base/finished"), 0.);
        QCOMPARE(stage.backend->describe(), std::string("Driver from libgood.so, in process"));
    }

    void fieldsTimeConsoleAndLogsReachIt() {
        Stage stage("Driver", {{"Loud", ResolvedValue{{PropertyType::Boolean, {1}, {}}, {}, Origin::Config}},
                               {"Text", text("hi")},
                               {"Pair", ResolvedValue{{PropertyType::Number, {3, 4}, {}}, {}, Origin::Config}}});
        QVERIFY(stage.start().ok());
        stage.at("leftEncoder/count") = 12;
        QVERIFY(stage.backend->tick(5, .05, .02).ok());
        QCOMPARE(stage.console.at(0), std::string("hi t=0.05 dt=0.02 n=12 rear=0 pair=7"));
        QCOMPARE(stage.logs.at(0), std::string("own.txt:line\n"));
    }

    void aControllerPublishesWhatItDescribes() {
        Stage stage("Counter", {{"End", number(2)}});
        const Status started = stage.start("publishing/libpublishing.so");
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        QCOMPARE(stage.at("brain/where", 1), 5.);
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QCOMPARE(stage.at("brain/count"), 1.);
        QVERIFY(stage.finished.empty());
        QVERIFY(stage.backend->tick(1, .01, .01).ok());
        QCOMPARE(stage.at("brain/count"), 2.);
        QCOMPARE(stage.finished, std::vector<std::string>{"counted enough"});
    }

    void publishingWhatIsNotDescribedEndsTheSetup() {
        Stage stage("Counter", {{"What", text("counts")}});
        const Status started = stage.start("publishing/libpublishing.so");
        QVERIFY(!started.ok());
        QCOMPARE(started.error().code, Code::UnknownPort);
        QCOMPARE(started.error().message,
                 std::string("robot0 cannot publish 'counts'; did you mean 'count'? (describe() of Counter "
                             "names as outputs: count, where)"));
    }

    /// Modules built with the headers of earlier releases, whose tables are shorter.
    void aModuleOfAnOlderSdkRuns_data() {
        QTest::addColumn<QByteArray>("version");
        QTest::addColumn<int>("minor");
        const std::pair<const char*, int> versions[] = {{"1.2", 2}, {"1.3", 3}, {"1.4", 4},  {"1.5", 4},  {"1.6", 5}, {"1.7", 6},
                                                        {"1.8", 7}, {"1.9", 7}, {"1.10", 8}, {"1.11", 9}, {"1.12", 9}};
        for (const auto& [version, interface] : versions) QTest::newRow(version) << QByteArray(version) << interface;
    }
    void aModuleOfAnOlderSdkRuns() {
        QFETCH(const QByteArray, version);
        QFETCH(const int, minor);
        const QByteArray library = "older/libolder_" + version + ".so";
        Stage stage("Driver", {{"Loud", ResolvedValue{{PropertyType::Boolean, {1}, {}}, {}, Origin::Config}}});
        const Status started = stage.start(library.constData());
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        const LoadedModule* module = stage.store.owner("Driver", TRUNDLE_CONTROLLER);
        QVERIFY(module && module->descriptor->abiMinor == static_cast<std::uint32_t>(minor));
        QCOMPARE(QByteArray(module->descriptor->sdkVersion), version + ".0");
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QCOMPARE(stage.at("base/linearVelocity"), .2);
        QCOMPARE(stage.console.at(0), std::string("hello t=0 dt=0 n=0 rear=0 pair=3"));
        QCOMPARE(stage.logs.at(0), std::string("own.txt:line\n"));

        Stage watcher("Watcher", {});
        QVERIFY(watcher.start(library.constData()).ok());
        QVERIFY(watcher.backend->tick(0, 0, 0).ok());
        QCOMPARE(watcher.console.at(1), std::string("1 1 1"));
    }

    /// The text may have been checked with a newer version of the module than the running one.
    void aLiveValueOutOfTheRunningCodesRangeIsRefused() {
        Stage stage("Rebuilt", {});
        QVERIFY(stage.store.load(kModules + "rebuilt/libbefore.so").ok());
        const Status started = stage.start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        const auto set = [&](double pace) { return stage.backend->set("Pace", {PropertyType::Number, {pace}, {}}); };
        QVERIFY(set(0).ok() && set(2).ok());
        for (const double wrong : {-0.1, 2.1}) {
            const Status refused = set(wrong);
            QVERIFY(!refused.ok());
            QCOMPARE(refused.error().code, Code::OutOfRange);
        }
    }

    /// The class reads as many elements as its member has, and no more than were given.
    void wrongCountsAreRefused() {
        const auto numbers = [](std::vector<double> n) {
            return ResolvedValue{{PropertyType::Number, std::move(n), {}}, {}, Origin::Config};
        };
        const std::pair<const char*, ResolvedValue> cases[] = {
            {"Pair", numbers({1})},     {"Pair", numbers({1, 2, 3})}, {"Pair", text("a")},    {"Speed", numbers({})},
            {"Speed", numbers({1, 2})}, {"Speed", text("fast")},      {"Text", numbers({1})}, {"Loud", numbers({1, 0})}};
        for (const auto& [field, value] : cases) {
            Stage stage("Driver", {{field, value}});
            const Status started = stage.start();
            QVERIFY2(!started.ok(), field);
            QCOMPARE(started.error().message, "the controller Driver of robot0 cannot take the value of " + std::string(field) +
                                                  ": wrong count of elements");
        }
    }

    void randomNumbersDependOnSeedRobotAndTickAlone() {
        const auto drawn = [](std::uint64_t seed, const std::string& name, std::vector<std::uint64_t> ticks) {
            Stage stage("Driver", {{"Loud", ResolvedValue{{PropertyType::Boolean, {1}, {}}, {}, Origin::Config}}}, name);
            stage.settings.seed = seed;
            if (!stage.start().ok()) return std::string("not started");
            for (const std::uint64_t tick : ticks)
                if (!stage.backend->tick(tick, 0, 0).ok()) return std::string("failed");
            return stage.console.back();
        };
        QVERIFY(drawn(1, "robot0", {7}).starts_with("warning: random "));
        QCOMPARE(drawn(1, "robot0", {7}), drawn(1, "robot0", {3, 4, 7}));
        QVERIFY(drawn(1, "robot0", {7}) != drawn(1, "robot0", {8}));
        QVERIFY(drawn(1, "robot0", {7}) != drawn(2, "robot0", {7}));
        QVERIFY(drawn(1, "robot0", {7}) != drawn(1, "robot1", {7}));
    }

    /// Those of the first do not depend on the others.
    void eachControllerOfARobotDrawsOtherNumbers() {
        const auto drawn = [](const std::vector<std::string>& names, std::size_t controller) {
            const std::map<std::string, ResolvedValue, std::less<>> loud{
                {"Loud", ResolvedValue{{PropertyType::Boolean, {1}, {}}, {}, Origin::Config}}};
            Stage stage("Driver", loud);
            stage.robot.controllers.clear();
            for (const std::string& name : names) stage.robot.controllers.push_back({{"Driver", name, loud, {}, {}}, {}});
            if (!stage.start("controllers/libgood.so", controller).ok()) return std::string("not started");
            return stage.backend->tick(7, 0, 0).ok() ? stage.console.back() : std::string("failed");
        };
        const std::string alone = drawn({"brain"}, 0), first = drawn({"brain", "arm", "head"}, 0),
                          second = drawn({"brain", "arm", "head"}, 1), third = drawn({"brain", "arm", "head"}, 2);
        QVERIFY2(alone.starts_with("warning: random "), alone.c_str());
        QCOMPARE(first, alone);
        QVERIFY(second != first && third != first && third != second);
        QCOMPARE(drawn({"brain", "arm"}, 1), second);
    }

    void reportsControllerFailures_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        QTest::newRow("setup") << 410 << "the controller Failing of robot0 failed in setup: no battery";
        QTest::newRow("device")
            << 411 << "robot0 has no DifferentialDrive port 'bas'; did you mean 'base'? (its DifferentialDrive ports: base)";
        QTest::newRow("kind") << 411 << "robot0 has no DifferentialDrive port 'frontTouch': that is of kind TouchSensor";
        QTest::newRow("signal") << 411
                                << "robot0 has no signal 'base/speed'; the signals of base: linearVelocity, angularVelocity";
        QTest::newRow("truth") << 411 << "robot0 gives 'base/pose' through the port groundTruth alone";
        QTest::newRow("groundTruth") << 411 << "robot0 has no ground truth 'base/pos'; there is: pose, velocity, base/pose";
        QTest::newRow("update") << 410 << "the controller Failing of robot0 failed: an exception that is no std::exception";
        QTest::newRow("give up") << 410 << "the controller Failing of robot0 gave up: the map is empty";
    }
    void reportsControllerFailures() {
        QFETCH(int, code);
        QFETCH(QString, words);
        Stage stage("Failing", {{"Where", text(QTest::currentDataTag())}});
        Status status = stage.start();
        if (status.ok()) status = stage.backend->tick(0, 0, 0);
        QVERIFY(!status.ok());
        QCOMPARE(static_cast<int>(status.error().code), code);
        QVERIFY2(status.error().message.starts_with(words.toStdString()), status.error().message.c_str());
    }

    void groundTruthHasAPortOfItsOwn() {
        Stage stage("Cheating", {});
        QVERIFY(stage.start().ok());
        stage.at("pose", 0) = 1.5;
        stage.at("pose", 3) = 1;
        stage.at("velocity", 5) = .25;
        stage.at("base/pose", 2) = 3;
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QCOMPARE(stage.console.at(0), std::string("1.5 1 0.25 3"));
    }

    void cameraWithoutStreamIsAlwaysNew() {
        Stage stage("Watcher", {});
        const Status started = stage.start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QVERIFY(stage.backend->tick(1, 0.01, 0.01).ok());
        stage.at("still/frame") = stage.at("stream/frame") = 1;
        QVERIFY(stage.backend->tick(2, 0.02, 0.01).ok());
        QCOMPARE(stage.console,
                 (std::vector<std::string>{"this port has no camera; robot.camera(\"NAME\") in setup() gives it one", "1 1 1",
                                           "1 1 0", "1 1 1", "1 0 0", "1 1 1", "1 1 0"}));
    }

    void aKindThatIsNotLoadedIsNamed() {
        Stage stage("Ghost", {});
        const Status status = stage.start();
        QCOMPARE(status.error().code, Code::KindNotLoaded);
    }

    void aValueOfTheWrongCountNeverReachesTheClass() {
        Stage stage("Driver", {{"Pair", number(1)}});
        const Status status = stage.start();
        QVERIFY(!status.ok());
        QVERIFY(status.error().message.find("Pair") != std::string::npos);
    }

    void restartsController() {
        Stage stage("Driver", {});
        QVERIFY(stage.start().ok());
        stage.backend->stop();
        QVERIFY(!stage.backend->tick(0, 0, 0).ok());
        QVERIFY(stage.backend->start(stage.layout, *stage.block, {}).ok());
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
    }

    void theTemplateDrives() {
        Stage stage("MyController", {});
        QVERIFY(stage.store.load(std::string(TRUNDLE_BINARY_DIR) + "/lib/trundle/libmy_controller.so").ok());
        const Status started = stage.start();
        QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
        QVERIFY(stage.backend->tick(0, 0, 0).ok());
        QCOMPARE(stage.at("base/linearVelocity"), .2);
        QCOMPARE(stage.at("base/angularVelocity"), .5);
    }
};

QTEST_APPLESS_MAIN(BackendTest)
#include "backend_test.moc"
