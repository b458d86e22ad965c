// The contract of a device: mounting with error messages, services, the order of act and sense.
#include <QtTest>

#include "world/probe_device.h"

using namespace fixture;

class DevicesTest : public QObject {
    Q_OBJECT

    Bench m_bench;

    std::string failureOf(std::function<std::int32_t(const TrundleMount&)> setup) {
        m_bench.probes["p"].setup = std::move(setup);
        Diagnostics diagnostics;
        Scene scene = withProbes({"p"});
        if (scene.build(code, diagnostics)) return "";
        return codeName(diagnostics.all().at(0).code) + " " + diagnostics.all().at(0).message;
    }

private Q_SLOTS:
    void init() {
        m_bench = {};
        bench = &m_bench;
    }

    void wrongNamesListWhatExists() {
        const auto text = [&](auto setup) { return QString::fromStdString(failureOf(setup)); };
        std::uint32_t id;
        QString t = text([&](const TrundleMount& m) { return m.joint(m.context, "leftAxel", &id); });
        qInfo("%s", qPrintable(t));
        QVERIFY(t.startsWith("E507 r/p: ") && t.contains("leftAxle") && t.contains("rightAxle"));
        t = text([&](const TrundleMount& m) { return m.geom(m.context, "chassis.hul", &id); });
        QVERIFY(t.contains("hull") && t.contains("slider"));
        t = text([&](const TrundleMount& m) { return m.body(m.context, "", &id); });
        QVERIFY(t.contains("chassis"));
        t = text([&](const TrundleMount& m) { return m.peerSignal(m.context, "Row", "leftMoter", "command") ? 0 : -1; });
        QVERIFY(t.contains("leftMotor"));
        t = text([&](const TrundleMount& m) { return m.peerSignal(m.context, "Encoder", "leftMotor", "command") ? 0 : -1; });
        QVERIFY(t.contains("is a Row"));
        t = text([&](const TrundleMount& m) { return m.peerSignal(m.context, "Row", "leftMotor", "comand") ? 0 : -1; });
        QVERIFY(t.contains("command, position, effort"));
        t = text([&](const TrundleMount& m) {
            m.fail(m.context, "I do not like it here");
            return 0;
        });
        QVERIFY(t.contains("I do not like it here"));
        t = text([&](const TrundleMount&) { return 7; });
        QVERIFY(t.contains("the probe says no"));
    }

    /// A module built from another version than its description: a value of another count or type never reaches its code.
    void wrongCountsAreRefused() {
        for (const PropertyValue& wrong :
             {PropertyValue{PropertyType::Text, {}, {"a", "b"}}, {PropertyType::Number, {1}, {}}, {PropertyType::Text, {}, {}}}) {
            Scene scene = withProbes({"p"});
            auto config = std::make_shared<RobotConfigSpec>(*scene.spec->robots[0].config);
            config->devices.back().values["Probe"] = {wrong, {}, Origin::Config};
            scene.spec->robots[0].config = config;
            Diagnostics diagnostics;
            QVERIFY(!scene.build(code, diagnostics));
            QCOMPARE(diagnostics.all().at(0).message, std::string("r/p: Probe was refused: wrong count of elements"));
        }
    }

    /// Messages reported while the world is built, before a listener is registered, are delivered once.
    void setupMessagesReachConsole() {
        m_bench.probes["p"].setup = [](const TrundleMount& m) {
            m.print(m.context, TRUNDLE_WARNING, "the mount is loose");
            return 0;
        };
        m_bench.probes["p"].sense = [](const TrundleServices& s) {
            s.print(s.context, TRUNDLE_INFO, "dark here");
            return 0;
        };
        auto world = withProbes({"p"}).build(code);
        QVERIFY(world);
        std::vector<std::string> heard;
        world->setDeviceText([&](const std::string& path, int severity, const std::string& text) {
            heard.push_back(path + " " + std::to_string(severity) + " " + text);
        });
        const std::string info = " " + std::to_string(TRUNDLE_INFO) + " ", warning = " " + std::to_string(TRUNDLE_WARNING) + " ";
        QCOMPARE(heard, (std::vector<std::string>{"r/p" + warning + "the mount is loose", "r/p" + info + "dark here"}));
        QVERIFY(world->tick().ok());
        QCOMPARE(heard.size(), std::size_t{3});
    }

    void unknownKindIsADiagnostic() {
        Scene scene = withProbes({"p"});
        Diagnostics diagnostics;
        QVERIFY(!scene.build(rowOnly, diagnostics));
        QCOMPARE(diagnostics.all().at(0).code, Code::KindNotLoaded);
    }

    void peersFieldsCanBeRead() {
        double gain = 0;
        std::string text;
        m_bench.probes["b"].setup = [&](const TrundleMount& m) {
            text = m.peerText(m.context, "a", "Probe");
            return m.peerNumber(m.context, "a", "Gain", &gain);
        };
        QVERIFY(withProbes({"a", "b"}).build(code));
        QCOMPARE(gain, 2.5);
        QCOMPARE(text, std::string("a"));
    }

    /// b drives a: it acts first although it is later in the text, and senses last.
    void actAndSenseFollowTheBinding() {
        std::string order;
        for (const char* name : {"a", "b", "c"}) {
            m_bench.probes[name].act = [&order, name](const TrundleServices&) {
                order += name;
                return 0;
            };
            m_bench.probes[name].sense = [&order, name](const TrundleServices&) {
                order += char(name[0] - 'a' + 'A');
                return 0;
            };
        }
        m_bench.probes["b"].setup = [](const TrundleMount& m) { return m.peerSignal(m.context, "", "a", "in") ? 0 : -1; };
        auto world = withProbes({"a", "b", "c"}).build(code);
        QVERIFY(world);
        order.clear();
        QVERIFY(world->tick().ok());
        QCOMPARE(order, std::string("bacABC"));
    }

    void circlesAreRefused() {
        for (const auto& [self, other] : {std::pair{"a", "b"}, {"b", "a"}})
            m_bench.probes[self].setup = [other = other](const TrundleMount& m) {
                return m.peerSignal(m.context, "", other, "in") ? 0 : -1;
            };
        Diagnostics diagnostics;
        Scene scene = withProbes({"a", "b"});
        QVERIFY(!scene.build(code, diagnostics));
        QVERIFY(QString::fromStdString(diagnostics.all().at(0).message).contains("r/a, r/b"));
    }

    void aFailingDeviceStopsTheWorld() {
        int turns = 0;
        m_bench.probes["p"].act = [&](const TrundleServices&) { return ++turns == 3 ? 1 : 0; };
        auto world = withProbes({"p"}).build(code);
        QVERIFY(world->tick().ok() && world->tick().ok());
        const Status status = world->tick();
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, Code::DeviceSetup);
        QVERIFY(QString::fromStdString(status.error().message).contains("r/p: the probe says no"));
        QVERIFY(!world->tick().ok());
        QCOMPARE(turns, 3);
    }

    void raysSeeOthersNotTheirRobot() {
        TrundleHit hit{}, own{}, down{};
        int found = 0, foundOwn = 0, none = 1;
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            const double from[3] = {0, 0, 0.09}, ahead[3] = {1, 0, 0}, under[3] = {0, 0, -1}, back[3] = {-1, 0, 0};
            found = s.ray(s.context, from, ahead, 10, 0, &hit);
            const double outside[3] = {1, 0, 0.09};
            foundOwn = s.ray(s.context, outside, back, 10, 1, &own);
            none = s.ray(s.context, from, ahead, 1, 0, nullptr);
            return s.ray(s.context, from, under, 10, 0, &down) ? 0 : 1;
        };
        auto world = withProbes({"p"}).build(code);
        QVERIFY(world && world->tick().ok());
        QCOMPARE(found, 1);
        QVERIFY(std::abs(hit.distance - 2) < 1e-9);
        QVERIFY(std::abs(hit.normal[0] + 1) < 1e-9);
        QCOMPARE(foundOwn, 1);
        QVERIFY(std::abs(own.distance - 0.88) < 1e-3); // the hull's front at 0.12
        QCOMPARE(none, 0);
        QVERIFY(std::abs(down.distance - 0.09) < 1e-9);
    }

    void contactsHaveForceAndSide() {
        std::uint32_t geom = 0, count = 0;
        TrundleContact contacts[4];
        m_bench.probes["p"].setup = [&](const TrundleMount& m) { return m.geom(m.context, "leftWheel.tyre", &geom); };
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            count = s.contacts(s.context, geom, contacts, 4);
            return 0;
        };
        auto world = withProbes({"p"}).build(code);
        QVERIFY(run(*world, 1));
        QCOMPARE(count, 1u);
        QVERIFY(std::abs(contacts[0].normal[2] - 1) < 1e-9);
        QVERIFY(contacts[0].force > 15 && contacts[0].force < 19);
        QVERIFY(contacts[0].depth > 0 && contacts[0].depth < 2e-4);
    }

    /// Each of two robots that touch sees the contact from its own side, whichever is listed first.
    void contactsOfBothRobots() {
        for (const bool swapped : {false, true}) {
            std::uint32_t geoms[2];
            std::vector<TrundleContact> seen[2];
            Scene scene = r0Scene(0.002);
            scene.spec->settings.gravity = Vec3::Zero();
            for (const int i : {0, 1}) {
                const std::string name = i ? "right" : "left";
                m_bench.probes[name].setup = [&, i](const TrundleMount& m) { return m.geom(m.context, "b.g", &geoms[i]); };
                m_bench.probes[name].sense = [&, i](const TrundleServices& s) {
                    seen[i].resize(8);
                    seen[i].resize(s.contacts(s.context, geoms[i], seen[i].data(), 8));
                    return 0;
                };
            }
            for (const int i : {swapped ? 1 : 0, swapped ? 0 : 1}) {
                auto config = std::make_shared<RobotConfigSpec>();
                config->bodies.push_back(body("b", {}, massOfSphere(i ? 3 : 1, 0.1), {sphere("g", 0.1)}));
                config->devices.push_back(probe(i ? "right" : "left"));
                scene.robot(i ? "right" : "left", at(i ? 0.198 : 0, 0, 1), config);
            }
            auto world = scene.build(code);
            QVERIFY(world->push("left/b", {50, 0, 0}, {0, 0, 1}).ok());
            QVERIFY(world->tick().ok());
            QVERIFY(seen[0].size() == 1 && seen[1].size() == 1);
            QVERIFY(seen[0][0].normal[0] < -0.99 && seen[1][0].normal[0] > 0.99);
            QVERIFY(seen[0][0].other == geoms[1] && seen[1][0].other == geoms[0]);
            QVERIFY(seen[0][0].force > 0 && seen[0][0].force == seen[1][0].force);
        }
    }

    /// What a device reads of bodies and joints is what is published, for a robot that is turned and tumbles.
    void statesOfATumblingRobot() {
        Scene scene = r0Scene(0.005);
        scene.spec->settings.gravity = Vec3(0.3, -0.2, -1);
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        config->devices.push_back(probe("p"));
        const Pose start = at(1, 2, 30, degrees(70, -20, 35));
        scene.robot("r", start, config);
        std::uint32_t body = 0, joint = 0;
        TrundleBodyState state{};
        double anchor[3], axis[3];
        m_bench.probes["p"].setup = [&](const TrundleMount& m) {
            return m.body(m.context, "leftWheel", &body) + m.joint(m.context, "rightAxle", &joint);
        };
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            s.bodyState(s.context, body, &state);
            s.jointAnchor(s.context, joint, anchor, axis);
            return 0;
        };
        auto world = scene.build(code);
        QVERIFY(world->push("r/chassis", {400, -300, 500}, start * Vec3(0.1, 0.05, 0.1)).ok());
        for (int i = 0; i < 40; ++i) {
            QVERIFY(world->tick().ok());
            const double *pose = slot(*world, "r/leftWheel/pose"), *moving = slot(*world, "r/leftWheel/velocity");
            for (int k = 0; k < 3; ++k) {
                QCOMPARE(state.position[k], pose[k]);
                QCOMPARE(state.linear[k], moving[k]);
                QCOMPARE(state.angular[k], moving[3 + k]);
            }
            for (int k = 0; k < 4; ++k) QCOMPARE(state.quaternion[k], pose[3 + k]);
            const double* c = slot(*world, "r/chassis/pose"); // the parent, whose frame is the config's
            const Pose chassis{Vec3(c), Quat(c[3], c[4], c[5], c[6])};
            QVERIFY((Vec3(anchor) - chassis * Vec3(0, -kR0Track / 2, kR0Radius)).norm() < 1e-9);
            QVERIFY((Vec3(axis) - chassis.rotation * Vec3::UnitY()).norm() < 1e-9);
        }
        QVERIFY(Vec3(state.angular).norm() > 1);
    }

    /// Of a joint to the world: fixed until the robot is placed, then turned and moved with it, each time.
    void aJointToTheWorldMovesWhenItsRobotIsPlaced() {
        Scene scene = r0Scene();
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("arm", at(0.3, 0, 0.2), massOfBox(1, {0.2, 0.1, 0.1}), {box("b", {0.2, 0.1, 0.1})}));
        config->bodies.push_back(body("hand", at(0.3, 0.4, 0.2), massOfSphere(0.5, 0.05), {sphere("s", 0.05)}));
        const Vec3 worldAxis(0.6, 0, 0.8), anchor(0.1, -0.2, 0.3), wristAxis(0, 0.6, -0.8), wrist(0.3, 0.3, 0.2);
        config->joints.push_back(joint("foot", JointType::Hinge, kWorldBody, 0, anchor, worldAxis));
        config->joints.push_back(joint("wrist", JointType::Hinge, 0, 1, wrist, wristAxis));
        config->devices.push_back(probe("p"));
        const Pose start = at(1, 2, 3, degrees(30, 0, 0));
        scene.robot("r", start, config);
        std::uint32_t joints[2];
        Vec3 anchors[2], axes[2];
        m_bench.probes["p"].setup = [&](const TrundleMount& m) {
            return m.joint(m.context, "foot", &joints[0]) + m.joint(m.context, "wrist", &joints[1]);
        };
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            for (int i = 0; i < 2; ++i) s.jointAnchor(s.context, joints[i], anchors[i].data(), axes[i].data());
            return 0;
        };
        auto world = scene.build(code);
        QVERIFY(world);
        const auto isAt = [&](const Pose& pose) {
            return (anchors[0] - pose * anchor).norm() < 1e-9 && (axes[0] - pose.rotation * worldAxis).norm() < 1e-9 &&
                   (anchors[1] - pose * wrist).norm() < 1e-9 && (axes[1] - pose.rotation * wristAxis).norm() < 1e-9;
        };
        QVERIFY(world->tick().ok());
        QVERIFY(isAt(start));
        for (const Pose& pose : {at(-4, 1, 2, degrees(100, 20, -30)), at(5, -1, 0, degrees(-70, 0, 0))}) {
            QVERIFY(world->place("r", pose).ok());
            QVERIFY(world->tick().ok());
            QVERIFY(isAt(pose));
        }
    }

    void randomIsAFunctionOfWhereAndWhen() {
        std::vector<std::uint64_t> numbers[2];
        for (int again = 0; again < 2; ++again) {
            for (const char* name : {"a", "b"})
                m_bench.probes[name].sense = [&, again](const TrundleServices& s) {
                    numbers[again].push_back(s.random(s.context, 0));
                    return 0;
                };
            auto world = withProbes({"a", "b"}).build(code);
            QVERIFY(run(*world, 0.05));
        }
        QVERIFY(numbers[0] == numbers[1]);
        std::sort(numbers[0].begin(), numbers[0].end());
        QVERIFY(std::adjacent_find(numbers[0].begin(), numbers[0].end()) == numbers[0].end());
    }

    void actuationOutsideActIsIgnored() {
        std::uint32_t id = 0;
        m_bench.probes["p"].setup = [&](const TrundleMount& m) { return m.body(m.context, "chassis", &id); };
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            const double force[3] = {1000, 0, 0}, point[3] = {0, 0, 0};
            s.bodyForce(s.context, id, force, point);
            return 0;
        };
        auto world = withProbes({"p"}).build(code);
        QVERIFY(run(*world, 0.5));
        QVERIFY(std::abs(world->robotPose(0).position.x()) < 1e-3);
    }

    void jointTorqueTurnsTheChild() {
        std::uint32_t id = 0;
        m_bench.probes["p"].setup = [&](const TrundleMount& m) { return m.joint(m.context, "leftAxle", &id); };
        m_bench.probes["p"].act = [&](const TrundleServices& s) {
            s.jointTorque(s.context, id, 0.1);
            return 0;
        };
        Scene scene = withProbes({"p"}, at(0, 0, 5));
        scene.spec->settings.gravity = Vec3::Zero();
        auto world = scene.build(code);
        QVERIFY(run(*world, 0.1));
        QVERIFY(value(*world, "r/leftAxle/rate") > 1);
        QVERIFY(std::abs(value(*world, "r/rightAxle/rate")) < 0.5);
    }

    /// A belt: a geom whose surface moves carries a crate along at its speed.
    void surfaceVelocityCarries() {
        std::uint32_t geom = 0;
        m_bench.probes["belt"].setup = [&](const TrundleMount& m) { return m.geom(m.context, "frame.top", &geom); };
        m_bench.probes["belt"].act = [&](const TrundleServices& s) {
            const double v[3] = {0.3, 0, 0};
            s.surfaceVelocity(s.context, geom, v);
            return 0;
        };
        Scene scene;
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("frame", at(0, 0, 0.5), massOfBox(50, {4, 1, 0.2}), {box("top", {4, 1, 0.2})}));
        config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 0.5}, Vec3::UnitZ()));
        config->devices.push_back(probe("belt"));
        scene.robot("conveyor", at(0, 0, 0, degrees(90, 0, 0)), config);
        const Vec3 size(0.2, 0.2, 0.2);
        scene.loose("crate", at(0, 0, 0.7), massOfBox(1, size), {box("crate", size)});
        auto world = scene.build(code);
        QVERIFY(world && run(*world, 2));
        const Vec3 v = velocity(*world, "crate/body");
        QVERIFY(std::abs(v.y() - 0.3) < 1e-3 && std::abs(v.x()) < 1e-3); // the belt's own x points along the world's y
    }

    void signalsAreWhereTheyShouldBe() {
        auto world = withProbes({"p"}).build(code);
        for (const char* path : {"r/pose", "r/velocity", "r/chassis/pose", "r/leftWheel/velocity", "r/leftAxle/position",
                                 "r/leftAxle/rate", "r/p/in", "r/p/out"})
            QVERIFY2(world->layout().find(path), path);
        QCOMPARE(world->layout().find("r/pose")->direction, SignalDirection::Truth);
        QCOMPARE(world->layout().find("r/p/in")->direction, SignalDirection::Command);
        QCOMPARE(world->layout().images().size(), std::size_t{1});
        QCOMPARE(world->block().header().tick, std::uint64_t{0});
        QVERIFY(world->tick().ok());
        QCOMPARE(world->block().header().tick, std::uint64_t{1});
        QCOMPARE(world->block().header().sequence % 2, std::uint64_t{0});
    }

    /// At tick 0 the pose is the text's, to the bit, even where the first body is elsewhere.
    void poseAtTheStartIsExact() {
        Scene scene = r0Scene();
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        config->bodies[0].pose = at(0.1, 0.2, 0.3, degrees(10, 20, 30));
        const Pose start = at(-1.5, 0.1, 0.7, degrees(33, 0, 0));
        scene.robot("r", start, config);
        auto world = scene.build();
        for (int k = 0; k < 3; ++k) QCOMPARE(value(*world, "r/pose", k), start.position[k]);
        QCOMPARE(value(*world, "r/pose", 3), start.rotation.w());
        QCOMPARE(value(*world, "r/pose", 6), start.rotation.z());
    }
};

QTEST_APPLESS_MAIN(DevicesTest)
#include "devices_test.moc"
