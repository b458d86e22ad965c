// What touches along a line rests on it: sides of cylinders and capsules on faces, faces on such sides, sides on sides.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

const Quat kAlongX = rotationFromHpr(degrees(0, 90, 0));

GeomSpec capsule(const std::string& name, double radius, double length, const Pose& pose, std::uint32_t surface) {
    GeomSpec geom = cylinder(name, radius, length, pose, surface);
    geom.shape = GeomShape::Capsule;
    return geom;
}

/// A box as a hull of triangles.
GeomSpec hull(const std::string& name, const Vec3& size, const Pose& pose, std::uint32_t surface) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (int k = 0; k < 8; ++k)
        mesh->points.push_back({(k & 1 ? .5 : -.5) * size.x(), (k & 2 ? .5 : -.5) * size.y(), (k & 4 ? .5 : -.5) * size.z()});
    mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    GeomSpec geom = box(name, size, pose, surface);
    geom.shape = GeomShape::Convex;
    geom.mesh = geom.hull = mesh;
    geom.collideAsHull = true;
    return geom;
}

/// Its highest point is the origin.
GeomSpec ground(const std::string& shape, std::uint32_t surface) {
    const Pose below{{0, 0, -0.5}, Quat::Identity()}, lying{{0, 0, -0.5}, kAlongX};
    if (shape == "box") return box("ground", {2, 2, 1}, below, surface);
    if (shape == "drum") return cylinder("ground", 1, 1, below, surface);
    if (shape == "log") return cylinder("ground", 0.5, 2, lying, surface);
    if (shape == "pipe") return capsule("ground", 0.5, 2, lying, surface);
    return hull("ground", {2, 2, 1}, below, surface);
}

} // namespace

class LineContactsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void rests_data() {
        QTest::addColumn<QString>("on");
        QTest::addColumn<QString>("shape");
        for (const char* on : {"box", "drum", "log", "pipe", "hull"})
            for (const char* shape : {"box", "roller", "can", "pill", "hull"})
                QTest::addRow("%s on a %s", shape, on) << on << shape;
    }
    void rests() {
        QFETCH(QString, on);
        QFETCH(QString, shape);
        for (const double h : {0.005, 0.01}) {
            Scene scene(h);
            const auto s = scene.surface(0.7);
            scene.scenery({ground(on.toStdString(), s)});
            const Vec3 size(0.2, 0.16, 0.1);
            const Pose lying{Vec3::Zero(), kAlongX};
            if (shape == "box") scene.loose("b", at(0.01, 0, 0.05), massOfBox(0.7, size), {box("g", size, {}, s)});
            if (shape == "hull") scene.loose("b", at(0.01, 0, 0.05), massOfBox(0.7, size), {hull("g", size, {}, s)});
            if (shape == "can")
                scene.loose("b", at(0.01, 0, 0.05), massOfCylinder(0.7, 0.08, 0.1), {cylinder("g", 0.08, 0.1, {}, s)});
            const MassProperties round = massOfCylinder(0.7, 0.05, 0.2, kAlongX);
            if (shape == "roller") scene.loose("b", at(0.01, 0, 0.05), round, {cylinder("g", 0.05, 0.2, lying, s)});
            if (shape == "pill") scene.loose("b", at(0.01, 0, 0.05), round, {capsule("g", 0.05, 0.2, lying, s)});
            auto world = scene.build();
            QVERIFY(world);
            QVERIFY(run(*world, 3));
            const Pose pose = world->robotPose(0);
            const double tilt = 2 * std::acos(std::min(1.0, std::abs(pose.rotation.w())));
            const QString where = QString("at %1 %2 %3, tilted by %4")
                                      .arg(pose.position.x())
                                      .arg(pose.position.y())
                                      .arg(pose.position.z())
                                      .arg(tilt);
            QVERIFY2((pose.position - Vec3(0.01, 0, 0.05)).norm() < 1e-4 && tilt < 1e-3, qPrintable(where));
            QVERIFY(velocity(*world, "b/body").norm() < 1e-3 && spin(*world, "b/body").norm() < 1e-2);
        }
    }

    /// With one end over the edge it rests as long as its centre is on the face, then it falls.
    void overhangs() {
        for (const bool falls : {false, true}) {
            Scene scene;
            const auto s = scene.surface(0.7);
            scene.scenery({hull("ground", {2, 2, 1}, {{0, 0, -0.5}, Quat::Identity()}, s)});
            scene.loose("b", at(falls ? 1.02 : 0.98, 0, 0.05), massOfCylinder(0.7, 0.05, 0.2, kAlongX),
                        {cylinder("g", 0.05, 0.2, {Vec3::Zero(), kAlongX}, s)});
            auto world = scene.build();
            QVERIFY(run(*world, 1.5));
            QCOMPARE(world->robotPose(0).position.z() < 0.04, falls);
        }
    }

    /// A capsule that falls level onto a box bounces straight up, as on a plane.
    void bouncesStraight() {
        Scene scene;
        const auto s = scene.surface(0.4, 0.7);
        scene.scenery({ground("box", s)});
        scene.loose("b", at(0, 0, 0.55), massOfCylinder(0.7, 0.05, 0.2, kAlongX),
                    {capsule("g", 0.05, 0.2, {Vec3::Zero(), kAlongX}, s)});
        auto world = scene.build();
        QVERIFY(run(*world, 0.45));
        const Vec3 v = velocity(*world, "b/body");
        QVERIFY2(v.z() > 1 && std::hypot(v.x(), v.y()) < 1e-6 && spin(*world, "b/body").norm() < 1e-4,
                 qPrintable(QString("%1 %2 %3").arg(v.x()).arg(v.y()).arg(v.z())));
    }
};

QTEST_APPLESS_MAIN(LineContactsTest)
#include "line_contacts_test.moc"
