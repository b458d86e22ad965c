// The scene for rays by itself: the same bits from every instruction set and grid, fans of any bearings, cosines and sines.
#include <QtTest>

#include <cstring>
#include <set>

#include "world/ray_reference.h"
#include "world/rays/fan_view.h"
#include "world/rays/ray_scene.h"

using namespace fixture;

namespace {

/// All kinds of geoms at random poses; actors with three geoms each.
void fill(RayScene& scene, std::uint64_t seed) {
    RayRandom random(seed);
    static const double planes[] = {1, 0,   0, 0.2, -1, 0,   0, 0.2, 0,  1,   0,  0.1, 0,  -1,
                                    0, 0.3, 0, 0,   1,  0.2, 0, 0,   -1, 0.2, .6, 0,   .8, 0.2}; // a box with a cut edge
    std::vector<std::array<Vec3, 3>> triangles;
    for (int i = 0; i < 400; ++i) {
        const Vec3 a = random.vector(3);
        triangles.push_back({a, a + random.vector(0.5), a + random.vector(0.5)});
    }
    auto map = std::make_shared<HeightMap>();
    map->columns = 30, map->rows = 23;
    for (int i = 0; i < 30 * 23; ++i) map->heights.push_back(static_cast<float>(random(0, 1)));
    for (std::uint32_t i = 0; i < 300; ++i) {
        RayGeom g;
        const double r = random(0.02, 0.3), size = i % 50 == 0 ? 8 : 1; // some are large
        g.shape.kind = static_cast<RayShape::Kind>(1 + i % 5);
        g.shape.radius = r;
        const Vec3 half(random(0.02, 0.4) * size, random(0.02, 0.4) * size, random(0.02, 0.4));
        for (int k = 0; k < 3; ++k) g.shape.half[k] = half[k];
        g.half = half;
        if (g.shape.kind == RayShape::Sphere) g.half.setConstant(r);
        if (g.shape.kind == RayShape::Cylinder) g.half = {r, r, half.z()};
        if (g.shape.kind == RayShape::Capsule) g.half = {r, r, half.z() + r};
        if (g.shape.kind == RayShape::Hull) {
            g.shape.planes = planes;
            g.shape.planeCount = 7;
            g.half = {0.2, 0.3, 0.2};
        }
        if (i == 10) g.shape.kind = RayShape::Plane;
        if (i == 20 || i == 21) {
            g.shape.kind = RayShape::Mesh;
            g.tree = std::make_shared<TriangleTree>(triangles);
            g.half.setConstant(4);
        }
        if (i == 30) {
            g.shape.kind = RayShape::Heights;
            g.heights = std::make_shared<HeightBlocks>(map, 5, 4, 0.4);
            g.half = {2.5, 0.4, 2};
        }
        g.bound = g.half.norm();
        g.centre = random.vector(5);
        g.axes = random.rotation().toRotationMatrix();
        if (i > 100) g.actor = i / 3;
        scene.add(std::move(g));
    }
    scene.update();
}

const std::vector<double> kElevations{-1.2, -0.3, 0, 0.2, 1.5};

std::vector<RayFan> someFans() {
    RayRandom random(77);
    std::vector<RayFan> fans;
    for (int i = 0; i < 60; ++i) {
        RayFan fan{random.vector(4), random.rotation().toRotationMatrix(), random(0.3, 12), random(-3, 3), 0.1, 60, kElevations};
        if (i % 6 == 1) fan.elevations = fan.elevations.subspan(2, 1), fan.axes = Mat3::Identity(); // flat
        if (i % 6 == 2) fan.bearingStep = -0.25;                                                    // clockwise, more than a turn
        if (i % 6 == 3) fan.count = 1, fan.elevations = fan.elevations.first(1);
        if (i % 6 == 4) fan.bearingStep = 0.007, fan.firstBearing = 700; // narrow, after many turns
        if (i % 6 == 5) fan.bearingStep = 0, fan.count = 7;
        fans.push_back(fan);
    }
    return fans;
}

} // namespace

class RaySceneTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Also for rays that meet an edge between triangles or faces of two geoms at once: the tie goes by the numbers.
    void sameBitsOnEveryInstructionSetAndGrid() {
        QCOMPARE(baselineRayKernel().lanes, 2);
        std::vector<const RayKernel*> kernels{&baselineRayKernel()};
        if (avx2RayKernel()) kernels.push_back(avx2RayKernel());
        else qInfo("this processor has no AVX2: one instruction set is compared");
        std::vector<RayBuffers> first;
        for (const RayKernel* kernel : kernels)
            for (const double cell : {1., 0.2, 30.}) {
                RayScene scene(*kernel, cell);
                fill(scene, 5);
                std::size_t at = 0;
                for (const RayFan& fan : someFans()) {
                    RayBuffers found(fan.size()), single(fan.size());
                    scene.castFan(fan, 60, found.hits());
                    for (std::size_t i = 0; i < fan.size(); ++i)
                        scene.castRay(beamOf(fan, i), 60, {&single.distances[i], &single.geoms[i], &single.normals[3 * i]});
                    for (const RayBuffers& result : {found, single}) {
                        if (first.size() == at) first.push_back(result);
                        QVERIFY2(result == first[at], kernel->name);
                        ++at;
                    }
                }
            }
        std::size_t hits = 0, all = 0;
        std::set<std::uint32_t> geoms;
        for (const RayBuffers& result : first)
            for (const std::uint32_t geom : result.geoms) {
                ++all;
                hits += geom != kNoGeom;
                geoms.insert(geom);
                QVERIFY(geom == kNoGeom || geom < 101 || geom / 3 != 60);
            }
        qInfo("%zu of %zu beams hit one of %zu geoms", hits, all, geoms.size());
        QVERIFY(hits > all / 4 && geoms.size() > 100 && geoms.contains(20) && geoms.contains(30));
    }

    /// Every beam of a fan is the single ray of its bearing and elevation.
    void fansAreTheirRays() {
        RayScene scene;
        fill(scene, 6);
        double most = 0;
        for (const RayFan& fan : someFans()) {
            RayBuffers found(fan.size());
            scene.castFan(fan, kNoGeom, found.hits());
            for (std::size_t i = 0; i < fan.size(); ++i) {
                double distance = 0, normal[3];
                std::uint32_t geom = 0;
                scene.castRay(beamOf(fan, i), kNoGeom, {&distance, &geom, normal});
                most = std::max(most, std::abs(distance - found.distances[i]));
                QCOMPARE(found.geoms[i], geom);
                QVERIFY((Vec3(normal) - Vec3(&found.normals[3 * i])).norm() < 1e-6);
            }
        }
        qInfo("most %.1e m", most);
        QVERIFY(most < 1e-9);
    }

    /// Of two geoms at the same place the lower is hit, whichever is found first.
    void tiesGoToTheLowerNumber() {
        for (const bool swapped : {false, true}) {
            RayScene scene;
            for (int i = 0; i < 2; ++i) {
                RayGeom g;
                g.half.setConstant(0.1);
                for (double& h : g.shape.half) h = 0.1;
                g.bound = g.half.norm();
                g.actor = (i == 0) == swapped ? 4 : kNoGeom; // the moving ones are searched later
                g.centre = {1, 0, 0};
                scene.add(std::move(g));
            }
            scene.update();
            const double flat[1] = {0};
            RayBuffers found(5);
            scene.castFan({Vec3::Zero(), Mat3::Identity(), 3, -0.02, 0.01, 5, flat}, kNoGeom, found.hits());
            QCOMPARE(found.geoms, std::vector<std::uint32_t>(5, 0));
            scene.castFan({Vec3::Zero(), Mat3::Identity(), 3, -0.02, 0.01, 5, flat}, 4, found.hits());
            QCOMPARE(found.geoms, std::vector<std::uint32_t>(5, swapped ? 1 : 0));
        }
    }

    /// Whatever its shape: a fan that leaves a robot out goes through that robot's geoms alone, to what is behind them.
    void whatIsLeftOutIsNotHit_data() {
        QTest::addColumn<int>("kind");
        for (const auto& [name, kind] : {std::pair{"box", RayShape::Box},
                                         {"sphere", RayShape::Sphere},
                                         {"cylinder", RayShape::Cylinder},
                                         {"capsule", RayShape::Capsule},
                                         {"mesh", RayShape::Mesh},
                                         {"height map", RayShape::Heights}})
            QTest::newRow(name) << static_cast<int>(kind);
    }
    void whatIsLeftOutIsNotHit() {
        QFETCH(const int, kind);
        const std::vector<std::array<Vec3, 3>> wall{{Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(0, 0, 2)}};
        auto map = std::make_shared<HeightMap>();
        map->columns = map->rows = 3;
        map->heights.assign(9, 0.5f);
        RayScene scene;
        for (std::uint32_t i = 0; i < 3; ++i) { // one behind the other, of robots 4, 9 and of none
            RayGeom g;
            g.shape.kind = static_cast<RayShape::Kind>(kind);
            g.shape.radius = 0.2;
            for (double& h : g.shape.half) h = 0.2;
            g.half.setConstant(0.4);
            if (kind == RayShape::Mesh) g.tree = std::make_shared<TriangleTree>(wall), g.half.setConstant(2);
            if (kind == RayShape::Heights) {
                g.heights = std::make_shared<HeightBlocks>(map, 2, 2, 0.4);
                g.half.setConstant(1);
                g.axes = rotationFromHpr(degrees(90, 0, 0)).toRotationMatrix(); // its up, y, is towards the fan
            }
            g.bound = g.half.norm();
            g.actor = i == 0 ? 4 : i == 1 ? 9 : kNoGeom;
            g.centre = {3. + 3 * i, 0, 0};
            scene.add(std::move(g));
        }
        scene.update();
        const double flat[1] = {0};
        const auto hit = [&](double x, std::uint32_t without) {
            RayBuffers found(3);
            scene.castFan({{x, 0, 0}, Mat3::Identity(), 20, -0.01, 0.01, 3, flat}, without, found.hits());
            double distance = 0;
            std::uint32_t geom = 0;
            scene.castRay({{x, 0, 0}, {1, 0, 0}, 20}, without, {&distance, &geom});
            return found.geoms == std::vector<std::uint32_t>(3, geom) && std::abs(found.distances[1] - distance) < 1e-9 ? geom
                                                                                                                        : 99u;
        };
        QCOMPARE(hit(0, kNoGeom), 0u);
        QCOMPARE(hit(0, 9), 0u);
        QCOMPARE(hit(0, 4), 1u);
        QCOMPARE(hit(4.5, 9), 2u);
        QCOMPARE(hit(4.5, 4), 1u);
        QCOMPARE(hit(7.5, 4), 2u);
    }

    /// A geom far away, or with a pose that is no number, takes nothing from the others.
    void farAndInvalidPoses() {
        for (const double far : {1e3, 1e12, 1e300, std::nan(""), HUGE_VAL}) {
            RayScene scene;
            for (int i = 0; i < 40; ++i) {
                RayGeom g;
                g.shape.kind = RayShape::Sphere;
                g.shape.radius = g.bound = 0.1;
                g.half.setConstant(0.1);
                g.actor = static_cast<std::uint32_t>(i);
                g.centre = i == 7 ? Vec3(far, -far, 0) : Vec3(i, 0, 0);
                scene.add(std::move(g));
            }
            scene.update();
            double distance = 0;
            std::uint32_t geom = 0;
            scene.castRay({{8.5, 0, 0}, {-1, 0, 0}, 5}, kNoGeom, {&distance, &geom});
            QVERIFY(geom == 8 && std::abs(distance - 0.4) < 1e-12);
            scene.castRay({{7.5, 0, 0}, {-1, 0, 0}, 5}, kNoGeom, {&distance, &geom});
            QVERIFY(geom == 6 && std::abs(distance - 1.4) < 1e-12);
        }
    }

    /// Small and large ones alike, and no longer where they were.
    void whatMovesIsHitWhereItIs() {
        const double halves[] = {0.1, 0.9, 4};
        const double flat[1] = {0};
        RayScene scene;
        for (std::uint32_t i = 0; i < 3; ++i) {
            RayGeom g;
            g.half.setConstant(halves[i]);
            for (double& h : g.shape.half) h = halves[i];
            g.bound = g.half.norm();
            g.actor = i;
            scene.add(std::move(g));
        }
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0, 30, 0), Vec3(-7, -40, 25)}) {
            const Vec3 before = scene.geom(0).centre - Vec3(20, 0, 0);
            for (std::uint32_t i = 0; i < 3; ++i) scene.geom(i).centre = place + Vec3(20. * (i + 1), 0, 0);
            scene.update();
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Vec3 centre = scene.geom(i).centre, over = centre + Vec3(0, 0, 10), left = centre - Vec3(10, 0, 0);
                double distance = 0;
                std::uint32_t geom = 0;
                scene.castRay({over, {0, 0, -1}, 12}, kNoGeom, {&distance, &geom});
                QCOMPARE(geom, i);
                QVERIFY(std::abs(distance - (10 - halves[i])) < 1e-9);
                RayBuffers found(1);
                scene.castFan({left, Mat3::Identity(), 12, 0, 0.1, 1, flat}, kNoGeom, found.hits());
                QCOMPARE(found.geoms[0], i);
                QVERIFY(std::abs(found.distances[0] - (10 - halves[i])) < 1e-9);
                if (place == Vec3::Zero()) continue;
                const Vec3 overThePlaceBefore = before + Vec3(20. * (i + 1), 0, 10);
                scene.castRay({overThePlaceBefore, {0, 0, -1}, 12}, kNoGeom, {&distance, &geom});
                QCOMPARE(geom, kNoGeom);
            }
        }
    }

    void cosinesAndSines() {
        long double most = 0;
        std::uint64_t hash = 0;
        RayRandom random(1);
        for (int i = 0; i < 200000; ++i) {
            const double angle = i % 2 ? random(-7, 7) : random(-1e4, 1e4);
            const Direction d = directionOf(angle);
            most = std::max({most, std::abs(d.cosine - std::cos(static_cast<long double>(angle))),
                             std::abs(d.sine - std::sin(static_cast<long double>(angle)))});
            for (const double v : {d.cosine, d.sine}) {
                std::uint64_t bits;
                std::memcpy(&bits, &v, sizeof bits);
                hash = (hash ^ bits) * 1099511628211u;
            }
        }
        qInfo("most %.2Le, hash %016llx", most, static_cast<unsigned long long>(hash));
        QVERIFY(most < 1.5e-16L);
        QVERIFY(directionOf(0).cosine == 1 && directionOf(0).sine == 0 && directionOf(-kPi / 2).sine == -1);
        QCOMPARE(hash, 0x4b197edf4461e3f6ull); // the same on every machine
    }

    /// A beam of the sector is never left out, whatever the first bearing and the step.
    void sectorsHaveAllTheirBeams() {
        RayRandom random(4);
        const double flat[1] = {0};
        for (int i = 0; i < 3000; ++i) {
            const RayFan fan{
                Vec3::Zero(), Mat3::Identity(), 10, random(-20, 20), random(-0.3, 0.3), static_cast<std::uint32_t>(random(1, 90)),
                flat};
            const BeamTable table(fan);
            const FanView view(fan, table);
            const double middle = random(-kPi, kPi), half = random(0, 1.5);
            std::set<int> found;
            view.beamsIn({middle - half, middle + half}, [&](int first, int last) {
                QVERIFY(first >= 0 && last < static_cast<int>(fan.count));
                for (int k = first; k <= last; ++k) found.insert(k);
            });
            std::size_t wanted = 0;
            for (int k = 0; k < static_cast<int>(fan.count); ++k)
                if (std::abs(std::remainder(fan.firstBearing + k * fan.bearingStep - middle, 2 * kPi)) < half - 1e-9) {
                    QVERIFY(found.contains(k));
                    ++wanted;
                }
            QVERIFY(found.size() <= wanted + 8 || fan.count == 1);
        }
    }
};

QTEST_APPLESS_MAIN(RaySceneTest)
#include "ray_scene_test.moc"
