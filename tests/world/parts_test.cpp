// Classes that do not depend on the engine: grids compared with brute force, wheel contacts, the order of devices.
#include <QtTest>

#include <random>

#include "world/broad_phase.h"
#include "world/device_order.h"
#include "world/fixtures.h"
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

    void devicesActBeforeTheirPeers() {
        QCOMPARE(actingOrder({{}, {}, {0, 1}}), (std::vector<std::uint32_t>{2, 0, 1}));
        QCOMPARE(actingOrder({{}, {}, {}}), (std::vector<std::uint32_t>{0, 1, 2}));
        QCOMPARE(actingOrder({{1}, {2}, {}}), (std::vector<std::uint32_t>{0, 1, 2}));
        QVERIFY(actingOrder({{1}, {0}, {}}).size() < 3);
    }
};

QTEST_APPLESS_MAIN(PartsTest)
#include "parts_test.moc"
