// Casts and light of a device through the SDK, with programs that have the tables and with older ones.
#include <QtTest>

#include <numbers>

#include <trundle/device.h>

using namespace trundle;

class RaysTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// With the table of a program from before 1.6 a fan is a loop over `ray`; with the present one it is one call.
    void fansAndRaysWithOldAndNewPrograms() {
        TrundleServices services{};
        services.ray = [](void*, const double from[3], const double along[3], double range, std::int32_t own,
                          TrundleHit* hit) -> std::int32_t { // a wall at x = 3, for those that see their robot at x = 1
            const double distance = ((own ? 1 : 3) - from[0]) / along[0];
            if (!(along[0] > 0.1) || distance > range) return 0;
            *hit = {distance, {-1, 0, 0}, 7, 0};
            return 1;
        };
        static const TrundleServicesRays rays{
            sizeof(TrundleServicesRays), 0,
            [](void*, const TrundleFan* f, double* distances, std::uint32_t* geoms, double* normals) -> std::int32_t {
                if (f->own) return -1;
                for (std::uint32_t i = 0; i < f->count * f->layers; ++i) {
                    distances[i] = f->elevations[i / f->count] + i + f->quaternion[3] + f->position[1];
                    if (geoms) geoms[i] = i;
                    if (normals) normals[3 * i + 2] = f->range;
                }
                return 0;
            },
            [](void*, const TrundleRay* r, std::uint32_t count, std::int32_t, double* distances, std::uint32_t*,
               double*) -> std::int32_t {
                for (std::uint32_t i = 0; i < count; ++i) distances[i] = r[i].range + r[i].direction[1];
                return 0;
            },
            [](void*, std::uint32_t geom, TrundleGeomInfo* info) -> std::int32_t {
                info->path = "box/block";
                info->reflectance = 0.5;
                return geom == 4 ? 0 : -1;
            }};
        services.size = offsetof(TrundleServices, rays); // as if the table ended there
        services.rays = &rays;
        Sensing world(services);
        Fan fan;
        fan.firstBearing = -std::numbers::pi / 3;
        fan.bearingStep = std::numbers::pi / 3;
        fan.count = 4;
        fan.elevations = {0, std::numbers::pi / 3};
        fan.range = 5;
        std::vector<double> distances(8);
        std::vector<GeomId> geoms(8);
        std::vector<Vec3> normals(8, Vec3::Ones());
        const Pose pose{{1, 2, 3}, {0, 0, 0, 1}}; // half a turn about z
        TrundleGeomInfo info{};
        QVERIFY(world.castFan(fan, Pose{{1, 2, 3}, Quat::Identity()}, {distances, geoms, normals}));
        const double expected[8] = {4, 2, 4, 5, 5, 4, 5, 5};
        for (std::size_t i = 0; i < 8; ++i) {
            QVERIFY(std::abs(distances[i] - expected[i]) < 1e-12);
            QVERIFY(geoms[i] == (expected[i] < 5 ? GeomId{7} : GeomId{}));
            QCOMPARE(normals[i], expected[i] < 5 ? Vec3(-1, 0, 0) : Vec3(0, 0, 0));
        }
        QVERIFY(world.castFan(fan, pose, {distances}));
        QVERIFY(std::abs(distances[3] - 4) < 1e-12 && std::abs(distances[0] - 5) < 1e-12);
        const Ray list[2] = {{{0, 0, 0}, {1, 0, 0}, 10}, {{0, 0, 0}, {0, 1, 0}, 2}};
        QVERIFY(world.castRays(list, {distances}, true));
        QCOMPARE(distances[0], 1.);
        QCOMPARE(distances[1], 2.);
        QVERIFY(!world.geomInfo(GeomId{4}, info) && std::string(info.path).empty());

        services.size = sizeof services;
        QVERIFY(world.castFan(fan, pose, {distances, geoms, normals}));
        QCOMPARE(distances[6], std::numbers::pi / 3 + 6 + 1 + 2);
        QVERIFY(geoms[6] == GeomId{6} && normals[6].z() == 5);
        QVERIFY(world.castRays(list, {distances}));
        QCOMPARE(distances[1], 3.);
        QVERIFY(world.geomInfo(GeomId{4}, info) && std::string(info.path) == "box/block" && info.reflectance == 0.5);
        QVERIFY(!world.geomInfo(GeomId{5}, info));
        fan.own = true;
        QVERIFY(!world.castFan(fan, pose, {distances}));
        fan.own = false;
        QVERIFY(!world.castFan(fan, pose, {std::span(distances).first(7)}) &&
                !world.castFan(fan, pose, {distances, std::span(geoms).first(7)}));
        fan.count = 0;
        QVERIFY(!world.castFan(fan, pose, {distances}));
    }

    /// A program from before 1.7 has no lights, and nothing returns any.
    void lightWithOldAndNewPrograms() {
        static const TrundleServicesLight light{
            sizeof(TrundleServicesLight), 0,
            [](void*, std::uint32_t geom, const double point[3], const double normal[3], double* share) -> std::int32_t {
                *share = point[0] + normal[2];
                return geom == 4 ? 0 : -1;
            },
            [](void*, TrundleLight* out, std::uint32_t capacity) -> std::uint32_t {
                for (std::uint32_t i = 0; out && i < capacity; ++i) out[i] = {{0, 0, 1. * i}, 0.5, TRUNDLE_LAMP, 1};
                return 3;
            }};
        TrundleServices services{};
        services.size = offsetof(TrundleServices, light);
        services.light = &light;
        Sensing world(services);
        std::vector<TrundleLight> lights(7);
        world.lights(lights);
        QVERIFY(lights.empty());
        QCOMPARE(world.reflectance(GeomId{4}, {0.25, 0, 0}, {0, 0, 0.5}), 0.);
        services.size = sizeof services;
        world.lights(lights);
        QVERIFY(lights.size() == 3 && lights[2].way[2] == 2 && lights[2].light == 0.5);
        QCOMPARE(world.reflectance(GeomId{4}, {0.25, 0, 0}, {0, 0, 0.5}), 0.75);
        QCOMPARE(world.reflectance(GeomId{5}, {0.25, 0, 0}, {0, 0, 0.5}), 0.);
    }

    /// In a program from before 1.8 devices have all the power that they need, and no device can be the supply.
    void powerWithOldAndNewPrograms() {
        static double drawn = 0, set = 0;
        static const TrundleServicesSupply supply{
            sizeof(TrundleServicesSupply),
            0,
            [](void*, double* now, double* nominal) -> std::int32_t {
                *now = 9;
                *nominal = 12;
                return 0;
            },
            [](void*, double watts, double conductance) { drawn += watts * (1 + conductance); },
            [](void*, TrundleLoad* load) {
                *load = {1, 2, 3};
            },
            [](void*, double volts) { set = volts; }};
        TrundleServices services{};
        services.size = offsetof(TrundleServices, supply);
        services.supply = &supply;
        Sensing world(services);
        world.draw(5);
        world.setSupplyVoltage(3);
        QVERIFY(!world.supply().present && world.supply().powered() && world.load().resistive == 0 && drawn == 0 && set == 0);
        QCOMPARE(world.supply().driven(7, 6), 7.);
        QCOMPARE(world.supply().highest(6), 6.);
        services.size = sizeof services;
        world.draw(5);
        world.draw(5, 1);
        world.setSupplyVoltage(3);
        QCOMPARE(drawn, 15.);
        QCOMPARE(set, 3.);
        QCOMPARE(world.load().conductance, 3.);
        const Supply now = world.supply();
        QCOMPARE(now.driven(6, 6), 4.5);
        QCOMPARE(now.driven(-20, 8), -8.);
        QCOMPARE(now.highest(12), 9.);

        TrundleMount table{};
        table.size = offsetof(TrundleMount, provideSupply);
        std::string reported;
        table.context = &reported;
        table.fail = [](void* context, const char* text) { *static_cast<std::string*>(context) = text; };
        Mount mount(table);
        mount.provideSupply(12, 12);
        QVERIFY(reported.find("no batteries") != std::string::npos && mount.failure() == reported);
    }
};

QTEST_APPLESS_MAIN(RaysTest)
#include "rays_test.moc"
