// How accurately a commanded motion is driven, through text, controller, drive, motors and the contacts of wheels and floor.
// Measured at the middle of the axle, for the reference robot of tests/data/r0.sim.

#include "flow/cli.h"

namespace {

struct AxlePose {
    double x = 0, y = 0, heading = 0;
};

constexpr double kPi = 3.14159265358979323846; // moc cannot read <numbers>
constexpr double kDegree = kPi / 180;

/// Smallest difference of two headings, in radians.
double turned(double a, double b) { return std::remainder(a - b, 2 * kPi); }

} // namespace

class DrivingFlowTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// Runs the reference robot with a controller block; `sets` are the arguments of --set.
    Outcome drive(const QString& controller, double seconds, const QStringList& sets = {},
                  const QString& ground = "Static floor { Config=Floor }") {
        const QString file = m_folder.filePath("drive.sim");
        const QString text = "#import r0.sim\n#loadModule controllers/linear_motion\n#loadModule controllers/arc_motion\n" +
                             ground + "\nRobot robot0 { Config=R0 " + controller + " }\n";
        if (!writeFile(file, text.toUtf8())) return {};
        QStringList arguments{"run",
                              file,
                              "-I",
                              QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data"),
                              "--json",
                              "--duration",
                              QString::number(seconds),
                              "--log-dir",
                              m_folder.filePath("logs")};
        for (const QString& set : sets) arguments << "--set" << set;
        return cli(arguments);
    }

    static AxlePose axle(const Outcome& run) {
        const QJsonObject robot = QJsonDocument::fromJson(run.out).object()["robots"].toObject()["robot0"].toObject();
        const QJsonArray pose = robot["signals"].toObject()["base/pose"].toArray();
        return {pose[0].toDouble(), pose[1].toDouble(), pose[2].toDouble() * kDegree}; // the JSON has degrees
    }

private Q_SLOTS:
    void servoDrivesStraight_data();
    void servoDrivesStraight();
    void servoDrivesArcs_data();
    void servoDrivesArcs();
    void voltageLagsByItsTimeConstant_data();
    void voltageLagsByItsTimeConstant();
    void theMotorIsStableAtEveryTick_data();
    void theMotorIsStableAtEveryTick();
    void pressedAgainstAWallItStays_data();
    void pressedAgainstAWallItStays();
    void backsOffAndTurns_data();
    void backsOffAndTurns();
    void withoutWhatMovesItTheRobotStays_data();
    void withoutWhatMovesItTheRobotStays();
};

void DrivingFlowTest::servoDrivesStraight_data() {
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("speed");
    for (const double distance : {5.0, 0.05, 0.5, 1.0, 2.0, -1.0, -3.0})
        for (const double speed : {0.1, 0.25, 0.5})
            if (std::abs(distance) / speed < 21) QTest::addRow("%g m at %g m/s", distance, speed) << distance << speed;
}

void DrivingFlowTest::servoDrivesStraight() {
    QFETCH(double, distance);
    QFETCH(double, speed);
    const Outcome run =
        drive(QString("LinearMotion brain { Distance=%1 Speed=%2 }").arg(distance).arg(speed), std::abs(distance) / speed + 2);
    QVERIFY2(run.code == 0, shown(run));
    QVERIFY2(run.err.contains(QString(" m of %1 m by odometry").arg(std::abs(distance)).toUtf8()), shown(run));
    const AxlePose end = axle(run);
    QVERIFY2(std::hypot(end.x - distance, end.y) < 5e-5, shown(run));
}

void DrivingFlowTest::servoDrivesArcs_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("angle"); // in degrees
    QTest::newRow("the reference: 0.3 m/s, 1 rad/s, a full turn") << 0.3 << 1.0 << 360.0;
    for (const double radius : {0.2, 0.5, 1.0})
        for (const double angle : {90.0, -180.0, 360.0})
            QTest::addRow("radius %g m, %g deg", radius, angle) << 0.2 << 0.2 / radius << angle;
    QTest::newRow("on the spot") << 0.0 << 0.5 << 90.0;
}

void DrivingFlowTest::servoDrivesArcs() {
    QFETCH(double, speed);
    QFETCH(double, rate);
    QFETCH(double, angle);
    const double seconds = std::abs(angle) * kDegree / rate + 2;
    const Outcome run =
        drive(QString("ArcMotion brain { Speed=%1 TurnRate=%2 Angle=%3 }").arg(speed).arg(rate).arg(angle), seconds,
              {QString("RobotConfig.R0.base.MaxAcceleration=%1").arg(2 * std::max(speed, 0.1)),
               QString("RobotConfig.R0.base.MaxAngularAcceleration=%1").arg(2 * rate)}); // ramps of 0.5 s
    QVERIFY2(run.code == 0, shown(run));
    const AxlePose end = axle(run);
    // The speed is positive for either turning direction: a circle of radius v / W about a point to the left or to the right.
    const double radius = std::copysign(speed / rate, angle), theta = angle * kDegree;
    QVERIFY2(std::hypot(end.x - radius * std::sin(theta), end.y - radius * (1 - std::cos(theta))) < 1e-4, shown(run));
    QVERIFY2(std::abs(turned(end.heading, theta)) < 0.02 * kDegree, shown(run));
}

void DrivingFlowTest::voltageLagsByItsTimeConstant_data() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.001, 0.01, 0.03}) QTest::addRow("tick %g s", tick) << tick;
}

// The wheels follow a voltage with the time constant tau = (M r^2 / 2 + I) / b, so the robot lags by v tau = 7.099 mm. A ramp of
// 0.5 s, so that the wheels do not slip, costs another 0.125 m.
void DrivingFlowTest::voltageLagsByItsTimeConstant() {
    QFETCH(double, tick);
    const Outcome run = drive("LinearMotion brain { Distance=10 Speed=0.5 }", 3,
                              {QString("Tick=%1").arg(tick), "RobotConfig.R0.base.Control=voltage"});
    QVERIFY2(run.code == 0, shown(run));
    const double lag = 3 * 0.5 - 0.125 - axle(run).x;
    QVERIFY2(std::abs(lag - 7.099e-3) < 0.01 * 7.099e-3, shown(run));
}

void DrivingFlowTest::theMotorIsStableAtEveryTick_data() {
    QTest::addColumn<double>("tick");
    QTest::addColumn<QString>("ground");
    for (const double tick : {0.001, 0.005, 0.01, 0.02, 0.025, 0.03, 0.04, 0.05}) {
        QTest::addRow("on the floor, tick %g s", tick) << tick << QString("Static floor { Config=Floor }");
        // A post under the hull carries the robot, so that the wheels turn freely.
        QTest::addRow("lifted, tick %g s", tick)
            << tick
            << QString("StaticConfig Post { Box top { Size=0.2,0.1,0.2 Pos=-0.03,0,-0.05 Material=grey Surface=rubber } }\n"
                       "Static post { Config=Post Pos=0,0,-0.02 }");
    }
}

void DrivingFlowTest::theMotorIsStableAtEveryTick() {
    QFETCH(double, tick);
    QFETCH(QString, ground);
    const bool lifted = ground.contains("Post");
    const Outcome run = drive("LinearMotion brain { Distance=100 Speed=0.5 }", 6,
                              {QString("Tick=%1").arg(tick), "RobotConfig.R0.base.Control=voltage"}, ground);
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject robot = QJsonDocument::fromJson(run.out).object()["robots"].toObject()["robot0"].toObject();
    for (const char* motor : {"leftMotor/rate", "rightMotor/rate"}) {
        const double rate = robot["signals"].toObject()[motor].toDouble();
        QVERIFY2(std::abs(rate - 10) < (lifted ? 1e-3 : 0.05), shown(run)); // 0.5 m/s on a wheel of radius 5 cm
    }
    if (!lifted) QVERIFY2(std::abs(axle(run).x - (3 - 0.125 - 7.1e-3)) < 5e-4, shown(run));
}

void DrivingFlowTest::pressedAgainstAWallItStays_data() {
    QTest::addColumn<double>("tick");
    QTest::addColumn<double>("distance");
    for (const double tick : {0.003, 0.005, 0.01, 0.02, 0.03})
        for (const double distance : {-0.5, -0.7, -2.0, 5.0})
            QTest::addRow("tick %g s, %g m", tick, distance) << tick << distance;
}

// Motors and floor hold the wheels while the wall holds the hull: nearly redundant constraints, for which the exact solver
// occasionally fails. The robot must still not move.
void DrivingFlowTest::pressedAgainstAWallItStays() {
    QFETCH(double, tick);
    QFETCH(double, distance);
    const Outcome run = cli({"run", configPath("experiments/linear_motion.sim"), "--json", "--duration", "30", "--log-dir",
                             m_folder.filePath("logs"), "--set", QString("Tick=%1").arg(tick), "--set",
                             QString("robot0.brain.Distance=%1").arg(distance)});
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    const QJsonObject robot = json["robots"].toObject()["robot0"].toObject();
    const double hull = distance < 0 ? -2 + 0.15 : 2 - 0.17; // walls at 2 m; the hull touches behind, the bumper in front
    QVERIFY2(std::abs(robot["pos"].toArray()[0].toDouble() - hull) < 1e-3, shown(run));
    QVERIFY2(std::abs(robot["pos"].toArray()[1].toDouble()) < 2e-3, shown(run));
}

void DrivingFlowTest::backsOffAndTurns_data() {
    QTest::addColumn<double>("backOff");
    QTest::addColumn<double>("angle");
    QTest::newRow("a right angle") << 0.2 << 90.;
    QTest::newRow("nearly round") << 0.45 << 150.;
    QTest::newRow("less") << 0.4 << 60.;
}

// A wall at 1.05 m: the bumper, 0.17 m ahead, touches it. The robot backs off by the whole distance, turns by the whole angle and
// drives on from there.
void DrivingFlowTest::backsOffAndTurns() {
    QFETCH(double, backOff);
    QFETCH(double, angle);
    const QString file = m_folder.filePath("bump.sim");
    const QString text =
        QString("#import robots/simple_robot.sim\n#loadModule controllers/bump_and_turn\n"
                "StaticConfig Wall { Box w { Size=0.1,9,0.5 Pos=1.1,0,0.25 } Plane floor { Surface=rubber } }\n"
                "Static wall { Config=Wall }\n"
                "Robot robot0 { Config=SimpleRobot BumpAndTurn brain { Speed=0.3 BackOff=%1 TurnRate=2 TurnAngle=%2,%2 } }\n")
            .arg(backOff)
            .arg(angle);
    QVERIFY(writeFile(file, text.toUtf8()));
    const double turning = 0.88 / 0.3 + backOff / 0.3 + angle * kDegree / 2 + 2.5; // braking and starting take 1.5 s
    const Outcome run = cli({"run", file, "-I", configPath(""), "--json", "--duration", QString::number(turning), "--log-dir",
                             m_folder.filePath("logs")});
    QVERIFY2(run.code == 0, shown(run));
    const AxlePose end = axle(run);
    QVERIFY2(std::abs(std::abs(end.heading) - angle * kDegree) < 2 * kDegree, shown(run));
    // It drives on from where backing off ended, by up to 5 cm farther: it slips at the wall.
    const double x = 0.88 - backOff + 0.06;
    const double aside = (end.x - x) * std::sin(end.heading) - end.y * std::cos(end.heading);
    const double along = (end.x - x) * std::cos(end.heading) + end.y * std::sin(end.heading);
    QVERIFY2(std::abs(aside) < 0.06 && along > 0.05, shown(run));
}

void DrivingFlowTest::withoutWhatMovesItTheRobotStays_data() {
    QTest::addColumn<QStringList>("sets");
    QTest::addColumn<QString>("change");
    QTest::newRow("no gravity") << QStringList{"Gravity=0,0,0"} << QString();
    QTest::newRow("no friction") << QStringList{"Surface.rubber.Friction=0", "Surface.plastic.Friction=0"} << QString();
    QTest::newRow("no wheels") << QStringList{"RobotConfig.R0.leftWheel.tyre.Collide=false",
                                              "RobotConfig.R0.rightWheel.tyre.Collide=false"}
                               << QString();
}

void DrivingFlowTest::withoutWhatMovesItTheRobotStays() {
    QFETCH(QStringList, sets);
    const Outcome run = drive("LinearMotion brain { Distance=1 Speed=0.2 }", 8, sets);
    QVERIFY2(run.code == 0, shown(run));
    const AxlePose end = axle(run);
    QVERIFY2(std::abs(end.x) < 0.05, shown(run));
}

QTEST_GUILESS_MAIN(DrivingFlowTest)
#include "driving_test.moc"
