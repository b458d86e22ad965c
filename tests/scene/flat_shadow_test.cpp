// Outlines of shadows on a plane, against the hull of many points of each shape.
#include <QtTest>

#include <numbers>
#include <random>

#include "scene/shapes/flat_shadow.h"

using namespace trundle;
using Eigen::Vector2d;

namespace {

using Corners = ShadowPlane::Outline;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Positive for an outline that is counter-clockwise.
double areaOf(const Corners& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

bool isConvex(const Corners& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()], &c = outline[(i + 2) % outline.size()];
        if (cross(b - a, c - b) < -1e-9) return false;
    }
    return outline.size() >= 3;
}

/// How far outside of a convex outline a point is (m); negative inside.
double outsideOf(const Corners& outline, const Vector2d& point) {
    double most = -1e9;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d along = outline[(i + 1) % outline.size()] - outline[i];
        if (along.norm() > 1e-9) most = std::max(most, -cross(along, point - outline[i]) / along.norm());
    }
    return most;
}

GeomSpec geomOf(GeomShape shape) {
    GeomSpec g;
    g.shape = shape;
    g.size = {0.4, 0.2, 0.1};
    g.radius = 0.15;
    g.length = 0.5;
    if (shape == GeomShape::Convex) { // a pyramid that leans
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->points = {{-0.1f, -0.1f, 0.f}, {0.2f, -0.1f, 0.f}, {0.f, 0.2f, 0.f}, {0.1f, 0.1f, 0.4f}};
        mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        g.mesh = mesh;
    }
    return g;
}

Quat anyTurn(std::mt19937& random) {
    std::normal_distribution<double> number;
    return Quat(number(random), number(random), number(random), number(random)).normalized();
}

ShadowPlane::Frame frameOf(const Pose& pose) { return {pose.position, pose.rotation.toRotationMatrix()}; }

/// A shape as it stands over a plane that may be tilted.
struct Cast {
    GeomSpec geom;
    Pose body, floor;
    Vec3 light;

    [[nodiscard]] double heightOf(const Vec3& world) const { return (floor.inverse() * world).z(); }
    /// Where the light through a point meets the plane, in its frame: by intersection.
    [[nodiscard]] Vector2d shadowOf(const Vec3& world) const {
        const Vec3 local = floor.inverse() * world, way = floor.rotation.inverse() * light;
        return (local - way * (local.z() / way.z())).head<2>();
    }
    [[nodiscard]] std::vector<Vec3> points() const {
        std::vector<Vec3> points;
        for (const Eigen::Vector3f& p : bareShapeOf(geom, {96, false}).points)
            points.push_back(body * (geom.pose * Vec3(p.cast<double>())));
        return points;
    }
    [[nodiscard]] Corners outline(double pixelsPerMetre = 1e5) const {
        Corners outline{{1, 1}}; // what was in it before goes
        const std::optional<ShadowSolid> solid = shadowSolidOf(geom, 3);
        if (!solid || solid->geom != 3) qFatal("no solid");
        ShadowPlane(floor, light).cast(*solid, frameOf(body), pixelsPerMetre, outline);
        return outline;
    }
};

Cast anyCast(GeomShape shape, std::mt19937& random, double height) {
    Cast cast;
    cast.geom = geomOf(shape);
    cast.geom.pose = {{0.1, -0.05, 0.02}, anyTurn(random)};
    cast.floor = {{0.3, -0.2, 0.5}, anyTurn(random)};
    cast.body = cast.floor * Pose{{0.7, 0.4, height}, anyTurn(random)};
    cast.light = cast.floor.rotation * Vec3(0.6 * std::sin(double(random())), 0.5, 0.8);
    return cast;
}

} // namespace

class FlatShadowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void coversTheShadowOfEachPointAndNoMore_data() {
        QTest::addColumn<GeomShape>("shape");
        QTest::newRow("box") << GeomShape::Box;
        QTest::newRow("sphere") << GeomShape::Sphere;
        QTest::newRow("cylinder") << GeomShape::Cylinder;
        QTest::newRow("capsule") << GeomShape::Capsule;
        QTest::newRow("convex") << GeomShape::Convex;
    }
    void coversTheShadowOfEachPointAndNoMore() {
        QFETCH(GeomShape, shape);
        std::mt19937 random(7);
        for (int round = 0; round < 200; ++round) {
            const Cast cast = anyCast(shape, random, 1);
            const Corners outline = cast.outline();
            QVERIFY(isConvex(outline));
            QVERIFY(areaOf(outline) > 0);
            const std::vector<Vec3> points = cast.points();
            for (const Vec3& point : points) QVERIFY(outsideOf(outline, cast.shadowOf(point)) < 1e-3);
            // Each corner is the shadow of some point, up to the chords of round shapes.
            for (const Vector2d& corner : outline) {
                double nearest = 1e9;
                for (const Vec3& point : points) nearest = std::min(nearest, (cast.shadowOf(point) - corner).norm());
                QVERIFY2(nearest < 0.02, qPrintable(QString::number(nearest)));
            }
        }
    }

    void whatIsBelowThePlaneCastsNone_data() { coversTheShadowOfEachPointAndNoMore_data(); }
    void whatIsBelowThePlaneCastsNone() {
        QFETCH(GeomShape, shape);
        std::mt19937 random(11);
        int through = 0, cut = 0;
        for (int round = 0; round < 200; ++round) {
            const Cast cast = anyCast(shape, random, 0.02 * (round % 20) - 0.2);
            const Corners outline = cast.outline();
            double lowest = 1e9, highest = -1e9;
            for (const Vec3& point : cast.points()) {
                lowest = std::min(lowest, cast.heightOf(point));
                highest = std::max(highest, cast.heightOf(point));
            }
            if (highest < -0.004) QVERIFY(outline.empty());
            if (highest < 0.02 || lowest > -0.02) continue;
            ++through;
            QVERIFY(isConvex(outline));
            Corners whole; // as if the plane were far below
            Cast high = cast;
            high.floor.position -= 5 * (high.floor.rotation * Vec3::UnitZ());
            whole = high.outline();
            QVERIFY(areaOf(outline) < areaOf(whole) + 1e-3);
            cut += areaOf(outline) < areaOf(whole) - 1e-3;
            for (const Vec3& point : cast.points())
                if (cast.heightOf(point) > 0) QVERIFY(outsideOf(outline, cast.shadowOf(point)) < 8e-3);
        }
        QVERIFY(through > 30 && cut > through / 2);
    }

    /// A box of 0.2 m sunk by half, light from +x at 45 degrees: the shadow begins at the box's far side, not beyond it.
    void aSunkBoxHasItsShadowOnOneSide() {
        Cast cast;
        cast.geom = geomOf(GeomShape::Box);
        cast.geom.size = {0.2, 0.2, 0.2};
        cast.light = Vec3(1, 0, 1);
        double low = 1e9, high = -1e9;
        for (const Vector2d& corner : cast.outline()) {
            low = std::min(low, corner.x());
            high = std::max(high, corner.x());
        }
        QVERIFY(std::abs(low + 0.2) < 1e-6); // 0.1 m high, so 0.1 m beyond the side at -0.1
        QVERIFY(std::abs(high - 0.103) < 1e-6);
    }

    void standingSlightlyInThePlaneIsStandingOnIt() {
        for (const double sunk : {0.0, 0.0029}) {
            Cast cast;
            cast.geom = geomOf(GeomShape::Box);
            cast.body.position = {0, 0, 0.05 - sunk};
            cast.light = Vec3::UnitZ();
            QCOMPARE(cast.outline().size(), 4u);
            QVERIFY(std::abs(areaOf(cast.outline()) - 0.08) < 1e-9);
        }
    }

    void roundEdgesAreAsFineAsTheyAreSeen() {
        std::mt19937 random(3);
        for (const GeomShape shape : {GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule}) {
            const Cast cast = anyCast(shape, random, 1);
            QVERIFY(cast.outline(20).size() < cast.outline(200).size());
            QVERIFY(cast.outline(200).size() < cast.outline(2000).size());
            QVERIFY(cast.outline(1e9).size() <= 98);
        }
    }

    void ofAMeshThereIsNoOutline() {
        GeomSpec mesh = geomOf(GeomShape::Convex);
        mesh.shape = GeomShape::Mesh;
        QVERIFY(!shadowSolidOf(mesh, 0));
        QVERIFY(!shadowSolidOf(geomOf(GeomShape::Plane), 0));
        GeomSpec missing = geomOf(GeomShape::Convex);
        missing.mesh = nullptr;
        QVERIFY(!shadowSolidOf(missing, 0));
        GeomSpec nothing = geomOf(GeomShape::Sphere);
        nothing.radius = 0;
        QVERIFY(!shadowSolidOf(nothing, 0));
    }
};

QTEST_APPLESS_MAIN(FlatShadowTest)
#include "flat_shadow_test.moc"
