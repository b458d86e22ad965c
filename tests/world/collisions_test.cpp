// Collisions of free bodies: momentum stays and energy never rises, whatever the shapes, masses, offsets, spins, restitution and friction,
// which come from a generator with a fixed seed.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr int kCollisions = 40; ///< in one world
constexpr double kApart = 8;    ///< m, so that what bounces off one pillar does not meet what bounces off the next

struct Random {
    std::mt19937 bits;
    double from(double low, double high) { return low + (high - low) * static_cast<double>(bits()) / 4294967295.0; }
    Vec3 vector(double most) { return {from(-most, most), from(-most, most), from(-most, most)}; }
};

struct Thing {
    MassProperties mass;
    GeomSpec geom;
};
Thing anyThing(Random& random, std::uint32_t surface) {
    const double mass = std::pow(10, random.from(-1, 1)), r = random.from(0.025, 0.1), length = random.from(0.05, 0.2);
    const int shape = static_cast<int>(random.from(0, 3.999));
    if (shape == 0) return {massOfSphere(mass, r), sphere("g", r, {}, surface)};
    if (shape == 1) {
        const Vec3 size(2 * r, length, random.from(0.05, 0.2));
        return {massOfBox(mass, size), box("g", size, {}, surface)};
    }
    Thing thing{massOfCylinder(mass, r, length), cylinder("g", r, length, {}, surface)};
    if (shape == 3) {
        thing.geom.shape = GeomShape::Capsule;
        thing.mass = massOfCylinder(mass, r, length + r);
    }
    return thing;
}

/// Kinetic energy, J. Of what falls the one that explicit ticks keep: with the height, half a tick before.
double energyOf(World& world, const Scene& scene, std::size_t i) {
    const std::string path = "b" + std::to_string(i) + "/body";
    const double h = scene.spec->settings.tick, mass = scene.spec->robots[i].config->bodies[0].mass.mass;
    const Vec3& gravity = scene.spec->settings.gravity;
    return world.robotEnergy(i).kinetic - mass * gravity.dot(position(world, path) - h / 2 * velocity(world, path));
}

} // namespace

class CollisionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void partsAsRestitutionSays_data() {
        QTest::addColumn<double>("e");
        QTest::addColumn<double>("h");
        for (const double e : {0.0, 0.2, 0.5})
            for (const double h : {0.001, 0.005, 0.01, 0.03}) QTest::addRow("e = %g, %g ms", e, 1e3 * h) << e << h;
    }
    /// A ball meets a wall at any distance within a tick: what pushes it out of the wall then does not throw it.
    void partsAsRestitutionSays() {
        QFETCH(double, e);
        QFETCH(double, h);
        double off = 0;
        for (const double v : {0.1, 0.3, 1.0, 3.0})
            for (int phase = 0; phase < 7; ++phase) {
                Scene scene(h);
                scene.spec->settings.gravity = Vec3::Zero();
                const auto s = scene.surface(0.3, e);
                scene.scenery({plane("wall", {{0.5, 0, 0}, rotationFromHpr(degrees(0, -90, 0))}, s)});
                scene.ball("b", {0.3 + phase / 140.0, 0, 0}, 1.7, 0.05, s);
                auto world = scene.build();
                QVERIFY(world->push("b/body", {1.7 * v / h, 0, 0}, position(*world, "b/body")).ok());
                QVERIFY(run(*world, std::ceil((0.3 / v + 0.2) / 0.03) * 0.03));
                off = std::max(off, std::abs(-velocity(*world, "b/body").x() / v - e));
            }
        qInfo("off by %.4f of the speed before at most", off);
        QVERIFY(off < 0.02);
    }

    void spinsUpOnABox_data() {
        QTest::addColumn<double>("h");
        for (const double h : {0.002, 0.005, 0.01}) QTest::addRow("%g ms", 1e3 * h) << h;
    }
    /// A ball that bounces rolls on: of its speed along 5/7 are left, on a box as on a plane.
    void spinsUpOnABox() {
        QFETCH(double, h);
        for (int phase = 0; phase < 5; ++phase) {
            Scene scene(h);
            scene.spec->settings.gravity = Vec3::Zero();
            const auto s = scene.surface(0.5, 0.5);
            scene.scenery({box("floor", {4, 4, 1}, at(0, 0, -0.5), s)});
            scene.ball("b", {0, 0, 0.05 + 0.0023 * phase}, 0.3, 0.02, s);
            auto world = scene.build();
            QVERIFY(world->push("b/body", Vec3(0.3, 0, -0.45) / h, position(*world, "b/body")).ok());
            QVERIFY(run(*world, 0.1));
            QVERIFY(velocity(*world, "b/body").z() > 0.7);
            QVERIFY2(std::abs(velocity(*world, "b/body").x() - 5 / 7.0) < 0.004,
                     qPrintable(QString::number(velocity(*world, "b/body").x())));
            QVERIFY(std::abs(spin(*world, "b/body").y() - 5 / 7.0 / 0.02) < 0.2);
        }
    }

    void energyNeverRises_data() {
        QTest::addColumn<QString>("with");
        QTest::addColumn<double>("e");
        QTest::addColumn<double>("mu");
        QTest::addColumn<double>("h");
        QTest::addColumn<unsigned>("seed");
        for (const double h : {0.001, 0.005, 0.01, 0.03})
            for (const char* with : {"each other", "a wall", "a pillar", "the floor"})
                for (const double e : {0.0, 0.3, 0.7, 1.0})
                    for (const double mu : {0.0, 0.3, 1.0})
                        QTest::addRow("%s, e = %g, mu = %g, %g ms", with, e, mu, 1e3 * h) << with << e << mu << h << 21u;
        for (const unsigned seed : {34u, 35u, 46u}) // a box that tumbles fast lands on a corner
            for (const double mu : {0.0, 0.05})
                QTest::addRow("a corner, mu = %g, 30 ms, %u", mu, seed) << "the floor" << 0.0 << mu << 0.03 << seed;
    }
    /// Pairs far from each other, or single bodies and the scenery.
    void energyNeverRises() {
        QFETCH(QString, with);
        QFETCH(double, e);
        QFETCH(double, mu);
        QFETCH(double, h);
        QFETCH(unsigned, seed);
        Random random{std::mt19937(seed)};
        Scene scene(h);
        const bool falls = with == "the floor";
        if (!falls) scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(mu, e);
        if (with == "a wall") scene.scenery({plane("wall", {{0.5, 0, 0}, rotationFromHpr(degrees(0, -90, 0))}, s)});
        if (falls) scene.scenery({plane("floor", {}, s)});
        const int bodies = with == "each other" ? 2 : 1;
        std::vector<Vec3> push, turn;
        for (int i = 0; i < kCollisions; ++i) {
            if (with == "a pillar")
                scene.scenery({box("pillar", {0.2, 0.15, 2}, at(0.6, kApart * i, 0), s)}, {}, "pillar" + std::to_string(i));
            for (int k = 0; k < bodies; ++k) {
                const Thing thing = anyThing(random, s);
                const Vec3 offset = random.vector(0.1);
                const Pose pose{{k ? 0.4 : 0.0, kApart * i + offset.y(), (falls ? 0.5 : 0) + offset.z()},
                                rotationFromHpr(degrees(random.from(-180, 180), random.from(-80, 80), random.from(-180, 180)))};
                scene.loose("b" + std::to_string(push.size()), pose, thing.mass, {thing.geom});
                Vec3 speed = random.vector(0.5);
                if (falls) speed.z() -= random.from(0, 2);
                else speed.x() = k ? random.from(-1, 0) : random.from(0.5, 3);
                push.push_back(thing.mass.mass * speed);
                turn.push_back(thing.mass.inertia.diagonal().cwiseProduct(random.vector(15)));
            }
        }
        auto world = scene.build();
        QVERIFY(world);
        for (std::size_t i = 0; i < push.size(); ++i) {
            const std::string path = "b" + std::to_string(i) + "/body";
            const Vec3 at = position(*world, path), arm = turn[i].unitOrthogonal();
            QVERIFY(world->push(path, push[i] / h, at).ok());
            QVERIFY(world->push(path, turn[i].cross(arm) / (2 * h), at + arm).ok());
            QVERIFY(world->push(path, -turn[i].cross(arm) / (2 * h), at - arm).ok());
        }
        QVERIFY(world->tick().ok());
        struct Totals {
            double energy = 0;
            Vec3 momentum = Vec3::Zero(), first = Vec3::Zero(); ///< first: velocity of the first body, m/s
        };
        const auto totals = [&](int pair) {
            Totals t;
            for (int k = 0; k < bodies; ++k) {
                const auto i = static_cast<std::size_t>(bodies * pair + k);
                t.energy += energyOf(*world, scene, i);
                const Vec3 v = velocity(*world, "b" + std::to_string(i) + "/body");
                t.momentum += scene.spec->robots[i].config->bodies[0].mass.mass * v;
                if (k == 0) t.first = v;
            }
            return t;
        };
        std::vector<Totals> start;
        for (int i = 0; i < kCollisions; ++i) start.push_back(totals(i));
        std::vector<Totals> before = start;
        std::vector<double> rise(kCollisions, 0), jump(kCollisions, 0);
        double momentum = 0;
        std::vector<bool> met(kCollisions, false);
        while (world->time() < 0.8) {
            QVERIFY(world->tick().ok());
            for (int i = 0; i < kCollisions; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const Totals now = totals(i);
                met[at] = met[at] || (now.first - before[at].first - scene.spec->settings.gravity * h).norm() > 1e-3;
                rise[at] = std::max(rise[at], now.energy / start[at].energy - 1);
                jump[at] = std::max(jump[at], (now.energy - before[at].energy) / start[at].energy);
                if (bodies == 2)
                    momentum = std::max(momentum, (now.momentum - start[at].momentum).norm() / start[at].momentum.norm());
                before[at] = now;
            }
        }
        const auto hits = std::count(met.begin(), met.end(), true);
        const auto count = [](const std::vector<double>& v) {
            return std::count_if(v.begin(), v.end(), [](double x) { return x > 1e-6; });
        };
        qInfo("%d hits; %d gained, %.2g at most; %d rose in a tick, %.2g at most; momentum off by %.1g", int(hits),
              int(count(rise)), *std::max_element(rise.begin(), rise.end()), int(count(jump)),
              *std::max_element(jump.begin(), jump.end()), momentum);
        QVERIFY(hits > kCollisions / 4);
        QVERIFY(momentum < 1e-9);
        QVERIFY(count(rise) <= (e == 1 && h > 0.02 ? 1 : 0));
        QVERIFY(*std::max_element(rise.begin(), rise.end()) < 0.01);
    }
};

QTEST_APPLESS_MAIN(CollisionsTest)
#include "collisions_test.moc"
