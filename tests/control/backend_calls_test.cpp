// Each call of the table that a controller gets, with and without what the run offers for it.
#include <cstring>
#include <functional>
#include <set>

#include "control/in_process_backend.h"
#include "control/published.h"
#include "control/medium_radios.h"
#include "radio/medium.h"

#include <QtTest>

using namespace trundle;

namespace {

/// A controller whose calls run what the test has written.
struct Script {
    std::function<int(const TrundleRobot&)> setup = [](const TrundleRobot&) { return 0; };
    std::function<int(const TrundleRobot&, double)> update = [](const TrundleRobot&, double) { return 0; };
    const TrundleRobot* robot = nullptr;
    int alive = 0;
    bool canCreate = true, acceptsValues = true;
    const char* why = "";
    std::vector<double> pair;
};
Script* g_script = nullptr;

TrundleKind scriptKind() {
    static const TrundleField fields[] = {
        {"Pair", "", "", "", 1, -5, 5, TRUNDLE_NUMBER, 2, 2, TRUNDLE_OPTIONAL | TRUNDLE_LIVE, {nullptr, nullptr, 0}}};
    TrundleKind kind{};
    kind.size = sizeof kind;
    kind.role = TRUNDLE_CONTROLLER;
    kind.name = "Script";
    kind.fields = fields;
    kind.fieldCount = 1;
    kind.create = []() -> void* { return g_script->canCreate ? (++g_script->alive, g_script) : nullptr; };
    kind.destroy = [](void* self) { --static_cast<Script*>(self)->alive; };
    kind.set = [](void*, std::uint32_t, const TrundleValue* value) -> std::int32_t {
        g_script->pair.assign(value->numbers, value->numbers + value->count);
        return g_script->acceptsValues ? 0 : 1;
    };
    kind.lastError = [](void*) { return g_script->why; };
    kind.setupController = [](void*, const TrundleRobot* robot) -> std::int32_t {
        g_script->robot = robot;
        return g_script->setup(*robot);
    };
    kind.update = [](void*, double since) -> std::int32_t { return g_script->update(*g_script->robot, since); };
    return kind;
}

ResolvedValue numbers(std::vector<double> values) { return {{PropertyType::Number, std::move(values), {}}, {}, Origin::Config}; }

struct Stage {
    explicit Stage(const std::string& name = "robot0") {
        g_script = &script;
        auto config = std::make_shared<RobotConfigSpec>();
        config->devices.push_back({"Transceiver", "near", {}, {}, {}});
        config->devices.push_back({"Transceiver", "far", {}, {}, {}});
        config->devices.push_back({"Camera", "eye", {}, {}, {}});
        robot.name = name;
        robot.config = config;
        robot.controllers = {{{"Script", "brain", {}, {}, {}}, {}}};
        settings.tick = 0.025;
        settings.seed = 7;
        layout.beginRobot(name);
        for (const char* radio : {"near", "far"})
            layout.add(std::string(radio) + "/rssi", "dBm", SignalType::Real, SignalDirection::Output, 1);
        layout.add("eye/speed", "", SignalType::Real, SignalDirection::Command, 3);
        layout.add("pose", "", SignalType::Real, SignalDirection::Truth, 7);
        block = std::make_unique<SignalBlock>(layout);
    }
    ~Stage() { backend.reset(); }
    Status start() {
        backend = makeInProcessBackend(robot, 0, settings, kind, library);
        return backend->start(layout, *block, outputs);
    }
    Status tick(std::uint64_t number = 0, double time = 0, double since = 0) { return backend->tick(number, time, since); }

    Script script;
    TrundleKind kind = scriptKind();
    RobotSpec robot;
    SettingsSpec settings;
    SignalLayout layout;
    std::unique_ptr<SignalBlock> block;
    std::string library;
    ControllerOutputs outputs;
    std::unique_ptr<ControllerBackend> backend;
};

std::string messageOf(const Status& status) { return status ? std::string() : status.error().message; }

/// Two radios of robot0, 3 m apart, and one of another robot.
struct Radios {
    Medium medium{MediumSettings{}};
    RadioId near, far, other;
    Radios() : near(open("robot0/near", 0, 21)), far(open("robot0/far", 3, 22)), other(open("robot1/near", 5, 23)) {}
    RadioId open(const std::string& path, double x, std::uint32_t address) {
        RadioDefinition d;
        d.path = path;
        d.address = address;
        d.rssiStep = 0;
        const RadioId id = medium.open(d);
        medium.place(id, Pose{Vec3(x, 0, 1), Quat::Identity()});
        return id;
    }
};

} // namespace

class BackendCallsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatTheRobotSaysOfItself() {
        Stage stage("rover");
        stage.script.setup = [](const TrundleRobot& robot) {
            return robot.size == sizeof robot && std::string(robot.name) == "rover" && robot.tick == 0.025 ? 0 : 1;
        };
        QCOMPARE(messageOf(stage.start()), std::string());
        QCOMPARE(stage.backend->describe(), std::string("Script, in process"));
        stage.library = "/some/where/libscript.so";
        QVERIFY(stage.start().ok());
        QCOMPARE(stage.backend->describe(), std::string("Script from libscript.so, in process"));
    }

    void timeAndTimeSinceTheLastUpdate() {
        Stage stage;
        std::vector<double> seen;
        stage.script.update = [&](const TrundleRobot& robot, double since) {
            seen.insert(seen.end(), {robot.time(robot.context), since});
            return 0;
        };
        QVERIFY(stage.start().ok() && stage.tick(3, 0.75, 0.5).ok() && stage.tick(4, 1, 0.25).ok());
        QCOMPARE(seen, (std::vector<double>{0.75, 0.5, 1, 0.25}));
    }

    /// One controller is alive at a time, from start to stop.
    void lifetime() {
        Stage stage;
        QVERIFY(stage.start().ok());
        QCOMPARE(stage.script.alive, 1);
        QVERIFY(stage.backend->start(stage.layout, *stage.block, {}).ok());
        QCOMPARE(stage.script.alive, 1);
        stage.backend->stop();
        QCOMPARE(stage.script.alive, 0);
        stage.backend->stop();
        QCOMPARE(stage.script.alive, 0);
        QCOMPARE(messageOf(stage.tick()), std::string("the controller Script of robot0 was not started"));
        QVERIFY(stage.backend->start(stage.layout, *stage.block, {}).ok());
        stage.backend.reset();
        QCOMPARE(stage.script.alive, 0);
    }

    void failuresSayHowAndWhy() {
        Stage stage;
        stage.script.why = "no battery";
        stage.script.canCreate = false;
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 could not be made: no battery"));
        stage.script.canCreate = true;
        stage.script.setup = [](const TrundleRobot&) { return 1; };
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 failed in setup: no battery"));
        stage.script.why = "";
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 failed in setup"));
        stage.script.setup = [](const TrundleRobot&) { return 0; };
        stage.script.update = [](const TrundleRobot&, double) { return 1; };
        QVERIFY(stage.start().ok());
        QCOMPARE(messageOf(stage.tick()), std::string("the controller Script of robot0 failed"));
        // A failure of an earlier start does not end the next one.
        stage.script.setup = [](const TrundleRobot& robot) { return robot.fail(robot.context, "gone"), 0; };
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 gave up: gone"));
        stage.script.setup = [](const TrundleRobot&) { return 0; };
        stage.script.update = [](const TrundleRobot& robot, double) {
            return robot.fail(robot.context, "first"), robot.fail(robot.context, "second"), 0;
        };
        QVERIFY(stage.backend->start(stage.layout, *stage.block, {}).ok());
        QCOMPARE(messageOf(stage.tick()), std::string("the controller Script of robot0 gave up: first"));
    }

    void fieldValues() {
        Stage stage;
        stage.robot.controllers[0].values["Pair"] = numbers({3, 4});
        QVERIFY(stage.start().ok());
        QCOMPARE(stage.script.pair, (std::vector<double>{3, 4}));
        QVERIFY(stage.backend->set("Pair", {PropertyType::Number, {1, 2}, {}}).ok());
        QCOMPARE(stage.script.pair, (std::vector<double>{1, 2}));
        QCOMPARE(messageOf(stage.backend->set("Pear", {PropertyType::Number, {1, 2}, {}})),
                 std::string("the controller of robot0 has no property Pear"));
        stage.script.acceptsValues = false;
        stage.script.why = "too much";
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 refuses the value of Pair: too much"));
        stage.robot.controllers.clear(); // no text: no values
        QVERIFY(stage.start().ok());
    }

    void signalsThatExistAndThatDoNot() {
        Stage stage;
        const auto info = [](const TrundleRobot& robot, const char* component, const char* signal) {
            std::uint32_t count = 99, direction = 99;
            const std::int32_t missing = robot.signalInfo(robot.context, component, signal, &count, &direction);
            return missing ? std::string("-") : std::to_string(count) + " " + std::to_string(direction);
        };
        std::vector<std::string> seen;
        stage.script.setup = [&](const TrundleRobot& robot) {
            for (const auto& [component, signal] : {std::pair{"eye", "speed"},
                                                    {"eye", ""},
                                                    {"eye", "sped"},
                                                    {"eyes", ""},
                                                    {"", "pose"},
                                                    {"", "nothing"},
                                                    {"near", "rssi"},
                                                    {"", ""},
                                                    {"ey", "speed"}})
                seen.push_back(info(robot, component, signal));
            return robot.signalInfo(robot.context, "eye", "speed", nullptr, nullptr);
        };
        QCOMPARE(messageOf(stage.start()), std::string()); // asking is no failure
        QCOMPARE(seen, (std::vector<std::string>{"3 2", "3 2", "-", "-", "7 3", "-", "1 1", "1 1", "-"}));
    }

    void boundSlotsAreThoseOfTheBlock() {
        Stage stage;
        stage.script.setup = [](const TrundleRobot& robot) {
            double* const speed = robot.bind(robot.context, "Camera", "eye", "speed");
            speed[2] = 8;
            return robot.bind(robot.context, "", "eye", "speed") == speed ? 0 : 1;
        };
        QCOMPARE(messageOf(stage.start()), std::string());
        QCOMPARE(stage.block->slots()[stage.layout.find("robot0/eye/speed")->offset + 2], 8.0);
        stage.script.setup = [](const TrundleRobot& robot) {
            return robot.bind(robot.context, "Gripper", "hand", "grip") || robot.bind(robot.context, "", "eye", "none");
        };
        QCOMPARE(
            messageOf(stage.start()), // the first failure, with all ports since none is of that kind
            std::string("robot0 has no Gripper port 'hand' (its ports: near (Transceiver), far (Transceiver), eye (Camera))"));
        stage.script.setup = [](const TrundleRobot& robot) { return robot.bind(robot.context, "", "nearr", "rssi") ? 1 : 0; };
        QVERIFY(messageOf(stage.start()).starts_with("robot0 has no port 'nearr'; did you mean 'near'?"));
    }

    void publishWithoutAControllerInTheText() {
        Stage stage;
        stage.script.setup = [](const TrundleRobot& robot) { return robot.publish(robot.context, "sum", nullptr) ? 1 : 0; };
        stage.robot.controllers.clear();
        QCOMPARE(messageOf(stage.start()), std::string("robot0 has no controller in its text that could publish 'sum'"));
    }

    /// Draws of one tick differ from each other, from those of another tick and from those of setup.
    void randomNumbers() {
        Stage stage;
        std::vector<std::uint64_t> drawn;
        const auto draw = [&](const TrundleRobot& robot) {
            for (int i = 0; i < 3; ++i) drawn.push_back(robot.random(robot.context));
            return 0;
        };
        stage.script.setup = draw;
        stage.script.update = [&](const TrundleRobot& robot, double) { return draw(robot); };
        QVERIFY(stage.start().ok() && stage.tick(0).ok() && stage.tick(1).ok());
        QCOMPARE(std::set<std::uint64_t>(drawn.begin(), drawn.end()).size(), std::size_t{9});
        const std::vector<std::uint64_t> first = std::exchange(drawn, {});
        QVERIFY(stage.backend->start(stage.layout, *stage.block, {}).ok() && stage.tick(0).ok() && stage.tick(1).ok());
        QCOMPARE(drawn, first);
    }

    void withoutOutputs() {
        Stage stage;
        stage.script.setup = [](const TrundleRobot& robot) {
            robot.print(robot.context, TRUNDLE_INFO, "unseen");
            robot.finish(robot.context, "unheard");
            const std::int32_t log = robot.openLog(robot.context, "a.csv");
            robot.writeLog(robot.context, 0, "x", 1);
            TrundlePicture picture{};
            picture.size = sizeof picture;
            const TrundleCameras& c = *robot.cameras;
            const bool refused = c.capture(c.context, "eye", &picture) != 0 && c.save(c.context, "eye", "a.png") != 0 &&
                                 !c.objectName(c.context, 1);
            return log == -1 && refused && std::string(c.lastError(c.context)) == "this run takes no pictures" ? 0 : 1;
        };
        QCOMPARE(messageOf(stage.start()), std::string());
    }

    void consoleLogsAndTheEnd() {
        Stage stage;
        std::vector<std::string> seen;
        stage.outputs.print = [&](int severity, const std::string& text) { seen.push_back(std::to_string(severity) + text); };
        stage.outputs.finish = [&](const std::string& reason) { seen.push_back("finish " + reason); };
        stage.outputs.openLog = [&](const std::string& file) { return file == "good.csv" ? 4 : -1; };
        stage.outputs.writeLog = [&](int log, std::string_view bytes) {
            seen.push_back(std::to_string(log) + ":" + std::string(bytes));
        };
        stage.script.setup = [](const TrundleRobot& robot) {
            robot.print(robot.context, TRUNDLE_ERROR, " smoke");
            robot.finish(robot.context, "done");
            const std::int32_t log = robot.openLog(robot.context, "good.csv");
            robot.writeLog(robot.context, log, "abcdef", 3);
            robot.writeLog(robot.context, -1, "never", 5);
            robot.writeLog(robot.context, log, nullptr, 5);
            return robot.openLog(robot.context, "bad.csv") == -1 ? 0 : 1;
        };
        QCOMPARE(messageOf(stage.start()), std::string());
        QCOMPARE(seen, (std::vector<std::string>{"3 smoke", "finish done", "4:abc"}));
    }

    void pictures() {
        Stage stage;
        CameraImage image{2, 1, 5, 0.125, {1, 2, 3, 4, 5, 6}, {7, 8}, {}};
        bool broken = false;
        std::string saved;
        stage.outputs.capture = [&](const std::string& camera) -> Result<const CameraImage*> {
            if (broken) return Error{Code::PictureFailed, "no light at " + camera};
            return &image;
        };
        stage.outputs.savePicture = [&](const std::string& camera, const std::string& file) {
            saved = camera + ">" + file;
            return Status{};
        };
        stage.outputs.objectName = [](std::uint32_t object) { return object == 2 ? std::string("robot0/hull") : std::string(); };
        QVERIFY(stage.start().ok());
        const TrundleCameras& c = *stage.script.robot->cameras;
        TrundlePicture picture{};
        picture.size = sizeof picture;
        QCOMPARE(c.capture(c.context, "eye", &picture), 0);
        QVERIFY(picture.width == 2 && picture.height == 1 && picture.time == 0.125 && picture.size == sizeof picture);
        QVERIFY(picture.pixels == image.pixels.data() && picture.depth == image.depth.data() && !picture.objects);
        image.objects = {1, 2};
        image.depth.clear();
        QVERIFY(c.capture(c.context, "eye", &picture) == 0 && !picture.depth && picture.objects == image.objects.data());
        // An older module's structure is shorter: nothing is written behind it.
        TrundlePicture shorter{};
        std::memset(&shorter, 0x55, sizeof shorter);
        shorter.size = offsetof(TrundlePicture, objects);
        TrundlePicture before = shorter;
        QCOMPARE(c.capture(c.context, "eye", &shorter), 0);
        QVERIFY(shorter.width == 2 && shorter.objects == before.objects);
        QVERIFY(c.capture(c.context, "eye", nullptr) != 0);
        QCOMPARE(c.save(c.context, "eye", "a.png"), 0);
        QCOMPARE(saved, std::string("eye>a.png"));
        QCOMPARE(c.lastError(c.context), "");
        broken = true;
        QVERIFY(c.capture(c.context, "eye", &picture) != 0);
        QCOMPARE(c.lastError(c.context), "no light at eye");
        broken = false;
        QVERIFY(c.capture(c.context, "eye", &picture) == 0 && std::string(c.lastError(c.context)).empty());
        QCOMPARE(c.objectName(c.context, 2), "robot0/hull");
        QVERIFY(!c.objectName(c.context, 3));
    }

    void radiosOfTheRobot() {
        Stage stage;
        Radios radios;
        stage.outputs.radios = radiosOf(radios.medium);
        QVERIFY(stage.start().ok());
        const TrundleRobot& robot = *stage.script.robot;
        const TrundleRobotRadio& r = *robot.radio;
        QCOMPARE(r.size, std::uint32_t{sizeof r});
        std::uint32_t far = 99;
        QVERIFY(r.find(robot.context, "far", &far) == 0 && far == radios.far);
        QCOMPARE(r.address(robot.context, far), 22u);
        QCOMPARE(r.address(robot.context, 3), 0u); // there are three
        const std::uint8_t bytes[] = {9, 8, 7, 6};
        QVERIFY(r.send(robot.context, 3, bytes, 3, 21, 0) != 0);
        QCOMPARE(r.send(robot.context, far, bytes, 3, 21, -10), 0);
        std::vector<std::uint8_t> tooLong(200);
        QVERIFY(r.send(robot.context, far, tooLong.data(), 200, 21, 0) != 0);
        radios.medium.advance(20'000);
        TrundlePacket packet{};
        packet.size = sizeof packet;
        QVERIFY(!r.receive(robot.context, 3, &packet) && !r.receive(robot.context, radios.near, nullptr));
        packet.size = sizeof packet - 1;
        QVERIFY(!r.receive(robot.context, radios.near, &packet));
        packet.size = sizeof packet;
        QCOMPARE(r.receive(robot.context, radios.near, &packet), 1);
        QVERIFY(packet.count == 3 && packet.bytes[0] == 9 && packet.bytes[2] == 7 && packet.bytes[3] == 0);
        QVERIFY(packet.from == 22 && packet.to == 21 && packet.time > 0 && packet.time < 0.02);
        QVERIFY2(std::abs(packet.rssi + 59.8) < 0.1, std::to_string(packet.rssi).c_str()); // -10 dBm less 49.8 dB over 3 m
        QCOMPARE(packet.lqi, static_cast<std::uint32_t>(radios.medium.counts(radios.near).lastLqi));
        QVERIFY(!r.receive(robot.context, radios.near, &packet));
        QCOMPARE(r.send(robot.context, far, bytes, 1, 21, -10), 0);
        radios.medium.advance(40'000);
        const std::uint32_t first = packet.sequence;
        QVERIFY(r.receive(robot.context, radios.near, &packet) == 1 && packet.sequence == first + 1 && packet.count == 1);
    }

    void radiosThatAreMissing() {
        Stage stage;
        std::uint32_t radio = 5;
        stage.script.setup = [&](const TrundleRobot& robot) { return robot.radio->find(robot.context, "near", &radio) ? 0 : 1; };
        QCOMPARE(messageOf(stage.start()), std::string("the controller Script of robot0 has no medium for its radio"));
        stage.script.setup = [&](const TrundleRobot& robot) {
            robot.radio->find(robot.context, "eye", &radio);
            robot.radio->find(robot.context, "near", &radio);
            return robot.radio->address(robot.context, 0) || !robot.radio->send(robot.context, 0, nullptr, 0, 0, 0);
        };
        QCOMPARE(messageOf(stage.start()),
                 std::string("robot0 has no Transceiver port 'eye': that is of kind Camera (its Transceiver "
                             "ports: near, far)"));
        QCOMPARE(radio, 5u);
        Radios radios; // robot1 has one of that name, robot2 none
        Stage other("robot2");
        other.outputs.radios = radiosOf(radios.medium);
        other.script.setup = [&](const TrundleRobot& robot) { return robot.radio->find(robot.context, "near", &radio) ? 0 : 1; };
        QVERIFY(!other.start().ok());
    }

    /// Of a kind that says that it uses nothing that robots share: no radio at all, pictures and new logs in setup alone.
    void whatAnIndependentControllerIsRefused() {
        Radios radios;
        Stage stage;
        stage.kind.traits = TRUNDLE_INDEPENDENT;
        stage.outputs.radios = radiosOf(radios.medium);
        std::uint32_t radio = 5;
        stage.script.setup = [&](const TrundleRobot& robot) { return robot.radio->find(robot.context, "near", &radio) ? 0 : 1; };
        QCOMPARE(
            messageOf(stage.start()),
            std::string("the controller Script of robot0 says that it is independent of other robots, and asks for a radio"));
        CameraImage image{1, 1, 5, 0.125, {1, 2, 3}, {}, {}};
        stage.outputs.capture = [&](const std::string&) -> Result<const CameraImage*> { return &image; };
        stage.outputs.openLog = [](const std::string&) { return 3; };
        int taken = 0, opened = 0;
        std::string error;
        const auto ask = [&](const TrundleRobot& robot) {
            TrundlePicture picture{};
            picture.size = sizeof picture;
            taken += robot.cameras->capture(robot.cameras->context, "eye", &picture) == 0;
            error = robot.cameras->lastError(robot.cameras->context);
            opened += robot.openLog(robot.context, "a.txt") == 3;
            const std::uint8_t byte = 1;
            return robot.radio->send(robot.context, radios.near, &byte, 1, 22, 0) != 0 ? 0 : 1; // a number that it guesses
        };
        stage.script.setup = ask;
        stage.script.update = [&](const TrundleRobot& robot, double) { return ask(robot); };
        QVERIFY(stage.start().ok() && taken == 1 && opened == 1 && error.empty());
        QVERIFY(stage.tick().ok() && taken == 1 && opened == 1);
        QCOMPARE(error, std::string("its kind says that it is independent of other robots, and it asks for a picture"));
    }
};

QTEST_APPLESS_MAIN(BackendCallsTest)
#include "backend_calls_test.moc"
