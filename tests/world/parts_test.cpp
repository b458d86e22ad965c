// Parts by themselves: grids compared with brute force, contacts of wheels, an actor that fails, the order of devices.
#include <QtTest>

#include <random>

#include "world/broad_phase.h"
#include "world/device_order.h"
#include "world/engine.h"
#include "world/fixtures.h"
#include "world/ode/collision/cylinder_on_box.h"
#include "world/wheel_contact.h"

using namespace fixture;

namespace {

std::vector<Box3> randomBoxes(int count, unsigned seed, double largest) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> place(-5, 5), size(0.01, largest);
    std::vector<Box3> boxes;
    for (int i = 0; i < count; ++i) {
        Box3 b;
        for (int k = 0; k < 3; ++k) {
            b.lo[k] = place(rng);
            b.hi[k] = b.lo[k] + (i % 17 == 0 ? 10 : 1) * size(rng);
        }
        boxes.push_back(b);
    }
    return boxes;
}

} // namespace

class PartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void pairGridFindsWhatBruteForceFinds() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const auto boxes = randomBoxes(150, seed, 0.1 * seed);
            std::vector<IndexPair> found, expected;
            PairGrid grid;
            grid.pairs(boxes, found);
            for (std::uint32_t a = 0; a < boxes.size(); ++a)
                for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
                    if (boxes[a].touches(boxes[b])) expected.emplace_back(a, b);
            QVERIFY(found == expected);
            found.clear();
            std::vector<std::uint32_t> partners;
            for (std::uint32_t a = 0; a < boxes.size(); ++a) {
                grid.partnersOf(a, boxes, partners);
                for (const std::uint32_t b : partners) found.emplace_back(a, b);
            }
            QVERIFY(found == expected);
        }
    }

    void staticGridFindsWhatBruteForceFinds() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const auto boxes = randomBoxes(200, seed, 0.05 * seed), asked = randomBoxes(50, seed + 100, 1);
            StaticGrid grid;
            grid.build(boxes);
            for (const Box3& box : asked) {
                std::vector<std::uint32_t> found, expected;
                grid.query(box, found);
                for (std::uint32_t i = 0; i < boxes.size(); ++i)
                    if (boxes[i].touches(box)) expected.push_back(i);
                QVERIFY(found == expected);
            }
        }
    }

    void wheelOnFloor() {
        GroundContact c;
        const WheelPose wheel{{1, 2, 0.049}, Vec3::UnitY(), 0.05};
        QCOMPARE(wheelOnPlane(wheel, Vec3::UnitZ(), 0, c), WheelContactResult::Contact);
        QVERIFY((c.position - Vec3(1, 2, -0.001)).norm() < 1e-12);
        QVERIFY(std::abs(c.depth - 0.001) < 1e-12);
        QCOMPARE(wheelOnPlane({{0, 0, 0.06}, Vec3::UnitY(), 0.05}, Vec3::UnitZ(), 0, c), WheelContactResult::NoContact);
        QCOMPARE(wheelOnPlane({{0, 0, 0.01}, Vec3::UnitZ(), 0.05}, Vec3::UnitZ(), 0, c), WheelContactResult::Unknown);
        const Vec3 half(1, 1, 0.1);
        QCOMPARE(wheelOnBox({{0, 0, 0.149}, Vec3::UnitY(), 0.05}, Vec3::Zero(), Mat3::Identity(), half, c),
                 WheelContactResult::Contact);
        QVERIFY(std::abs(c.depth - 0.001) < 1e-12);
        QCOMPARE(wheelOnBox({{0.98, 0, 0.149}, Vec3::UnitY(), 0.05}, Vec3::Zero(), Mat3::Identity(), half, c),
                 WheelContactResult::Unknown);
    }

    /// A wheel that leans, on a slope and on a turned box: its tread's lowest point is in its middle plane, at its radius.
    void leaningWheel() {
        const Pose tilt{Vec3(0.3, -0.2, 1), rotationFromHpr(degrees(40, 10, -25))};
        const Vec3 normal = tilt.rotation * Vec3::UnitZ();
        for (const double lean : {-30., 0., 20.}) {
            const Vec3 axle = tilt.rotation * (rotationFromHpr(degrees(0, 0, lean)) * Vec3::UnitY());
            const WheelPose wheel{tilt * Vec3(0.1, 0.05, 0.049 * std::cos(lean * kPi / 180)), axle, 0.05};
            GroundContact plane, block;
            QCOMPARE(wheelOnPlane(wheel, normal, normal.dot(tilt.position), plane), WheelContactResult::Contact);
            const Mat3 axes = tilt.rotation.toRotationMatrix();
            QCOMPARE(wheelOnBox(wheel, tilt * Vec3(0, 0, -0.5), axes, Vec3(1, 1, 0.5), block), WheelContactResult::Contact);
            for (const GroundContact& c : {plane, block}) {
                QVERIFY(std::abs((c.position - wheel.centre).dot(axle)) < 1e-12);
                QVERIFY(std::abs((c.position - wheel.centre).norm() - 0.05) < 1e-12);
                QVERIFY((c.normal - normal).norm() < 1e-12);
                QVERIFY(std::abs(c.depth - 0.001 * std::cos(lean * kPi / 180)) < 1e-12);
            }
        }
    }

    /// ODE finds no contact of such wheels: they enter a bumper sideways, above or below its middle by more than half its height.
    void wheelMeetsBumper() {
        std::mt19937 rng(5);
        std::uniform_real_distribution<double> unit(0, 1);
        const Vec3 half(0.01, 0.15, 0.02);
        int measured = 0;
        FlatPair pair;
        for (int i = 0; i < 2000; ++i) {
            const double heading = 2.8 * (unit(rng) - 0.5), deep = 0.018 * unit(rng) - 0.003, below = 0.02 + 0.01 * unit(rng);
            const double chord = std::sqrt(0.05 * 0.05 - (below - 0.02) * (below - 0.02));
            const double reach = chord * std::abs(std::cos(heading)) + 0.015 * std::abs(std::sin(heading));
            const Mat3 axes = (rotationFromHpr(Vec3(heading, 0, 0)) * rotationFromHpr(degrees(0, 0, 90)) *
                               rotationFromHpr(Vec3(6 * unit(rng), 0, 0)))
                                  .toRotationMatrix();
            const Vec3 at(0.01 + reach - deep, 0.16 * (unit(rng) - 0.5), (i % 2 ? 1 : -1) * below);
            const PlacedCylinder wheel{at, axes, 0.05, 0.015};
            const PlacedBox bumper{Vec3::Zero(), Mat3::Identity(), half};
            if (std::abs(deep) < 2e-4) continue;
            QCOMPARE(overlap(wheel, bumper), deep > 0);
            if (deep < 0) continue;
            const FlatTouch& touch = cylinderOnBox(wheel, bumper, pair);
            QVERIFY(!touch.apart);
            if (touch.normal.x() < 0.99) continue; // another face is nearer
            double deepest = 0;
            for (const FlatContact& c : touch.contacts) deepest = std::max(deepest, c.depth);
            if (touch.contacts.empty()) continue; // only edges cross
            ++measured;
            QVERIFY2(std::abs(deepest - deep) < 5e-4, qPrintable(QString("%1 for %2").arg(deepest).arg(deep)));
        }
        QVERIFY(measured > 1000);
    }

    /// Such a pair is pushed apart, whichever of the two is the first.
    void barAndCanPartAgain() {
        const Quat lying = rotationFromHpr(degrees(0, 0, 90));
        const Vec3 size(0.02, 0.3, 0.04);
        for (const bool barFirst : {true, false})
            for (const double side : {1., -1.})
                for (const double height : {0.025, -0.025}) {
                    Scene scene;
                    scene.spec->settings.gravity = Vec3::Zero();
                    const double start = 0.01 + std::sqrt(0.05 * 0.05 - 0.005 * 0.005) - 0.003; // 3 mm into the bar's edge
                    const auto add = [&](bool isBar) {
                        if (isBar) scene.loose("bar", {}, massOfBox(1, size), {box("b", size)});
                        else
                            scene.loose("can", at(side * start, 0, height), massOfCylinder(1, 0.05, 0.03, lying),
                                        {cylinder("c", 0.05, 0.03, {Vec3::Zero(), lying})});
                    };
                    add(barFirst);
                    add(!barFirst);
                    auto world = scene.build();
                    QVERIFY(world && world->tick().ok());
                    QVERIFY(!world->contacts().empty());
                    for (const WorldContact& c : world->contacts())
                        QVERIFY((c.first.starts_with("bar/") ? -side : side) * c.normal.x() > 0.9); // towards the first
                    QVERIFY(run(*world, 0.1));
                    QVERIFY(side * (position(*world, "can/body") - position(*world, "bar/body")).x() > start + 5e-4);
                }
    }

    /// Of any orientation, against random points of the cylinder.
    void cylinderOverlapsBox() {
        std::mt19937 rng(9);
        std::uniform_real_distribution<double> unit(-1, 1);
        const Vec3 half(0.05, 0.1, 0.025);
        int overlapping = 0;
        for (int i = 0; i < 400; ++i) {
            const Quat turn = Quat(unit(rng), unit(rng), unit(rng), unit(rng)).normalized();
            const Vec3 at(0.12 * unit(rng), 0.15 * unit(rng), 0.1 * unit(rng));
            bool sampled = false;
            for (int k = 0; k < 20000 && !sampled; ++k) {
                const Vec3 p(0.05 * unit(rng), 0.05 * unit(rng), 0.03 * unit(rng));
                sampled = std::hypot(p.x(), p.y()) < 0.05 && ((at + turn * p).cwiseAbs().array() < half.array()).all();
            }
            const bool found = overlap({at, turn.toRotationMatrix(), 0.05, 0.03}, {Vec3::Zero(), Mat3::Identity(), half});
            overlapping += sampled;
            if (sampled) QVERIFY(found);
            else if (found) QVERIFY(overlap({at, turn.toRotationMatrix(), 0.053, 0.033}, {Vec3::Zero(), Mat3::Identity(), half}));
        }
        QVERIFY(overlapping > 100);
    }

    /// What could be made of an actor that fails is gone again: the next one is as if it had come first.
    void failedActorLeavesNothing() {
        const auto ends = [](bool failsFirst) {
            const EngineSettings settings{{0, 0, -g}, 1, SolverChoice::Auto, 20, 0.8, {SurfaceSpec{"s", 0.5, 0, 0, 0, {}}}};
            auto engine = std::move(makeOdeEngine(settings)).value();
            (void)engine->addStatic(plane(), {});
            const auto config = std::make_shared<RobotConfigSpec>(*r0({1, true, false, 0, 0, 0}));
            auto broken = std::make_shared<RobotConfigSpec>(*config);
            GeomSpec empty = box("empty", {1, 1, 1});
            empty.shape = GeomShape::Mesh;
            broken->bodies[2].geoms.push_back(empty);
            const auto add = [&](const RobotConfigSpec& of) {
                ActorDef def{at(0, 0, 0.01), {}, &of.joints, true};
                for (const BodySpec& body : of.bodies) def.bodies.push_back({def.frame * body.pose, &body});
                return engine->addActor(def);
            };
            if (failsFirst && add(*broken)) return std::vector<double>{};
            const auto made = add(*config);
            if (!made) return std::vector<double>{};
            engine->setMotor(made.value().joints[0], {3, 0.1, 2, 0});
            for (int i = 0; i < 50; ++i)
                if (engine->step(0.01)) return std::vector<double>{};
            std::vector<double> state{double(made.value().actor.index), double(engine->contactCount())};
            for (const BodyHandle body : made.value().bodies)
                for (const double x : {engine->state(body).position.x(), engine->state(body).linear.x()}) state.push_back(x);
            return state;
        };
        const std::vector<double> expected = ends(false);
        QVERIFY(expected.size() > 2);
        QVERIFY(ends(true) == expected);
    }

    void devicesActBeforeTheirPeers() {
        QCOMPARE(actingOrder({{}, {}, {0, 1}}), (std::vector<std::uint32_t>{2, 0, 1}));
        QCOMPARE(actingOrder({{}, {}, {}}), (std::vector<std::uint32_t>{0, 1, 2}));
        QCOMPARE(actingOrder({{1}, {2}, {}}), (std::vector<std::uint32_t>{0, 1, 2}));
        QVERIFY(actingOrder({{1}, {0}, {}}).size() < 3);
    }
};

QTEST_APPLESS_MAIN(PartsTest)
#include "parts_test.moc"
