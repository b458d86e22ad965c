// Body poses read from the signal block.
#include <QtTest>

#include <numbers>

#include "scene/queries/poses.h"

using namespace trundle;

namespace {

/// Two robots of one config with a body 1 m in front of the first.
ExperimentSpec twoRobots() {
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.resize(2);
    config->bodies[0].name = "chassis";
    config->bodies[1].name = "arm";
    config->bodies[1].pose.position = {1, 0, 0.2};
    ExperimentSpec experiment;
    experiment.robots.resize(2);
    experiment.robots[0] = {"a", {{5, 0, 0}, rotationFromHpr({std::numbers::pi / 2, 0, 0})}, config, {}, {}};
    experiment.robots[1] = {"b", {{-5, 0, 0}, Quat::Identity()}, config, {}, {}};
    return experiment;
}

SignalLayout layoutFor(const std::vector<std::string>& paths) {
    SignalLayout layout;
    layout.beginRobot("a");
    layout.add("other", "m", SignalType::Real, SignalDirection::Output);
    for (const std::string& path : paths) {
        const std::size_t slash = path.find('/');
        if (const std::string robot = path.substr(0, slash); robot != layout.images().back().robot) layout.beginRobot(robot);
        layout.add(path.substr(slash + 1), "m", SignalType::Real, SignalDirection::Truth, 7);
    }
    return layout;
}

void write(SignalBlock& block, const SignalLayout& layout, const char* path, std::array<double, 7> values) {
    std::copy(values.begin(), values.end(), block.slots().begin() + layout.find(path)->offset);
}

} // namespace

class PosesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bodiesStartAtTextPoses() {
        const BodyPoses poses = startPoses(twoRobots());
        QCOMPARE(poses.size(), std::size_t(4));
        QVERIFY((poses[0].position - Vec3(5, 0, 0)).norm() < 1e-12);
        QVERIFY((poses[1].position - Vec3(5, 1, 0.2)).norm() < 1e-12); // the robot looks along +y
        QVERIFY((poses[3].position - Vec3(-4, 0, 0.2)).norm() < 1e-12);
    }

    void readsPosesFromSignalBlock() {
        const ExperimentSpec experiment = twoRobots();
        const SignalLayout layout = layoutFor({"a/chassis/pose", "a/arm/pose", "b/chassis/pose", "b/arm/pose"});
        SignalBlock block(layout);
        write(block, layout, "a/chassis/pose", {1, 2, 3, 0, 0, 0, 2}); // w x y z; it is normalised
        write(block, layout, "a/arm/pose", {4, 5, 6, 1, 0, 0, 0});
        write(block, layout, "b/chassis/pose", {7, 8, 9, 1, 0, 0, 0});
        write(block, layout, "b/arm/pose", {-1, -2, -3, 1, 0, 0, 0});
        BodyPoses poses;
        const PoseReader reader(experiment, layout);
        QCOMPARE(reader.found(), std::size_t(4));
        reader.read(block, poses);
        QCOMPARE(poses.size(), std::size_t(4));
        QCOMPARE(poses[0].position.y(), 2.0);
        QVERIFY((poses[0].rotation * Vec3::UnitX() - Vec3(-1, 0, 0)).norm() < 1e-12); // half a turn about z
        QCOMPARE(poses[3].position.z(), -3.0);
    }

    void ignoresInvalidPoses() {
        const ExperimentSpec experiment = twoRobots();
        const SignalLayout layout = layoutFor({"a/chassis/pose", "a/arm/pose"});
        SignalBlock block(layout);
        write(block, layout, "a/chassis/pose", {std::nan(""), 0, 0, 1, 0, 0, 0});
        write(block, layout, "a/arm/pose", {1, 1, 1, 0, 0, 0, 0}); // invalid quaternion: identity
        BodyPoses poses;
        const PoseReader reader(experiment, layout);
        QCOMPARE(reader.found(), std::size_t(2));
        reader.read(block, poses);
        const BodyPoses start = startPoses(experiment);
        for (std::size_t i = 0; i < start.size(); ++i) QVERIFY((poses[i].position - start[i].position).norm() == 0);
    }

    void ledsShowTheirColourWhileTheyShine() {
        ExperimentSpec experiment = twoRobots();
        auto config = std::make_shared<RobotConfigSpec>(*experiment.robots[0].config);
        config->devices.resize(1);
        config->devices[0].kind = "Led";
        config->devices[0].name = "led";
        for (RobotSpec& robot : experiment.robots) robot.config = config;
        const LedColour white{1, 1, 1}, dark{0, 0, 0};
        QVERIFY(startPoses(experiment).leds == (std::vector<LedColour>{white, white})); // as its properties say
        SignalLayout layout;
        layout.beginRobot("a");
        layout.add("led/color", "", SignalType::Real, SignalDirection::Command, 3);
        layout.add("led/lit", "", SignalType::Boolean, SignalDirection::Output);
        SignalBlock block(layout);
        const auto at = [&](const char* path) { return block.slots().begin() + layout.find(path)->offset; };
        BodyPoses poses;
        const PoseReader reader(experiment, layout);
        reader.read(block, poses);
        QVERIFY(poses.leds == (std::vector<LedColour>{dark, white}));
        const double commanded[] = {0.5, 7, std::nan("")};
        std::copy(std::begin(commanded), std::end(commanded), at("a/led/color"));
        *at("a/led/lit") = 1;
        reader.read(block, poses);
        QVERIFY(poses.leds == (std::vector<LedColour>{{0.5f, 1, 0}, white}));
        *at("a/led/lit") = 0; // switched off, of the colour that it was commanded
        reader.read(block, poses);
        QVERIFY(poses.leds == (std::vector<LedColour>{dark, white}));
        *at("a/led/lit") = 1;
        reader.read(block, poses);
        QVERIFY(poses.leds == (std::vector<LedColour>{{0.5f, 1, 0}, white}));
    }

    /// Each has a switch and a colour of its own.
    void twoLedsOfTwoRobotsShineByThemselves() {
        ExperimentSpec experiment = twoRobots();
        auto config = std::make_shared<RobotConfigSpec>(*experiment.robots[0].config);
        config->devices.resize(2);
        SignalLayout layout;
        for (std::size_t i = 0; i < 2; ++i) config->devices[i].kind = "Led", config->devices[i].name = i ? "rear" : "front";
        for (RobotSpec& robot : experiment.robots) {
            robot.config = config;
            layout.beginRobot(robot.name);
            for (const ComponentSpec& led : config->devices) {
                layout.add(led.name + "/color", "", SignalType::Real, SignalDirection::Command, 3);
                layout.add(led.name + "/lit", "", SignalType::Boolean, SignalDirection::Output);
            }
        }
        SignalBlock block(layout);
        const std::vector<std::string> leds{"a/front", "a/rear", "b/front", "b/rear"};
        std::vector<LedColour> colours;
        for (std::size_t i = 0; i < leds.size(); ++i) {
            const auto colour = block.slots().begin() + layout.find(leds[i] + "/color")->offset;
            for (std::size_t k = 0; k < 3; ++k) colour[k] = 0.125 * static_cast<double>(1 + i + k);
            colours.push_back({0.125f * float(1 + i), 0.125f * float(2 + i), 0.125f * float(3 + i)});
        }
        const PoseReader reader(experiment, layout);
        for (unsigned on = 0; on < 16; ++on) {
            std::vector<LedColour> expected(4, LedColour{0, 0, 0});
            for (std::size_t i = 0; i < leds.size(); ++i) {
                const bool lit = (on >> i & 1) != 0;
                block.slots()[layout.find(leds[i] + "/lit")->offset] = lit;
                if (lit) expected[i] = colours[i];
            }
            BodyPoses poses;
            reader.read(block, poses);
            QVERIFY(poses.leds == expected);
        }
    }

    void aSignalOfAnotherShapeIsNoPose() {
        const ExperimentSpec experiment = twoRobots();
        SignalLayout layout;
        layout.beginRobot("a");
        layout.add("chassis/pose", "m", SignalType::Real, SignalDirection::Truth, 3);
        QCOMPARE(PoseReader(experiment, layout).found(), std::size_t(0));
    }

    /// Of a Pen's line as many points as are written, no more than it has place for; what is not finite is left out.
    void linesOfPens() {
        ExperimentSpec experiment = twoRobots();
        auto config = std::make_shared<RobotConfigSpec>(*experiment.robots[0].config);
        config->devices.resize(1);
        config->devices[0].kind = "Pen";
        config->devices[0].name = "pen";
        const auto given = [&](const char* key, std::vector<double> numbers) {
            config->devices[0].values[key] = {{PropertyType::Number, std::move(numbers), {}}, {}, Origin::Config};
        };
        given("Width", {0.004});
        given("ColorRGB", {0.25, 0.5, 0.75});
        experiment.robots[1].config = config; // the first robot has none
        SignalLayout layout;
        layout.beginRobot("b");
        layout.add("pen/line", "m", SignalType::Real, SignalDirection::Output, 12); // three points
        layout.add("pen/points", "", SignalType::Integer, SignalDirection::Output);
        layout.add("other", "", SignalType::Real, SignalDirection::Output, 20);
        SignalBlock block(layout);
        std::vector<double> line{1, 2, 3, 1, std::nan(""), 5, 6, 0, 7, 8, 9, 0};
        std::ranges::copy(line, block.slots().begin() + layout.find("b/pen/line")->offset);
        const PoseReader reader(experiment, layout);
        BodyPoses poses;
        for (const auto& [count, points] : {std::pair(0., 0), {1., 1}, {2., 1}, {3., 2}, {9., 2}, {-1., 0}, {std::nan(""), 0}}) {
            block.slots()[layout.find("b/pen/points")->offset] = count;
            reader.read(block, poses);
            QVERIFY(poses.lines && poses.lines->size() == 1);
            const PenLine& pen = poses.lines->front();
            QVERIFY(pen.width == 0.004 && pen.colour == (std::array{0.25, 0.5, 0.75}));
            QCOMPARE(int(pen.points.size()), points);
            if (points > 0) QVERIFY(pen.points[0].at == Vec3(1, 2, 3) && pen.points[0].begins);
            if (points > 1) QVERIFY(pen.points[1].at == Vec3(7, 8, 9) && !pen.points[1].begins);
        }
        const SignalLayout none;
        reader.read(SignalBlock(none), poses); // of another run: nothing of it is read
        QVERIFY(poses.lines && poses.lines->empty());
    }

    /// Leds of the second robot are on its bodies; those of other shapes of signals stay as they are.
    void ledsAreOnTheirBodies() {
        ExperimentSpec experiment = twoRobots();
        auto config = std::make_shared<RobotConfigSpec>(*experiment.robots[0].config);
        config->devices.resize(2);
        for (std::size_t i = 0; i < 2; ++i) {
            ComponentSpec& led = config->devices[i];
            led.kind = "Led";
            led.name = i ? "rear" : "front";
            led.values["Body"] = {{PropertyType::Reference, {}, {i ? "chassis" : "arm"}}, {}, Origin::Config};
            led.values["On"] = {{PropertyType::Boolean, {double(i)}, {}}, {}, Origin::Config};
            led.values["Diameter"] = {{PropertyType::Number, {0.01 + 0.01 * double(i)}, {}}, {}, Origin::Config};
            led.values["Pos"] = {{PropertyType::Number, {1, 2, 3}, {}}, {}, Origin::Config};
            led.values["HPR"] = {{PropertyType::Number, {std::numbers::pi / 2, 0, 0}, {}}, {}, Origin::Config};
        }
        for (RobotSpec& robot : experiment.robots) robot.config = config;
        const std::vector<LedModel> leds = ledsOf(experiment);
        QCOMPARE(leds.size(), std::size_t(4));
        const std::pair<std::string, std::size_t> expected[] = {{"a/front", 1}, {"a/rear", 0}, {"b/front", 3}, {"b/rear", 2}};
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY((std::pair(leds[i].path, leds[i].body) == expected[i]));
            QCOMPARE(leds[i].atStart, i % 2 ? (LedColour{1, 1, 1}) : (LedColour{0, 0, 0}));
            QCOMPARE(leds[i].diameter, i % 2 ? 0.02 : 0.01);
            QVERIFY((leds[i].mounting * Vec3::UnitX() - Vec3(1, 3, 3)).norm() < 1e-12);
        }
        SignalLayout layout;
        layout.beginRobot("a");
        layout.add("front/color", "", SignalType::Real, SignalDirection::Command, 4);
        layout.add("front/lit", "", SignalType::Boolean, SignalDirection::Output);
        SignalBlock block(layout);
        for (double& slot : block.slots()) slot = 0.5;
        BodyPoses poses;
        PoseReader(experiment, layout).read(block, poses);
        QCOMPARE(poses.leds[0], (LedColour{0, 0, 0}));
        BodyPoses old = poses; // of a text with fewer Leds
        old.leds.resize(1);
        PoseReader(experiment, layout).read(block, old);
        QCOMPARE(old.leds.size(), std::size_t(4));
    }

    void ofAnotherSizeOrTooLongAPoseIsNone() {
        const ExperimentSpec experiment = twoRobots();
        SignalLayout layout;
        layout.beginRobot("a");
        layout.add("chassis/pose", "m", SignalType::Real, SignalDirection::Truth, 8);
        layout.add("arm/pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        SignalBlock block(layout);
        write(block, layout, "a/arm/pose", {1, 1, 1, 1e7, 0, 0, 0});
        const PoseReader reader(experiment, layout);
        QCOMPARE(reader.found(), std::size_t(1));
        BodyPoses poses;
        reader.read(block, poses);
        QVERIFY((poses[1].position - startPoses(experiment)[1].position).norm() == 0);
    }
};

QTEST_APPLESS_MAIN(PosesTest)
#include "poses_test.moc"
