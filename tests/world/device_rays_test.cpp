// Rays, fans and geoms through the services of a device.
#include <QtTest>

#include <numbers>

#include "world/probe_device.h"

using namespace fixture;

class DeviceRaysTest : public QObject {
    Q_OBJECT

    Bench m_bench;

private Q_SLOTS:
    void init() {
        m_bench = {};
        bench = &m_bench;
    }

    /// A fan and a list of rays say what single rays say; invalid ones end the run with a message.
    void fansSeeWhatRaysSee() {
        double distances[8] = {}, normals[24] = {}, single[8] = {}, listed[8] = {};
        std::uint32_t geoms[8] = {};
        TrundleHit hits[8] = {};
        TrundleGeomInfo wall{sizeof wall}, floor{sizeof floor}, own{sizeof own}, nothing{sizeof nothing};
        std::int32_t unknown = 0, ownDistance = 0;
        const double up[2] = {-0.3, 0.1}, half = std::sqrt(0.5);
        TrundleFan fan{{0, 0, 0.09}, {half, 0, 0, half}, 10, -2.2, 0.5, up, 4, 2, 0, 0}; // x forwards is the world's y
        m_bench.probes["p"].sense = [&](const TrundleServices& s) {
            TrundleRay rays[8];
            for (std::uint32_t i = 0; i < 8; ++i) {
                const double bearing = fan.firstBearing + i % 4 * fan.bearingStep + std::numbers::pi / 2, e = up[i / 4];
                rays[i] = {{0, 0, 0.09}, {std::cos(e) * std::cos(bearing), std::cos(e) * std::sin(bearing), std::sin(e)}, 10};
                single[i] = s.ray(s.context, rays[i].origin, rays[i].direction, 10, 0, &hits[i]) ? hits[i].distance : 10;
            }
            if (s.rays->castRays(s.context, rays, 8, 0, listed, nullptr, nullptr) != 0) return 1;
            if (s.rays->castFan(s.context, &fan, distances, geoms, normals) != 0) return 2;
            unknown = s.rays->geomInfo(s.context, 1000, &nothing);
            double near = 0;
            const TrundleRay back{{1, 0, 0.09}, {-1, 0, 0}, 5};
            std::uint32_t hit = 0;
            s.rays->castRays(s.context, &back, 1, 1, &near, &hit, nullptr);
            ownDistance = std::abs(near - 0.88) < 1e-3;
            s.rays->geomInfo(s.context, hit, &own);
            return s.rays->geomInfo(s.context, geoms[6], &wall) + s.rays->geomInfo(s.context, geoms[0], &floor);
        };
        Scene scene = withProbes({"p"});
        MaterialSpec grey;
        grey.name = "grey";
        grey.colour = {0.5, 0.5, 0.5};
        scene.spec->materials = {grey};
        auto world = scene.build(code);
        QVERIFY(world && world->tick().ok());
        for (int i = 0; i < 8; ++i) {
            QVERIFY(std::abs(distances[i] - single[i]) < 1e-9 && std::abs(listed[i] - single[i]) < 1e-9);
            QCOMPARE(geoms[i], single[i] < 10 ? hits[i].geom : 0xffffffffu);
            for (int k = 0; k < 3; ++k) QVERIFY(std::abs(normals[3 * i + k] - (single[i] < 10 ? hits[i].normal[k] : 0)) < 1e-9);
        }
        QVERIFY(single[6] < 10 && single[0] < 10 && single[4] < 10 && single[7] == 10);
        QCOMPARE(std::string(wall.path), std::string("arena/wall"));
        QCOMPARE(std::string(wall.material), std::string("grey"));
        QVERIFY(std::abs(wall.reflectance - 0.25) < 1e-12 && wall.colour[2] == 0.5 && wall.opacity == 1);
        QCOMPARE(std::string(floor.path), std::string("arena/floor"));
        QCOMPARE(std::string(own.path), std::string("r/chassis/hull"));
        QVERIFY(unknown != 0 && ownDistance);
        fan.range = std::nan("");
        const Status refused = world->tick();
        QVERIFY(!refused.ok());
        QVERIFY(QString::fromStdString(refused.error().message).contains("castFan was asked for a value that is not valid"));
    }
};

QTEST_APPLESS_MAIN(DeviceRaysTest)
#include "device_rays_test.moc"
