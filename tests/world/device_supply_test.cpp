// Power and lamps through the services of devices: the C interface that modules use.
#include <QtTest>

#include <trundle/abi_light.h>

#include "world/probe_device.h"

using namespace fixture;

class DeviceSupplyTest : public QObject {
    Q_OBJECT

    Bench m_bench;

private Q_SLOTS:
    void init() {
        m_bench = {};
        bench = &m_bench;
    }

    /// The supply senses last, wherever it is in the text, and has what all others drew in this tick alone.
    void aSupplyGetsWhatOthersDraw() {
        std::vector<double> resistive, regulated, conductance, seen;
        m_bench.probes["supply"].setup = [](const TrundleMount& m) { return m.provideSupply(m.context, 12, 11.5); };
        m_bench.probes["supply"].sense = [&](const TrundleServices& s) {
            TrundleLoad load{};
            s.supply->load(s.context, &load);
            resistive.push_back(load.resistive);
            regulated.push_back(load.regulated);
            conductance.push_back(load.conductance);
            s.supply->setVoltage(s.context, 10 - double(resistive.size()));
            return 0;
        };
        m_bench.probes["a"].act = [&](const TrundleServices& s) {
            double now = 0, nominal = 0;
            if (s.supply->voltage(s.context, &now, &nominal) != 0 || nominal != 12) return 1;
            seen.push_back(now);
            s.supply->draw(s.context, 100, 0);   // not in act
            s.supply->setVoltage(s.context, 99); // nor by another device
            return 0;
        };
        m_bench.probes["a"].sense = [](const TrundleServices& s) {
            s.supply->draw(s.context, 3, 0.5);
            s.supply->draw(s.context, std::nan(""), 0);
            s.supply->setVoltage(s.context, 99);
            return 0;
        };
        m_bench.probes["b"].sense = [](const TrundleServices& s) {
            s.supply->draw(s.context, 4, 0);
            s.supply->draw(s.context, 2, 0.25);
            return 0;
        };
        auto world = withProbes({"supply", "a", "b"}).build(code);
        QVERIFY(world);
        for (int i = 0; i < 3; ++i) QVERIFY(world->tick().ok());
        QCOMPARE(seen, (std::vector<double>{9, 8, 7})); // from the start state on
        for (const double watts : resistive) QCOMPARE(watts, 5.);
        for (const double watts : regulated) QCOMPARE(watts, 4.);
        for (const double siemens : conductance) QCOMPARE(siemens, 0.75);
        QCOMPARE(resistive.size(), std::size_t(4));
    }

    void aRobotHasOneSupply() {
        std::int32_t second = 0;
        m_bench.probes["a"].setup = [](const TrundleMount& m) { return m.provideSupply(m.context, 12, 12); };
        m_bench.probes["b"].setup = [&](const TrundleMount& m) {
            second = m.provideSupply(m.context, 6, 6);
            return 0;
        };
        QVERIFY(withProbes({"a", "b"}).build(code));
        QCOMPARE(second, -1);
    }

    void withoutASupplyNothingIsDrawn() {
        std::int32_t present = 0;
        TrundleLoad load{1, 1, 1};
        m_bench.probes["a"].sense = [&](const TrundleServices& s) {
            double volts = 5;
            present = s.supply->voltage(s.context, &volts, &volts);
            s.supply->draw(s.context, 3, 0.5);
            s.supply->setVoltage(s.context, 3);
            s.supply->load(s.context, &load);
            return volts == 5 ? 0 : 1;
        };
        auto world = withProbes({"a"}).build(code);
        QVERIFY(world && world->tick().ok());
        QCOMPARE(present, -1);
        QVERIFY(load.regulated == 0 && load.resistive == 0 && load.conductance == 0);
    }

    /// A device is a lamp where its body is, until it is dark again.
    void aDeviceIsALamp() {
        std::uint32_t body = 0, without = 0;
        double light = 0.25;
        std::vector<TrundleLight> lights;
        const double point[3] = {0.01, 0, 0.02};
        m_bench.probes["led"].setup = [&](const TrundleMount& m) { return m.body(m.context, "chassis", &body); };
        m_bench.probes["led"].act = [&](const TrundleServices& s) {
            s.light->emit(s.context, body, point, light);
            s.light->emit(s.context, 1000, point, 5); // no such body
            return 0;
        };
        m_bench.probes["eye"].sense = [&](const TrundleServices& s) {
            if (s.time == 0) without = s.light->lights(s.context, nullptr, 0);
            lights.resize(s.light->lights(s.context, nullptr, 0));
            s.light->lights(s.context, lights.data(), std::uint32_t(lights.size()));
            s.light->emit(s.context, body, point, 9); // not in sense
            return 0;
        };
        auto world = withProbes({"eye", "led"}).build(code);
        QVERIFY(world && world->tick().ok());
        QCOMPARE(lights.size(), std::size_t(without + 1));
        const TrundleLight& lamp = lights.back();
        QVERIFY(lamp.type == TRUNDLE_LAMP && lamp.light == 0.25 && lamp.shadows == 1);
        const auto entry = world->layout().find("r/chassis/pose");
        QVERIFY(entry);
        const auto pose = world->block().slots().subspan(entry->offset, 7);
        const Vec3 expected = Vec3(pose[0], pose[1], pose[2]) + Quat(pose[3], pose[4], pose[5], pose[6]) * Vec3(point);
        QVERIFY((Vec3(lamp.way) - expected).norm() < 1e-12);
        light = 0;
        QVERIFY(world->tick().ok());
        QCOMPARE(lights.size(), std::size_t(without));
    }
};

QTEST_GUILESS_MAIN(DeviceSupplyTest)
#include "device_supply_test.moc"
