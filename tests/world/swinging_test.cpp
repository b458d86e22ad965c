// Pendulums of any length, mass and amplitude against elliptic integrals: a joint takes no energy. Some from a generator with a
// fixed seed.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

struct Pendulum {
    std::string name;
    double mass = 1, length = 1, amplitude = 90; ///< m from the joint to the centre, degrees
    Vec3 size{0.06, 0.06, 0.06};                 ///< of the bob
    JointType type = JointType::Hinge;
    double heading = 0; ///< degrees of the plane in which it swings
};

std::vector<Pendulum> pendulums() {
    std::vector<Pendulum> list{{"10 deg", 1, 1, 10},
                               {"90 deg", 1, 1, 90},
                               {"170 deg", 1, 1, 170},
                               {"90 deg on a ball joint", 1, 1, 90, {0.06, 0.06, 0.06}, JointType::Ball},
                               {"rod", 0.5, 0.25, 60, {0.02, 0.02, 0.5}},
                               {"plate across", 3, 0.1, 45, {0.02, 0.4, 0.2}}};
    std::mt19937 random(19);
    const auto from = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967295.0; };
    for (int i = 0; i < 8; ++i) {
        Pendulum p;
        p.name = "random " + std::to_string(i);
        p.mass = std::pow(10, from(-2, 2));
        p.length = std::pow(10, from(-0.5, 0.7));
        p.amplitude = from(5, 150);
        p.size = p.length * Vec3(from(0.05, 0.5), from(0.05, 0.5), from(0.05, 0.5));
        p.type = i % 2 ? JointType::Ball : JointType::Hinge;
        if (p.type == JointType::Ball) p.size.y() = p.size.x(); // others leave their plane
        p.heading = p.type == JointType::Hinge ? from(-180, 180) : 0;
        list.push_back(p);
    }
    return list;
}

double periodOf(const Pendulum& p) {
    const double inertia = massOfBox(p.mass, p.size).inertia(1, 1) + p.mass * p.length * p.length;
    double a = 1, b = std::cos(p.amplitude * kPi / 360); // the mean of both: arithmetic and geometric
    while (std::abs(a - b) > 1e-15) {
        const double next = (a + b) / 2;
        b = std::sqrt(a * b);
        a = next;
    }
    return 2 * kPi * std::sqrt(inertia / (p.mass * g * p.length)) / a;
}

/// Mechanical energy in units of what the swing of a link by 90 degrees takes.
double energyOf(const World& world, double unit) {
    const RobotEnergy energy = world.robotEnergy(0);
    return (energy.kinetic + energy.potential) / unit;
}

} // namespace

class SwingingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void swings_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("h");
        int index = 0;
        for (const Pendulum& p : pendulums()) {
            for (const double h : {0.005, 0.01, 0.03}) QTest::addRow("%s, %g ms", p.name.c_str(), 1e3 * h) << index << h;
            ++index;
        }
    }
    /// Over 40 s. The period: within .0006 % at 10 ms for small swings, .0025 % for any; a quarter of it at 5 ms. The amplitude: half
    /// a degree of 90 at 10 ms.
    void swings() {
        QFETCH(int, index);
        QFETCH(double, h);
        const Pendulum p = pendulums()[static_cast<std::size_t>(index)];
        Scene scene(h);
        const Quat plane = rotationFromHpr(degrees(p.heading, 0, 0)),
                   raised = plane * Quat(Eigen::AngleAxisd(-p.amplitude * kPi / 180, Vec3::UnitY()));
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("bob", {raised * Vec3(0, 0, -p.length), raised}, massOfBox(p.mass, p.size), {}));
        config->joints.push_back(joint("pivot", p.type, kWorldBody, 0, Vec3::Zero(), plane * Vec3::UnitY()));
        scene.robot("p", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        const Vec3 along = plane * Vec3::UnitX();
        const auto angle = [&] {
            const Vec3 at = position(*world, "p/bob");
            return std::atan2(at.dot(along), -at.z());
        };
        double last = angle(), first = 0, latest = 0, amplitude = 0, longest = 0, speed = 0;
        int crossings = 0;
        const double period = periodOf(p);
        while (world->time() < 40) {
            QVERIFY(world->tick().ok());
            const double now = angle();
            if (last < 0 && now >= 0) {
                latest = world->time() - h * now / (now - last);
                if (crossings++ == 0) first = latest;
                speed = (now - last) / h; // at the bottom: the amplitude follows from it
            }
            if (world->time() > 40 - 1.2 * period) amplitude = std::max(amplitude, std::abs(now));
            longest = std::max(longest, std::abs(position(*world, "p/bob").norm() - p.length));
            last = now;
        }
        const double measured = (latest - first) / (crossings - 1), off = measured / period - 1;
        // From the rate at the bottom, as no tick meets the moment of rest.
        const double inertia = massOfBox(p.mass, p.size).inertia(1, 1) + p.mass * p.length * p.length;
        const double s = inertia * speed * speed / (2 * p.mass * g * p.length);
        const double kept = std::acos(std::clamp(1 - s, -1.0, 1.0)) * 180 / kPi / p.amplitude;
        qInfo("period %.4f s %+.5f %%, amplitude kept %.5f (seen %.5f), length off by %.2g mm", period, 100 * off, kept,
              amplitude * 180 / kPi / p.amplitude, 1e3 * longest);
        const double ticks = h / 0.01;
        QVERIFY(std::abs(kept - 1) < 0.5 / 90 * std::max(1.0, ticks));
        QVERIFY(std::abs(off) < (p.amplitude > 10 ? 2.5e-5 : 6e-6) * ticks * ticks);
        QVERIFY(longest < 1e-5 * p.length);
    }

    void chain_data() {
        QTest::addColumn<int>("links");
        QTest::addColumn<double>("h");
        QTest::newRow("2 links, 5 ms") << 2 << 0.005;
        QTest::newRow("2 links, 10 ms") << 2 << 0.01;
        QTest::newRow("5 links, 5 ms") << 5 << 0.005;
        QTest::newRow("5 links, 10 ms") << 5 << 0.01;
    }
    /// A chain of rods that starts level whips about: its energy after 20 s within a tenth of what it had to fall. Longer ticks are
    /// too long for chains like these.
    void chain() {
        QFETCH(int, links);
        QFETCH(double, h);
        Scene scene(h);
        auto config = std::make_shared<RobotConfigSpec>();
        const Vec3 size(0.3, 0.03, 0.03);
        for (int i = 0; i < links; ++i) {
            const std::string n = std::to_string(i);
            config->bodies.push_back(body("rod" + n, at(0.15 + 0.3 * i, 0, 0), massOfBox(0.2, size), {}));
            config->joints.push_back(joint("j" + n, JointType::Hinge, i ? i - 1 : kWorldBody, i, {0.3 * i, 0, 0}, Vec3::UnitY()));
        }
        scene.robot("p", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        const double unit = links * 0.2 * g * links * 0.15, e0 = energyOf(*world, unit);
        double most = 0, least = 0;
        while (world->time() < 20) {
            QVERIFY(world->tick().ok());
            most = std::max(most, energyOf(*world, unit) - e0);
            least = std::min(least, energyOf(*world, unit) - e0);
        }
        qInfo("energy between %+.4f and %+.4f, in the end %+.4f", least, most, energyOf(*world, unit) - e0);
        QVERIFY(std::abs(energyOf(*world, unit) - e0) < 0.1);
    }
};

QTEST_APPLESS_MAIN(SwingingTest)
#include "swinging_test.moc"
