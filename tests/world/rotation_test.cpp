// How bodies turn, compared with a reference that is integrated here in small steps: angular momentum, energy, flips about the
// middle axis, precession of tops. Bodies, angles and rates come from a generator with a fixed seed.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kTicks[] = {0.005, 0.01, 0.03};

/// A body that turns about a fixed point: its centre of mass, or the tip of a top.
struct Gyro {
    Mat3 inertia = Mat3::Identity(); ///< about that point, in the body's axes
    Vec3 arm = Vec3::Zero();         ///< kg m: mass times the centre of mass from there
    Vec3 gravity = Vec3::Zero();
    Quat turned = Quat::Identity();
    Vec3 rate = Vec3::Zero(); ///< rad/s, body's axes

    [[nodiscard]] Vec3 change(const Quat& q, const Vec3& w) const {
        return inertia.inverse() * ((inertia * w).cross(w) + arm.cross(q.conjugate() * gravity));
    }
    /// Runge and Kutta's method.
    void step(double h) {
        const auto slope = [&](const Quat& q, const Vec3& w) { return Quat((q * Quat(0, w.x(), w.y(), w.z())).coeffs() / 2); };
        const auto plus = [](const Quat& q, double t, const Quat& d) { return Quat(q.coeffs() + t * d.coeffs()); };
        const Quat q1 = slope(turned, rate);
        const Vec3 w1 = change(turned, rate);
        const Quat q2 = slope(plus(turned, h / 2, q1), rate + h / 2 * w1);
        const Vec3 w2 = change(plus(turned, h / 2, q1), rate + h / 2 * w1);
        const Quat q3 = slope(plus(turned, h / 2, q2), rate + h / 2 * w2);
        const Vec3 w3 = change(plus(turned, h / 2, q2), rate + h / 2 * w2);
        const Quat q4 = slope(plus(turned, h, q3), rate + h * w3);
        const Vec3 w4 = change(plus(turned, h, q3), rate + h * w3);
        turned = Quat(turned.coeffs() + h / 6 * (q1.coeffs() + 2 * q2.coeffs() + 2 * q3.coeffs() + q4.coeffs())).normalized();
        rate += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
    }
};

struct Tumbler {
    std::string name;
    double mass = 1;
    Vec3 size{0.3, 0.2, 0.1};
    Vec3 rate{0.01, 6, 0.01}; ///< body's axes
    Quat turned = Quat::Identity();
};

Vec3 momentsOf(const Tumbler& t) { return massOfBox(t.mass, t.size).inertia.diagonal(); }

/// Gives a body at rest an angular momentum in its next tick, by two opposite forces.
void spinUp(World& world, const std::string& path, const Vec3& momentum) {
    const Vec3 arm = momentum.unitOrthogonal(), force = momentum.cross(arm) / (2 * world.experiment().settings.tick);
    const Vec3 at = position(world, path);
    (void)world.push(path, force, at + arm);
    (void)world.push(path, -force, at - arm);
}

Quat rotation(World& world, const std::string& path) {
    const double* p = slot(world, path + "/pose");
    return {p[3], p[4], p[5], p[6]};
}

Vec3 momentum(World& world, const Vec3& moments) {
    const Quat q = rotation(world, "b/body");
    return q * moments.cwiseProduct(q.conjugate() * spin(world, "b/body"));
}

double energy(World& world, const Vec3& moments) { return momentum(world, moments).dot(spin(world, "b/body")) / 2; }

std::vector<Tumbler> tumblers() {
    std::vector<Tumbler> list{{"middle axis", 1, {0.3, 0.2, 0.1}, {0.01, 6, 0.01}, Quat::Identity()},
                              {"largest moment", 2, {0.3, 0.2, 0.1}, {0.5, 0.3, 8}, Quat::Identity()},
                              {"smallest moment", 2, {0.3, 0.2, 0.1}, {9, 0.5, 0.3}, Quat::Identity()},
                              {"rod", 0.5, {0.6, 0.02, 0.02}, {5, 3, -2}, Quat::Identity()},
                              {"plate", 0.5, {0.3, 0.3, 0.005}, {3, 1, 7}, Quat::Identity()},
                              {"fast", 0.1, {0.05, 0.03, 0.02}, {20, -60, 35}, Quat::Identity()}};
    std::mt19937 random(17);
    const auto from = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967295.0; };
    for (int i = 0; i < 14; ++i) {
        Tumbler t;
        t.name = "random " + std::to_string(i);
        t.mass = std::pow(10, from(-2, 2));
        t.size = std::pow(10, from(-1.5, 0)) * Vec3(from(0.2, 1), from(0.2, 1), from(0.2, 1));
        t.rate = Vec3(from(-1, 1), from(-1, 1), from(-1, 1)) * std::pow(10, from(-0.5, 1.3));
        t.turned = rotationFromHpr(degrees(from(-180, 180), from(-80, 80), from(-180, 180)));
        list.push_back(t);
    }
    return list;
}

void addTumblers() {
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("h");
    int index = 0;
    for (const Tumbler& t : tumblers()) {
        for (const double h : kTicks) QTest::addRow("%s, %g ms", t.name.c_str(), 1e3 * h) << index << h;
        ++index;
    }
}

Scene sceneOf(const Tumbler& t, double h) {
    Scene scene(h);
    scene.spec->settings.gravity = Vec3::Zero();
    scene.loose("b", {{0, 0, 1}, t.turned}, massOfBox(t.mass, t.size), {box("b", t.size)});
    return scene;
}

/// A top on a ball joint: a disc on a rod without mass.
struct Top {
    std::string name;
    double mass = 1, radius = 0.1, arm = 0.1, tilt = 30, spin = 60; ///< tilt in degrees from the vertical
    double squash = 1;                                              ///< of the inertia about y
};

MassProperties massOf(const Top& t) {
    MassProperties mass = massOfCylinder(t.mass, t.radius, 0.02);
    mass.inertia(1, 1) *= t.squash;
    return mass;
}

std::vector<Top> tops() {
    std::vector<Top> list{{"disc", 1, 0.1, 0.1, 30, 60, 1},
                          {"level", 1, 0.1, 0.05, 90, 50, 1},
                          {"hanging", 1, 0.1, 0.1, 150, 40, 1},
                          {"not symmetric", 1, 0.1, 0.05, 40, 60, 1.2}};
    std::mt19937 random(18);
    const auto from = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967295.0; };
    for (int i = 0; i < 8; ++i) {
        Top t;
        t.name = "random " + std::to_string(i);
        t.mass = std::pow(10, from(-1, 1));
        t.radius = from(0.05, 0.3);
        t.arm = from(0.3, 1) * t.radius;
        t.tilt = from(15, 160);
        // Fast enough not to fall: I3 w > 2 sqrt(m g arm I1) times a margin.
        const double i3 = t.mass * t.radius * t.radius / 2, i1 = i3 / 2 + t.mass * t.arm * t.arm;
        t.spin = from(1.2, 2.5) * 2 * std::sqrt(t.mass * g * t.arm * i1) / i3;
        list.push_back(t);
    }
    return list;
}

} // namespace

class RotationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void tumbling_data() { addTumblers(); }
    /// Over 30 s: momentum within 1e-6, energy within 0.5 %.
    void tumbling() {
        QFETCH(int, index);
        QFETCH(double, h);
        const Tumbler t = tumblers()[static_cast<std::size_t>(index)];
        const Vec3 moments = momentsOf(t);
        auto world = sceneOf(t, h).build();
        QVERIFY(world);
        const Vec3 given = t.turned * moments.cwiseProduct(t.rate);
        spinUp(*world, "b/body", given);
        QVERIFY(world->tick().ok());
        const double e0 = t.rate.dot(moments.cwiseProduct(t.rate)) / 2;
        double lost = 0, off = 0;
        while (world->time() < 30) {
            QVERIFY(world->tick().ok());
            off = std::max(off, (momentum(*world, moments) - given).norm() / given.norm());
            lost = std::max(lost, std::abs(energy(*world, moments) / e0 - 1));
        }
        qInfo("momentum off by %.2g, energy by %.2g", off, lost);
        QVERIFY(off < 1e-6);
        QVERIFY(lost < 5e-3);
    }

    void flips_data() { addTumblers(); }
    /// Times at which the rate about any of the body's axes changes its sign, over 30 s: within 2 %.
    void flips() {
        QFETCH(int, index);
        QFETCH(double, h);
        const Tumbler t = tumblers()[static_cast<std::size_t>(index)];
        const Vec3 moments = momentsOf(t);
        auto world = sceneOf(t, h).build();
        spinUp(*world, "b/body", t.turned * moments.cwiseProduct(t.rate));
        Gyro reference;
        reference.inertia = moments.asDiagonal();
        reference.turned = t.turned;
        reference.rate = t.rate;
        const double fine = h / std::max(4.0, std::ceil(h * t.rate.norm() / 0.01));
        const auto steps = static_cast<int>(std::lround(h / fine));
        std::array<std::vector<double>, 3> seen, expected;
        const auto record = [](const Vec3& before, const Vec3& after, double time, double dt, auto& list) {
            for (int k = 0; k < 3; ++k)
                if (before[k] * after[k] < 0)
                    list[static_cast<std::size_t>(k)].push_back(time - dt * after[k] / (after[k] - before[k]));
        };
        Vec3 last = reference.rate;
        while (world->time() < 30) {
            const double from = world->time();
            for (int i = 0; i < steps; ++i) {
                const Vec3 before = reference.rate;
                reference.step(fine);
                record(before, reference.rate, from + fine * (i + 1), fine, expected);
            }
            QVERIFY(world->tick().ok());
            const Vec3 now = rotation(*world, "b/body").conjugate() * spin(*world, "b/body");
            record(last, now, world->time(), h, seen);
            last = now;
        }
        double worst = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            QVERIFY(std::abs(static_cast<double>(seen[k].size()) - static_cast<double>(expected[k].size())) <= 1);
            for (std::size_t i = 0; i < std::min(seen[k].size(), expected[k].size()); ++i)
                worst = std::max(worst, std::abs(seen[k][i] - expected[k][i]) / std::max(1.0, expected[k][i]));
        }
        // How far the orientation is off in the end.
        const double away = rotation(*world, "b/body").angularDistance(reference.turned) * 180 / kPi;
        qInfo("%zu flips about y, %zu expected, times within %.3f %%, turned within %.2g deg", seen[1].size(), expected[1].size(),
              100 * worst, away);
        QVERIFY(worst < 0.02);
    }

    void precession_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<double>("h");
        int index = 0;
        for (const Top& t : tops()) {
            for (const double h : kTicks) QTest::addRow("%s, %g ms", t.name.c_str(), 1e3 * h) << index << h;
            ++index;
        }
    }
    /// The angle by which a heavy top has gone round the vertical: within 2 %.
    void precession() {
        QFETCH(int, index);
        QFETCH(double, h);
        const Top t = tops()[static_cast<std::size_t>(index)];
        const MassProperties mass = massOf(t);
        Scene scene(h);
        auto config = std::make_shared<RobotConfigSpec>();
        const Quat tilted = rotationFromHpr(degrees(0, t.tilt, 0));
        config->bodies.push_back(body("body", {tilted * Vec3(0, 0, t.arm), tilted}, mass, {}));
        config->joints.push_back(joint("tip", JointType::Ball, kWorldBody, 0, Vec3::Zero(), Vec3::UnitZ()));
        scene.robot("b", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        Gyro reference;
        reference.inertia = mass.inertia;
        reference.inertia(0, 0) += t.mass * t.arm * t.arm;
        reference.inertia(1, 1) += t.mass * t.arm * t.arm;
        reference.arm = Vec3(0, 0, t.mass * t.arm);
        reference.gravity = Vec3(0, 0, -g);
        reference.turned = tilted;
        reference.rate = Vec3(0, 0, t.spin);
        spinUp(*world, "b/body", tilted * Vec3(0, 0, mass.inertia(2, 2) * t.spin));
        const double fine = h / std::ceil(h * t.spin / 0.01);
        const auto azimuth = [](const Vec3& p) { return std::atan2(p.y(), p.x()); };
        double round = 0, expected = 0, a = azimuth(tilted * Vec3::UnitZ()), b = a;
        const auto unwrap = [](double step) { return step - 2 * kPi * std::nearbyint(step / (2 * kPi)); };
        while (world->time() < 10) {
            for (int i = 0; i < static_cast<int>(std::lround(h / fine)); ++i) {
                reference.step(fine);
                const double now = azimuth(reference.turned * Vec3::UnitZ());
                expected += unwrap(now - b);
                b = now;
            }
            QVERIFY(world->tick().ok());
            const double now = azimuth(position(*world, "b/body"));
            round += unwrap(now - a);
            a = now;
        }
        qInfo("h w %.2g, %.2f deg round, expected %.2f: %+.2f %%", h * t.spin, round * 180 / kPi, expected * 180 / kPi,
              100 * (round / expected - 1));
        QVERIFY(std::abs(round / expected - 1) < 0.02);
    }

    void spinsOnAFloor_data() {
        QTest::addColumn<double>("h");
        for (const double h : {0.001, 0.005, 0.01}) QTest::addRow("%g ms", 1e3 * h) << h;
    }
    /// A fast top on a frictionless floor: nothing turns it about the vertical, and its lean stays.
    void spinsOnAFloor() {
        QFETCH(double, h);
        const double lean = 20 * kPi / 180, mass = 0.3, arm = 0.05, rate = 120;
        const Vec3 moments(0.0004, 0.0004, 0.0005);
        Scene scene(h);
        const auto ice = scene.surface(0);
        scene.scenery({plane("floor", {}, ice)});
        const Quat tilted = rotationFromHpr(Vec3(0, lean, 0));
        scene.loose("b", {Vec3(0, 0, 0.002), tilted}, {mass, {0, 0, arm}, Mat3(moments.asDiagonal())},
                    {sphere("tip", 0.002, {}, ice)});
        auto world = scene.build();
        QVERIFY(world);
        // Steady precession about the vertical, of the centre of mass as the fixed point.
        const double axial = moments.z() * rate, up = moments.x() * std::cos(lean);
        const double round = (axial - std::sqrt(axial * axial - 4 * up * mass * g * arm)) / (2 * up);
        const Vec3 axis = tilted * Vec3::UnitZ(), aside = round * (Vec3::UnitZ() - std::cos(lean) * axis);
        spinUp(*world, "b/body", axial * axis + moments.x() * aside);
        QVERIFY(world->tick().ok());
        const double start = momentum(*world, moments).z();
        for (int i = 0; i < 15; ++i) {
            QVERIFY(run(*world, 0.1));
            const double now = momentum(*world, moments).z();
            const double leans = std::acos((rotation(*world, "b/body") * Vec3::UnitZ()).z()) * 180 / kPi;
            QVERIFY2(std::abs(now / start - 1) < 5e-4, qPrintable(QString("momentum %1 of %2").arg(now).arg(start)));
            QVERIFY2(std::abs(leans - 20) < 0.5, qPrintable(QString("leans by %1 degrees").arg(leans)));
        }
    }
};

QTEST_APPLESS_MAIN(RotationTest)
#include "rotation_test.moc"
