// Vehicles in lanes: the same bits on every instruction set, in any lane and beside any neighbours.
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "world/wheeled/vehicle_block.h"

using namespace trundle;

namespace {

/// Two driven wheels, a slider, a ball that turns freely; one wheel of it has rollers and grips along one way alone.
VehicleModel fourSupports() {
    VehicleModel model;
    model.supportCount = 4;
    model.wheelCount = 2;
    model.mass = 2.4;
    const double inverse[6] = {80, 1, -2, 50, 0.5, 30};
    std::ranges::copy(inverse, model.inverseInertia);
    model.stiffness = 2e4;
    model.damping = 150;
    model.wheelDamping[1] = 1e-4;
    model.supports[0] = {{0.05, 0.12, -0.02}, 0.05, {1, 0}, 0.05, 0.9, 0, true};
    model.supports[1] = {{0.05, -0.12, -0.02}, 0.05, {0.8, 0.6}, 0.04, 0.7, 1, false};
    model.supports[2] = {{-0.12, 0, -0.05}, 0.02, {1, 0}, 0, 0.05, 0, true};
    model.supports[3] = {{0.12, 0, -0.05}, 0.02, {1, 0}, 0, 0.6, 0, true};
    model.supports[3].rolling = 0.08;
    QFETCH_GLOBAL(bool, planar);
    if (!planar) return model;
    model.planar = true;
    std::ranges::copy(std::array<double, 6>{0, 0, 0, 0, 0, 30}, model.inverseInertia);
    return model;
}

/// What a vehicle comes with; some slip, some are at rest, some have a servo, dry friction or no motor.
struct Start {
    std::vector<double> numbers;
};

Start startOf(int vehicle) {
    std::mt19937_64 bits(static_cast<std::uint64_t>(vehicle) + 1);
    const auto random = [&bits](double low, double high) {
        return low + (high - low) * 0x1p-53 * static_cast<double>(bits() >> 11);
    };
    Start start;
    const auto add = [&](double value) { start.numbers.push_back(value); };
    const bool rests = vehicle % 7 == 0;
    for (int k = 0; k < 3; ++k) add(random(-3, 3)); // position
    add(0.0699);
    const double half = random(-3, 3);
    for (const double q : {std::cos(half), 0., 0., std::sin(half)}) add(q);
    for (const double h : {std::cos(2 * half), std::sin(2 * half)}) add(h);
    for (int k = 0; k < 6; ++k) add(rests ? 0 : random(-0.5, 0.5));        // speeds
    for (int k = 0; k < 6; ++k) add(vehicle % 3 == 0 ? random(-2, 2) : 0); // force, moment
    for (int i = 0; i < 2; ++i) {
        add(rests ? 0 : random(-9, 9)); // spin
        add(random(-900, 900));
        add(0.01);
        add(2e-4);
        add(random(-9, 9)); // of the motor
        add(vehicle % 4 == 1 ? 0 : 25);
        add(vehicle % 5 == 2 ? 0 : vehicle % 5 == 3 ? 0.05 : 2);
        add(vehicle % 4 == 2 ? 0.1 : 0);
        add(vehicle % 6 == 4 ? 0.02 : 0);
        add(vehicle % 6 == 5 ? 1e-3 : 0);
    }
    for (int i = 0; i < 12; ++i) add(rests ? 0 : random(0, 0.05)); // impulses
    return start;
}

/// State and motors of a lane, in the order of startOf().
template <class Use> void eachField(VehicleBlock& b, Use use) {
    for (auto& f : b.position) use(f);
    use(b.height);
    for (auto& f : b.rotation) use(f);
    use(b.c), use(b.s);
    for (auto& f : b.linear) use(f);
    for (auto& f : b.angular) use(f);
    for (auto& f : b.force) use(f);
    for (auto& f : b.moment) use(f);
    for (int i = 0; i < 2; ++i) {
        VehicleWheelRow& w = b.wheels[i];
        for (auto* f : {&w.spin, &w.angle, &w.torque, &w.inertia, &w.rate, &w.softness, &w.limit, &w.damping, &w.dry, &w.viscous})
            use(*f);
    }
}

template <class Use> void eachImpulse(VehicleBlock& b, Use use) {
    for (int i = 0; i < 4; ++i) use(b.supports[i].normal), use(b.supports[i].alongImpulse), use(b.supports[i].acrossImpulse);
}

/// What the world gets; the rows of a lane that has settled go on with the others.
std::vector<double> resultOf(VehicleBlock& b, int lane) {
    std::vector<double> out;
    eachField(b, [&](const VehicleField& f) { out.push_back(f[lane]); });
    for (int i = 0; i < 4; ++i)
        for (const auto* f : {&b.supports[i].keptNormal, &b.supports[i].keptAlong, &b.supports[i].keptAcross})
            out.push_back((*f)[lane]);
    for (int i = 0; i < 2; ++i)
        for (const auto* f : {&b.wheels[i].impulse, &b.wheels[i].friction, &b.wheels[i].halfCosine, &b.wheels[i].halfSine})
            out.push_back((*f)[lane]);
    return out;
}

bool sameBits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

using Vehicles = std::array<int, kVehicleLanes>;

std::unique_ptr<VehicleBlock> blockOf(const Vehicles& vehicles) {
    auto block = std::make_unique<VehicleBlock>();
    for (int lane = 0; lane < kVehicleLanes; ++lane) {
        const Start start = startOf(vehicles[static_cast<std::size_t>(lane)]);
        std::size_t at = 0;
        const auto take = [&](VehicleField& f) { f[lane] = start.numbers[at++]; };
        eachField(*block, take);
        eachImpulse(*block, take);
        const double loads[4] = {11.5, 8.25, 2.5, 1.25}; // N
        for (int i = 0; i < 4; ++i) block->supports[i].load[lane] = loads[i];
    }
    return block;
}

/// By vehicle, of the lanes of a block.
std::vector<std::vector<double>> solved(const VehicleKernel& kernel, const Vehicles& vehicles) {
    const VehicleModel model = fourSupports();
    const VehicleTick tick{{0.1, -0.2, -9.81}, 0.01};
    const auto block = blockOf(vehicles);
    kernel.prepare(*block, model, tick);
    kernel.settle(*block, model, 1e-6 * 9.81 * tick.h * model.mass, 300);
    kernel.finish(*block, model, tick);
    std::vector<std::vector<double>> out;
    for (int lane = 0; lane < kVehicleLanes; ++lane) out.push_back(resultOf(*block, lane));
    return out;
}

} // namespace

class LanesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase_data() {
        QTest::addColumn<bool>("planar");
        QTest::newRow("wheeled") << false;
        QTest::newRow("planar") << true;
    }
    void sameBitsOnEveryInstructionSet() {
        QCOMPARE(baselineVehicleKernel().lanes, 2);
        const VehicleKernel* wide = avx2VehicleKernel();
        const VehicleKernel* fast = wide ? wide : &baselineVehicleKernel(); // the only one of a processor without AVX2
        for (int i = 0; i < 240; i += 4) {
            const Vehicles vehicles{i, i + 1, i + 2, i + 3};
            QVERIFY(solved(baselineVehicleKernel(), vehicles) == solved(*fast, vehicles));
        }
    }

    /// A vehicle has the bits that it has in a block of its own, whatever else is in the block: those settle earlier or later.
    void sameBitsBesideOthers() {
        for (const VehicleKernel* kernel : {&baselineVehicleKernel(), avx2VehicleKernel()}) {
            if (!kernel) continue;
            for (int i = 0; i < 60; ++i) {
                const auto alone = solved(*kernel, {i, i, i, i}).front();
                const Vehicles vehicles{7 * i % 60, i, (i + 31) % 60, i};
                const auto beside = solved(*kernel, vehicles);
                QVERIFY2(sameBits(beside[1], alone) && sameBits(beside[3], alone), kernel->name);
            }
        }
    }

    /// The cases are different, and the solution is one: wheels that grip roll, all impulses are within their cones.
    void solves() {
        const VehicleModel model = fourSupports();
        int slips = 0, grips = 0;
        for (int i = 0; i < 60; ++i) {
            const auto block = blockOf({i, i, i, i});
            const VehicleTick tick{{0, 0, -9.81}, 0.01};
            vehicleKernel().prepare(*block, model, tick);
            vehicleKernel().settle(*block, model, 1e-9, 3000);
            for (int s = 0; s < 3; ++s) {
                const VehicleSupportRow& row = block->supports[s];
                const double along = row.keptAlong[0], across = model.supports[s].round ? row.keptAcross[0] : 0;
                const double limit = model.supports[s].friction * row.keptNormal[0], force = std::hypot(along, across);
                QVERIFY(row.keptNormal[0] >= 0);
                QVERIFY(force <= limit + 1e-8);
                if (s == 0) ++(force < 0.999 * limit ? grips : slips);
            }
        }
        qInfo("%d grip, %d slip", grips, slips);
        QVERIFY(slips > 5 && grips > 5);
    }
};

QTEST_APPLESS_MAIN(LanesTest)
#include "lanes_test.moc"
