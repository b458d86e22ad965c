// Triangle meshes of geoms.
#include <QtTest>

#include <map>
#include <numbers>
#include <set>

#include "scene/shapes/extents.h"
#include "scene/shapes/shape_mesh.h"

Q_DECLARE_METATYPE(trundle::GeomSpec)

using namespace trundle;
using Eigen::Vector3f;

namespace {

using Place = std::array<float, 3>;
Place placeOf(const Vector3f& p) {
    return {std::round(p.x() * 1e5f) + 0.f, std::round(p.y() * 1e5f) + 0.f, std::round(p.z() * 1e5f) + 0.f};
}

/// Each edge occurs equally often in both directions.
bool isClosed(const ShapeMesh& mesh) {
    std::map<std::pair<Place, Place>, int> edges;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        for (int k = 0; k < 3; ++k) {
            const Place a = placeOf(mesh.points[mesh.indices[t + k]]), b = placeOf(mesh.points[mesh.indices[t + (k + 1) % 3]]);
            if (a < b) ++edges[{a, b}];
            else if (b < a) --edges[{b, a}];
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

double volumeOf(const ShapeMesh& mesh) {
    double volume = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const Eigen::Vector3d a = mesh.points[mesh.indices[t]].cast<double>(),
                              b = mesh.points[mesh.indices[t + 1]].cast<double>(),
                              c = mesh.points[mesh.indices[t + 2]].cast<double>();
        volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
}

Vector3f highest(const ShapeMesh& mesh) {
    Vector3f high = mesh.points.front();
    for (const Vector3f& p : mesh.points) high = high.cwiseMax(p);
    return high;
}

GeomSpec geomOf(GeomShape shape) {
    GeomSpec g;
    g.shape = shape;
    g.size = {0.4, 0.2, 0.1};
    g.radius = 0.3;
    g.length = 0.8;
    return g;
}

} // namespace

class ShapesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void shapesAreClosedAndHaveTheirVolume_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("volume");
        QTest::addColumn<double>("error"); // polygons lose volume of round shapes, bevels that of boxes
        const double pi = std::numbers::pi;
        QTest::newRow("box") << int(GeomShape::Box) << 0.008 << 0.01;
        QTest::newRow("sphere") << int(GeomShape::Sphere) << 4 * pi / 3 * 0.027 << 0.03;
        QTest::newRow("cylinder") << int(GeomShape::Cylinder) << pi * 0.09 * 0.8 << 0.02;
        QTest::newRow("capsule") << int(GeomShape::Capsule) << pi * 0.09 * 0.8 + 4 * pi / 3 * 0.027 << 0.03;
    }
    void shapesAreClosedAndHaveTheirVolume() {
        QFETCH(int, shape);
        QFETCH(double, volume);
        QFETCH(double, error);
        const ShapeMesh mesh = shapeOf(geomOf(GeomShape(shape)), {32, true});
        QVERIFY(!mesh.indices.empty());
        QCOMPARE(mesh.points.size(), mesh.normals.size());
        QVERIFY(isClosed(mesh));
        QVERIFY(std::abs(volumeOf(mesh) / volume - 1) < error);
        for (const Vector3f& n : mesh.normals) QVERIFY(std::abs(n.norm() - 1) < 1e-5f);
        for (const std::uint32_t i : mesh.indices) QVERIFY(i < mesh.points.size());
    }

    void sizesAreExact() {
        QVERIFY((highest(boxMesh({0.4f, 0.2f, 0.1f}, true)) - Vector3f(0.2f, 0.1f, 0.05f)).norm() < 1e-7f);
        QVERIFY((highest(cylinderMesh(0.3f, 0.8f, 12)) - Vector3f(0.3f, 0.3f, 0.4f)).norm() < 1e-6f);
        QVERIFY((highest(sphereMesh(0.3f, 12)) - Vector3f(0.3f, 0.3f, 0.3f)).norm() < 1e-6f);
        QVERIFY((highest(capsuleMesh(0.3f, 0.8f, 12)) - Vector3f(0.3f, 0.3f, 0.7f)).norm() < 1e-6f);
    }

    void undrawableShapesAreEmpty_data() {
        QTest::addColumn<double>("value");
        for (const double v : {0.0, -1.0, double(NAN), double(INFINITY), 1e30})
            QTest::newRow(qPrintable(QString::number(v))) << v;
    }
    void undrawableShapesAreEmpty() {
        QFETCH(double, value);
        for (const GeomShape shape : {GeomShape::Box, GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule}) {
            GeomSpec g = geomOf(shape);
            g.size.y() = g.radius = value;
            QVERIFY(shapeOf(g, {}).indices.empty());
        }
        QVERIFY(shapeOf(geomOf(GeomShape::Plane), {}).indices.empty());
    }

    void aBareShapeIsTheSameSurfaceWithOnePointAtEachPlace() {
        for (const GeomShape shape : {GeomShape::Box, GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule}) {
            const ShapeMesh bare = bareShapeOf(geomOf(shape), {12, true}), whole = shapeOf(geomOf(shape), {12, false});
            QVERIFY(isClosed(bare));
            QVERIFY(std::abs(volumeOf(bare) / volumeOf(whole) - 1) < 1e-5);
            std::set<Place> places;
            for (const Vector3f& point : bare.points) places.insert(placeOf(point));
            QCOMPARE(places.size(), bare.points.size());
            QVERIFY(bare.indices.size() <= whole.indices.size());
        }
        QCOMPARE(bareShapeOf(geomOf(GeomShape::Box), {12, true}).points.size(), std::size_t(8));
    }
    void smallObjectsHaveFewerSegments() {
        const auto segments = [](double radius, double pixelsPerMetre) {
            GeomSpec g = geomOf(GeomShape::Cylinder);
            g.radius = radius;
            return bareShapeOf(g, {36, false, pixelsPerMetre}).points.size() / 2;
        };
        QCOMPARE(segments(0.05, 0), std::size_t(36)); // size on screen unknown
        QCOMPARE(segments(0.05, 1e6), std::size_t(36));
        QCOMPARE(segments(0.05, 1), std::size_t(4));
        std::size_t before = 4;
        for (const double pixels : {20.0, 60.0, 200.0, 600.0}) { // pixels per metre
            const std::size_t n = segments(0.05, pixels);
            QVERIFY(n >= before && n % 2 == 0);
            QVERIFY(0.05 * pixels * (1 - std::cos(std::numbers::pi / double(n))) <=
                    0.5 + 1e-9); // deviation from the circle in pixels
            before = n;
        }
    }

    void aMissingMeshIsMarked() {
        for (const GeomShape shape : {GeomShape::Mesh, GeomShape::Convex, GeomShape::Heightfield}) {
            QVERIFY(isPlaceholder(geomOf(shape)));
            QVERIFY(isClosed(shapeOf(geomOf(shape), {})));
        }
        QVERIFY(!isPlaceholder(geomOf(GeomShape::Box)));
    }

    /// However a shape is turned, its bounds hold all that is drawn of it, and little more.
    void boundsHoldWhatIsDrawn_data() {
        QTest::addColumn<GeomSpec>("geom");
        auto wedge = std::make_shared<TriangleMesh>();
        wedge->points = {{{0.1, 0, 0}}, {{0.7, 0.1, 0}}, {{0.2, 0.5, 0.1}}, {{0.3, 0.2, 0.9}}};
        wedge->triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
        GeomSpec mesh = geomOf(GeomShape::Mesh);
        mesh.mesh = wedge;
        QTest::newRow("mesh") << mesh;
        QTest::newRow("missing mesh") << geomOf(GeomShape::Mesh);
        QTest::newRow("missing height map") << geomOf(GeomShape::Heightfield);
        QTest::newRow("box") << geomOf(GeomShape::Box);
        QTest::newRow("sphere") << geomOf(GeomShape::Sphere);
        QTest::newRow("cylinder") << geomOf(GeomShape::Cylinder);
        QTest::newRow("capsule") << geomOf(GeomShape::Capsule);
    }
    void boundsHoldWhatIsDrawn() {
        QFETCH(GeomSpec, geom);
        for (int round = 0; round < 12; ++round) {
            geom.pose = {Vec3(0.3, -0.2, 0.1), rotationFromHpr(Vec3(0.7, 0.4, -1.1) * round)};
            const Pose owner{Vec3(-2, 5, 1), rotationFromHpr(Vec3(0.2, -0.3, 0.9) * round)};
            const Bounds bounds = boundsOf(geom, owner);
            Bounds drawn;
            const ShapeMesh shape = shapeOf(geom, {});
            for (const Vector3f& p : shape.points) drawn.add(owner * geom.pose * Vec3(p.cast<double>()));
            QVERIFY(((drawn.low - bounds.low).array() > -1e-6).all() && ((bounds.high - drawn.high).array() > -1e-6).all());
            QVERIFY(((bounds.size() - drawn.size()).array() < 0.1 * geom.radius).all());
        }
    }

    void edgesOfAMeshStaySharpAndRoundsBecomeSmooth() {
        TriangleMesh roof; // two faces that meet at a right angle
        roof.points = {{0, -1, 0}, {1, -1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {1, 1, 0}};
        roof.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
        for (const Vector3f& n : smoothedMesh(roof).normals) QVERIFY(std::abs(std::abs(n.y()) - std::sqrt(0.5f)) < 1e-5f);
        TriangleMesh bend = roof; // nearly flat
        for (auto& p : bend.points) p[2] *= 0.1;
        const ShapeMesh smooth = smoothedMesh(bend);
        for (std::size_t i = 0; i < smooth.points.size(); ++i)
            if (smooth.points[i].y() == 0) QVERIFY(std::abs(smooth.normals[i].y()) < 1e-5f);
    }

    void readsBrokenMeshSafely() {
        TriangleMesh mesh;
        mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {NAN, 0, 0}, {1e300, 0, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 1, 99}, {0, 1, 3}, {0, 2, 4}};
        const ShapeMesh drawn = smoothedMesh(mesh);
        QCOMPARE(drawn.indices.size(), std::size_t(3)); // only the first triangle is valid
        QVERIFY(smoothedMesh(TriangleMesh{}).indices.empty());
    }

    void handlesPointWithManyFaces() {
        TriangleMesh fan;
        constexpr std::uint32_t kFaces = 200000;
        fan.points.push_back({0, 0, 0});
        for (std::uint32_t i = 0; i <= kFaces; ++i) fan.points.push_back({std::cos(i * 1e-5), std::sin(i * 1e-5), 0});
        for (std::uint32_t i = 1; i <= kFaces; ++i) fan.triangles.push_back({0, i, i + 1});
        QCOMPARE(smoothedMesh(fan).indices.size(), std::size_t(kFaces) * 3);
    }

    void mapsTopRowOfPictureToPlusY() {
        HeightMap map{3, 2, {0, 0.5f, 1, 0, 0, 0}};
        const ShapeMesh mesh = heightfieldMesh(map, {4, 2, 0.5f});
        QCOMPARE(mesh.points.size(), std::size_t(6));
        QVERIFY((mesh.points[0] - Vector3f(-2, 1, 0)).norm() < 1e-6f);
        QVERIFY((mesh.points[2] - Vector3f(2, 1, 0.5f)).norm() < 1e-6f);
        QVERIFY((mesh.points[5] - Vector3f(2, -1, 0)).norm() < 1e-6f);
        for (const Vector3f& n : mesh.normals) QVERIFY(n.z() > 0);
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const Vector3f a = mesh.points[mesh.indices[t]], b = mesh.points[mesh.indices[t + 1]],
                           c = mesh.points[mesh.indices[t + 2]];
            QVERIFY((b - a).cross(c - a).z() > 0);
        }
    }

    void aHugeHeightMapIsThinnedOut() {
        HeightMap map{3000, 2000, std::vector<float>(6000000, 0.5f)};
        const ShapeMesh mesh = heightfieldMesh(map, {30, 20, 1});
        QVERIFY(mesh.points.size() <= 512u * 512u);
        QVERIFY((mesh.points.front() - Vector3f(-15, 10, 0.5f)).norm() < 1e-4f);
        QVERIFY((mesh.points.back() - Vector3f(15, -10, 0.5f)).norm() < 1e-4f);
    }

    void aHeightMapWithTooFewValuesIsNothing() {
        QVERIFY(heightfieldMesh(HeightMap{10, 10, std::vector<float>(50)}, {1, 1, 1}).indices.empty());
    }
};

QTEST_APPLESS_MAIN(ShapesTest)
#include "shapes_test.moc"
