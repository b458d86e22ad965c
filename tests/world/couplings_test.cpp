// Springs between two bodies and gears between two joints, against their equations.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

BodySpec block(const std::string& name, const Vec3& position, double mass, double inertia, std::vector<GeomSpec> geoms = {}) {
    return body(name, {position, Quat::Identity()}, {mass, Vec3::Zero(), Mat3(Vec3::Constant(inertia).asDiagonal())},
                std::move(geoms));
}

SpringSpec spring(int parent, int child, const Vec3& anchor, const Vec3& anchor2, double stiffness, double damping) {
    SpringSpec s;
    s.name = "spring";
    s.parent = parent;
    s.child = child;
    s.anchor = anchor;
    s.anchor2 = anchor2;
    s.length = (anchor2 - anchor).norm();
    s.stiffness = stiffness;
    s.damping = damping;
    return s;
}

GearSpec gear(int joint, int other, double ratio) {
    GearSpec g;
    g.name = "gear";
    g.joint = joint;
    g.other = other;
    g.ratio = ratio;
    return g;
}

/// Circular frequency without damping (rad/s) and decay (1/s).
struct Swing {
    double frequency = 0, decay = 0;
};

/// x'' = T x' - D x by least squares, about 0.
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

Swing swing(World& world, const std::string& signal, double seconds, double rest) {
    std::vector<double> x;
    for (const double until = world.time() + seconds; world.time() < until;) {
        if (const auto ticked = world.tick(); !ticked.ok()) {
            qWarning("%s", ticked.error().message.c_str());
            return {};
        }
        x.push_back(value(world, signal) - rest);
    }
    return swingOf(x, world.time() / static_cast<double>(world.ticks()));
}

/// Period within 0.5 %, decay within 2 % of critical.
void check(const Swing& measured, double frequency, double decay) {
    const double period = frequency / measured.frequency - 1, more = (measured.decay - decay) / frequency;
    qInfo("period %+.4f %%, decay %+.4f %% of critical", 100 * period, 100 * more);
    QVERIFY(std::abs(period) < 5e-3);
    QVERIFY(std::abs(more) < 2e-2);
}

void addFrequencies() {
    QTest::addColumn<double>("frequency");
    QTest::addColumn<double>("ratio");
    for (const double frequency : {1.0, 2.5, 5.0, 10.0, 20.0})
        for (const double ratio : {0.0, 0.05, 0.3})
            QTest::addRow("%g Hz, %g of critical", frequency, ratio) << frequency << ratio;
}

double kinetic(World& world, const std::string& path, double mass, double inertia) {
    return mass * velocity(world, path).squaredNorm() / 2 + inertia * spin(world, path).squaredNorm() / 2;
}

} // namespace

class CouplingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void springSwings_data() { addFrequencies(); }
    /// Two free bodies: their reduced mass swings, their momentum stays.
    void springSwings() {
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        const double w = 2 * kPi * frequency, mass = 3.0 * 2.0 / 5.0;
        Scene scene(0.01);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("a", {0, 0, 1}, 3, 0.1));
        config->bodies.push_back(block("b", {0.6, 0, 1}, 2, 0.1));
        config->springs.push_back(spring(0, 1, {0, 0, 1}, {0.6, 0, 1}, mass * w * w, 2 * ratio * mass * w));
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("r/b", {0.05 * w * 2 / 0.01, 0, 0}, {0.6, 0, 1}).ok());
        check(swing(*world, "r/spring/length", std::min(6 / frequency, ratio > 0 ? 3 / (ratio * w) : 1e9), 0.6), w, ratio * w);
        const Vec3 momentum = 3 * velocity(*world, "r/a") + 2 * velocity(*world, "r/b");
        QVERIFY(std::abs(momentum.x() - 2 * 0.05 * w) < 1e-9 && std::abs(momentum.y()) < 1e-9);
    }

    void doorSwings_data() { addFrequencies(); }
    /// A door on a hinge, its spring at an angle on a lever: the inertia is that of the door about its hinge.
    void doorSwings() {
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        const double w = 2 * kPi * frequency, inertia = 0.3 + 2 * 0.25;
        Scene scene(0.01);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("door", {0.5, 0, 1}, 2, 0.3));
        config->joints.push_back(joint("hinge", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
        const Vec3 end(0.4, 0, 1), foot(0.4 - 0.3, -0.4, 1); // 3-4-5
        const double lever = 0.4 * 0.8, mass = inertia / (lever * lever);
        config->springs.push_back(spring(kWorldBody, 0, foot, end, mass * w * w, 2 * ratio * mass * w));
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("r/door", {0, 1e-3 * w * inertia / 0.5 / 0.01, 0}, {0.5, 0, 1}).ok());
        check(swing(*world, "r/hinge/position", std::min(6 / frequency, ratio > 0 ? 3 / (ratio * w) : 1e9), 0), w, ratio * w);
    }

    void armSpringsSwing_data() { addFrequencies(); }
    /// A cart guided up and down, on a trailing arm with a wheel on the ground, and a strut between them: what swings is the cart.
    void armSpringsSwing() {
        QFETCH(double, frequency);
        QFETCH(double, ratio);
        const double w = 2 * kPi * frequency, mass = 50;
        Scene scene(0.01);
        scene.surface(0);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("cart", {0, 0, 0.8}, mass, 1));
        config->bodies.push_back(block("arm", {-0.4, 0, 0.1}, 0.2, 1e-3));
        config->bodies.push_back(block("wheel", {-0.4, 0, 0.1}, 0.2, 1e-3, {sphere("tyre", 0.1, {}, 1)}));
        config->joints.push_back(joint("guide", JointType::Slider, kWorldBody, 0, {0, 0, 0.8}, Vec3::UnitZ()));
        config->joints.push_back(joint("pivot", JointType::Hinge, 0, 1, {0, 0, 0.1}, Vec3::UnitY()));
        config->joints.push_back(joint("axle", JointType::Hinge, 1, 2, {-0.4, 0, 0.1}, Vec3::UnitY()));
        // The strut stands upright at half the arm: it shortens by half of what the cart sinks.
        SpringSpec strut = spring(0, 1, {-0.2, 0, 0.6}, {-0.2, 0, 0.1}, 4 * mass * w * w, 8 * ratio * mass * w);
        const double load = 2 * mass * g;
        strut.length += load / strut.stiffness; // carries the cart as it stands
        config->springs.push_back(strut);
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(world->push("r/cart", Vec3(0, 0, -0.6 * mass * w * velocity(*world, "r/cart").z()), {0, 0, 0.8}).ok());
            QVERIFY(world->tick().ok());
        }
        const double rest = value(*world, "r/guide/position");
        QVERIFY(std::abs(rest) < 2e-3);
        QVERIFY(std::abs(value(*world, "r/spring/force") + load) < 0.02 * load); // pushes
        const double amplitude = std::min(0.004, 0.4 * g / (w * w));
        QVERIFY(world->push("r/cart", Vec3(0, 0, -amplitude * mass * w / 0.01), {0, 0, 0.8}).ok());
        check(swing(*world, "r/guide/position", std::min(6 / frequency, ratio > 0 ? 3 / (ratio * w) : 1e9), rest), w, ratio * w);
    }

    void springHangs() {
        Scene scene(0.01);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("load", {0, 0, 0.5}, 2, 0.01));
        config->springs.push_back(spring(kWorldBody, 0, {0, 0, 1}, {0, 0, 0.5}, 400, 30));
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 5));
        QVERIFY(std::abs(value(*world, "r/spring/force") - 2 * g) < 1e-6); // pulls
        QVERIFY(std::abs(value(*world, "r/spring/length") - (0.5 + 2 * g / 400)) < 1e-8);
        QVERIFY(std::abs(value(*world, "r/spring/rate")) < 1e-8);
    }

    void gearTrain_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<Vec3>("axis2");
        QTest::addColumn<Vec3>("place2");
        QTest::newRow("spur wheels") << -0.5 << Vec3(0, 0, 1) << Vec3(0.3, 0, 1);
        QTest::newRow("ring wheel") << 3.0 << Vec3(0, 0, 1) << Vec3(0.1, 0.1, 1);
        QTest::newRow("belt") << 1.0 << Vec3(0, 0, 1) << Vec3(0.3, 0.2, 1.1);
        QTest::newRow("belt, axis the other way") << -1.0 << Vec3(0, 0, -1) << Vec3(0.3, 0.2, 1.1);
        QTest::newRow("bevel") << 2.0 << Vec3(0, 1, 0) << Vec3(0, 0, 1);
        QTest::newRow("worm") << 0.05 << Vec3(0, 0.6, 0.8) << Vec3(0.2, 0.1, 0.9);
    }
    /// rate = ratio * other's rate; the torque T on the other wheel turns J2 + ratio^2 J1; no energy is lost, and the ends of the gear
    /// press on their common body alone.
    void gearTrain() {
        QFETCH(double, ratio);
        QFETCH(Vec3, axis2);
        QFETCH(Vec3, place2);
        for (const bool isFree : {false, true}) {
            const double j1 = 0.02, j2 = 0.05, base = 400;
            Scene scene(0.01);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(block("base", {0, 0, 1}, 1000, base));
            config->bodies.push_back(block("one", {0, 0, 1}, 1, j1));
            config->bodies.push_back(block("two", place2, 1, j2));
            config->joints.push_back(joint("first", JointType::Hinge, 0, 1, {0, 0, 1}, Vec3::UnitZ()));
            config->joints.push_back(joint("second", JointType::Hinge, 0, 2, place2, axis2));
            if (!isFree) config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
            config->gears.push_back(gear(0, 1, ratio));
            config->devices.push_back(row("motor", "second"));
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            command(*world, "r/motor", 1e6, 1e6 / 0.1, 0.1); // 0.1 N m whatever the rate
            QVERIFY(run(*world, 1));
            const double w1 = value(*world, "r/first/rate"), w2 = value(*world, "r/second/rate"),
                         expected = 0.1 / (j2 + ratio * ratio * j1);
            QVERIFY2(std::abs(w1 - ratio * w2) < 1e-6 * std::abs(w1), qPrintable(QString::number(w1 / w2, 'g', 12)));
            QVERIFY2(std::abs(w2 / expected - 1) < (isFree ? 2e-3 : 1e-4), qPrintable(QString::number(w2 / expected, 'g', 9)));
            QVERIFY(std::abs(value(*world, "r/first/position") - ratio * value(*world, "r/second/position")) < 1e-5);
            QVERIFY2(std::abs(value(*world, "r/gear/torque") / (j1 * ratio * expected) - 1) < 5e-3,
                     qPrintable(QString::number(value(*world, "r/gear/torque") / (j1 * ratio * expected))));
            // Efficiency 1, to and fro.
            const auto energy = [&] {
                return kinetic(*world, "r/one", 1, j1) + kinetic(*world, "r/two", 1, j2) + kinetic(*world, "r/base", 1000, base);
            };
            command(*world, "r/motor", 0, 0, 0);
            QVERIFY(run(*world, 0.02));
            const double before = energy();
            QVERIFY(run(*world, 3));
            QVERIFY2(std::abs(energy() / before - 1) < 1e-4, qPrintable(QString::number(energy() / before, 'g', 9)));
            if (!isFree) continue;
            const Vec3 spinOfAll = base * spin(*world, "r/base") + j1 * spin(*world, "r/one") + j2 * spin(*world, "r/two");
            const Vec3 momentum = 1000 * velocity(*world, "r/base") + velocity(*world, "r/one") + velocity(*world, "r/two");
            QVERIFY2(momentum.norm() < 1e-9, qPrintable(QString::number(momentum.norm())));
            QVERIFY2(spinOfAll.norm() < 2e-3 * (j1 * std::abs(w1) + j2 * std::abs(w2)),
                     qPrintable(QString::number(spinOfAll.norm())));
        }
    }

    void rack_data() {
        QTest::addColumn<Vec3>("way");
        QTest::addColumn<double>("ratio");
        QTest::newRow("rack, wheel of 5 cm") << Vec3(0, 1, 0) << 0.05;
        QTest::newRow("rack below") << Vec3(1, 0, 0) << -0.05;
        QTest::newRow("screw of 2 mm") << Vec3(0, 0, 1) << 0.002 / (2 * kPi);
        QTest::newRow("oblique") << Vec3(0.6, 0, 0.8) << 0.1;
    }
    /// The slider's ratio is in m/rad; in reverse the hinge is geared to the slider.
    void rack() {
        QFETCH(Vec3, way);
        QFETCH(double, ratio);
        for (const bool isReverse : {false, true}) {
            const double inertia = 0.02, mass = 3;
            Scene scene(0.01);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(block("pinion", {0, 0, 1}, 1, inertia));
            config->bodies.push_back(block("rack", {0.1, 0, 1}, mass, 0.1));
            config->joints.push_back(joint("turn", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
            config->joints.push_back(joint("slide", JointType::Slider, kWorldBody, 1, {0.1, 0, 1}, way));
            config->gears.push_back(isReverse ? gear(0, 1, 1 / ratio) : gear(1, 0, ratio));
            config->devices.push_back(row("motor", "turn"));
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            command(*world, "r/motor", 1e6, 1e6 / 0.1, 0.1);
            QVERIFY(run(*world, 1));
            const double expected = 0.1 / (inertia + ratio * ratio * mass);
            QVERIFY2(std::abs(value(*world, "r/turn/rate") / expected - 1) < 1e-4,
                     qPrintable(QString::number(value(*world, "r/turn/rate") / expected, 'g', 9)));
            const double shown = value(*world, "r/slide/rate") / (ratio * value(*world, "r/turn/rate"));
            QVERIFY2(std::abs(shown - 1) < 1e-6, qPrintable(QString::number(shown, 'g', 12)));
            QVERIFY(std::abs(value(*world, "r/slide/position") / (ratio * value(*world, "r/turn/position")) - 1) < 1e-5);
            if (!isReverse) QVERIFY(std::abs(value(*world, "r/gear/force") / (mass * ratio * expected) - 1) < 1e-3);
        }
    }

    /// Arms whose masses are off their axles keep the ratio as balanced wheels do.
    void gearsOfUnbalancedArms_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("ratio");
        for (const double tick : {0.002, 0.01, 0.03})
            for (const double ratio : {-0.5, 2.0}) QTest::addRow("ratio %g, %g ms", ratio, 1e3 * tick) << tick << ratio;
    }
    void gearsOfUnbalancedArms() {
        QFETCH(double, tick);
        QFETCH(double, ratio);
        for (const bool isFree : {false, true}) {
            Scene scene(tick);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(block("base", {0, 0, 1}, 20, 4));
            config->bodies.push_back(block("one", {0.1, 0, 1}, 0.25, 1e-3));   // axle at 0, 0
            config->bodies.push_back(block("two", {0.3, 0.06, 1}, 0.2, 1e-3)); // axle at 0.3, 0
            config->joints.push_back(joint("first", JointType::Hinge, 0, 1, {0, 0, 1}, Vec3::UnitZ()));
            config->joints.push_back(joint("second", JointType::Hinge, 0, 2, {0.3, 0, 1}, Vec3::UnitZ()));
            if (!isFree) config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
            config->gears.push_back(gear(0, 1, ratio));
            config->devices.push_back(row("motor", "second"));
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            command(*world, "r/motor", 20 / std::max(1.0, ratio), 0.01, 1);
            double rates = 0, positions = 0;
            for (int i = 0; i * tick < 3; ++i) {
                QVERIFY(world->tick().ok());
                if (i * tick < 1) continue;
                const double w1 = value(*world, "r/first/rate"), w2 = value(*world, "r/second/rate");
                rates = std::max(rates, std::abs(w1 / (ratio * w2) - 1));
                positions =
                    std::max(positions, std::abs(value(*world, "r/first/position") - ratio * value(*world, "r/second/position")));
            }
            QVERIFY2(rates < 1e-3 && positions < 1e-3,
                     qPrintable(QString("rates off by %1, positions by %2").arg(rates).arg(positions)));
            QVERIFY(std::abs(value(*world, "r/second/rate")) > 5);
        }
    }

    void commonBody_data() {
        QTest::addColumn<bool>("firstIsTurned");
        QTest::addColumn<bool>("secondIsTurned");
        for (const bool first : {false, true})
            for (const bool second : {false, true})
                QTest::addRow("%s, %s", first ? "child" : "parent", second ? "child" : "parent") << first << second;
    }
    /// The body in common may be the parent or the child of each joint; the rates are those of the joints, with their signs.
    void commonBody() {
        QFETCH(bool, firstIsTurned);
        QFETCH(bool, secondIsTurned);
        for (const double ratio : {-0.5, 3.0}) {
            const double j1 = 0.02, j2 = 0.05, expected = 0.1 / (j2 + ratio * ratio * j1);
            Scene scene(0.01);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(block("base", {0, 0, 1}, 1000, 400));
            config->bodies.push_back(block("one", {0, 0, 1}, 1, j1));
            config->bodies.push_back(block("two", {0.3, 0, 1}, 1, j2));
            const auto hinge = [](const char* name, bool isTurned, int wheel, const Vec3& place) {
                return joint(name, JointType::Hinge, isTurned ? wheel : 0, isTurned ? 0 : wheel, place, Vec3::UnitZ());
            };
            config->joints.push_back(hinge("first", firstIsTurned, 1, {0, 0, 1}));
            config->joints.push_back(hinge("second", secondIsTurned, 2, {0.3, 0, 1}));
            config->gears.push_back(gear(0, 1, ratio));
            config->devices.push_back(row("motor", "second"));
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            command(*world, "r/motor", 1e6, 1e6 / 0.1, 0.1); // 0.1 N m whatever the rate
            QVERIFY(run(*world, 1));
            const double w1 = value(*world, "r/first/rate"), w2 = value(*world, "r/second/rate");
            QVERIFY2(std::abs(w1 - ratio * w2) < 1e-4 * std::abs(w1), qPrintable(QString::number(w1 / w2, 'g', 12)));
            QVERIFY2(std::abs(w2 / expected - 1) < 5e-3, qPrintable(QString::number(w2 / expected, 'g', 9)));
            QVERIFY(std::abs(value(*world, "r/first/position") - ratio * value(*world, "r/second/position")) < 1e-4);
        }
    }

    void fingerCurls_data() {
        QTest::addColumn<bool>("isReverse");
        QTest::newRow("far geared to near") << false;
        QTest::newRow("near geared to far") << true; // the gear's end is in the world
    }
    /// A finger whose second link is geared to its first: the joints have the first link in common.
    void fingerCurls() {
        QFETCH(bool, isReverse);
        Scene scene(0.01);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("near", {0.05, 0, 1}, 0.1, 1e-3));
        config->bodies.push_back(block("far", {0.15, 0, 1}, 0.1, 1e-3));
        config->joints.push_back(joint("knuckle", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, Vec3::UnitY()));
        config->joints.push_back(joint("middle", JointType::Hinge, 0, 1, {0.1, 0, 1}, Vec3::UnitY()));
        config->gears.push_back(isReverse ? gear(0, 1, 1 / 0.7) : gear(1, 0, 0.7));
        config->devices.push_back(row("motor", "knuckle"));
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/motor", 1, 0, 5);
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(value(*world, "r/knuckle/rate") - 1) < 1e-6);
        const double off = value(*world, "r/middle/position") - 0.7 * value(*world, "r/knuckle/position");
        QVERIFY2(std::abs(off) < 2e-4, qPrintable(QString::number(off)));
        QVERIFY2(std::abs(value(*world, "r/middle/rate") - 0.7) < 1e-3, qPrintable(QString::number(value(*world, "r/middle/rate"))));
    }

    void refusesWhatNoForceCouples() {
        for (const bool isSlider : {false, true}) {
            Scene scene(0.01);
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(block("a", {0, 0, 1}, 1, 1));
            config->bodies.push_back(block("b", {0, 0, 2}, 1, 1));
            const JointType type = isSlider ? JointType::Slider : JointType::Hinge;
            config->joints.push_back(joint("first", type, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
            config->joints.push_back(joint("second", type, kWorldBody, 1, {0, 0, 2}, Vec3::UnitZ()));
            config->gears.push_back(gear(0, 1, -1));
            scene.robot("r", {}, config);
            QVERIFY(!scene.build());
            auto good = std::make_shared<RobotConfigSpec>(*config);
            good->gears[0].ratio = 1; // a shaft between them
            Scene other(0.01);
            other.robot("r", {}, good);
            QVERIFY(other.build());
        }
    }

    /// Couplings in the quick solver, and in what it iterates in short steps.
    void holdsInTheQuickSolver() {
        Scene scene(0.01);
        scene.spec->settings.solver = SolverChoice::Quick;
        scene.spec->settings.iterations = 200;
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(block("one", {0, 0, 1}, 1, 0.02));
        config->bodies.push_back(block("two", {0.3, 0, 1}, 1, 0.05));
        config->joints.push_back(joint("first", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
        config->joints.push_back(joint("second", JointType::Hinge, kWorldBody, 1, {0.3, 0, 1}, Vec3::UnitZ()));
        config->gears.push_back(gear(0, 1, -0.5));
        config->devices.push_back(row("motor", "second"));
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/motor", 1, 0, 5);
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(value(*world, "r/first/rate") + 0.5) < 0.01);
        QVERIFY(std::abs(value(*world, "r/first/position") + 0.5 * value(*world, "r/second/position")) < 0.01);
    }
};

QTEST_APPLESS_MAIN(CouplingsTest)
#include "couplings_test.moc"
