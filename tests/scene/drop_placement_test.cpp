// Placement of dropped objects on and beside others.
#include <QtTest>

#include <random>

#include "scene/queries/drop_placement.h"

using namespace trundle;

namespace {

GeomSpec shape(GeomShape kind, const Vec3& size, const Pose& pose = {}) {
    GeomSpec geom;
    geom.shape = kind;
    geom.size = size;
    geom.radius = size.x();
    geom.length = size.z();
    geom.pose = pose;
    return geom;
}

/// A house with a gable roof, open below: a non-convex mesh that collides as a mesh.
std::shared_ptr<const TriangleMesh> gable() {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}, {-0.5, 0, 0.8}, {0.5, 0, 0.8}};
    mesh->triangles = {{0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}, {3, 0, 4}, {1, 2, 5}};
    return mesh;
}

Pose turned(const Vec3& at, const Vec3& hprDegrees) { return {at, rotationFromHpr(hprDegrees * M_PI / 180)}; }

bool holds(const GeomSpec& g, const Pose& owner, const Vec3& point, double depth) {
    const Vec3 p = (owner * g.pose).inverse() * point;
    switch (g.shape) {
    case GeomShape::Box: return ((0.5 * g.size - p.cwiseAbs()).array() > depth).all();
    case GeomShape::Sphere: return p.norm() < g.radius - depth;
    case GeomShape::Cylinder: return p.head<2>().norm() < g.radius - depth && std::abs(p.z()) < 0.5 * g.length - depth;
    case GeomShape::Capsule:
        return (p - Vec3(0, 0, std::clamp(p.z(), -0.5 * g.length, 0.5 * g.length))).norm() < g.radius - depth;
    case GeomShape::Plane: return p.z() < -depth;
    default: return false;
    }
}

/// Points all over a shape, its surface included.
std::vector<Vec3> pointsOf(const GeomSpec& g, const Pose& owner) {
    std::vector<Vec3> all;
    constexpr int kSteps = 10;
    const Vec3 half = g.shape == GeomShape::Box
                          ? Vec3(0.5 * g.size)
                          : Vec3(g.radius, g.radius, g.shape == GeomShape::Sphere ? g.radius : 0.5 * g.length);
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; j <= kSteps; ++j)
            for (int k = 0; k <= kSteps; ++k) {
                Vec3 p(2.0 * i / kSteps - 1, 2.0 * j / kSteps - 1, 2.0 * k / kSteps - 1);
                if (g.shape == GeomShape::Cylinder && p.head<2>().norm() > 1) p.head<2>().normalize();
                if (g.shape == GeomShape::Sphere && p.norm() > 1) p.normalize();
                if (g.shape == GeomShape::Capsule) { // a ball whose halves are moved apart
                    if (p.norm() > 1) p.normalize();
                    all.push_back(owner * (g.pose * (g.radius * p + Vec3(0, 0, std::copysign(0.5 * g.length, p.z())))));
                    continue;
                }
                all.push_back(owner * (g.pose * p.cwiseProduct(half)));
            }
    return all;
}

/// A room with a floor, a rotated wall, a post, a tilted board, a table on legs and a house.
std::shared_ptr<const ExperimentSpec> room() {
    auto experiment = std::make_shared<ExperimentSpec>();
    const auto add = [&](const char* name, std::vector<GeomSpec> geoms, const Pose& pose = {}) {
        StaticSpec fixed;
        fixed.name = name;
        fixed.pose = pose;
        for (std::size_t i = 0; i < geoms.size(); ++i) geoms[i].name = "g" + std::to_string(i);
        fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(geoms));
        experiment->statics.push_back(std::move(fixed));
    };
    add("floor", {shape(GeomShape::Plane, Vec3::Zero())});
    add("wall", {shape(GeomShape::Box, {2, 0.1, 0.5}, turned({0, 0, 0.25}, {0, 0, 0}))}, turned({1, 0.5, 0}, {37, 0, 0}));
    add("post", {shape(GeomShape::Cylinder, {0.2, 0, 0.6}, turned({0, 0, 0.3}, {0, 0, 0}))}, turned({-1, 0.5, 0}, {0, 0, 0}));
    add("board", {shape(GeomShape::Box, {1, 0.6, 0.05}, turned({0, 0, 0.15}, {0, -15, 0}))}, turned({0, -1.5, 0}, {20, 0, 0}));
    add("table",
        {shape(GeomShape::Box, {1, 0.6, 0.04}, turned({0, 0, 0.7}, {0, 0, 0})),
         shape(GeomShape::Box, {0.05, 0.05, 0.68}, turned({0.45, 0.25, 0.34}, {0, 0, 0})),
         shape(GeomShape::Box, {0.05, 0.05, 0.68}, turned({-0.45, -0.25, 0.34}, {0, 0, 0}))},
        turned({-2, -1.5, 0}, {10, 0, 0}));
    GeomSpec house = shape(GeomShape::Mesh, Vec3::Zero());
    house.mesh = gable();
    add("house", {house}, turned({2, -1.5, 0}, {30, 0, 0}));
    return experiment;
}

struct Thing {
    const char* name;
    std::vector<PlacementGeom> geoms;
};

std::vector<Thing> things() {
    return {{"crate", {{shape(GeomShape::Box, {0.25, 0.25, 0.25}, turned({0, 0, 0.125}, {0, 0, 0})), {}}}},
            {"turned crate",
             {{shape(GeomShape::Box, {0.4, 0.2, 0.1}, turned({0, 0, 0}, {0, 0, 0})), turned({0, 0, 0}, {25, 30, 10})}}},
            {"lying drum",
             {{shape(GeomShape::Cylinder, {0.1, 0, 0.4}, turned({0, 0, 0.1}, {0, 90, 0})), turned({0, 0, 0}, {40, 0, 0})}}},
            {"ball", {{shape(GeomShape::Sphere, {0.08, 0, 0}, turned({0, 0, 0.08}, {0, 0, 0})), {}}}},
            {"capsule",
             {{shape(GeomShape::Capsule, {0.08, 0, 0.3}, turned({0, 0, 0.08}, {0, 70, 0})), turned({0, 0, 0}, {40, 0, 0})}}},
            {"dumbbell",
             {{shape(GeomShape::Sphere, {0.1, 0, 0}, turned({0.2, 0, 0.1}, {0, 0, 0})), {}},
              {shape(GeomShape::Sphere, {0.1, 0, 0}, turned({-0.2, 0, 0.1}, {0, 0, 0})), {}}}}};
}

} // namespace

class DropPlacementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void separationIsExact_data() {
        QTest::addColumn<int>("moved");
        QTest::addColumn<int>("fixed");
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b) QTest::addRow("%d out of %d", a, b) << a << b;
    }
    /// At the computed distance two shapes do not overlap; at a slightly smaller one they do.
    void separationIsExact() {
        QFETCH(int, moved);
        QFETCH(int, fixed);
        std::mt19937 random(unsigned(7 + moved * 3 + fixed));
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        const auto make = [&](int kind) {
            const GeomShape shapes[] = {GeomShape::Box, GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule};
            return shape(
                shapes[kind], {any(0.1, 0.4), any(0.1, 0.4), any(0.1, 0.4)},
                turned({any(-0.05, 0.05), any(-0.05, 0.05), any(-0.05, 0.05)}, {any(-180, 180), any(-90, 90), any(-180, 180)}));
        };
        const auto shareAPoint = [](const GeomSpec& a, const Pose& at, const GeomSpec& b, double depth) {
            for (const Vec3& p : pointsOf(a, at))
                if (holds(b, {}, p, depth)) return true;
            for (const Vec3& p : pointsOf(b, {}))
                if (holds(a, at, p, depth)) return true;
            return false;
        };
        for (int i = 0; i < 30; ++i) {
            const GeomSpec a = make(moved), b = make(fixed);
            const ConvexPiece one = ConvexPiece::of(a, {}, Bounds{}).at(0), other = ConvexPiece::of(b, {}, Bounds{}).at(0);
            if (!one.isInside(other, 1e-3)) continue;
            const Vec3 way = Vec3(any(-1, 1), any(-1, 1), any(-1, 1)).normalized();
            const double far = one.exitDistance(other, way);
            QVERIFY(std::isfinite(far) && far > 0);
            QVERIFY(!shareAPoint(a, {(far + 1e-6) * way, Quat::Identity()}, b, 1e-6));
            ConvexPiece clear = one, nearly = one;
            clear.move((far + 1e-5) * way);
            nearly.move((far - 1e-3) * way);
            QVERIFY(!clear.isInside(other, 1e-6));
            QVERIFY(nearly.isInside(other, 0)); // exact: no farther than necessary
        }
    }

    /// Each corner of a box is part of it, whichever of the two is moved.
    void everyCornerCounts() {
        const Pose tilt = turned({0.3, -0.2, 0.1}, {30, 20, 10});
        const ConvexPiece crate = ConvexPiece::of(shape(GeomShape::Box, {1, 0.8, 0.6}), tilt, Bounds{}).at(0);
        for (int i = 0; i < 8; ++i) {
            const Vec3 corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.4 : -0.4, i & 4 ? 0.3 : -0.3);
            const Vec3 out = tilt.rotation * corner.normalized();
            const GeomSpec ball = shape(GeomShape::Sphere, {0.02, 0, 0}, {tilt * (0.97 * corner), Quat::Identity()});
            const ConvexPiece point = ConvexPiece::of(ball, {}, Bounds{}).at(0);
            QVERIFY2(crate.isInside(point, 0.01) && point.isInside(crate, 0.01), qPrintable(QString::number(i)));
            const double left = (0.03 * corner).norm();
            QVERIFY(point.exitDistance(crate, out) > left &&
                    std::abs(point.exitDistance(crate, out) - crate.exitDistance(point, -out)) < 1e-6);
        }
    }

    void dropNeverOverlaps_data() {
        QTest::addColumn<int>("thing");
        const auto all = things();
        for (int i = 0; i < int(all.size()); ++i) QTest::newRow(all[std::size_t(i)].name) << i;
    }
    void dropNeverOverlaps() {
        QFETCH(int, thing);
        const auto experiment = room();
        const ObjectIndex objects(experiment);
        const BodyPoses poses;
        const DropPlacement placement(objects, poses, [](const ObjectRef&) { return true; });
        const std::vector<PlacementGeom> geoms = things()[std::size_t(thing)].geoms;
        std::mt19937 random(11);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int steep = 0;
        for (int i = 0; i < 30; ++i) {
            const Vec3 from(any(-3, 3), any(-4, 2), any(0.3, 2)), to(any(-2.5, 2.5), any(-2, 1.2), any(0, 0.7));
            const auto hits = castRay(objects, poses, {from, (to - from).normalized()});
            if (hits.empty()) continue;
            steep += hits.front().normal.z() < 0.5;
            const Vec3 at = placement.placeFor(geoms, hits, to, 0.05);
            for (const PlacementGeom& part : geoms) {
                const Pose owner = Pose{at, Quat::Identity()} * part.body;
                const std::vector<Vec3> points = pointsOf(part.geom, owner);
                for (const StaticSpec& fixed : experiment->statics)
                    for (const GeomSpec& geom : *fixed.geoms)
                        for (const Vec3& p : points)
                            QVERIFY2(!holds(geom, fixed.pose, p, 1e-5),
                                     qPrintable(QString("in %1 at %2 %3 %4, pointed at %5")
                                                    .arg(QString::fromStdString(fixed.name))
                                                    .arg(at.x())
                                                    .arg(at.y())
                                                    .arg(at.z())
                                                    .arg(QString::fromStdString(objects.pathOf(hits.front().geom)))));
            }
        }
        QVERIFY(steep > 2);
    }

    void onSideFaceItRestsOnFloorAndTouches() {
        const auto experiment = room();
        const ObjectIndex objects(experiment);
        const DropPlacement placement(objects, {}, [](const ObjectRef&) { return true; });
        const std::vector<PlacementGeom> crate = things()[0].geoms;
        const StaticSpec& wall = experiment->statics[1];
        for (const double side : {1.0, -1.0}) {
            const Vec3 normal = wall.pose.rotation * Vec3(0, side, 0), face = wall.pose * Vec3(0.3, 0.05 * side, 0.3);
            const auto hits = castRay(objects, {}, {face + normal + Vec3(0, 0, 0.5), (-normal - Vec3(0, 0, 0.5)).normalized()});
            QCOMPARE(hits.front().geom, (ObjectRef{ObjectKind::StaticGeom, 1, 0, 0}));
            const Vec3 at = placement.placeFor(crate, hits, face, 0);
            QVERIFY(std::abs(at.z()) < 1e-5); // on the floor
            double nearest = 1;
            for (const Vec3& p : pointsOf(crate[0].geom, {at, Quat::Identity()}))
                nearest = std::min(nearest, normal.dot(p - face));
            QVERIFY2(nearest > 0 && nearest < 1e-4, qPrintable(QString::number(nearest)));
        }
        // The side of a table top: there is free space below.
        const StaticSpec& table = experiment->statics[4];
        const Vec3 edge = table.pose * Vec3(0, -0.3, 0.7), out = table.pose.rotation * Vec3(0, -1, 0);
        const Vec3 below = placement.placeFor(crate, castRay(objects, {}, {edge + out, -out}), edge, 0);
        QVERIFY(std::abs(below.z()) < 1e-5);
    }

    /// Beside an obstacle Pos is in whole millimetres, as near to it as those allow.
    void besideAnObstaclePosIsRound() {
        const auto experiment = room();
        const ObjectIndex objects(experiment);
        const DropPlacement placement(objects, {}, [](const ObjectRef&) { return true; });
        const std::vector<PlacementGeom> crate = things()[0].geoms;
        std::mt19937 random(3);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int beside = 0;
        for (int i = 0; i < 40; ++i) {
            const Vec3 from(any(-3, 3), any(-4, 2), any(0.3, 1)), to(any(-1.5, 1.5), any(-1, 1), any(0, 0.4));
            const auto hits = castRay(objects, {}, {from, (to - from).normalized()});
            if (hits.empty() || hits.front().normal.z() > 0.5) continue;
            const Vec3 exact = placement.placeFor(crate, hits, to, 0), at = placement.placeFor(crate, hits, to, 0.05);
            if (exact.z() > 1e-4 || at.z() > 1e-4) continue; // on a slope the height follows from x and y
            ++beside;
            for (int k = 0; k < 2; ++k)
                QVERIFY2(std::abs(at[k] * 1000 - std::round(at[k] * 1000)) < 1e-6, qPrintable(QString::number(at[k], 'g', 12)));
            QVERIFY(placement.isFree(crate, at));
        }
        QVERIFY2(beside > 3, qPrintable(QString::number(beside)));
    }

    /// Walls and beams dropped across others: each is supported under its middle, or is on the floor.
    void nothingHangsInTheAir() {
        const auto experiment = room();
        const ObjectIndex objects(experiment);
        const DropPlacement placement(objects, {}, [](const ObjectRef&) { return true; });
        std::mt19937 random(5);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int tops = 0, floors = 0, beside = 0;
        for (int i = 0; i < 60; ++i) {
            const double length = any(0.6, 2.5), height = any(0.1, 0.6);
            const std::vector<PlacementGeom> wall{
                {shape(GeomShape::Box, {length, 0.1, height}, turned({0, 0, height / 2}, {any(-180, 180), 0, 0})), {}}};
            const Vec3 to(any(-1.6, 2.2), any(-0.6, 1.6), 0);
            const auto hits = castRay(objects, {}, {to + Vec3(0, 0, 3), -Vec3::UnitZ()});
            const Vec3 at = placement.placeFor(wall, hits, to, 0.05);
            for (const StaticSpec& fixed : experiment->statics)
                for (const GeomSpec& geom : *fixed.geoms)
                    for (const Vec3& p : pointsOf(wall[0].geom, {at, Quat::Identity()}))
                        QVERIFY(!holds(geom, fixed.pose, p, 1e-5));
            const auto below = castRay(objects, {}, {at + Vec3(0, 0, 1e-3), -Vec3::UnitZ()});
            QVERIFY2(!below.empty() && at.z() - below.front().point.z() < 6e-3,
                     qPrintable(QString("%1 m long at %2 %3 %4, put at %5 %6")
                                    .arg(length)
                                    .arg(at.x())
                                    .arg(at.y())
                                    .arg(at.z())
                                    .arg(to.x())
                                    .arg(to.y())));
            (at.z() < 1e-4 ? floors : tops) += 1;
            beside += at.z() < 1e-4 && (at - to).head<2>().norm() > 0.05;
        }
        QVERIFY2(tops > 0 && floors > 10 && beside > 5, qPrintable(QString("%1 %2 %3").arg(tops).arg(floors).arg(beside)));
    }

    void onTopItRestsOnTop() {
        const auto experiment = room();
        const ObjectIndex objects(experiment);
        const DropPlacement placement(objects, {}, [](const ObjectRef&) { return true; });
        const auto dropped = [&](int thing, const Vec3& over) {
            return placement.placeFor(things()[std::size_t(thing)].geoms, castRay(objects, {}, {over, -Vec3::UnitZ()}), over, 0);
        };
        QVERIFY(std::abs(dropped(0, {-1, 0.5, 3}).z() - 0.6) < 1e-5);   // the post
        QVERIFY(std::abs(dropped(3, {-2, -1.5, 3}).z() - 0.72) < 1e-5); // the table
        QVERIFY(std::abs(dropped(0, {0, 1.5, 3}).z()) < 1e-5);
        // A ball on a slope touches it: its centre is a radius above the board.
        const StaticSpec& board = experiment->statics[3];
        const Vec3 ball = dropped(3, board.pose * Vec3(0, 0, 3)) + Vec3(0, 0, 0.08);
        const Vec3 local = (board.pose * board.geoms->at(0).pose).inverse() * ball;
        QVERIFY2(std::abs(local.z() - 0.025 - 0.08) < 1e-5, qPrintable(QString::number(local.z())));
        // The origin of an object may be its centre.
        const double low = dropped(1, {0, 1.5, 3}).z();
        QVERIFY(low > 0.1 && low < 0.2);
    }
};

QTEST_APPLESS_MAIN(DropPlacementTest)
#include "drop_placement_test.moc"
