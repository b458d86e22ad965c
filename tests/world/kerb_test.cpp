// Traction over kerbs: what friction gives is what the load allows, neither more nor less, and momentum is kept. No closed form is known for
// where a vehicle lands, so this adds up the forces that contacts report, over a whole crossing.
#include <QtTest>

#include <thread>

#include "world/friction_vehicles.h"

using namespace fixture;

namespace {

/// Sums over a time: N s.
struct Impulses {
    double load = 0, grip = 0;                           ///< of wheels: along the normals, and across
    Vec3 forces = Vec3::Zero(), momentum = Vec3::Zero(); ///< all forces on the vehicle with its weight; change of momentum
    double farthest = 0, highest = 0;
};

Vec3 momentumOf(World& world) {
    Vec3 sum = Vec3::Zero();
    for (const BodySpec& b : world.experiment().robots[0].config->bodies) {
        const double* p = slot(world, "v/" + b.name + "/pose");
        const Vec3 lever = Quat(p[3], p[4], p[5], p[6]) * b.mass.centre;
        sum += b.mass.mass * (velocity(world, "v/" + b.name) + spin(world, "v/" + b.name).cross(lever));
    }
    return sum;
}

Vehicle fourWheels(double mu, double mass) {
    Vehicle v;
    v.mass = mass;
    v.friction = mu;
    v.wheels = {{0.12, 0.15, 0}, {0.12, -0.15, 0}, {-0.12, 0.15, 0}, {-0.12, -0.15, 0}};
    v.centre = {0, 0, 0.05};
    return v;
}

/// Over a kerb that begins at 0.6 m and is 0.5 m long.
std::optional<Impulses> cross(double tick, Vehicle v, double height, double heading, double rim, double seconds) {
    Scene scene(tick);
    addVehicle(scene, v, 0);
    scene.scenery(
        {plane("floor", {}, v.ground), box("kerb", {0.5, 4, height}, at(0.85, 0, height / 2, degrees(heading, 0, 0)), v.ground)});
    auto world = scene.build(beltOrRow);
    if (!world) return {};
    driveAll(*world, v, rim / v.radius);
    Impulses sum;
    const Vec3 start = momentumOf(*world);
    for (double t = 0; t < seconds; t += tick) {
        if (!world->tick()) return {};
        for (const WorldContact& c : world->contacts()) {
            const bool first = c.first.starts_with("v/");
            sum.forces += (first ? tick : -tick) * (c.force * c.normal + c.friction);
            if ((first ? c.first : c.second).find("wheel") == std::string_view::npos) continue;
            sum.load += tick * c.force;
            sum.grip += tick * c.friction.norm();
        }
        sum.forces += tick * v.total * scene.spec->settings.gravity;
        sum.farthest = std::max(sum.farthest, position(*world, "v/chassis").x());
        sum.highest = std::max(sum.highest, position(*world, "v/chassis").z());
    }
    sum.momentum = momentumOf(*world) - start;
    return sum;
}

void addTicks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.001, 0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
}

} // namespace

class KerbTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wheelsThatSlip_data() { addTicks(); }
    /// Wheels that spin far too fast all the time: the impulse of friction is mu times that of the load, whatever lifts, lands and strikes.
    void wheelsThatSlip() {
        QFETCH(double, tick);
        for (const auto& [mu, mass, height] : {std::array{0.5, 3., 0.01}, std::array{0.3, 8., 0.02}}) {
            const auto sum = cross(tick, fourWheels(mu, mass), height, 0, 20, 1.5);
            QVERIFY(sum);
            const double off = sum->grip / (mu * sum->load) - 1;
            qInfo("mu %g, kerb of %g mm: friction %+.2f %%, momentum off by %.2g N s of %.3g", mu, 1e3 * height, 100 * off,
                  (sum->momentum - sum->forces).norm(), sum->momentum.norm());
            QVERIFY(sum->farthest > 1.3 && sum->highest > 0.7 * height); // it was over
            QVERIFY(std::abs(off) < (tick > 0.02 ? 0.04 : 0.02));
            QVERIFY((sum->momentum - sum->forces).norm() < 1e-3 * (1 + sum->momentum.norm()));
        }
    }

    void kerbsAtAnAngle_data() {
        QTest::addColumn<double>("mu");
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("tick");
        for (const auto& [mu, mass, height, heading] :
             {std::array{0.3, 3., 0.01, 20.}, std::array{0.15, 8., 0.02, 30.}, std::array{0.35, 5., 0.016, 45.},
              std::array{0.2, 20., 0.012, -35.}, std::array{0.25, 1., 0.008, -10.}})
            for (const double tick : {0.001, 0.005, 0.01, 0.03})
                QTest::addRow("mu %g, %g mm at %g deg, %g ms", mu, 1e3 * height, heading, 1e3 * tick)
                    << mu << mass << height << heading << tick;
    }
    /// What strikes a wheel aside has no part in how much it slips: a contact is a cone from its first tick on.
    void kerbsAtAnAngle() {
        QFETCH(double, mu);
        QFETCH(double, mass);
        QFETCH(double, height);
        QFETCH(double, heading);
        QFETCH(double, tick);
        Vehicle v = fourWheels(mu, mass);
        v.radius = 0.1;
        v.wheelMass = 0.02 * mass;
        // a wheel that turns by far more than 1.5 rad in a tick leaves its axle
        const auto sum = cross(tick, v, height, heading, 5, 1.2);
        QVERIFY(sum);
        const double off = sum->grip / (mu * sum->load) - 1;
        qInfo("friction %+.2f %%, momentum off by %.2g N s of %.3g", 100 * off, (sum->momentum - sum->forces).norm(),
              sum->momentum.norm());
        QVERIFY(sum->farthest > 0.6 && sum->highest > 0.7 * height);
        QVERIFY(std::abs(off) < (tick > 0.02 ? 0.02 : 0.01));
        QVERIFY((sum->momentum - sum->forces).norm() < 1e-3 * (1 + sum->momentum.norm()));
    }

    void wheelsThatRoll_data() { addTicks(); }
    /// At a steady rate friction stays below mu times the load, and after the kerb the vehicle is as fast as its wheels again.
    void wheelsThatRoll() {
        QFETCH(double, tick);
        for (const auto& [mu, mass, height, speed] :
             {std::array{0.8, 3., 0.01, 0.4}, std::array{0.9, 8., 0.015, 0.6}, std::array{0.6, 2., 0.005, 1.}}) {
            const double seconds = std::ceil(2.2 / speed / 0.03) * 0.03;
            const auto sum = cross(tick, fourWheels(mu, mass), height, 0, speed, seconds);
            QVERIFY(sum);
            const double most = sum->grip / (mu * sum->load), now = sum->momentum.x() / ((mass + 0.08) * speed);
            qInfo("kerb of %g mm at %g m/s: friction %.3f of the most, then %.5f of its speed, momentum off by %.2g",
                  1e3 * height, speed, most, now, (sum->momentum - sum->forces).norm());
            QVERIFY(sum->farthest > 1.3 && sum->highest > 0.7 * height);
            QVERIFY(most < 1);
            QVERIFY(std::abs(now - 1) < 2e-3);
            QVERIFY((sum->momentum - sum->forces).norm() < 1e-3 * (1 + sum->momentum.norm()));
        }
    }

    /// As often at once as there are threads: each run ends in the same bits as one alone.
    void sameBitsInAnyThread() {
        const auto hash = [] {
            Scene scene(0.01);
            Vehicle v = fourWheels(0.6, 4);
            addVehicle(scene, v, 0.02);
            scene.scenery({plane("floor", {}, v.ground), box("kerb", {0.5, 4, 0.01}, at(0.85, 0, 0.005), v.ground)});
            for (int i = 0; i < 6; ++i)
                scene.loose("crate" + std::to_string(i), at(1.4, -0.3, 0.1 + 0.25 * i, degrees(10 * i, 5, 3)),
                            massOfBox(0.5, {0.2, 0.2, 0.2}), {box("c", {0.2, 0.2, 0.2})});
            auto world = scene.build(beltOrRow);
            for (std::size_t i = 0; i < 4; ++i) drive(*world, v, i, (i % 2 ? 8 : 14) / v.radius);
            return run(*world, 2) ? world->stateHash() : 0;
        };
        const std::uint64_t alone = hash();
        QVERIFY(alone != 0);
        for (const std::size_t count : {1, 4}) {
            std::vector<std::uint64_t> hashes(count, 0);
            std::vector<std::thread> threads;
            for (std::uint64_t& result : hashes) threads.emplace_back([&result, &hash] { result = hash(); });
            for (std::thread& thread : threads) thread.join();
            for (const std::uint64_t result : hashes) QCOMPARE(result, alone);
        }
    }
};

QTEST_APPLESS_MAIN(KerbTest)
#include "kerb_test.moc"
