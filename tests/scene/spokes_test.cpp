// Spokes drawn on wheels.
#include <QtTest>

#include <map>
#include <numbers>

#include "scene/shapes/spokes.h"

using namespace trundle;

namespace {

using Patterns = std::vector<std::vector<SpokePattern>>;

GeomSpec roundGeom(GeomShape shape, double radius, double length, Vec3 at = Vec3::Zero()) {
    GeomSpec geom;
    geom.shape = shape;
    geom.radius = radius;
    geom.length = length;
    geom.pose = {at, rotationFromHpr({0, 0, std::numbers::pi / 2})}; // along the body's y
    return geom;
}
GeomSpec tyre(Vec3 at = Vec3::Zero()) { return roundGeom(GeomShape::Cylinder, 0.05, 0.03, at); }
GeomSpec box(Vec3 size, Vec3 at = Vec3::Zero()) {
    GeomSpec geom;
    geom.size = size;
    geom.pose.position = at;
    return geom;
}

/// A chassis and a wheel, whose hinge is along y.
RobotConfigSpec rover(std::vector<GeomSpec> wheelGeoms) {
    RobotConfigSpec config;
    config.bodies.resize(2);
    config.bodies[0].geoms = {box({0.3, 0.2, 0.1})};
    config.bodies[1].pose.position = {0.06, 0.125, 0.05};
    config.bodies[1].geoms = std::move(wheelGeoms);
    JointSpec hinge;
    hinge.parent = 0, hinge.child = 1;
    hinge.anchor = config.bodies[1].pose.position;
    hinge.axis = Vec3::UnitY();
    config.joints = {hinge};
    return config;
}
std::vector<std::uint32_t> geomsWithSpokes(const RobotConfigSpec& config, const std::vector<MaterialSpec>& materials = {}) {
    std::vector<std::uint32_t> geoms;
    const Patterns patterns = spokePatternsOf(config, materials);
    for (const SpokePattern& pattern : patterns.at(1)) geoms.push_back(pattern.geom);
    return geoms;
}
using Geoms = std::vector<std::uint32_t>;

using Edge = std::pair<std::array<long, 3>, std::array<long, 3>>;
/// Edges without an opposite edge, over all paints together.
std::size_t openEdges(const std::array<ShapeMesh, kWheelPaints>& parts) {
    std::map<Edge, int> edges;
    const auto placeOf = [](const Eigen::Vector3f& p) {
        return std::array{std::lround(p.x() * 1e6), std::lround(p.y() * 1e6), std::lround(p.z() * 1e6)};
    };
    for (const ShapeMesh& mesh : parts) {
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            const auto a = placeOf(mesh.points[mesh.indices[i]]), b = placeOf(mesh.points[mesh.indices[next]]);
            if (a != b) edges[a < b ? Edge{a, b} : Edge{b, a}] += a < b ? 1 : -1;
        }
    }
    return std::size_t(std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

} // namespace

class SpokesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aWheelOnAHingeHasSpokes() {
        const Patterns patterns = spokePatternsOf(rover({tyre()}), {});
        QCOMPARE(patterns.size(), std::size_t(2));
        QVERIFY(patterns[0].empty());
        QCOMPARE(patterns[1].size(), std::size_t(1));
        QVERIFY(patterns[1][0].top && patterns[1][0].bottom);
        QVERIFY((patterns[1][0].axis.cwiseAbs() - Vec3::UnitZ()).norm() < 1e-9); // the cylinder's own axis
    }

    void addsNoSpokesToVisiblyRotatingShapes() {
        QCOMPARE(geomsWithSpokes(rover({tyre({0.01, 0, 0})})), Geoms{});                            // off the axis
        QCOMPARE(geomsWithSpokes(rover({tyre(), box({0.02, 0.04, 0.02}, {0.03, 0, 0})})), Geoms{}); // a crank
        QCOMPARE(geomsWithSpokes(rover({tyre(), box({0.02, 0.01, 0.02})})), Geoms{0});              // a motor hidden in the wheel
        GeomSpec across = tyre();
        across.pose.rotation = Quat::Identity();
        QCOMPARE(geomsWithSpokes(rover({across})), Geoms{});
        std::vector<MaterialSpec> materials(2);
        materials[1].picture = std::make_shared<Raster>();
        GeomSpec pictured = tyre(), clear = tyre();
        pictured.material = 1;
        QCOMPARE(geomsWithSpokes(rover({pictured}), materials), Geoms{});
        clear.visible = false;
        QCOMPARE(geomsWithSpokes(rover({clear})), Geoms{});
    }

    void otherJointsAndBodies() {
        RobotConfigSpec config = rover({tyre()});
        config.joints[0].type = JointType::Slider;
        QCOMPARE(geomsWithSpokes(config), Geoms{});
        config.joints[0].type = JointType::Suspension;
        QCOMPARE(geomsWithSpokes(config), Geoms{}); // it slides along y
        std::swap(config.joints[0].axis, config.joints[0].axis2);
        QCOMPARE(geomsWithSpokes(config), Geoms{0});
        config = rover({tyre()});
        std::swap(config.joints[0].parent, config.joints[0].child); // the wheel carries the chassis
        QCOMPARE(geomsWithSpokes(config), Geoms{0});
        config.bodies[0].geoms = {roundGeom(GeomShape::Cylinder, 0.1, 0.3, {0.06, 0.125, 0.05})};
        QVERIFY(spokePatternsOf(config, {})[0].empty()); // a round chassis is not a wheel
    }

    void aHubThatIsABodyOfItsOwnTurnsItsTyre() {
        RobotConfigSpec config = rover({});
        config.bodies.push_back(config.bodies[1]);
        config.bodies[2].geoms = {tyre()};
        JointSpec weld;
        weld.type = JointType::Fixed;
        weld.parent = 1, weld.child = 2;
        config.joints.push_back(weld);
        QCOMPARE(spokePatternsOf(config, {})[2].size(), std::size_t(1));
    }

    void aFaceBelowAnotherHasNone() {
        // A disc that protrudes on both sides, with a nut on it.
        const Patterns patterns = spokePatternsOf(
            rover({tyre(), roundGeom(GeomShape::Cylinder, 0.04, 0.034, {}), roundGeom(GeomShape::Cylinder, 0.006, 0.04)}), {});
        QCOMPARE(patterns[1].size(), std::size_t(2));
        QVERIFY(!patterns[1][0].top && !patterns[1][0].bottom);
        QVERIFY(patterns[1][1].top && patterns[1][1].bottom);
        // Two tyres side by side: the outer faces.
        const Patterns twins = spokePatternsOf(rover({tyre({0, 0.016, 0}), tyre({0, -0.016, 0})}), {});
        QCOMPARE(twins[1].size(), std::size_t(2));
    }

    void spokesLeaveTheOutlineAsItIs_data() {
        QTest::addColumn<int>("segments");
        for (const int n : {6, 8, 14, 18, 36, 96}) QTest::addRow("%d", n) << n;
    }
    void spokesLeaveTheOutlineAsItIs() {
        QFETCH(int, segments);
        for (const GeomShape shape : {GeomShape::Cylinder, GeomShape::Sphere, GeomShape::Capsule}) {
            const auto parts = spokedShapeOf(roundGeom(shape, 0.05, 0.03), {}, {segments, true, 0});
            QCOMPARE(openEdges(parts), std::size_t(0));
            const ShapeMesh plain = shapeOf(roundGeom(shape, 0.05, 0.03), {segments, true, 0});
            const auto reachOf = [](const ShapeMesh& mesh, Eigen::Vector2f& reach) { // about z and along it
                for (const auto& p : mesh.points) reach = reach.cwiseMax(Eigen::Vector2f(p.head<2>().norm(), std::abs(p.z())));
            };
            Eigen::Vector2f spoked(0, 0), whole(0, 0);
            for (const ShapeMesh& part : parts) reachOf(part, spoked);
            reachOf(plain, whole);
            QVERIFY(std::abs(spoked[1] - whole[1]) < 1e-6f);
            QVERIFY(spoked[0] < 0.05f + 1e-6f);
            QVERIFY(shape != GeomShape::Cylinder || spoked[0] > whole[0] - 1e-6f);
            QVERIFY(!parts[std::size_t(segments < 8 ? WheelPaint::Mean : WheelPaint::Metal)].indices.empty());
        }
    }

    void spokesProtrudeFromTyre_data() {
        QTest::addColumn<double>("red");
        QTest::addColumn<double>("green");
        QTest::addColumn<double>("blue");
        QTest::newRow("black") << 0.0 << 0.0 << 0.0;
        QTest::newRow("darkgrey") << 0.25 << 0.25 << 0.25;
        QTest::newRow("grey") << 0.5 << 0.5 << 0.5;
        QTest::newRow("white") << 1.0 << 1.0 << 1.0;
        QTest::newRow("red") << 0.8 << 0.15 << 0.12;
        QTest::newRow("yellow") << 0.9 << 0.8 << 0.15;
        QTest::newRow("blue") << 0.15 << 0.35 << 0.7;
    }
    void spokesProtrudeFromTyre() {
        QFETCH(double, red);
        QFETCH(double, green);
        QFETCH(double, blue);
        MaterialSpec material;
        material.colour = {red, green, blue};
        const auto lightness = [&](WheelPaint paint) {
            const auto c = paintedMaterial(material, paint).colour;
            return 0.30 * c[0] + 0.59 * c[1] + 0.11 * c[2];
        };
        QCOMPARE(paintedMaterial(material, WheelPaint::Tyre).colour, material.colour);
        QVERIFY(std::abs(lightness(WheelPaint::Metal) - lightness(WheelPaint::Tyre)) > 0.2);
        QVERIFY(std::abs(lightness(WheelPaint::Metal) - lightness(WheelPaint::Gap)) > 0.15);
        QVERIFY(std::abs(lightness(WheelPaint::Mean) - lightness(WheelPaint::Tyre)) > 0.07);
    }
};

QTEST_APPLESS_MAIN(SpokesTest)
#include "spokes_test.moc"
