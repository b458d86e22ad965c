// A convex hull comes to rest on each type of geom.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kSide = 0.2;

/// The surface of a cube as a mesh with far more points than a hull may have, most of them in the same six planes.
std::shared_ptr<const TriangleMesh> finelyCutCube() {
    auto mesh = std::make_shared<TriangleMesh>();
    constexpr int kCuts = 8;
    for (int x = 0; x <= kCuts; ++x)
        for (int y = 0; y <= kCuts; ++y)
            for (int z = 0; z <= kCuts; ++z)
                if (x % kCuts == 0 || y % kCuts == 0 || z % kCuts == 0)
                    mesh->points.push_back(
                        {kSide * x / kCuts - kSide / 2, kSide * y / kCuts - kSide / 2, kSide * z / kCuts - kSide / 2});
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

/// A block of 0.5 x 0.5 x 0.3 m, open below, its top at z = 0 in cuts x cuts squares of two triangles each.
GeomSpec meshGround(std::uint32_t cuts) {
    auto mesh = std::make_shared<TriangleMesh>();
    constexpr double kHalf = 0.25;
    for (std::uint32_t x = 0; x <= cuts; ++x)
        for (std::uint32_t y = 0; y <= cuts; ++y)
            mesh->points.push_back({2 * kHalf * x / cuts - kHalf, 2 * kHalf * y / cuts - kHalf, 0});
    for (std::uint32_t x = 0; x < cuts; ++x)
        for (std::uint32_t y = 0; y < cuts; ++y) {
            const std::uint32_t a = x * (cuts + 1) + y, b = a + cuts + 1;
            mesh->triangles.push_back({a, b, b + 1});
            mesh->triangles.push_back({a, b + 1, a + 1});
        }
    const auto first = static_cast<std::uint32_t>(mesh->points.size());
    constexpr double kCorners[4][2] = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
    for (const auto& c : kCorners) {
        mesh->points.push_back({c[0], c[1], 0});
        mesh->points.push_back({c[0], c[1], -0.3});
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % 4);
        mesh->triangles.push_back({a, a + 1, b + 1});
        mesh->triangles.push_back({a, b + 1, b});
    }
    GeomSpec geom;
    geom.name = "ground";
    geom.shape = GeomShape::Mesh;
    geom.mesh = std::move(mesh);
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
        QTest::newRow("end of a cylinder") << cylinder("ground", 0.3, 0.5, at(0, 0, -0.25));
        QTest::newRow("end of a thin cylinder") << cylinder("ground", 0.08, 0.5, at(0, 0, -0.25));
        QTest::newRow("end of a cylinder upside down") << cylinder("ground", 0.3, 0.5, at(0.05, 0, -0.25, degrees(0, 180, 0)));
        GeomSpec other = hull(finelyCutCube());
        other.pose = at(0.02, 0.01, -kSide / 2);
        QTest::newRow("hull") << other;
    }
    void liesOnWhatItFallsOn() {
        QFETCH(GeomSpec, ground);
        Scene scene;
        scene.scenery({ground}).loose("cube", at(0, 0, kSide / 2 + 0.02), massOfBox(1, {kSide, kSide, kSide}),
                                      {hull(finelyCutCube())});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        const Vec3 p = position(*world, "cube/body");
        qInfo("%.3f mm above, %.3f mm aside, %.4f m/s", 1e3 * (p.z() - kSide / 2), 1e3 * std::hypot(p.x(), p.y()),
              velocity(*world, "cube/body").norm());
        QVERIFY(std::abs(p.z() - kSide / 2) < 1e-3);
        QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
    }

    void liesOnAMesh_data() {
        QTest::addColumn<GeomSpec>("ground");
        QTest::addColumn<double>("x");
        for (const double x : {0.0, 0.03, 0.19, 0.22}) { // at the last one nearly half of it hangs over an edge
            QTest::addRow("two triangles, at %g m", x) << meshGround(1) << x;
            QTest::addRow("200 triangles, at %g m", x) << meshGround(10) << x;
            QTest::addRow("5000 triangles, at %g m", x) << meshGround(50) << x;
        }
    }
    /// It falls at 3 m/s: the distance per tick exceeds the size of the finest triangles.
    void liesOnAMesh() {
        QFETCH(GeomSpec, ground);
        QFETCH(double, x);
        Scene scene;
        scene.scenery({ground}).loose("cube", at(x, 0.01, kSide / 2 + 0.5, degrees(7, 0, 0)), massOfBox(1, {kSide, kSide, kSide}),
                                      {hull(finelyCutCube())});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        const Vec3 before = position(*world, "cube/body");
        QVERIFY(run(*world, 5));
        const Vec3 after = position(*world, "cube/body");
        qInfo("%.3f mm above, %.4f mm/s", 1e3 * (after.z() - kSide / 2), 1e3 * (after - before).norm() / 5);
        QVERIFY(std::abs(after.z() - kSide / 2) < 1e-3);
        QVERIFY((after - before).norm() < 5e-4); // a tenth of a millimetre a second at most
    }
    /// Against the edge of a mesh block it slides along the side and does not climb or sink in.
    void pushedAgainstTheSideOfAMeshBlock() {
        Scene scene;
        GeomSpec block = meshGround(1);
        block.pose = at(0, 0, 0.15);
        scene.surface(0.1);
        scene.scenery({plane("floor", {}, 1), block})
            .loose("cube", at(-0.45, 0.02, kSide / 2), massOfBox(1, {kSide, kSide, kSide}), {hull(finelyCutCube())});
        auto world = scene.build();
        QVERIFY(world);
        for (int i = 0; i < 300; ++i) {
            QVERIFY(world->push("cube/body", {4, 0, 0}, position(*world, "cube/body")).ok());
            QVERIFY(world->tick().ok());
        }
        const Vec3 p = position(*world, "cube/body");
        qInfo("x %.4f z %.4f", p.x(), p.z());
        QVERIFY(std::abs(p.x() - (-0.25 - kSide / 2)) < 2e-3);
        QVERIFY(std::abs(p.z() - kSide / 2) < 2e-3);
    }

    void boxRestsOnHull() {
        Scene scene;
        scene.scenery({hull(finelyCutCube())})
            .loose("cube", at(0.03, 0, kSide + 0.02), massOfBox(1, {kSide, kSide, kSide}), {box("box", {kSide, kSide, kSide})});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        QVERIFY((position(*world, "cube/body") - Vec3(0.03, 0, kSide)).norm() < 1e-3);
        QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
    }

    /// Thrown on a corner it tumbles and comes to rest on a face. It penetrates the ground by at most the distance of one tick at 1 m/s.
    void tumblesOntoAFace() {
        for (int i = 0; i < 12; ++i) {
            Scene scene;
            scene.scenery({box("ground", {3, 3, 0.5}, at(0, 0, -0.25))})
                .loose("cube", at(0, 0, 0.35, degrees(17 * i, 35 + 3 * i, 40 - 5 * i)), massOfBox(1, {kSide, kSide, kSide}),
                       {hull(finelyCutCube())});
            auto world = scene.build();
            QVERIFY(world);
            double lowest = 1;
            while (world->time() < 4) {
                QVERIFY(world->tick().ok());
                lowest = std::min(lowest, position(*world, "cube/body").z());
            }
            QVERIFY2(lowest > kSide / 2 - 1e-2, qPrintable(QString::number(lowest)));
            QVERIFY2(std::abs(position(*world, "cube/body").z() - kSide / 2) < 1e-3, qPrintable(QString::number(i)));
            QVERIFY(velocity(*world, "cube/body").norm() < 1e-3);
        }
    }
};

QTEST_APPLESS_MAIN(HullTest)
#include "hull_test.moc"
