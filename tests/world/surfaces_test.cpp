// Edges of meshes, hulls and height maps: what rolls onto them, lies on them, passes beside them.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

const Quat kSideways = rotationFromHpr(degrees(0, 0, 90));

std::shared_ptr<TriangleMesh> boxMesh(const Vec3& size) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (int k = 0; k < 8; ++k)
        mesh->points.push_back({(k & 1 ? .5 : -.5) * size.x(), (k & 2 ? .5 : -.5) * size.y(), (k & 4 ? .5 : -.5) * size.z()});
    mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A box as a box, a mesh or a hull.
GeomSpec block(const std::string& kind, const Vec3& size, const Pose& pose, std::uint32_t surface) {
    GeomSpec geom = box("block", size, pose, surface);
    if (kind == "box") return geom;
    geom.shape = kind == "mesh" ? GeomShape::Mesh : GeomShape::Convex;
    geom.mesh = geom.hull = boxMesh(size);
    geom.collideAsHull = kind == "hull";
    return geom;
}

constexpr double kRidge = 0.1, kWidth = 4, kDepth = 1;

/// A ridge along x at y = 0, 0.1 m high: 9 x 3 samples, or the triangles of their cells.
GeomSpec ridge(bool isMesh) {
    GeomSpec geom = plane("ridge");
    const std::uint32_t columns = 9;
    if (!isMesh) {
        auto map = std::make_shared<HeightMap>(HeightMap{columns, 3, {}});
        for (std::uint32_t i = 0; i < 3 * columns; ++i) map->heights.push_back(i / columns == 1 ? 1.f : 0.f);
        geom.shape = GeomShape::Heightfield;
        geom.heightMap = map;
        geom.size = {kWidth, kDepth, kRidge};
        return geom;
    }
    auto mesh = std::make_shared<TriangleMesh>();
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t i = 0; i < columns; ++i)
            mesh->points.push_back({kWidth * (i / 8.0 - 0.5), kDepth * (k / 2.0 - 0.5), k == 1 ? kRidge : 0.0});
    for (std::uint32_t k = 0; k < 2; ++k)
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = k * columns + i, c = a + columns;
            mesh->triangles.push_back({a, a + 1, c});
            mesh->triangles.push_back({a + 1, c + 1, c});
        }
    geom.shape = GeomShape::Mesh;
    geom.mesh = mesh;
    return geom;
}

std::shared_ptr<RobotConfigSpec> wheelOf(double radius, double width) {
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("frame", at(0, 1, 0), massOfSphere(1, 0.1), {}));
    config->bodies.push_back(
        body("b", {}, massOfCylinder(1, radius, width, kSideways), {cylinder("g", radius, width, {Vec3::Zero(), kSideways})}));
    config->joints.push_back(joint("axle", JointType::Hinge, 0, 1, Vec3::Zero(), Vec3::UnitY()));
    return config;
}

} // namespace

class SurfacesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// What rolls onto a sheet of half a millimetre turns about its edge, and rises.
    void rollsOverAnEdge_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<bool>("isBall");
        QTest::addColumn<double>("tick");
        for (const char* kind : {"mesh", "hull"})
            for (const bool isBall : {true, false})
                for (const double tick : {0.002, 0.01, 0.03})
                    QTest::addRow("%s on a %s, %g ms", isBall ? "ball" : "cylinder", kind, 1e3 * tick) << kind << isBall << tick;
    }
    void rollsOverAnEdge() {
        QFETCH(QString, kind);
        QFETCH(bool, isBall);
        QFETCH(double, tick);
        const double r = 0.04, from = 0.2, high = 5e-4, along = 0.5, down = 9.8, inertia = isBall ? 0.4 : 0.5;
        Scene scene(tick);
        const auto s = scene.surface(0.8);
        scene.spec->settings.gravity = {along, 0, -down}; // downhill along x
        scene.scenery({plane("floor", {}, s), block(kind.toStdString(), {1.5, 0.5, high}, at(0.75, 0, high / 2), s)});
        if (isBall) scene.ball("b", {-from, 0.013, r}, 0.5, r, s);
        else
            scene.loose("b", at(-from, 0.013, r), massOfCylinder(0.5, r, 0.06, kSideways),
                        {cylinder("g", r, 0.06, {Vec3::Zero(), kSideways}, s)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 2));
        const double a = along / (1 + inertia), v = std::sqrt(2 * a * from), rest = 2 - v / a;
        const double turned = v * (1 - high / r / (1 + inertia)),
                     risen = std::sqrt(turned * turned - 2 * down * high / (1 + inertia));
        const double x = world->robotPose(0).position.x(), theory = risen * rest + a * rest * rest / 2;
        QVERIFY2(std::abs(x - theory) < (tick < 0.02 ? 0.02 : 0.06) * theory,
                 qPrintable(QString("%1 of %2").arg(x).arg(theory)));
    }

    /// One millimetre too low on a ridge, between its samples.
    void liesOnARidge_data() {
        QTest::addColumn<bool>("isMesh");
        QTest::addColumn<QString>("shape");
        for (const bool isMesh : {false, true})
            for (const char* shape : {"ball", "can", "log", "crate", "hull", "wheel"})
                QTest::addRow("%s, %s", shape, isMesh ? "mesh" : "height map") << isMesh << shape;
    }
    void liesOnARidge() {
        QFETCH(bool, isMesh);
        QFETCH(QString, shape);
        Scene scene(0.002);
        scene.spec->settings.gravity = Vec3::Zero();
        scene.scenery({ridge(isMesh)});
        const double r = 0.1, deep = 1e-3;
        const Pose pose = at(0.17, 0, kRidge + r - deep), lying{Vec3::Zero(), kSideways};
        const Vec3 size(2 * r, 2 * r, 2 * r);
        if (shape == "ball") scene.ball("b", pose.position, 1, r);
        if (shape == "can") scene.loose("b", pose, massOfCylinder(1, r, 2 * r), {cylinder("g", r, 2 * r)});
        if (shape == "log") scene.loose("b", pose, massOfCylinder(1, r, 2 * r, kSideways), {cylinder("g", r, 2 * r, lying)});
        if (shape == "crate") scene.loose("b", pose, massOfBox(1, size), {box("g", size)});
        if (shape == "hull") scene.loose("b", pose, massOfBox(1, size), {block("hull", size, {}, 0)});
        if (shape == "wheel") scene.robot("b", pose, wheelOf(r, 0.04));
        auto world = scene.build();
        QVERIFY(world && world->tick().ok());
        QVERIFY(!world->contacts().empty());
        double deepest = 0;
        for (const WorldContact& c : world->contacts()) {
            deepest = std::max(deepest, c.depth);
            QVERIFY2(std::abs(c.normal.x()) < 1e-6 && c.normal.z() > 0.97, qPrintable(QString::number(c.normal.z())));
        }
        QVERIFY2(std::abs(deepest - deep) < 3e-5, qPrintable(QString::number(deepest)));
    }

    /// A wheel beside a wall touches it with its side alone, whatever the wall is.
    void passesBesideAWall() {
        const double radius = 0.05, width = 0.02;
        for (const std::string kind : {"mesh", "hull"})
            for (const double gap : {0.005, 0.0005, -0.001}) {
                Scene scene(0.002);
                scene.spec->settings.gravity = Vec3::Zero();
                scene.scenery({block(kind, {4, 0.1, 0.3}, at(0, -0.05 - gap - width / 2, 0.15), 0)})
                    .robot("r", at(0.1, 0, 0.05), wheelOf(radius, width));
                auto world = scene.build();
                QVERIFY(world && world->tick().ok());
                QVERIFY2(world->contacts().empty() == (gap > 0), qPrintable(QString("%1, %2").arg(kind.c_str()).arg(gap)));
                for (const WorldContact& c : world->contacts()) {
                    QVERIFY2(c.normal.y() > 0.999, qPrintable(QString::number(c.normal.y())));
                    QVERIFY2(std::abs(c.depth + gap) < 1e-5, qPrintable(QString::number(c.depth)));
                }
            }
    }

    /// A tyre of which only the outer half is above a kerb is carried by it.
    void aRimOnAKerb() {
        Scene scene(0.002);
        scene.spec->settings.gravity = Vec3::Zero();
        scene.scenery({block("mesh", {2, 0.2, 0.1}, at(0, -0.103, -0.05), 0)})
            .robot("r", at(0.1, 0, 0.0499), wheelOf(0.05, 0.02));
        auto world = scene.build();
        QVERIFY(world && world->tick().ok());
        QCOMPARE(world->contacts().size(), std::size_t(1));
        const WorldContact& c = world->contacts()[0];
        QVERIFY(c.normal.z() > 0.999 && std::abs(c.depth - 1e-4) < 1e-6 && c.position.y() < -0.005);
    }

    /// A crate on a slope of many small triangles stays, and one that is slippery slides as on a plane.
    void cratesOnFineSlopes() {
        const double slope = 0.2, side = 3, deep = 0.05;
        const std::uint32_t n = 129;
        auto map = std::make_shared<HeightMap>(HeightMap{n, n, {}});
        for (std::uint32_t i = 0; i < n * n; ++i) map->heights.push_back(static_cast<float>(i % n) / (n - 1));
        GeomSpec hill = plane("hill");
        hill.shape = GeomShape::Heightfield;
        hill.heightMap = map;
        hill.size = {side, side, slope * side};
        const double angle = std::atan(slope), cosine = std::cos(angle);
        for (const double friction : {0.6, 0.1}) {
            Scene scene(0.01);
            const auto s = scene.surface(friction);
            hill.surface = s;
            const Vec3 normal(-std::sin(angle), 0, cosine), foot(0.61, 0.013, slope * (0.61 + side / 2));
            scene.scenery({hill}).loose("b", {foot + deep * normal, rotationFromHpr({0, -angle, 0})},
                                        massOfBox(1, {0.3, 0.3, 0.1}), {box("g", {0.3, 0.3, 0.1}, {}, s)});
            auto world = scene.build();
            QVERIFY(world && run(*world, 0.5));
            const Vec3 way = world->robotPose(0).position - foot - deep * normal;
            const double slid = friction > slope ? 0 : 0.5 * 9.81 * (std::sin(angle) - friction * cosine) * 0.25;
            QVERIFY2(std::abs(way.dot(normal)) < 2e-5, qPrintable(QString::number(way.dot(normal))));
            QVERIFY2(std::abs(way.norm() - slid) < 1e-4 + 0.025 * slid,
                     qPrintable(QString("%1 of %2").arg(way.norm()).arg(slid)));
        }
    }
};

QTEST_APPLESS_MAIN(SurfacesTest)
#include "surfaces_test.moc"
