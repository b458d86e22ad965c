// What is put on a face snaps to its middle, its edges, the axes of the object and steps; whichever is nearest.
#include <QtTest>

#include <random>

#include "scene/queries/face_snap.h"

using namespace trundle;

namespace {

GeomSpec box(const Vec3& size, const Pose& pose = {}) {
    GeomSpec geom;
    geom.shape = GeomShape::Box;
    geom.size = size;
    geom.pose = pose;
    return geom;
}

GeomSpec cylinder(double radius, double length) {
    GeomSpec geom;
    geom.shape = GeomShape::Cylinder;
    geom.radius = radius;
    geom.length = length;
    return geom;
}

RayHit hitAt(const Vec3& point, const Vec3& normal) {
    RayHit hit;
    hit.point = point;
    hit.normal = normal;
    return hit;
}

FaceSnapOptions options(double step, double near, const Bounds& thing = {}) {
    FaceSnapOptions o;
    o.thing = thing;
    o.step = step;
    o.near = {near, near};
    return o;
}

/// Of a point on the top of a box of 0.3 m x 0.2 m x 0.1 m around (0.013, 0.02, 0.09).
FaceSnap onTop(double x, double y, const FaceSnapOptions& o) {
    const Pose at{{0.013, 0.02, 0.09}, Quat::Identity()};
    const RayHit hit = hitAt({x, y, 0.14}, Vec3::UnitZ());
    const auto face = FlatFace::of(box({0.3, 0.2, 0.1}), at, hit);
    return face ? snapOnFace(*face, hit.point, o) : FaceSnap{};
}

bool isAt(const FaceSnap& snap, const Vec3& point) { return snap.point.isApprox(point, 1e-9); }

} // namespace

class FaceSnapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void middle() {
        const FaceSnap snap = onTop(0.017, 0.026, options(0.05, 0.01));
        QVERIFY(isAt(snap, {0.013, 0.02, 0.14}));
        QCOMPARE(snap.guides.size(), std::size_t(2));
        QVERIFY(snap.guides[0][0].isApprox(Vec3(0.013, -0.08, 0.14)) && snap.guides[0][1].isApprox(Vec3(0.013, 0.12, 0.14)));
    }
    /// A plate whose origin is 1 cm left of its middle along x, and as far beyond it along y: its middle snaps, not its origin.
    void middleOfAThingBesideItsOrigin() {
        const Bounds plate{{-0.03, -0.02, 0}, {0.05, 0, 0.03}};
        FaceSnapOptions o = options(0, 0.008, plate);
        o.origin = {5, 5, 5};
        const FaceSnap snap = onTop(0.005, 0.034, o);
        QVERIFY(isAt(snap, {0.003, 0.03, 0.14}));
        QCOMPARE(snap.guides.size(), std::size_t(2)); // through the middle of the face
        QVERIFY(snap.guides[0][0].isApprox(Vec3(0.013, -0.08, 0.14)) && snap.guides[0][1].isApprox(Vec3(0.013, 0.12, 0.14)));
        QVERIFY(isAt(onTop(0.023, 0.01, o), {0.023, 0.01, 0.14})); // not at the mirrored place
    }
    void stepsFartherAway() {
        const FaceSnap snap = onTop(0.092, 0.044, options(0.05, 0.01));
        QVERIFY(isAt(snap, {0.1, 0.05, 0.14}));
        QVERIFY(snap.guides.empty());
    }
    /// A sensor without an extent.
    void edgesForAPoint() {
        const FaceSnap snap = onTop(0.16, -0.079, options(0.05, 0.01));
        QVERIFY(isAt(snap, {0.163, -0.08, 0.14}));
        QCOMPARE(snap.guides.size(), std::size_t(2));
    }
    /// A box of 4 cm x 2 cm whose origin is 1 cm left of its middle (y), flush with two edges.
    void edgesForAThing() {
        const Bounds thing{{-0.02, -0.02, 0}, {0.02, 0, 0.03}};
        const FaceSnap snap = onTop(0.145, -0.057, options(0.05, 0.01, thing));
        QVERIFY(isAt(snap, {0.143, -0.06, 0.14}));
        QVERIFY(snap.guides[0][0].isApprox(Vec3(0.163, -0.08, 0.14))); // along the edge
    }
    void whatIsLargerThanTheFaceHasNoEdges() {
        const Bounds thing{{-0.4, -0.4, 0}, {0.4, 0.4, 0.03}};
        const FaceSnap snap = onTop(0.16, 0.11, options(0, 0.01, thing));
        QVERIFY(isAt(snap, {0.16, 0.11, 0.14}));
    }
    void axesOfTheObject() {
        FaceSnapOptions o = options(0, 0.01);
        o.origin = {0.06, -0.03, 0.5};
        const FaceSnap snap = onTop(0.064, -0.036, o);
        QVERIFY(isAt(snap, {0.06, -0.03, 0.14}));
        QCOMPARE(snap.guides.size(), std::size_t(2));
    }
    void nothingNear() { QVERIFY(isAt(onTop(0.06, 0.05, options(0, 0.01)), {0.06, 0.05, 0.14})); }

    void aTurnedSide() {
        const Pose at{{1, 2, 0.5}, rotationFromHpr({0.5, 0.3, -0.2})};
        const GeomSpec crate = box({0.3, 0.2, 0.1}, Pose{{0.1, 0, 0}, rotationFromHpr({-0.3, 0, 0.7})});
        const Pose X_WG = at * crate.pose;
        const auto place = [&](double x, double z) { return X_WG * Vec3(x, -0.1, z); };
        const RayHit hit = hitAt(place(0.144, 0.003), X_WG.rotation * -Vec3::UnitY());
        const auto face = FlatFace::of(crate, at, hit);
        QVERIFY(face);
        QVERIFY(face->middle.isApprox(place(0, 0)));
        FaceSnapOptions o = options(0.05, 0.01);
        o.origin = face->middle;
        QVERIFY(snapOnFace(*face, hit.point, o).point.isApprox(place(0.15, 0)));
        QVERIFY(snapOnFace(*face, place(0.07, 0.02), o).point.isApprox(place(0.07, 0.02))); // no step along it
    }
    void cylinders() {
        const GeomSpec can = cylinder(0.1, 0.3);
        const RayHit top = hitAt({0.004, -0.003, 0.15}, Vec3::UnitZ());
        QVERIFY(isAt(snapOnFace(*FlatFace::of(can, {}, top), top.point, options(0, 0.01)), {0, 0, 0.15}));
        const Vec3 out(std::cos(0.7), std::sin(0.7), 0);
        const RayHit side = hitAt(0.1 * out + Vec3(0, 0, 0.006), out);
        const auto face = FlatFace::of(can, {}, side);
        QVERIFY(isAt(snapOnFace(*face, side.point, options(0, 0.01)), 0.1 * out));
        QVERIFY(isAt(snapOnFace(*face, 0.1 * out + Vec3(0, 0, -0.145), options(0, 0.01)), 0.1 * out - Vec3(0, 0, 0.15)));
    }
    /// A roof of 0.4 m x 0.2 m whose origin is at a corner of its base: on its base and gables, not on its slopes.
    void meshes() {
        auto roof = std::make_shared<TriangleMesh>();
        roof->points = {{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.2, 0}, {0, 0.2, 0}, {0, 0.1, 0.1}, {0.4, 0.1, 0.1}};
        roof->triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {1, 2, 5}, {0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}};
        GeomSpec geom;
        geom.shape = GeomShape::Mesh;
        geom.mesh = roof;
        geom.pose.position = {1, 0, 0};
        const RayHit base = hitAt({1.196, 0.097, 0}, -Vec3::UnitZ()), gable = hitAt({1.4, 0.096, 0.055}, Vec3::UnitX());
        QVERIFY(isAt(snapOnFace(*FlatFace::of(geom, {}, base), base.point, options(0, 0.01)), {1.2, 0.1, 0}));
        QVERIFY(isAt(snapOnFace(*FlatFace::of(geom, {}, gable), gable.point, options(0, 0.01)), {1.4, 0.1, 0.05}));
        QVERIFY(!FlatFace::of(geom, {}, hitAt({1.2, 0.05, 0.05}, Vec3(0, -1, 1).normalized())));
    }
    void roundFacesHaveNone() {
        GeomSpec ball;
        ball.shape = GeomShape::Sphere;
        ball.radius = 0.1;
        QVERIFY(!FlatFace::of(ball, {}, hitAt({0, 0, 0.1}, Vec3::UnitZ())));
    }
    /// Of random boxes and points: the snapped point is on the face and never farther away than the nearest step or `near`.
    void staysOnTheFace() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> some(-1, 1);
        for (int i = 0; i < 2000; ++i) {
            const GeomSpec crate = box({1.2 + some(random), 1.2 + some(random), 1.2 + some(random)});
            const Pose at{{some(random), some(random), some(random)},
                          i % 2 ? Quat(Quat::Identity()) : rotationFromHpr({3 * some(random), some(random), 3 * some(random)})};
            const int k = i % 3;
            Vec3 p = 0.5 * crate.size.cwiseProduct(Vec3(some(random), some(random), some(random))), n = Vec3::Zero();
            n[k] = some(random) < 0 ? -1 : 1;
            p[k] = n[k] * crate.size[k] / 2;
            const RayHit hit = hitAt(at * p, at.rotation * n);
            const auto face = FlatFace::of(crate, at, hit);
            QVERIFY(face);
            const FaceSnap snap = snapOnFace(*face, hit.point, options(0.05, 0.02));
            QVERIFY(std::abs((snap.point - hit.point).dot(hit.normal)) < 1e-9);
            QVERIFY((snap.point - hit.point).norm() < std::sqrt(2.) * 0.025 + 1e-9);
        }
    }

    /// The axes of the object count where they cross the face; a thing that is a little larger than it has no edges.
    void onlyWhatIsOnTheFaceCounts() {
        FaceSnapOptions o = options(0, 0.01);
        o.origin = {0.17, 0.13, 0}; // 7 mm beyond the front edge, 10 mm beyond the left one
        QVERIFY(isAt(onTop(0.1735, 0.129, o), {0.163, 0.12, 0.14}) || isAt(onTop(0.1735, 0.129, o), {0.1735, 0.12, 0.14}));
        o.near = {0.005, 0.005};
        QVERIFY(isAt(onTop(0.169, 0.128, o), {0.169, 0.128, 0.14}));
        const Bounds wide{{-0.155, -0.02, 0}, {0.155, 0.02, 0.03}};
        QVERIFY(isAt(onTop(0.0195, 0.02, options(0, 0.002, wide)), {0.0195, 0.02, 0.14}));
    }

    /// Guides are lines of the face itself: on a lower end, on a gable, along a side of a cylinder.
    void guidesAreOnTheFace() {
        const GeomSpec can = cylinder(0.1, 0.3);
        const RayHit low = hitAt({0.004, -0.003, -0.15}, -Vec3::UnitZ());
        const FaceSnap end = snapOnFace(*FlatFace::of(can, {}, low), low.point, options(0, 0.01));
        QVERIFY(isAt(end, {0, 0, -0.15}));
        QCOMPARE(end.guides.size(), std::size_t(2));
        for (const auto& line : end.guides)
            for (const Vec3& p : line) QVERIFY(std::abs(p.z() + 0.15) < 1e-12);
        const RayHit side = hitAt({0.1, 0, 0.006}, Vec3::UnitX());
        QVERIFY(snapOnFace(*FlatFace::of(can, {}, side), side.point, options(0, 0.01)).guides.empty()); // it has no width
        auto wedge = std::make_shared<TriangleMesh>();
        wedge->points = {{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.2, 0}, {0, 0.2, 0}, {0, 0.1, 0.1}, {0.4, 0.1, 0.1}};
        wedge->triangles = {{0, 2, 1}, {0, 3, 2}};
        GeomSpec geom;
        geom.shape = GeomShape::Mesh;
        geom.mesh = wedge;
        const RayHit base = hitAt({0.196, 0.097, 0}, -Vec3::UnitZ());
        const FaceSnap snap = snapOnFace(*FlatFace::of(geom, {}, base), base.point, options(0, 0.01));
        QCOMPARE(snap.guides.size(), std::size_t(2));
        for (const auto& line : snap.guides)
            for (const Vec3& p : line) QVERIFY(std::abs(p.z()) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(FaceSnapTest)
#include "face_snap_test.moc"
