// A convex hull lies on whatever it falls on.
#include <QtTest>
#undef slots // a word of ours: SignalBlock::slots()

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kSide = 0.2;

/// A cube's surface as a mesh that has far more points than a hull may keep, most of them in the same six planes.
std::shared_ptr<const TriangleMesh> finelyCutCube() {
    auto mesh = std::make_shared<TriangleMesh>();
    constexpr int kCuts = 8;
    for (int x = 0; x <= kCuts; ++x)
        for (int y = 0; y <= kCuts; ++y)
            for (int z = 0; z <= kCuts; ++z)
                if (x % kCuts == 0 || y % kCuts == 0 || z % kCuts == 0)
                    mesh->points.push_back({kSide * x / kCuts - kSide / 2, kSide * y / kCuts - kSide / 2, kSide * z / kCuts - kSide / 2});
    return mesh;
}

GeomSpec hull(std::shared_ptr<const TriangleMesh> mesh) {
    GeomSpec geom;
    geom.name = "hull";
    geom.shape = GeomShape::Mesh;
    geom.mesh = std::move(mesh);
    geom.collideAsHull = true;
    return geom;
}

} // namespace

class HullTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void liesOnWhatItFallsOn_data() {
        QTest::addColumn<GeomSpec>("ground");
        QTest::newRow("plane") << plane();
        QTest::newRow("box") << box("ground", {2, 2, 0.5}, at(0, 0, -0.25));
        QTest::newRow("turned box") << box("ground", {2, 0.5, 2}, at(0, 0, -0.25, degrees(30, 0, 90)));
        QTest::newRow("a fifth beyond the edge of a box") << box("ground", {2, 2, 0.5}, at(-0.94, 0, -0.25));
        QTest::newRow("corner of a box") << box("ground", {2, 2, 0.5}, at(-0.95, -0.95, -0.25));
        GeomSpec other = hull(finelyCutCube());
        other.pose = at(0.02, 0.01, -kSide / 2);
        QTest::newRow("hull") << other;
    }
    void liesOnWhatItFallsOn() {
        QFETCH(GeomSpec, ground);
        Scene scene;
        scene.scenery({ground}).loose("cube", at(0, 0, kSide / 2 + 0.02), massOfBox(1, {kSide, kSide, kSide}), {hull(finelyCutCube())});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        const Vec3 p = position(*world, "cube/body");
        qInfo("%.3f mm above, %.3f mm aside, %.4f m/s", 1e3 * (p.z() - kSide / 2), 1e3 * std::hypot(p.x(), p.y()), velocity(*world, "cube/body").norm());
        QVERIFY(std::abs(p.z() - kSide / 2) < 1e-3);
        QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
    }

    void aBoxLiesOnAHull() {
        Scene scene;
        scene.scenery({hull(finelyCutCube())}).loose("cube", at(0.03, 0, kSide + 0.02), massOfBox(1, {kSide, kSide, kSide}), {box("box", {kSide, kSide, kSide})});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        QVERIFY((position(*world, "cube/body") - Vec3(0.03, 0, kSide)).norm() < 1e-3);
        QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
    }

    /// Thrown on a corner it tumbles and comes to lie on a face; thrown on an edge of the ground it leaves no hole.
    void tumblesOntoAFace() {
        for (int i = 0; i < 12; ++i) {
            Scene scene;
            scene.scenery({box("ground", {3, 3, 0.5}, at(0, 0, -0.25))})
                .loose("cube", at(0, 0, 0.35, degrees(17 * i, 35 + 3 * i, 40 - 5 * i)), massOfBox(1, {kSide, kSide, kSide}), {hull(finelyCutCube())});
            auto world = scene.build();
            QVERIFY(world);
            double lowest = 1;
            while (world->time() < 4) {
                QVERIFY(world->tick().ok());
                lowest = std::min(lowest, position(*world, "cube/body").z());
            }
            QVERIFY2(lowest > kSide / 2 - 5e-3, qPrintable(QString::number(lowest)));
            QVERIFY2(std::abs(position(*world, "cube/body").z() - kSide / 2) < 1e-3, qPrintable(QString::number(i)));
            QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
        }
    }
};

QTEST_APPLESS_MAIN(HullTest)
#include "hull_test.moc"
