// Driving accuracy of R0 with a rate servo on each wheel: the values of the physics notes, measured at the middle of the axle.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kStall = 5.4;                                                       // N m, motor M0
constexpr double kNoLoad = 12 / (0.03 * 30), kDamping = 30.0 * 30 * 0.03 * 0.03 / 2; // rad/s, N m s/rad

/// Trapezoidal speed profile over `length` at cruising speed `speed` with ramps of `ramp` seconds.
struct Trapezoid {
    double length, speed, ramp;
    [[nodiscard]] double end() const { return length / speed + ramp; }
    [[nodiscard]] double at(double t) const {
        const double a = speed / ramp, T = end();
        if (t <= 0) return 0;
        if (t >= T) return length;
        if (t < ramp) return a * t * t / 2;
        if (t > T - ramp) return length - a * (T - t) * (T - t) / 2;
        return speed * (t - ramp / 2);
    }
};

struct PoseError {
    double along, across, heading;
};

/// Drives the amounts on R0 and gives the error against the integrated ideal motion, in the ideal end's frame.
PoseError drive(Scene& scene, double x, double theta, double seconds, double ramp) {
    auto world = scene.build();
    if (!world || !run(*world, 0.5)) return {1e9, 1e9, 1e9};
    const double h = scene.spec->settings.tick;
    const Pose start = world->robotPose(0);
    const Trapezoid unit{1, 1 / (seconds - ramp), ramp};
    Pose ideal = start;
    double heading = hprFromRotation(start.rotation).x();
    const auto ticks = static_cast<int>(std::ceil(seconds / h)) + static_cast<int>(0.5 / h);
    for (int k = 0; k < ticks; ++k) {
        const double t = static_cast<double>(k) * h, part = unit.at(t + h) - unit.at(t);
        const double v = x * part / h, w = theta * part / h;
        command(*world, "r/leftMotor", (v - w * kR0Track / 2) / kR0Radius, 0, kStall);
        command(*world, "r/rightMotor", (v + w * kR0Track / 2) / kR0Radius, 0, kStall);
        if (!world->tick()) return {1e9, 1e9, 1e9};
        const double turned = w * h, chord = turned == 0 ? v * h : v * h * std::sin(turned / 2) / (turned / 2);
        ideal.position += chord * Vec3(std::cos(heading + turned / 2), std::sin(heading + turned / 2), 0);
        heading += turned;
    }
    const Pose end = world->robotPose(0);
    const Vec3 off = rotationFromHpr({-heading, 0, 0}) * Vec3(end.position - ideal.position);
    const double turnError = std::remainder(hprFromRotation(end.rotation).x() - heading, 2 * kPi);
    return {off.x(), off.y(), turnError};
}

} // namespace

class DrivingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void driving_data() {
        QTest::addColumn<QString>("ground");
        QTest::addColumn<bool>("round");
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("turnDeg");
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("mostMm");
        QTest::addColumn<double>("mostDeg");
        const double circle = 0.3 * 2 * kPi;
        for (const char* engine : {"wheeled", "planar"}) {
            const auto row = [engine](const char* name, bool round = false, const char* ground = "") -> QTestData& {
                return QTest::addRow("%s: %s", engine, name) << engine + QString(ground) << round;
            };
            row("straight 5 m, 1 ms") << 0.001 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
            row("straight 5 m, 10 ms") << 0.01 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
            row("straight 5 m, 30 ms") << 0.03 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
            row("arc 360 deg, 10 ms") << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.1 << 0.02;
            row("arc 360 deg, 30 ms") << 0.03 << circle << 360.0 << 2 * kPi + 0.5 << 0.54 << 0.1;
            row("ten turns, 10 ms") << 0.01 << 10 * circle << 3600.0 << 20 * kPi + 0.5 << 0.62 << 0.12;
            row("spin W=4, 5 turns, 10 ms") << 0.01 << 0.0 << 1800.0 << 10 * kPi / 4 + 0.5 << 0.05 << 0.92;
            row("arc on a box, round wheels", true, " box") << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.1 << 0.02;
        }
        QTest::newRow("straight 5 m, 1 ms") << "plane" << false << 0.001 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
        QTest::newRow("straight 5 m, 10 ms") << "plane" << false << 0.01 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
        QTest::newRow("straight 5 m, 30 ms") << "plane" << false << 0.03 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
        QTest::newRow("arc 360 deg, 10 ms") << "plane" << false << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.1 << 0.02;
        QTest::newRow("arc 360 deg, 30 ms") << "plane" << false << 0.03 << circle << 360.0 << 2 * kPi + 0.5 << 0.54 << 0.1;
        QTest::newRow("ten turns, 10 ms") << "plane" << false << 0.01 << 10 * circle << 3600.0 << 20 * kPi + 0.5 << 0.62 << 0.12;
        QTest::newRow("spin W=4, 5 turns, 10 ms")
            << "plane" << false << 0.01 << 0.0 << 1800.0 << 10 * kPi / 4 + 0.5 << 0.05 << 0.92;
        QTest::newRow("straight on a box") << "box" << false << 0.01 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
        QTest::newRow("arc on a box") << "box" << false << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.1 << 0.02;
        QTest::newRow("straight, round wheels") << "plane" << true << 0.01 << 5.0 << 0.0 << 10.5 << 0.05 << 0.001;
        QTest::newRow("arc, round wheels") << "plane" << true << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.1 << 0.02;
        QTest::newRow("straight on a mesh") << "mesh" << false << 0.01 << 5.0 << 0.0 << 10.5 << 0.1 << 0.01;
        QTest::newRow("arc on a mesh") << "mesh" << false << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.2 << 0.05;
        QTest::newRow("straight on a heightfield") << "heights" << false << 0.01 << 5.0 << 0.0 << 10.5 << 0.1 << 0.01;
        QTest::newRow("arc on a heightfield") << "heights" << false << 0.01 << circle << 360.0 << 2 * kPi + 0.5 << 0.2 << 0.05;
    }
    void driving() {
        QFETCH(QString, ground);
        QFETCH(bool, round);
        QFETCH(double, tick);
        QFETCH(double, distance);
        QFETCH(double, turnDeg);
        QFETCH(double, seconds);
        QFETCH(double, mostMm);
        QFETCH(double, mostDeg);
        Scene scene = r0Scene(tick);
        if (ground.startsWith("wheeled")) scene.spec->settings.engine = EngineChoice::Wheeled;
        if (ground.startsWith("planar")) scene.spec->settings.engine = EngineChoice::Planar;
        if (ground == "plane" || ground == "wheeled" || ground == "planar") scene.scenery({plane("floor", {}, 1)});
        if (ground.endsWith("box")) scene.scenery({box("floor", {30, 30, 0.2}, at(0, 0, -0.1), 1)});
        if (ground == "mesh") scene.scenery({meshFloor()});
        if (ground == "heights") scene.scenery({heightFloor()});
        R0Options options;
        options.roundWheels = round;
        scene.robot("r", {}, r0(options));
        const PoseError e = drive(scene, distance, turnDeg * kPi / 180, seconds, 0.5);
        qInfo("along %.5f mm, across %.5f mm, heading %.6f deg", 1e3 * e.along, 1e3 * e.across, e.heading * 180 / kPi);
        QVERIFY(1e3 * std::hypot(e.along, e.across) <= mostMm);
        QVERIFY(std::abs(e.heading) * 180 / kPi <= mostDeg);
    }

    static GeomSpec meshFloor() {
        auto mesh = std::make_shared<TriangleMesh>();
        constexpr int n = 60;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) mesh->points.push_back({0.2 * (i - n / 2), 0.2 * (j - n / 2), 0});
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
                mesh->triangles.push_back({a, b, c});
                mesh->triangles.push_back({b, d, c});
            }
        GeomSpec geom = plane("mesh", {}, 1);
        geom.shape = GeomShape::Mesh;
        geom.mesh = mesh;
        return geom;
    }
    static GeomSpec heightFloor() {
        auto map = std::make_shared<HeightMap>();
        map->columns = map->rows = 41;
        map->heights.assign(41 * 41, 0.5f);
        GeomSpec geom = plane("hills", at(0, 0, -0.5), 1);
        geom.shape = GeomShape::Heightfield;
        geom.size = {14, 14, 1};
        geom.heightMap = map;
        return geom;
    }

    void voltageLag_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<int>("engine");
        for (const EngineChoice engine : {EngineChoice::General, EngineChoice::Wheeled, EngineChoice::Planar})
            for (const double tick : {0.001, 0.01, 0.03})
                QTest::addRow("%g ms, %s", 1e3 * tick, nameOf(engine)) << tick << static_cast<int>(engine);
    }
    /// Open loop with a ramp to 0.5 m/s: the lag is v tau, tau = (M r^2/2 + I)/b, at every tick length.
    void voltageLag() {
        QFETCH(double, tick);
        QFETCH(int, engine);
        Scene scene = r0Scene(tick);
        scene.spec->settings.engine = static_cast<EngineChoice>(engine);
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.6));
        const double x0 = world->robotPose(0).position.x();
        const Trapezoid ramp{100, 0.5, 0.5};
        const auto ticks = static_cast<int>(1.5 / tick);
        for (int k = 0; k < ticks; ++k) {
            const double rate = (ramp.at((k + 1) * tick) - ramp.at(k * tick)) / tick / kR0Radius;
            command(*world, "r/leftMotor", rate, 1 / kDamping, kStall);
            command(*world, "r/rightMotor", rate, 1 / kDamping, kStall);
            QVERIFY(world->tick().ok());
        }
        const double lag = ramp.at(ticks * tick) - (world->robotPose(0).position.x() - x0);
        qInfo("lag %.4f mm", 1e3 * lag);
        QVERIFY(std::abs(1e3 * lag - 7.099) < 0.07);
    }

    void stableInTheAir_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.01, 0.03, 0.05}) QTest::newRow(qPrintable(QString::number(tick))) << tick;
    }
    /// Wheels in the air (gravity off): no-load rate to six digits at any tick length.
    void stableInTheAir() {
        QFETCH(double, tick);
        Scene scene = r0Scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        scene.robot("r", at(0, 0, 1), r0());
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/leftMotor", kNoLoad, 1 / kDamping, kStall);
        command(*world, "r/rightMotor", kNoLoad, 1 / kDamping, kStall);
        QVERIFY(run(*world, 3));
        QVERIFY(std::abs(value(*world, "r/leftAxle/rate") / kNoLoad - 1) < 1e-6);
        QVERIFY(std::abs(value(*world, "r/rightAxle/rate") / kNoLoad - 1) < 1e-6);
    }

    /// The wheel's angle is the integral of its rate over many rotations.
    void angleIsTheSumOfRate() {
        Scene scene = r0Scene(0.03);
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/leftMotor", 10, 0, kStall);
        command(*world, "r/rightMotor", 10, 0, kStall);
        double sum = 0;
        for (int i = 0; i < 400; ++i) {
            QVERIFY(world->tick().ok());
            sum += value(*world, "r/leftAxle/rate") * 0.03;
        }
        QVERIFY(sum > 100);
        QVERIFY(std::abs(value(*world, "r/leftAxle/position") - sum) < 1e-6 * sum);
        QCOMPARE(value(*world, "r/leftMotor/position"), value(*world, "r/leftAxle/position"));
    }

    /// Negative tests: without gravity, friction or wheels a robot does not drive.
    void doesNotDrive_data() {
        QTest::addColumn<QString>("without");
        QTest::addColumn<bool>("drives");
        QTest::newRow("nothing missing") << "" << true;
        QTest::newRow("gravity off") << "gravity" << false;
        QTest::newRow("friction zero") << "friction" << false;
        QTest::newRow("wheels removed") << "wheels" << false;
    }
    void doesNotDrive() {
        QFETCH(QString, without);
        QFETCH(bool, drives);
        Scene scene = r0Scene(0.01, without == "friction" ? 0 : 1);
        if (without == "gravity") scene.spec->settings.gravity = Vec3::Zero();
        R0Options options;
        options.wheels = without != "wheels";
        scene.scenery({plane("floor", {}, 1)}).robot("r", at(0, 0, without == "gravity" ? 0.001 : 0), r0(options));
        auto world = scene.build();
        QVERIFY(world);
        if (options.wheels) {
            command(*world, "r/leftMotor", 5, 0, kStall);
            command(*world, "r/rightMotor", 5, 0, kStall);
        }
        QVERIFY(run(*world, 2));
        const double x = world->robotPose(0).position.x();
        qInfo("went %.4f m", x);
        QCOMPARE(x > 0.45, drives);
        if (!drives) QVERIFY(std::abs(x) < 0.05);
    }

    void alongAWall_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("angle");
        QTest::addColumn<int>("engine");
        for (const EngineChoice engine : {EngineChoice::General, EngineChoice::Wheeled, EngineChoice::Planar})
            for (const double tick : {0.005, 0.01, 0.03})
                for (const double angle : {5, 10, 13, 30})
                    QTest::addRow("%g degrees, %g ms, %s", angle, 1e3 * tick, nameOf(engine))
                        << tick << angle << static_cast<int>(engine);
    }
    /// A robot whose tyres stand flush with its hull drives against a wall. Its front corner, `ahead` of the axle and `aside`, meets the
    /// wall first: below an angle whose tangent is (ahead - mu aside) / (aside + mu ahead) that turns it along the wall, and it goes on at
    /// the speed of its wheels; above it the robot turns nose-on and stays. From 14 degrees on the wheels slip aside at this
    /// speed, and the blow at the start decides.
    void alongAWall() {
        QFETCH(double, tick);
        QFETCH(double, angle);
        QFETCH(int, engine);
        constexpr double ahead = 0.11, aside = 0.14, mu = 0.3, speed = 0.4, radius = 0.05, width = 0.03;
        const bool slides = angle < std::atan((ahead - mu * aside) / (aside + mu * ahead)) * 180 / kPi;
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        const Vec3 hull(0.30, 2 * aside, 0.10), centre(0.06 + ahead - 0.15, 0, 0.09);
        config->bodies[0].mass = massOfBox(2.1, hull, centre);
        config->bodies[0].geoms = {box("hull", hull, {centre, Quat::Identity()}, 3),
                                   sphere("slider", 0.02, at(-0.1, 0, 0.02), 2)};
        for (const int wheel : {1, 2}) {
            const Vec3 hub(0.06, (wheel == 1 ? 1 : -1) * (aside - width / 2), radius);
            BodySpec& body = config->bodies[std::size_t(wheel)];
            body.pose.position = config->joints[std::size_t(wheel - 1)].anchor = hub;
            body.mass = massOfCylinder(0.15, radius, width, rotationFromHpr(degrees(0, 0, 90)));
            body.geoms[0].radius = radius;
            body.geoms[0].length = width;
        }
        Scene scene = r0Scene(tick);
        scene.spec->settings.engine = static_cast<EngineChoice>(engine);
        scene.scenery({plane("floor", {}, 1), box("wall", {20, 0.1, 1}, at(8, 0.55, 0.5), 3)});
        scene.robot("r", at(0, 0.25, 0, degrees(angle, 0, 0)), config);
        auto world = scene.build();
        QVERIFY(world);
        const auto drive = [&](double seconds) {
            for (long i = std::lround(seconds / tick); i > 0; --i) {
                for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, speed / radius, 1 / 0.18, 3.6);
                if (!world->tick()) return false;
            }
            return true;
        };
        QVERIFY(drive(9));
        const double from = world->robotPose(0).position.x(), since = world->time();
        QVERIFY(drive(3));
        const double along = (world->robotPose(0).position.x() - from) / (world->time() - since),
                     heading = hprFromRotation(world->robotPose(0).rotation).x() * 180 / kPi;
        qInfo("%.4f m/s along the wall, heading %.2f degrees", along, heading);
        QVERIFY(slides ? std::abs(along - speed) < 0.01 : std::abs(along) < 0.01);
        QVERIFY(slides ? std::abs(heading) < 0.5 : std::abs(heading - 90) < 1);
    }
};

QTEST_APPLESS_MAIN(DrivingTest)
#include "driving_test.moc"
