// Rays, pieces and drops at rarer edges: from below and behind, turned owners, planes that are tilted, things that do not collide.
#include <QtTest>

#include <set>

#include "scene/queries/drop_placement.h"
#include "scene/queries/ghosts.h"
#include "scene/queries/radio_model.h"
#include "scene/queries/ray_cast.h"

using namespace trundle;

namespace {

GeomSpec shape(GeomShape kind, const Vec3& size, const Vec3& at = Vec3::Zero(), const Vec3& hprDegrees = Vec3::Zero()) {
    GeomSpec geom;
    geom.name = "g";
    geom.shape = kind;
    geom.size = size;
    geom.radius = size.x();
    geom.length = size.z();
    geom.pose = {at, rotationFromHpr(hprDegrees * M_PI / 180)};
    return geom;
}

StaticSpec fixed(const char* name, std::vector<GeomSpec> geoms, const Pose& pose = {}) {
    for (std::size_t i = 0; i < geoms.size(); ++i) geoms[i].name = "g" + std::to_string(i);
    return {name, "S", pose, std::make_shared<const std::vector<GeomSpec>>(std::move(geoms)), {}, {}};
}

std::shared_ptr<ExperimentSpec> scenery(std::vector<StaticSpec> statics) {
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->statics = std::move(statics);
    return experiment;
}

/// One triangle in the plane z = 0, seen from above, and one that names a point which is not there.
GeomSpec triangle() {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->triangles = {{0, 1, 2}, {0, 1, 1u << 30}};
    GeomSpec geom = shape(GeomShape::Mesh, Vec3::Zero());
    geom.mesh = mesh;
    return geom;
}

const auto kAll = [](const ObjectRef&) { return true; };

/// Where things are put in some scenery.
struct Room {
    explicit Room(std::vector<StaticSpec> statics) : objects(scenery(std::move(statics))) {}
    explicit Room(std::shared_ptr<ExperimentSpec> experiment)
        : objects(std::move(experiment)), poses(startPoses(objects.experiment())) {}
    Vec3 dropped(const GeomSpec& thing, const Vec3& over, double step = 0) const {
        return placement.placeFor({{thing, {}}}, castRay(objects, poses, {over, -Vec3::UnitZ()}), over, step);
    }
    ObjectIndex objects;
    BodyPoses poses;
    DropPlacement placement{objects, poses, kAll};
};

} // namespace

class ShapesMetTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The normal is that of the side which is hit, in the world.
    void normalsFaceTheRay_data() {
        QTest::addColumn<Vec3>("from");
        QTest::addColumn<Vec3>("along");
        QTest::addColumn<Vec3>("normal"); // zero: missed
        const Vec3 up = Vec3::UnitZ(), ahead = Vec3::UnitX(), side = Vec3::UnitY();
        QTest::newRow("plane from above") << Vec3(5, 5, 1) << Vec3(-up) << up;
        QTest::newRow("plane from below") << Vec3(5, 5, -1) << up << Vec3(-up);
        QTest::newRow("triangle from above") << Vec3(0.2, 0.2, 3) << Vec3(-up) << up;
        QTest::newRow("triangle from below") << Vec3(0.2, 0.2, 1) << up << Vec3(-up);
        QTest::newRow("beside the triangle") << Vec3(0.6, 0.6, 1) << up << Vec3(Vec3::Zero());
        QTest::newRow("box turned with its static, from its front") << Vec3(-4, 3, 0.5) << side << Vec3(-side);
        QTest::newRow("the same from aside") << Vec3(-9, 5, 0.5) << ahead << Vec3(-ahead);
    }
    void normalsFaceTheRay() {
        QFETCH(Vec3, from);
        QFETCH(Vec3, along);
        QFETCH(Vec3, normal);
        const ObjectIndex objects(scenery({fixed("floor", {shape(GeomShape::Plane, Vec3::Zero())}),
                                           fixed("sail", {triangle()}, {Vec3(0, 0, 2), Quat::Identity()}),
                                           fixed("crate", {shape(GeomShape::Box, {1, 0.5, 1}, {0, 0, 0.5})},
                                                 {Vec3(-4, 5, 0), rotationFromHpr({M_PI / 2, 0, 0})})}));
        const auto hits = castRay(objects, {}, {from, along});
        QCOMPARE(hits.empty(), normal.isZero());
        if (!hits.empty()) QVERIFY((hits[0].normal - normal).norm() < 1e-9);
    }

    /// What is drawn and what collides may differ.
    void whatCollidesIsAWall() {
        GeomSpec drawn = shape(GeomShape::Box, {0.1, 1, 1}, {1, 0, 0}), solid = shape(GeomShape::Box, {0.1, 1, 1}, {2, 0, 0});
        drawn.collide = false;
        solid.visible = false;
        const ObjectIndex objects(scenery({fixed("walls", {drawn, solid, drawn})}));
        QCOMPARE(solidsBetween(objects, {}, Vec3::Zero(), {3, 0, 0}, 99, 99), 1);
        const auto hits = castRay(objects, {}, {Vec3::Zero(), Vec3::UnitX()});
        QCOMPARE(hits.size(), std::size_t(2));
        QCOMPARE(hits[0].distance, 0.95);
    }

    /// Out of a half space below a tilted plane: along the way, not along its normal.
    void outOfATiltedPlane() {
        const GeomSpec slope = shape(GeomShape::Plane, Vec3::Zero(), Vec3::Zero(), {0, 30, 0});
        const ConvexPiece ground = ConvexPiece::of(slope, {Vec3(1, 0, 0), Quat::Identity()}, Bounds{}).at(0);
        const Vec3 normal = slope.pose.rotation * Vec3::UnitZ();
        const auto ball = [&](double depth) { // its lowest point is so deep
            return ConvexPiece::of(shape(GeomShape::Sphere, {0.1, 0, 0}, Vec3(1, 0, 0) + (0.1 - depth) * normal), {}, Bounds{})
                .at(0);
        };
        QVERIFY(std::abs(ball(0.05).exitDistance(ground, normal) - 0.05) < 1e-9);
        QVERIFY(std::abs(ball(0.05).exitDistance(ground, Vec3::UnitZ()) - 0.05 / std::cos(M_PI / 6)) < 1e-9);
        QVERIFY(std::isinf(ball(0.05).exitDistance(ground, -normal)) &&
                std::isinf(ball(0.05).exitDistance(ground, Vec3::UnitY())));
        QCOMPARE(ball(-0.05).exitDistance(ground, Vec3::UnitZ()), 0.0);
        QVERIFY(ball(0.05).isInside(ground, 0.04) && !ball(0.05).isInside(ground, 0.06));
    }

    void aDepthIsThatOfTheOverlap() {
        const ConvexPiece crate = ConvexPiece::of(shape(GeomShape::Box, {1, 1, 1}), {}, Bounds{}).at(0);
        for (int k = 0; k < 3; ++k)
            for (const double way : {1., -1.}) {
                const GeomSpec other = shape(GeomShape::Box, {1, 1, 1}, 0.99 * way * Vec3::Unit(k));
                const ConvexPiece piece = ConvexPiece::of(other, {}, Bounds{}).at(0);
                QVERIFY(piece.isInside(crate, 0.009) && !piece.isInside(crate, 0.011));
                QVERIFY(std::abs(piece.exitDistance(crate, way * Vec3::Unit(k)) - 0.01) < 1e-6);
            }
    }

    /// A mesh is its triangles, or its hull; without a file it does not collide. A height map has its first row at +y.
    void piecesOfMeshesAndHeightMaps() {
        GeomSpec mesh = triangle();
        const Bounds everywhere{Vec3::Constant(-9), Vec3::Constant(9)};
        QCOMPARE(ConvexPiece::of(mesh, {}, everywhere).size(), std::size_t(1));
        mesh.collideAsHull = true;
        auto hull = std::make_shared<TriangleMesh>();
        hull->points = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        mesh.hull = hull;
        const auto pieces = ConvexPiece::of(mesh, {Vec3(0, 0, 5), rotationFromHpr({M_PI / 2, 0, 0})}, Bounds{});
        QCOMPARE(pieces.size(), std::size_t(1));
        QVERIFY((pieces[0].support(Vec3::UnitY()) - Vec3(0, 3, 5)).norm() < 1e-9);
        mesh.mesh = nullptr;
        mesh.hull = nullptr;
        QVERIFY(ConvexPiece::of(mesh, {}, everywhere).empty());

        GeomSpec land = shape(GeomShape::Heightfield, {6, 4, 1.5});
        land.heightMap = std::make_shared<HeightMap>(HeightMap{4, 3, {0, 0, 0, 1, 0, 0, 0, 0, 0.5f, 0, 0, 0}});
        const auto cells = ConvexPiece::of(land, {}, everywhere);
        QCOMPARE(cells.size(), std::size_t(12));
        Bounds all;
        for (const ConvexPiece& cell : cells) all.add(cell.bounds());
        QVERIFY(all.low == Vec3(-3, -2, 0) && all.high == Vec3(3, 2, 1.5));
        const auto highest = [&](const Vec3& at) { // of the triangles at a corner
            double z = -1;
            for (const ConvexPiece& cell : ConvexPiece::of(land, {}, {at - Vec3(0.1, 0.1, 9), at + Vec3(0.1, 0.1, 9)}))
                z = std::max(z, cell.bounds().high.z());
            return z;
        };
        QCOMPARE(highest({3, 2, 0}), 1.5);
        QCOMPARE(highest({-3, -2, 0}), 0.75);
        QCOMPARE(highest({-3, 2, 0}), 0.);
        QCOMPARE(highest({3, -2, 0}), 0.);
    }

    void onGroundOfAnyHeight() {
        const GeomSpec crate = shape(GeomShape::Box, {0.2, 0.2, 0.2}, {0, 0, 0.1});
        for (const double z : {0.1234564, -0.7654321, 0.1234567}) { // never in the ground by what Pos is rounded
            const Room room({fixed("floor", {shape(GeomShape::Plane, Vec3::Zero(), {0, 0, z})})});
            const double at = room.dropped(crate, {0.3, 0.2, 3}).z();
            QVERIFY2(at >= z && at < z + 1e-5, qPrintable(QString::number(at, 'g', 12)));
        }
        const Room nothing(std::vector<StaticSpec>{});
        QVERIFY(nothing.dropped(crate, {0.3, 0.2, 0}).z() < 1e-5);
        QVERIFY(std::abs(nothing.dropped(crate, {0.34, 0.26, 0}, 0.05).x() - 0.35) < 1e-9);
        GeomSpec ghost = crate; // it collides nowhere: what is seen of it is put down
        ghost.collide = false;
        ghost.pose.position.z() = 0;
        const Room floor({fixed("floor", {shape(GeomShape::Plane, Vec3::Zero())})});
        QVERIFY(std::abs(floor.dropped(ghost, {0, 0, 3}).z() - 0.1) < 1e-5);
        GeomSpec deep = crate; // neither seen nor solid: it has no part in that
        deep.collide = deep.visible = false;
        deep.pose.position.z() = -5;
        const auto hits = castRay(floor.objects, {}, {Vec3(0, 0, 3), -Vec3::UnitZ()});
        QVERIFY(std::abs(floor.placement.placeFor({{ghost, {}}, {deep, {}}}, hits, {}, 0).z() - 0.1) < 1e-5);
    }

    /// Against a face: rounded along it, touching it; also from below.
    void againstAFace() {
        const Room room({fixed("wall", {shape(GeomShape::Box, {0.1, 4, 2}, {1.0234, 0, 1})})});
        const GeomSpec box = shape(GeomShape::Box, {0.2, 0.1, 0.1});
        const auto put = [&](const Vec3& from, const Vec3& along, double step) {
            return room.placement.placeAgainst({{box, {}}}, castRay(room.objects, {}, {from, along}).at(0), step);
        };
        const Vec3 side = put({0, 0.512, 0.777}, Vec3::UnitX(), 0.05);
        QVERIFY((side - Vec3(0.8734, 0.5, 0.8)).norm() < 1e-4 && side.x() <= 0.8734);
        QVERIFY((put({0, 0.512, 0.777}, Vec3::UnitX(), 0) - Vec3(0.8734, 0.512, 0.777)).norm() < 1e-4);
        const Vec3 below = put({1.03, 0.512, -1}, Vec3::UnitZ(), 0.05);
        QVERIFY((below - Vec3(1.05, 0.5, -0.05)).norm() < 1e-4 && below.z() <= -0.05);
    }

    /// Rather the floor than the top of a wall, a slope or a robot; as near as possible.
    void onTheFloor_data() {
        QTest::addColumn<int>("what");
        QTest::addColumn<double>("z");
        QTest::addColumn<bool>("isThere");
        QTest::newRow("nothing else") << 0 << 0. << true;
        QTest::newRow("a narrow wall") << 1 << 0. << false;
        QTest::newRow("a broad table") << 2 << 0.7 << true; // and nothing below it is high enough
        QTest::newRow("a steep roof") << 3 << 0. << false;
        QTest::newRow("a robot") << 4 << 0. << false;
    }
    void onTheFloor() {
        QFETCH(int, what);
        QFETCH(double, z);
        QFETCH(bool, isThere);
        std::vector<StaticSpec> statics{fixed("floor", {shape(GeomShape::Plane, Vec3::Zero())})};
        if (what == 1) statics.push_back(fixed("wall", {shape(GeomShape::Box, {0.1, 2, 0.5}, {0, 0, 0.25})}));
        if (what == 2) statics.push_back(fixed("table", {shape(GeomShape::Box, {1, 1, 0.7}, {0, 0, 0.35})}));
        if (what == 3) statics.push_back(fixed("roof", {shape(GeomShape::Box, {2, 1, 1}, {0, 0, 0}, {0, 65, 0})}));
        auto experiment = scenery(statics);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.resize(1);
        config->bodies[0].geoms = {shape(GeomShape::Box, {0.6, 0.6, 0.2}, {0, 0, 0.1})};
        if (what == 4) experiment->robots.push_back({"r", {}, config, {}, {}});
        const Room room(experiment);
        const GeomSpec crate = shape(GeomShape::Box, {0.3, 0.3, 0.3});
        const auto at = room.placement.placeOnFloor({{crate, {}}}, {0.01, 0.02, 0}, 0.05);
        QVERIFY(at);
        QVERIFY2(std::abs(at->z() - 0.15 - z) < 1e-4, qPrintable(QString::number(at->z())));
        QCOMPARE((at->head<2>() - Vec3(0.01, 0.02, 0).head<2>()).norm() < 1e-9, isThere);
        QVERIFY(at->head<2>().norm() < 2 && room.placement.isFree({{crate, {}}}, *at));
        for (int k = 0; k < 2; ++k) {
            const double steps = ((*at)[k] - (k == 0 ? 0.01 : 0.02)) / 0.05;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-6);
        }
    }

    /// Of robots with different numbers of bodies and devices: each radio on its body, with its own values.
    void radiosOfSeveralRobots() {
        const auto radio = [](const char* name, const char* body, double address, double current) {
            ComponentSpec spec{"Transceiver", name, {}, {}, {}};
            spec.values["Body"] = {{PropertyType::Reference, {}, {body}}, {}, Origin::Config};
            spec.values["Antenna"] = {{PropertyType::Reference, {}, {"dipole"}}, {}, Origin::Config};
            const auto given = [&](const char* key, std::vector<double> numbers) {
                spec.values[key] = {{PropertyType::Number, std::move(numbers), {}}, {}, Origin::Config};
            };
            given("Channel", {11});
            given("Address", {address});
            given("ReceiveCurrent", {current});
            given("TransmitCurrent", {0.5, 0.25});
            given("HPR", {M_PI / 2, 0, 0});
            return spec;
        };
        auto one = std::make_shared<RobotConfigSpec>(), two = std::make_shared<RobotConfigSpec>();
        one->bodies.resize(3);
        two->bodies.resize(2);
        for (std::size_t b = 0; b < 3; ++b) one->bodies[b].name = "b" + std::to_string(b);
        for (std::size_t b = 0; b < 2; ++b) two->bodies[b].name = "b" + std::to_string(b);
        one->devices = {radio("low", "b2", 7, 0.01), {"Led", "l", {}, {}, {}}};
        two->devices = {radio("low", "b1", 8, 0.02), radio("high", "none", 9, 0.03)};
        ExperimentSpec experiment;
        experiment.robots = {{"a", {}, one, {}, {}}, {"b", {}, two, {}, {}}};
        const std::vector<RadioNode> nodes = radioNodesOf(experiment);
        QCOMPARE(nodes.size(), std::size_t(3));
        const std::tuple<std::string, std::size_t, std::uint32_t, double> expected[] = {
            {"a/low", 2, 7, 0.01}, {"b/low", 4, 8, 0.02}, {"b/high", 3, 9, 0.03}};
        const auto dipole = antennaNamed(experiment, "dipole");
        for (std::size_t i = 0; i < 3; ++i) {
            const RadioDefinition& r = nodes[i].radio;
            QVERIFY((std::tuple(r.path, nodes[i].body, r.address, r.receiveCurrent) == expected[i]));
            QVERIFY(r.transmitCurrents == (std::vector{0.5, 0.25}) && r.powerLevels.empty());
            QVERIFY((nodes[i].mounting.rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
            QCOMPARE(r.antenna->gain(Vec3::UnitX()), dipole->gain(Vec3::UnitX()));
        }
    }

    /// What is lost is drawn where the robot is now, as it was.
    void ghostsAreWhereTheirRobotsAre() {
        auto before = scenery({fixed("arena", {shape(GeomShape::Plane, Vec3::Zero()), shape(GeomShape::Box, {1, 1, 1})})});
        before->materials.resize(3);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.resize(2);
        for (std::size_t b = 0; b < 2; ++b) {
            config->bodies[b].name = b ? "arm" : "hull";
            config->bodies[b].geoms = {shape(GeomShape::Box, {1, 1, 1})};
            config->bodies[b].geoms[0].name = "box";
        }
        before->robots = {{"a", {Vec3(1, 0, 0), Quat::Identity()}, config, {}, {}}};
        auto now = std::make_shared<ExperimentSpec>(*before);
        now->materials.resize(1);
        now->robots[0].pose.position = {7, 8, 9};
        now->statics[0].pose.position = {4, 5, 6};
        std::set<std::string> asked;
        const auto isWritten = [&](const std::string& path) { return asked.insert(path), true; };
        QVERIFY(!ghostsOf(*now, *before, isWritten)); // only moved
        auto less = std::make_shared<RobotConfigSpec>(*config);
        less->bodies[1].geoms.clear();
        now->robots[0].config = less;
        now->statics[0] = fixed("arena", {}, now->statics[0].pose);
        const auto ghosts = ghostsOf(*now, *before, isWritten);
        QVERIFY(ghosts && ghosts->robots.size() == 1 && ghosts->statics.size() == 1);
        QCOMPARE(ghosts->materials.size(), std::size_t(3));
        QVERIFY(ghosts->robots[0].pose.position == Vec3(7, 8, 9) && ghosts->statics[0].pose.position == Vec3(4, 5, 6));
        QCOMPARE(ghosts->robots[0].config->bodies.size(), std::size_t(1));
        QCOMPARE(ghosts->robots[0].config->bodies[0].name, std::string("arm"));
        QCOMPARE(ghosts->statics[0].geoms->size(), std::size_t(1)); // no plane
        QVERIFY(asked.contains("a.arm.box") && !asked.contains("a.box") && !asked.contains("a.hull.box"));
        now->statics.clear();
        now->robots = before->robots;
        const auto wall = ghostsOf(*now, *before, isWritten);
        QVERIFY(wall && wall->robots.empty() && wall->statics.size() == 1 && wall->statics[0].geoms->size() == 1);
    }
};

QTEST_APPLESS_MAIN(ShapesMetTest)
#include "shapes_met_test.moc"
