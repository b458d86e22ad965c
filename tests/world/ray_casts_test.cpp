// Rays and fans of the engine against closed forms of its geoms, brute force over triangles, and ODE's own rays.
#include <QtTest>

#include <map>
#include <ode/ode.h>

#include "world/engine.h"
#include "world/ray_reference.h"
#include "world/rays/ray_targets.h"

using namespace fixture;

namespace {

struct Shape {
    GeomSpec spec;
    BodyHandle body; ///< invalid: fixed at `fixed`
    Pose fixed;
    std::uint32_t actor = kNoGeom;
};

GeomSpec capsule(double radius, double length) {
    GeomSpec geom = cylinder("capsule", radius, length);
    geom.shape = GeomShape::Capsule;
    return geom;
}

/// An octahedron.
GeomSpec polyhedron(RayRandom& random) {
    GeomSpec geom;
    geom.name = "hull";
    geom.shape = GeomShape::Convex;
    auto mesh = std::make_shared<TriangleMesh>();
    const Vec3 half(random(0.05, 0.3), random(0.05, 0.3), random(0.05, 0.3));
    for (const int x : {-1, 1})
        for (int k = 0; k < 3; ++k) {
            std::array<double, 3> p{0, 0, 0};
            p[static_cast<std::size_t>(k)] = x * half[k];
            mesh->points.push_back(p);
        }
    for (std::uint32_t n = 0; n < 8; ++n) {
        std::array<std::uint32_t, 3> t{n & 1 ? 0u : 3u, n & 2 ? 1u : 4u, n & 4 ? 2u : 5u};
        if (((n & 1) != 0) ^ ((n & 2) != 0) ^ ((n & 4) != 0)) std::swap(t[1], t[2]);
        mesh->triangles.push_back(t);
    }
    geom.mesh = geom.hull = mesh;
    geom.collideAsHull = true;
    return geom;
}

GeomSpec randomShape(RayRandom& random) {
    const double r = random(0.02, 0.3);
    switch (static_cast<int>(random(0, 5))) {
    case 0: return box("box", {random(0.02, 1.5), random(0.02, 0.6), random(0.02, 0.6)});
    case 1: return sphere("sphere", r);
    case 2: return cylinder("cylinder", r, random(0.01, 1.5));
    case 3: return capsule(r, random(0.01, 1.5));
    default: return polyhedron(random);
    }
}

/// An engine with scenery and free bodies at random poses, all numbered as the engine does.
struct RandomWorld {
    std::unique_ptr<Engine> engine;
    std::vector<Shape> shapes; ///< by geom
    std::vector<ActorHandles> actors;

    explicit RandomWorld() {
        EngineSettings settings;
        settings.surfaces.push_back({"default", 0.5, 0, 0, 0, {}});
        settings.gravity = Vec3::Zero();
        engine = std::move(makeOdeEngine(settings)).value();
    }
    void addStatic(const GeomSpec& spec, const Pose& pose) {
        const auto made = engine->addStatic(spec, pose);
        QVERIFY(made.ok());
        QCOMPARE(std::size_t(made.value().index), shapes.size());
        shapes.push_back({spec, {}, pose});
    }
    void addRobot(const Pose& pose, std::vector<GeomSpec> geoms, const Vec3& push = Vec3::Zero()) {
        const BodySpec spec = body("body", {}, massOfBox(2, {0.3, 0.3, 0.3}), std::move(geoms));
        ActorDef def;
        def.frame = pose;
        def.bodies.push_back({pose, &spec});
        const std::vector<JointSpec> none;
        def.joints = &none;
        auto made = engine->addActor(def);
        QVERIFY(made.ok());
        for (std::size_t k = 0; k < spec.geoms.size(); ++k)
            shapes.push_back({spec.geoms[k], made.value().bodies[0], spec.geoms[k].pose, made.value().actor.index});
        engine->addForce(made.value().bodies[0], push, pose * Vec3(0.1, 0, 0));
        actors.push_back(std::move(made).value());
    }
    [[nodiscard]] Pose poseOf(const Shape& shape) const {
        if (!shape.body.valid()) return shape.fixed;
        const BodyState& s = engine->state(shape.body);
        return Pose{s.position, s.rotation} * shape.fixed;
    }
    [[nodiscard]] std::pair<double, std::uint32_t> nearest(const SingleRay& ray, std::uint32_t without) const {
        std::pair<double, std::uint32_t> best{kMiss, kNoGeom};
        for (std::uint32_t i = 0; i < shapes.size(); ++i)
            if (shapes[i].actor != without || without == kNoGeom)
                best = std::min(best, {referenceHit(shapes[i].spec, poseOf(shapes[i]), ray), i});
        return best.first == kMiss ? std::pair(ray.range, kNoGeom) : best;
    }
};

struct Differences {
    double most = 0;
    int count = 0, hits = 0, otherGeoms = 0;
    void add(const std::pair<double, std::uint32_t>& expected, double distance, std::uint32_t geom) {
        most = std::max(most, std::abs(expected.first - distance));
        count += 1;
        hits += geom != kNoGeom;
        otherGeoms += geom != expected.second;
    }
};

} // namespace

class RayCastsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// 40 scenes with 250 geoms at random poses each, after they have moved; fans and single rays from random poses.
    void closedForms() {
        Differences fans, rays;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            RayRandom random(seed);
            RandomWorld world;
            world.addStatic(plane("floor"), {{0, 0, -3}, Quat::Identity()});
            world.addStatic(plane("slope"), {{0, 0, -4}, rotationFromHpr(degrees(random(0, 360), random(5, 60), 0))});
            for (int i = 0; i < 148; ++i) world.addStatic(randomShape(random), {random.vector(4), random.rotation()});
            for (int i = 0; i < 50; ++i) {
                const GeomSpec first = randomShape(random);
                GeomSpec second = sphere("second", 0.05, at(0.2, 0.1, 0.3, degrees(20, 30, 40)));
                world.addRobot({random.vector(4), random.rotation()}, {first, second}, random.vector(300));
            }
            for (int tick = 0; tick < 3; ++tick) QVERIFY(!world.engine->step(0.01));
            for (int sensor = 0; sensor < 6; ++sensor) {
                const std::vector<double> elevations{random(-1, -0.2), 0, random(0.1, 1.2)};
                const RayFan fan{
                    random.vector(3), random.rotation().toRotationMatrix(), random(0.5, 6), random(-4, 4), random(-0.4, 0.4), 60,
                    elevations};
                const std::uint32_t without = sensor % 2 ? world.actors[static_cast<std::size_t>(sensor)].actor.index : kNoGeom;
                RayBuffers found(fan.size()), single(fan.size());
                std::vector<SingleRay> list;
                for (std::size_t i = 0; i < fan.size(); ++i) list.push_back(beamOf(fan, i));
                world.engine->rays().castFan(fan, without, found.hits());
                world.engine->rays().castRays(list, without, single.hits());
                for (std::size_t i = 0; i < fan.size(); ++i) {
                    const auto expected = world.nearest(list[i], without);
                    fans.add(expected, found.distances[i], found.geoms[i]);
                    rays.add(expected, single.distances[i], single.geoms[i]);
                }
            }
        }
        qInfo("fans: most %.1e m of %d beams, %d hits; rays: most %.1e", fans.most, fans.count, fans.hits, rays.most);
        QVERIFY(fans.most < 1e-9 && rays.most < 1e-9);
        QVERIFY(fans.hits > 12000 && fans.hits < fans.count - 1000);
        QCOMPARE(fans.otherGeoms, 0);
        QCOMPARE(rays.otherGeoms, 0);
    }

    /// From inside a solid a ray ends where it leaves it; normals are of the surface, against the ray.
    void insideSolidsAndNormals() {
        const double c = std::cos(0.5), s = std::sin(0.5);
        struct Case {
            GeomSpec geom;
            double inside, outside; ///< along (c, s, 0), from the centre and from 3 m before it
            Vec3 normal;            ///< as met from outside
        };
        RayRandom random(1);
        const Case cases[] = {{box("box", {1, 2, 1}), 0.5 / c, 3 - 0.5 / c, {-1, 0, 0}},
                              {sphere("sphere", 0.7), 0.7, 2.3, {-c, -s, 0}},
                              {cylinder("cylinder", 0.4, 1), 0.4, 2.6, {-c, -s, 0}},
                              {capsule(0.3, 1), 0.3, 2.7, {-c, -s, 0}}};
        for (const Case& k : cases)
            for (const bool moves : {false, true}) {
                RandomWorld world;
                const Pose pose{random.vector(2), random.rotation()};
                if (moves) world.addRobot(pose, {k.geom});
                else world.addStatic(k.geom, pose);
                const Vec3 along = pose.rotation * Vec3(c, s, 0);
                for (const auto& [origin, expected, normal] :
                     {std::tuple{pose.position, k.inside, k.normal}, {Vec3(pose.position - 3 * along), k.outside, k.normal}}) {
                    const auto hit = world.engine->rays().ray({origin, along, 10}, kNoGeom);
                    QVERIFY(hit);
                    QVERIFY(std::abs(hit->distance - expected) < 1e-12);
                    QVERIFY((hit->normal - pose.rotation * normal).norm() < 1e-9);
                }
                QVERIFY(!world.engine->rays().ray({pose.position - 3 * along, along, k.outside - 1e-9}, kNoGeom));
                QVERIFY(!world.engine->rays().ray({pose.position - 3 * along, -along, 10}, kNoGeom));
                QCOMPARE(bool(world.engine->rays().ray({pose.position, along, 10}, 0)), !moves); // actor 0 is the robot
            }
    }

    void meshesAgainstAllTriangles() {
        RayRandom random(3);
        RandomWorld world;
        GeomSpec terrain;
        terrain.name = "terrain";
        terrain.shape = GeomShape::Mesh;
        auto mesh = std::make_shared<TriangleMesh>();
        constexpr std::uint32_t n = 40;
        for (std::uint32_t k = 0; k <= n; ++k)
            for (std::uint32_t i = 0; i <= n; ++i) mesh->points.push_back({0.2 * i - 4, 0.2 * k - 4, random(-0.15, 0.15)});
        for (std::uint32_t k = 0; k < n; ++k)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = k * (n + 1) + i;
                mesh->triangles.push_back({a, a + 1, a + n + 1});
                mesh->triangles.push_back({a + n + 2, a + n + 1, a + 1});
            }
        terrain.mesh = mesh;
        world.addStatic(terrain, at(0.3, 0.1, 0, degrees(30, 10, -5)));
        for (int i = 0; i < 30; ++i) world.addRobot({random.vector(3), random.rotation()}, {randomShape(random)});
        compareWithReference(world, random, 1e-9);
    }

    void heightMapsAgainstTheirTriangles_data() {
        QTest::addColumn<uint>("columns");
        QTest::addColumn<uint>("rows");
        QTest::newRow("wide") << 33u << 21u;
        QTest::newRow("power of two") << 17u << 17u;
        QTest::newRow("long") << 3u << 40u;
        QTest::newRow("one cell") << 2u << 2u;
    }
    void heightMapsAgainstTheirTriangles() {
        QFETCH(const uint, columns);
        QFETCH(const uint, rows);
        RayRandom random(5);
        RandomWorld world;
        GeomSpec field;
        field.name = "field";
        field.shape = GeomShape::Heightfield;
        field.size = {8, 6, 0.5};
        auto map = std::make_shared<HeightMap>();
        map->columns = columns;
        map->rows = rows;
        for (uint i = 0; i < columns * rows; ++i) map->heights.push_back(static_cast<float>(random(0, 1)));
        field.heightMap = map;
        world.addStatic(field, at(0.2, -0.3, -0.2, degrees(70, -8, 4)));
        world.addRobot({{1, 1, 1}, random.rotation()}, {randomShape(random)});
        compareWithReference(world, random, 1e-9);
    }

    /// The engine's rays were ODE's before: the same numbers to within rounding.
    void odesOwnRays() {
        RayRandom random(9);
        RandomWorld world;
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        const dGeomID ray = dCreateRay(nullptr, 1);
        Differences found;
        for (int round = 0; round < 4000; ++round) {
            RandomWorld one;
            GeomSpec spec = randomShape(random);
            while (spec.shape == GeomShape::Convex) spec = randomShape(random);
            const Pose pose{random.vector(1), random.rotation()};
            one.addStatic(spec, pose);
            const dGeomID geom = spec.shape == GeomShape::Box ? dCreateBox(nullptr, spec.size.x(), spec.size.y(), spec.size.z())
                                 : spec.shape == GeomShape::Sphere  ? dCreateSphere(nullptr, spec.radius)
                                 : spec.shape == GeomShape::Capsule ? dCreateCapsule(nullptr, spec.radius, spec.length)
                                                                    : dCreateCylinder(nullptr, spec.radius, spec.length);
            const Quat& q = pose.rotation;
            const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
            dGeomSetQuaternion(geom, turn);
            dGeomSetPosition(geom, pose.position.x(), pose.position.y(), pose.position.z());
            for (int k = 0; k < 10; ++k) {
                const Vec3 from = random.vector(2), to = pose.position + random.vector(0.3), along = (to - from).normalized();
                dGeomRaySetLength(ray, 5);
                dGeomRaySet(ray, from.x(), from.y(), from.z(), along.x(), along.y(), along.z());
                dContactGeom contact;
                const bool meets = dCollide(ray, geom, 1, &contact, sizeof contact) != 0;
                const auto hit = one.engine->rays().ray({from, along, 5}, kNoGeom);
                QCOMPARE(bool(hit), meets);
                if (hit) found.add({contact.depth, 0}, hit->distance, hit->geom);
            }
            dGeomDestroy(geom);
        }
        dGeomDestroy(ray);
        qInfo("most %.1e m of %d hits", found.most, found.count);
        QVERIFY(found.count > 10000 && found.most < 1e-12);
    }

    /// Beams exactly in the plane of a face, along an edge, into a corner, on boxes that stand in line.
    void grazingBeams() {
        RandomWorld world;
        for (int i = 0; i < 6; ++i) world.addStatic(box("box", {0.5, 0.5, 0.5}, {}), at(2 + i, 0, 0));
        world.addStatic(box("other", {0.5, 0.5, 0.5}), at(2, 0.5, 0)); // shares a face with the first
        const double flat[1] = {0};
        for (const auto& [y, z, expected, geom] : {std::tuple{0., 0., 1.75, 0u},
                                                   {0.25, 0., 1.75, 0u},
                                                   {-0.25, 0., 1.75, 0u},
                                                   {0.25, 0.25, 1.75, 0u},
                                                   {-0.25, -0.25, 1.75, 0u},
                                                   {0.75, 0.1, 1.75, 6u},
                                                   {0.7500001, 0.1, 9., kNoGeom},
                                                   {-0.2500001, 0.1, 9., kNoGeom}}) {
            const RayFan fan{{0, y, z}, Mat3::Identity(), 9, 0, 0, 3, flat};
            RayBuffers found(3);
            world.engine->rays().castFan(fan, kNoGeom, found.hits());
            for (std::size_t i = 0; i < 3; ++i) {
                QCOMPARE(found.distances[i], expected);
                QCOMPARE(found.geoms[i], geom);
            }
            const auto hit = world.engine->rays().ray({{0, y, z}, {1, 0, 0}, 9}, kNoGeom);
            QCOMPARE(hit ? hit->geom : kNoGeom, geom);
        }
    }

    /// The faces of a hull belong to it too: a level beam at the height of its bottom.
    void grazingBeamsOnAHull() {
        auto mesh = std::make_shared<TriangleMesh>();
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25})
                for (const double z : {-0.25, 0.25}) mesh->points.push_back({x, y, z});
        mesh->triangles = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5},
                           {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
        GeomSpec geom;
        geom.name = "hull";
        geom.shape = GeomShape::Convex;
        geom.mesh = geom.hull = mesh;
        geom.collideAsHull = true;
        RandomWorld world;
        world.addRobot(at(2, 0, 0), {geom});
        const double flat[1] = {0};
        for (const auto& [y, z, expected] : {std::tuple{0., 0., 1.75},
                                             {0., -0.25, 1.75},
                                             {0., 0.25, 1.75},
                                             {0.25, 0.1, 1.75},
                                             {-0.25, -0.25, 1.75},
                                             {0., -0.2500001, 9.},
                                             {0.2500001, 0., 9.}}) {
            const RayFan fan{{0, y, z}, Mat3::Identity(), 9, 0, 0, 3, flat};
            RayBuffers found(3);
            world.engine->rays().castFan(fan, kNoGeom, found.hits());
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY2(std::abs(found.distances[i] - expected) < 1e-12,
                         qPrintable(QString("%1,%2: %3").arg(y).arg(z).arg(found.distances[i])));
        }
    }

    /// Poses are taken over once in a tick with casts, and never without casts.
    void updatesOnlyWhenSomebodyCasts() {
        RandomWorld world;
        world.addStatic(plane("floor"), {});
        world.addRobot(at(1, 0, 1), {box("box", {0.2, 0.2, 0.2})}, {200, 0, 0});
        for (int i = 0; i < 5; ++i) QVERIFY(!world.engine->step(0.01));
        const RayTargets& rays = world.engine->rays();
        QCOMPARE(rays.updates(), 0u);
        double before = 0;
        for (std::uint64_t tick = 1; tick <= 5; ++tick) {
            for (int i = 0; i < 10; ++i) {
                const auto hit = rays.ray({{-1, 0, 1}, {1, 0, 0}, 9}, kNoGeom);
                QVERIFY(hit && std::abs(hit->distance - world.nearest({{-1, 0, 1}, {1, 0, 0}, 9}, kNoGeom).first) < 1e-12);
                QVERIFY(i > 0 || hit->distance > before);
                before = hit->distance;
            }
            QCOMPARE(rays.updates(), tick);
            QVERIFY(!world.engine->step(0.01));
        }
        world.addStatic(box("late", {0.1, 1, 1}), at(0, 0, 1)); // is seen without a step
        const auto hit = rays.ray({{-1, 0, 1}, {1, 0, 0}, 9}, kNoGeom);
        QVERIFY(hit && std::abs(hit->distance - 0.95) < 1e-12);
        QCOMPARE(rays.updates(), 6u);
        QVERIFY(!rays.ray({{-1, 0, 1}, {0, 0, 0}, 9}, kNoGeom) && !rays.ray({{-1, 0, 1}, {1, 0, 0}, -1}, kNoGeom));
        QVERIFY(!rays.ray({{std::nan(""), 0, 1}, {1, 0, 0}, 9}, kNoGeom));
    }

private:
    static void compareWithReference(const RandomWorld& world, RayRandom& random, double tolerance) {
        Differences found, single;
        for (int sensor = 0; sensor < 20; ++sensor) {
            const std::vector<double> elevations{random(-0.6, -0.1), 0.05, 0.3};
            const Quat tilt = rotationFromHpr(degrees(random(0, 360), random(-20, 20), random(-20, 20)));
            const RayFan fan{Vec3(random(-3, 3), random(-2, 2), random(0, 0.8)),
                             tilt.toRotationMatrix(),
                             random(1, 9),
                             0,
                             2 * kPi / 36,
                             36,
                             elevations};
            RayBuffers hits(fan.size());
            world.engine->rays().castFan(fan, kNoGeom, hits.hits());
            for (std::size_t i = 0; i < fan.size(); ++i) {
                const SingleRay ray = beamOf(fan, i);
                const auto expected = world.nearest(ray, kNoGeom);
                found.add(expected, hits.distances[i], hits.geoms[i]);
                const auto hit = world.engine->rays().ray(ray, kNoGeom);
                single.add(expected, hit ? hit->distance : ray.range, hit ? hit->geom : kNoGeom);
                if (hits.geoms[i] != kNoGeom) QVERIFY(Vec3(&hits.normals[3 * i]).dot(ray.direction) < 0);
                if (hit) QVERIFY((hit->normal - Vec3(&hits.normals[3 * i])).norm() < 1e-6);
            }
        }
        qInfo("most %.1e m of %d beams, %d hits", found.most, found.count, found.hits);
        QVERIFY(found.most < tolerance && single.most < tolerance);
        QVERIFY(found.hits > 500);
        QCOMPARE(found.otherGeoms, 0);
        QCOMPARE(single.otherGeoms, 0);
    }
};

QTEST_APPLESS_MAIN(RayCastsTest)
#include "ray_casts_test.moc"
