// What rays hit in both engines, and the normals there: at right angles to the surface, which two rays beside the first one show.
#include <QtTest>

#include "world/engine.h"
#include "world/ray_reference.h"
#include "world/rays/beam_table.h"
#include "world/rays/ray_targets.h"
#include "world/wheeled/wheeled.h"

using namespace fixture;

namespace {

GeomSpec withShape(GeomShape shape, double radius, double length) {
    GeomSpec geom = cylinder("round", radius, length);
    geom.shape = shape;
    return geom;
}

/// A pyramid of four triangles, as a mesh or its hull.
GeomSpec pyramid(bool isHull) {
    GeomSpec geom;
    geom.name = "pyramid";
    geom.shape = isHull ? GeomShape::Convex : GeomShape::Mesh;
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0.4, 0, -0.2}, {-0.3, 0.35, -0.2}, {-0.2, -0.4, -0.2}, {0.05, 0, 0.4}};
    mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    geom.mesh = mesh;
    if (isHull) geom.hull = mesh, geom.collideAsHull = true;
    return geom;
}

GeomSpec hills() {
    GeomSpec geom;
    geom.name = "hills";
    geom.shape = GeomShape::Heightfield;
    geom.size = {0.8, 0.6, 0.3};
    auto map = std::make_shared<HeightMap>();
    map->columns = 5, map->rows = 4;
    RayRandom random(9);
    for (int i = 0; i < 20; ++i) map->heights.push_back(static_cast<float>(random(0, 1)));
    geom.heightMap = map;
    return geom;
}

EngineSettings settings() {
    EngineSettings made;
    made.surfaces.push_back({"default", 0.5, 0, 0, 0, {}});
    return made;
}

std::optional<SingleHit> hitBy(const Engine& engine, const SingleRay& ray) { return engine.rays().ray(ray, kNoGeom); }

} // namespace

class RayNormalsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void normals_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("isWheeled");
        for (const bool isWheeled : {false, true}) {
            int shape = 0;
            for (const char* name : {"box", "ball", "rod", "disc", "long capsule", "short capsule", "hull", "mesh", "hills"})
                QTest::addRow("%s, %s", name, isWheeled ? "wheeled" : "general") << shape++ << isWheeled;
        }
    }
    void normals() {
        QFETCH(int, shape);
        QFETCH(bool, isWheeled);
        const GeomSpec shapes[] = {box("box", {0.5, 0.3, 0.2}),
                                   sphere("ball", 0.3),
                                   cylinder("rod", 0.1, 0.8),
                                   cylinder("disc", 0.4, 0.1),
                                   withShape(GeomShape::Capsule, 0.1, 0.7),
                                   withShape(GeomShape::Capsule, 0.3, 0.1),
                                   pyramid(true),
                                   pyramid(false),
                                   hills()};
        const GeomSpec& spec = shapes[shape];
        if (isWheeled && spec.shape == GeomShape::Heightfield) return; // it has none
        auto made = isWheeled ? makeWheeledEngine(settings(), false) : makeOdeEngine(settings());
        QVERIFY(made.ok());
        const auto engine = std::move(made).value();
        RayRandom random(11);
        QVERIFY(engine->addStatic(spec, {Vec3(0.3, -0.2, 0.5), random.rotation()}).ok());
        int hits = 0, smooth = 0;
        for (int i = 0; i < 3000; ++i) {
            SingleRay ray;
            ray.origin = Vec3(0.3, -0.2, 0.5) + 2 * random.vector(1).normalized();
            ray.direction = (Vec3(0.3, -0.2, 0.5) + random.vector(0.4) - ray.origin).normalized();
            ray.range = 5;
            const auto hit = hitBy(*engine, ray);
            if (!hit) continue;
            ++hits;
            QVERIFY(std::abs(hit->normal.norm() - 1) < 1e-9);
            const double slope = -hit->normal.dot(ray.direction);
            QVERIFY(slope > -1e-9);
            if (slope < 0.05) continue;
            const Vec3 side = ray.direction.unitOrthogonal(), other = ray.direction.cross(side),
                       at = ray.origin + hit->distance * ray.direction;
            for (const Vec3& by : {side, other}) {
                constexpr double kBeside = 1e-6; // m
                SingleRay beside = ray;
                beside.origin += kBeside * by;
                const auto next = hitBy(*engine, beside);
                if (!next || (next->normal - hit->normal).norm() > 1e-3) continue; // beyond an edge
                ++smooth;
                const Vec3 way = beside.origin + next->distance * ray.direction - at;
                QVERIFY2(std::abs(way.dot(hit->normal)) < 1e-3 * way.norm(),
                         qPrintable(QString::number(way.dot(hit->normal) / way.norm())));
            }
        }
        QVERIFY2(hits > 300 && smooth > hits, qPrintable(QString::number(hits)));
    }

    void wheeledAgainstTheReference_data() {
        QTest::addColumn<int>("shape");
        for (int shape = 0; shape < 5; ++shape) QTest::addRow("%d", shape) << shape;
    }
    /// The wheeled engine's rays and fans find the tips of what is long, from any side.
    void wheeledAgainstTheReference() {
        QFETCH(int, shape);
        const GeomSpec shapes[] = {box("box", {0.9, 0.1, 0.2}), sphere("ball", 0.3), cylinder("rod", 0.1, 1.6),
                                   withShape(GeomShape::Capsule, 0.1, 1.2), withShape(GeomShape::Capsule, 0.3, 0.5)};
        const GeomSpec& spec = shapes[shape];
        const auto engine = std::move(makeWheeledEngine(settings(), false)).value();
        RayRandom random(21);
        const Pose pose{Vec3(0, 0, 2), random.rotation()};
        QVERIFY(engine->addStatic(spec, pose).ok());
        const double elevations[1] = {0};
        int hits = 0;
        for (int i = 0; i < 4000; ++i) {
            const Mat3 axes = random.rotation().toRotationMatrix();
            // From beside a point of its axis, or a little beyond its end, across it.
            const Vec3 towards = pose * Vec3(0, 0, random(-1.1, 1.1) * (0.5 * spec.length + spec.radius));
            const SingleRay ray{towards - 3 * axes.col(0), axes.col(0), 6};
            const double expected = referenceHit(spec, pose, ray);
            const auto hit = hitBy(*engine, ray);
            QCOMPARE(bool(hit), expected != kMiss);
            double distance = 0;
            std::uint32_t geom = 0;
            engine->rays().castFan({ray.origin, axes, 6, 0, 0.1, 1, elevations}, kNoGeom, {&distance, &geom, nullptr});
            QCOMPARE(geom != kNoGeom, expected != kMiss);
            if (!hit) continue;
            ++hits;
            QVERIFY(std::abs(hit->distance - expected) < 1e-9 && std::abs(distance - expected) < 1e-9);
        }
        QVERIFY(hits > 500);
    }

    /// A table of beams is that of its fan: each of its numbers counts.
    void tablesOfAlikeFans() {
        const double level[] = {0}, raised[] = {0.1}, both[] = {0, 0.1};
        const auto fan = [](double first, double step, std::uint32_t count, std::span<const double> elevations) {
            RayFan made;
            made.firstBearing = first;
            made.bearingStep = step;
            made.count = count;
            made.elevations = elevations;
            return made;
        };
        const RayFan fans[] = {fan(-1, 0.1, 20, level),   fan(-1, 0.2, 20, level), fan(-1, -0.1, 20, level),
                               fan(-0.5, 0.1, 20, level), fan(-1, 0.1, 21, level), fan(-1, 0.1, 20, raised),
                               fan(-1, 0.1, 20, both)};
        BeamTables tables;
        for (int round = 0; round < 3; ++round)
            for (const RayFan& wanted : fans) {
                const BeamTable& table = tables.of(wanted);
                QCOMPARE(table.count, wanted.count);
                QCOMPARE(table.layers.size(), wanted.elevations.size());
                const Direction last = directionOf(wanted.firstBearing + (wanted.count - 1) * wanted.bearingStep);
                QCOMPARE(table.cosines[wanted.count - 1], last.cosine);
                QCOMPARE(table.sines[wanted.count - 1], last.sine);
                QCOMPARE(table.cosines[0], directionOf(wanted.firstBearing).cosine);
                for (std::size_t i = 0; i < wanted.elevations.size(); ++i)
                    QCOMPARE(table.layers[i].sine, directionOf(wanted.elevations[i]).sine);
            }
    }
};

QTEST_APPLESS_MAIN(RayNormalsTest)
#include "ray_normals_test.moc"
