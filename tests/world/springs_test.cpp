// Springs and dampers swing as their equations say, and what stands at its rest height stays there from the first tick.
#include <QtTest>

#include "world/fixtures.h"
#include "world/spring_row.h"

using namespace fixture;

namespace {

/// An oscillation: circular frequency without damping (rad/s) and decay (1/s).
struct Swing {
    double frequency = 0, decay = 0;
};

/// The oscillation of samples at each tick about 0: x'' = T x' - D x by least squares.
Swing swingOf(const std::vector<double>& x, double tick) {
    double a = 0, b = 0, c = 0, p = 0, q = 0;
    for (std::size_t i = 2; i < x.size(); ++i) {
        a += x[i - 1] * x[i - 1];
        b += x[i - 1] * x[i - 2];
        c += x[i - 2] * x[i - 2];
        p += x[i] * x[i - 1];
        q += x[i] * x[i - 2];
    }
    const double det = a * c - b * b, sum = (p * c - q * b) / det, product = -(q * a - p * b) / det;
    const double decay = -std::log(product) / (2 * tick), turn = std::acos(sum / (2 * std::sqrt(product))) / tick;
    return {std::hypot(turn, decay), decay};
}

struct Spring {
    double frequency = 5, ratio = 0, inertia = 1; ///< Hz, of critical damping, kg or kg m^2
    [[nodiscard]] double w() const { return 2 * kPi * frequency; }
    [[nodiscard]] double stiffness() const { return inertia * w() * w(); }
    [[nodiscard]] double damping() const { return 2 * ratio * inertia * w(); }
    /// Long enough for some swings, short enough not to die out.
    [[nodiscard]] double seconds() const { return std::min(6 / frequency, ratio > 0 ? 3 / (ratio * w()) : 1e9); }
};

void addSprings(const std::vector<double>& ratios = {0.0, 0.05, 0.4}) {
    QTest::addColumn<double>("tick");
    QTest::addColumn<double>("frequency");
    QTest::addColumn<double>("ratio");
    QTest::addColumn<double>("inertia");
    for (const double tick : {0.005, 0.01, 0.03})
        for (const double frequency : {1.0, 2.5, 5.0, 8.0, 13.0, 20.0})
            for (const double ratio : ratios)
                for (const double inertia : {0.05, 2.0, 60.0})
                    if (2 * kPi * frequency * tick < 1.55)
                        QTest::addRow("%g Hz, %g of critical, %g kg, %g ms", frequency, ratio, inertia, 1e3 * tick)
                            << tick << frequency << ratio << inertia;
}

/// Period within 0.5 %, decay within 2 % of critical.
void check(const Swing& measured, const Swing& expected) {
    const double period = expected.frequency / measured.frequency - 1,
                 decay = (measured.decay - expected.decay) / expected.frequency;
    qInfo("period %+.4f %%, decay %+.4f %% of critical", 100 * period, 100 * decay);
    QVERIFY(std::abs(period) < 5e-3);
    QVERIFY(std::abs(decay) < 2e-2);
}

BodySpec block(const std::string& name, const Vec3& position, double mass, double inertia, std::vector<GeomSpec> geoms = {}) {
    return body(name, {position, Quat::Identity()}, {mass, Vec3::Zero(), Mat3(Vec3::Constant(inertia).asDiagonal())},
                std::move(geoms));
}

} // namespace

class SpringsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sliderSwings_data() { addSprings(); }
    void sliderSwings() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        QFETCH(double, inertia);
        const Spring spring{frequency, ratio, inertia};
        Scene scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("block", {0, 0, 1}, inertia, inertia));
        config->joints.push_back(joint("axle", JointType::Slider, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
        config->joints[0].stiffness = spring.stiffness();
        config->joints[0].damping = spring.damping();
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("r/block", {0, 0, 0.1 * inertia * spring.w() / tick}, {0, 0, 1}).ok());
        check(swing(*world, "r/axle/position", spring.seconds(), 0), {spring.w(), spring.ratio * spring.w()});
    }

    void hingeSwings_data() { addSprings(); }
    /// A torsion spring between two free bodies: the inertia is I1 I2 / (I1 + I2).
    void hingeSwings() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        QFETCH(double, inertia);
        const Spring spring{frequency, ratio, inertia * 3 / 4};
        Scene scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("base", {0, 0, 1}, 1, 3 * inertia));
        config->bodies.push_back(block("top", {0, 0, 1.2}, 2, inertia));
        config->joints.push_back(joint("axle", JointType::Hinge, 0, 1, {0, 0, 1.1}, Vec3::UnitZ()));
        config->joints[0].stiffness = spring.stiffness();
        config->joints[0].damping = spring.damping();
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        const double push = 0.1 * spring.inertia * spring.w() / tick;
        QVERIFY(world->push("r/top", {0, push / 2, 0}, {1, 0, 1.2}).ok());
        QVERIFY(world->push("r/top", {0, -push / 2, 0}, {-1, 0, 1.2}).ok());
        check(swing(*world, "r/axle/position", spring.seconds(), 0), {spring.w(), spring.ratio * spring.w()});
    }

    void suspensionSwings_data() { addSprings(); }
    /// A quarter of a car, guided by a slider, on a light wheel that stands on the floor.
    void suspensionSwings() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        QFETCH(double, inertia);
        const Spring spring{frequency, ratio, inertia};
        const double wheelMass = 0.02 * inertia;
        Scene scene(tick);
        scene.surface(0);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("car", {0, 0, 0.5}, inertia, inertia));
        config->bodies.push_back(block("wheel", {0, 0, 0.1}, wheelMass, wheelMass, {sphere("tyre", 0.1, {}, 1)}));
        config->joints.push_back(joint("guide", JointType::Slider, kWorldBody, 0, {0, 0, 0.5}, Vec3::UnitZ()));
        config->joints.push_back(joint("spring", JointType::Suspension, 0, 1, {0, 0, 0.1}, Vec3::UnitZ()));
        config->joints[1].axis2 = Vec3::UnitY();
        config->joints[1].stiffness = spring.stiffness();
        config->joints[1].damping = spring.damping();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        // It settles while the test damps it, and is kicked so that the wheel stays on the floor.
        const double contact = 40 * std::max(2e5, 1.02 * inertia * g / 1e-4),
                     sag = inertia * g / spring.stiffness() + 1.02 * inertia * g / contact;
        while (world->time() < 12 / frequency) {
            QVERIFY(
                world->push("r/car", Vec3(0, 0, -0.6 * inertia * spring.w() * velocity(*world, "r/car").z()), {0, 0, 0.5}).ok());
            QVERIFY(world->tick().ok());
        }
        QVERIFY(std::abs(value(*world, "r/guide/position") / -sag - 1) < 1e-3);
        QVERIFY(world->push("r/car", Vec3(0, 0, -0.4 * sag * inertia * spring.w() / tick), {0, 0, 0.5}).ok());
        check(swing(*world, "r/guide/position", spring.seconds(), -sag), {spring.w(), spring.ratio * spring.w()});
    }

    void carSettles_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("share"); // of a wheel in the mass
        QTest::addColumn<double>("drop");  // m
        for (const double tick : {0.005, 0.01, 0.03})
            for (const double frequency : {1.5, 4.0, 12.0})
                for (const double mass : {0.8, 15.0, 400.0})
                    for (const double share : {0.004, 0.08})
                        for (const double drop : {0.0, 0.05})
                            if (2 * kPi * frequency * tick < 1.55)
                                QTest::addRow("%g Hz, %g kg, wheels of %g, from %g m, %g ms", frequency, mass, share, drop,
                                              1e3 * tick)
                                    << tick << frequency << mass << share << drop;
    }
    /// A car on four suspended wheels lands, comes to rest where its springs carry it, and swings up and down at its frequency.
    void carSettles() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, mass);
        QFETCH(double, share);
        QFETCH(double, drop);
        const double ratio = 0.15;
        const Spring spring{frequency, ratio, mass / 4};
        Scene scene(tick);
        scene.surface(0.8);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("car", at(0, 0, 0.3), massOfBox(mass, {1, 0.6, 0.2}), {box("hull", {1, 0.6, 0.2}, {}, 1)}));
        for (const double x : {-0.4, 0.4})
            for (const double y : {-0.3, 0.3}) {
                const int index = static_cast<int>(config->bodies.size());
                config->bodies.push_back(body("wheel" + std::to_string(index), at(x, y, 0.1), massOfSphere(share * mass, 0.1),
                                              {sphere("tyre", 0.1, {}, 1)}));
                JointSpec j = joint("j" + std::to_string(index), JointType::Suspension, 0, index, {x, y, 0.1}, Vec3::UnitZ());
                j.axis2 = Vec3::UnitY();
                j.stiffness = spring.stiffness();
                j.damping = spring.damping();
                config->joints.push_back(j);
            }
        scene.scenery({plane("floor", {}, 1)}).robot("r", at(0, 0, drop), config);
        auto world = scene.build();
        QVERIFY(world);
        double most = 0;
        while (world->time() < 10 / frequency + 1) {
            QVERIFY(world->tick().ok());
            most = std::max(most, velocity(*world, "r/car").norm());
        }
        const double sag = g / (spring.w() * spring.w());
        if (sag > 0.15) return; // on its belly
        QVERIFY(most < 1.1 * (std::sqrt(2 * g * drop) + sag * spring.w()) + g * tick);
        QVERIFY2(velocity(*world, "r/car").norm() < 2e-3 * most, qPrintable(QString::number(velocity(*world, "r/car").norm())));
        QVERIFY(std::abs((0.3 - position(*world, "r/car").z()) / sag - 1) < 0.02);
        QVERIFY(world->push("r/car", Vec3(0, 0, -0.4 * sag * mass * spring.w() / tick), position(*world, "r/car")).ok());
        const Swing measured = swing(*world, "r/car/pose", 3 / frequency, position(*world, "r/car").z(), 2);
        check(measured, {spring.w(), ratio * spring.w()});
    }

    void hangingWheelSwings_data() { addSprings(); }
    void hangingWheelSwings() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        QFETCH(double, inertia);
        const Spring spring{frequency, ratio, inertia};
        Scene scene(tick);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("frame", {0, 0, 1}, 5, 1));
        config->bodies.push_back(block("wheel", {0, 0, 0.5}, inertia, inertia));
        config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
        config->joints.push_back(joint("spring", JointType::Suspension, 0, 1, {0, 0, 0.5}, Vec3::UnitZ()));
        config->joints[1].axis2 = Vec3::UnitY();
        config->joints[1].stiffness = spring.stiffness();
        config->joints[1].damping = spring.damping();
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        check(swing(*world, "r/wheel/pose", spring.seconds(), 0.5 - inertia * g / spring.stiffness(), 2),
              {spring.w(), spring.ratio * spring.w()});
    }

    void softContactSwings_data() { addSprings({0}); }
    /// A ball, and a crate on four points, on a floor that gives: a spring that only pushes.
    void softContactSwings() {
        QFETCH(double, tick);
        QFETCH(double, frequency);
        QFETCH(double, inertia);
        for (const bool crate : {false, true}) {
            const Spring spring{frequency, 0, inertia};
            const double weight = inertia * g, own = std::max(2e5, weight / ((crate ? 3 : 1) * 1e-4)), points = crate ? 4 : 1;
            Scene scene(tick);
            const auto soft = scene.surface(0.5, 0, 0, points / spring.stiffness() - 1 / own), hard = scene.surface(0.5);
            const double sag = weight / spring.stiffness();
            scene.scenery({plane("floor", {}, soft)});
            if (crate)
                scene.loose("b", at(0, 0, 1 - 0.7 * sag), massOfBox(inertia, {2, 2, 2}), {box("box", {2, 2, 2}, {}, hard)});
            else scene.ball("b", {0, 0, 1 - 0.7 * sag}, inertia, 1, hard);
            auto world = scene.build();
            QVERIFY(world);
            check(swing(*world, "b/body/pose", spring.seconds(), 1 - sag, 2), {spring.w(), 0});
        }
    }

    void hopsNoHigher_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<int>("kind");                 // slider, suspension, spring
        for (const double tick : {0.002, 0.005, 0.01}) // the foot swings by 0.9 rad in 10 ms
            for (const int kind : {0, 1, 2}) QTest::addRow("kind %d, %g ms", kind, 1e3 * tick) << tick << kind;
    }
    /// A weight on a foot with an undamped spring, dropped: each landing costs what the foot had. Until the
    /// tick ends the spring does not feel it, which may add some percent. Rates are those of half a tick before.
    void hopsNoHigher() {
        QFETCH(double, tick);
        QFETCH(int, kind);
        const double top = 2, foot = 0.2, k = 1500, drop = 0.01, start = (top + foot) * g * drop;
        Scene scene(tick);
        scene.surface(1);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("top", {0, 0, 0.4}, top, 0.01));
        config->bodies.push_back(block("foot", {0, 0, 0.05}, foot, 1e-3, {sphere("pad", 0.05, {}, 1)}));
        config->joints.push_back(joint("rail", JointType::Slider, kWorldBody, 0, {0, 0, 0.4}, Vec3::UnitZ()));
        config->joints.push_back(
            joint("leg", kind == 1 ? JointType::Suspension : JointType::Slider, 0, 1, {0, 0, 0.05}, Vec3::UnitZ()));
        config->joints[1].axis2 = Vec3::UnitY();
        if (kind < 2) config->joints[1].stiffness = k;
        else {
            SpringSpec spring;
            spring.name = "coil";
            spring.parent = 0;
            spring.child = 1;
            spring.anchor = {0, 0, 0.4};
            spring.anchor2 = {0, 0, 0.05};
            spring.length = 0.35;
            spring.stiffness = k;
            config->springs.push_back(spring);
        }
        scene.scenery({plane("floor", {}, 1)}).robot("r", at(0, 0, drop), config);
        auto world = scene.build();
        QVERIFY(world);
        double most = 0;
        while (world->time() < 8) {
            QVERIFY(world->tick().ok());
            const double zt = position(*world, "r/top").z() - 0.4, zf = position(*world, "r/foot").z() - 0.05,
                         vt = velocity(*world, "r/top").z(), vf = velocity(*world, "r/foot").z(), q = zt - zf;
            const double energy = g * (top * zt + foot * zf) + (top * vt * vt + foot * vf * vf + k * q * q) / 2,
                         half = tick / 2 * (k * q * (vt - vf) + g * (top * vt + foot * vf));
            most = std::max(most, energy - half);
            QVERIFY2(energy - half < 1.1 * start, qPrintable(QString::number((energy - half) / start)));
        }
        qInfo("%.4f of the energy at the start", most / start);
    }

    void bouncesNoHigherOnSoftGround_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("turn"); // rad per tick
        for (const double tick : {0.002, 0.01, 0.02})
            for (const double turn : {0.3, 1.0, 1.5}) QTest::addRow("%g rad, %g ms", turn, 1e3 * tick) << tick << turn;
    }
    /// A ball on ground that gives, dropped: no bounce is higher than the one before.
    void bouncesNoHigherOnSoftGround() {
        QFETCH(double, tick);
        QFETCH(double, turn);
        const double own = 2e5, height = 0.3, stiffness = std::pow(turn / tick, 2), mass = std::min(1.0, own / 2 / stiffness);
        Scene scene(tick);
        const auto soft = scene.surface(0.5, 0, 0, 1 / (mass * stiffness) - 1 / own), hard = scene.surface(0.5);
        scene.scenery({plane("floor", {}, soft)}).ball("b", {0, 0, 0.1 + height}, mass, 0.1, hard);
        auto world = scene.build();
        QVERIFY(world);
        double last = height * (1 + 1e-6);
        bool flew = true;
        double at = 0;
        while (world->time() < 20) {
            QVERIFY(world->tick().ok());
            const double z = position(*world, "b/body").z() - 0.1, v = velocity(*world, "b/body").z();
            if (z <= 0) {
                flew = false;
                continue;
            }
            at = z + v * v / (2 * g) - tick * v / 2; // of its top; the rate is that of half a tick before
            if (!flew) QVERIFY2(at < last * (1 + 1e-6) + 1e-9, qPrintable(QString("%1 after %2").arg(at).arg(last)));
            if (!flew) last = std::min(last, at);
            flew = true;
        }
        qInfo("%.4f of the height", at / height);
    }

    void staysAtItsRest_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("mass");
        QTest::addColumn<bool>("solid");
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const double degrees : {0.0, 5.0, 15.0, 25.0})
                for (const double heading : {0.0, 37.0})
                    for (const double mass : {0.1, 1.0, 30.0})
                        for (const bool solid : {false, true})
                            QTest::addRow("%g deg, turned by %g, %g kg, %s, %g ms", degrees, heading, mass,
                                          solid ? "box" : "plane", 1e3 * tick)
                                << tick << degrees << heading << mass << solid;
    }
    /// A crate placed on a slope that holds it neither jumps nor slips.
    void staysAtItsRest() {
        QFETCH(double, tick);
        QFETCH(double, degrees);
        QFETCH(double, heading);
        QFETCH(double, mass);
        QFETCH(bool, solid);
        Scene scene(tick);
        const auto s = scene.surface(0.6);
        const Quat slope = rotationFromHpr(fixture::degrees(0, degrees, 0)),
                   turned = slope * rotationFromHpr(fixture::degrees(heading, 0, 0));
        if (solid) scene.scenery({box("slope", {20, 20, 1}, {slope * Vec3(0, 0, -0.5), slope}, s)});
        else scene.scenery({plane("slope", {Vec3::Zero(), slope}, s)});
        const Vec3 size(0.4, 0.3, 0.1), start = slope * Vec3(0.3, -0.2, 0.05), normal = slope * Vec3::UnitZ();
        scene.loose("crate", {start, turned}, massOfBox(mass, size), {box("crate", size, {}, s)});
        auto world = scene.build();
        QVERIFY(world);
        double slip = 0, rise = 0;
        while (world->time() < 1) {
            QVERIFY(world->tick().ok());
            const Vec3 moved = position(*world, "crate/body") - start;
            slip = std::max(slip, (moved - moved.dot(normal) * normal).norm());
            rise = std::max(rise, moved.dot(normal));
        }
        qInfo("slip %.4f mm, rise %.4f mm", 1e3 * slip, 1e3 * rise);
        QVERIFY(slip < (tick > 0.02 ? 1e-3 : 1e-4));
        QVERIFY(rise < 1e-5);
    }

    void parkedRobotStays_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("heading");
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const double degrees : {0.0, 10.0, 15.0}) // from 18 on it tips over nose down
                for (const double heading : {0.0, 90.0, 180.0, 30.0})
                    QTest::addRow("%g deg, turned by %g, %g ms", degrees, heading, 1e3 * tick) << tick << degrees << heading;
    }
    /// A robot whose motors hold its wheels, parked on a slope in any direction.
    void parkedRobotStays() {
        QFETCH(double, tick);
        QFETCH(double, degrees);
        QFETCH(double, heading);
        Scene scene = r0Scene(tick);
        const Quat slope = rotationFromHpr(fixture::degrees(0, degrees, 0));
        scene.scenery({plane("slope", {Vec3::Zero(), slope}, 1)});
        scene.robot("r", {Vec3::Zero(), slope * rotationFromHpr(fixture::degrees(heading, 0, 0))}, r0());
        auto world = scene.build();
        QVERIFY(world);
        double slip = 0;
        const Vec3 normal = slope * Vec3::UnitZ(), start = position(*world, "r/chassis");
        while (world->time() < 1) {
            command(*world, "r/leftMotor", 0, 0, 5.4);
            command(*world, "r/rightMotor", 0, 0, 5.4);
            QVERIFY(world->tick().ok());
            const Vec3 moved = position(*world, "r/chassis") - start;
            slip = std::max(slip, (moved - moved.dot(normal) * normal).norm());
        }
        qInfo("slip %.4f mm", 1e3 * slip);
        QVERIFY(slip < (tick > 0.02 ? 1e-3 : 1e-4));
    }

private:
    /// The swing of a signal about `rest`.
    static Swing swing(World& world, const std::string& signal, double seconds, double rest, int index = 0) {
        std::vector<double> x;
        const double tick = world.experiment().settings.tick;
        for (int i = 0; i < std::max(8.0, seconds / tick); ++i) {
            if (!world.tick()) return {};
            x.push_back(value(world, signal, index) - rest);
        }
        return swingOf(x, tick);
    }
};

QTEST_APPLESS_MAIN(SpringsTest)
#include "springs_test.moc"
