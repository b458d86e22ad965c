// A robot from dimensions: which motor it gets, what the limits are, and that its text is a good robot without warnings.
#include <QTest>

#include <cmath>
#include <numbers>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/wizard/robot_text.h"

using namespace trundle;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

RobotDesign scaled(BaseShape base, double size, double mass) {
    RobotDesign d = usualDesign(base);
    for (double* value : {&d.length, &d.width, &d.height, &d.wheelRadius, &d.wheelSeparation, &d.wheelBase}) *value *= size;
    d.mass = mass;
    return d;
}

std::string failure(const RobotDesign& design) {
    const auto choice = chooseMotor(design);
    return choice ? "chose " + std::string(choice.value().motor.name) : choice.error().message;
}

} // namespace

class WizardTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itsTextIsAGoodRobot_data() {
        QTest::addColumn<int>("base");
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("mass");
        for (const BaseShape base : kBaseShapes)
            for (const auto& [size, mass] : {std::pair{0.5, 0.5}, {1., 3.}, {2., 15.}})
                QTest::addRow("base %d, size %g", static_cast<int>(base), size) << static_cast<int>(base) << size << mass;
    }
    void itsTextIsAGoodRobot() {
        QFETCH(int, base);
        QFETCH(double, size);
        QFETCH(double, mass);
        const RobotDesign design = scaled(static_cast<BaseShape>(base), size, mass);
        const auto choice = chooseMotor(design);
        QVERIFY2(choice.ok(), failure(design).c_str());
        const std::string robot = robotText(design, choice.value());
        sample::PlanFixture fixture;
        fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
        const auto loaded =
            fixture.open({{"rover.sim", robot}, {"main.sim", "#import rover.sim\nRobot rover { Config=Rover }\n"}});
        QVERIFY(loaded);
        QCOMPARE(QString::fromStdString(sample::messages(*loaded)), QString());
        QVERIFY(loaded->experiment);
        double total = 0;
        for (const auto& body : loaded->experiment->robots.at(0).config->bodies) total += body.mass.mass;
        QVERIFY2(std::abs(total - mass) < 1e-3 * mass, qPrintable(QString::number(total)));
        std::size_t compared = 0;
        for (std::size_t f = 0; f < loaded->paths.size(); ++f)
            if (loaded->paths[f].ends_with("rover.sim")) {
                QCOMPARE(QString::fromStdString(format(*loaded->trees[f])), QString::fromStdString(robot));
                ++compared;
            }
        QCOMPARE(compared, 1u);
    }

    /// The stall torque and the speed without load in the text are those of the data sheet.
    void theTextHasTheMotorOfTheDataSheet() {
        RobotDesign design;
        const auto choice = chooseMotor(design);
        QVERIFY(choice.ok());
        const std::string text = robotText(design, choice.value());
        const auto value = [&](const std::string& key) {
            return std::stod(text.substr(text.find(" " + key + "=") + key.size() + 2));
        };
        const GearMotor& motor = choice.value().motor;
        const double torque =
            value("TorqueConstant") * value("MaxVoltage") / value("Resistance") * value("GearRatio") * value("Efficiency");
        const double speed = value("MaxVoltage") / value("BackEmfConstant") / value("GearRatio");
        QVERIFY2(std::abs(torque / motor.stallTorque - 1) < 0.02, qPrintable(QString::number(torque)));
        QVERIFY2(std::abs(speed / motor.noLoadSpeed - 1) < 0.01, qPrintable(QString::number(speed)));
    }

    void choosesTheMotor_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("mass");
        QTest::addColumn<QString>("motor");
        QTest::newRow("light") << 0.5 << 0.5 << "Pololu 75:1 Micro Metal HPCB 12 V";
        QTest::newRow("usual") << 0.5 << 3. << "Pololu 70:1 37D 12 V";
        QTest::newRow("faster") << 0.8 << 3. << "Pololu 50:1 37D 12 V";
        QTest::newRow("fast") << 2. << 3. << "Pololu 19:1 37D 12 V";
        QTest::newRow("fastest") << 4. << 3. << "Pololu 10:1 37D 12 V";
        QTest::newRow("heavy") << 1. << 60. << "maxon RE 40 with GP 42 C 26:1";
        QTest::newRow("heavy and fast") << 2. << 60. << "maxon RE 40 with GP 42 C 12:1";
    }
    void choosesTheMotor() {
        QFETCH(double, speed);
        QFETCH(double, mass);
        QFETCH(QString, motor);
        RobotDesign design;
        design.topSpeed = speed;
        design.mass = mass;
        const auto choice = chooseMotor(design);
        QVERIFY2(choice.ok(), failure(design).c_str());
        QCOMPARE(QString::fromUtf8(choice.value().motor.name.data(), static_cast<qsizetype>(choice.value().motor.name.size())),
                 motor);
        QVERIFY(choice.value().topSpeed >= speed);
        QVERIFY(choice.value().slope >= kLeastSlopeDeg * kDegree);
        QCOMPARE(choice.value().topSpeed, choice.value().motor.noLoadSpeed * design.wheelRadius / 1.2);
    }

    void namesTheLimit_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("expected");
        QTest::newRow("mass") << "mass" << 0. << "The mass must be from 0.1 to 1000 kg, not 0.";
        QTest::newRow("not a number") << "mass" << std::nan("") << "The mass must be from 0.1 to 1000 kg, not nan.";
        QTest::newRow("too heavy") << "mass" << 900. << "No motor is strong enough: of those that reach 0.5 m/s";
        QTest::newRow("too fast") << "topSpeed" << 8.
                                  << "No motor is fast enough: with these wheels Pololu 10:1 37D 12 V reaches 4.36 m/s";
        QTest::newRow("wheels") << "wheelSeparation" << 0.2
                                << "The wheels touch the hull: the wheel separation must be at least 0.229 m";
        QTest::newRow("tall") << "height" << 1. << "It would tip over";
    }
    void namesTheLimit() {
        QFETCH(QString, key);
        QFETCH(double, value);
        QFETCH(QString, expected);
        RobotDesign design;
        (key == "mass"       ? design.mass
         : key == "topSpeed" ? design.topSpeed
         : key == "height"   ? design.height
                             : design.wheelSeparation) = value;
        const QString said = QString::fromStdString(failure(design));
        QVERIFY2(said.startsWith(expected), qPrintable(said));
    }

    /// It rocks from wheel to wheel where it skids; one that is as high and longer does not.
    void aSkidSteeredBaseMustNotRock() {
        RobotDesign design = usualDesign(BaseShape::SkidSteer);
        QVERIFY2(chooseMotor(design).ok(), failure(design).c_str());
        design.height = 0.45;
        const QString said = QString::fromStdString(failure(design));
        QVERIFY2(said.startsWith("It would rock from wheel to wheel when it skids in a turn: make the hull at most 0.32 m high"),
                 qPrintable(said));
        design.wheelBase = 0.4;
        QVERIFY2(chooseMotor(design).ok(), failure(design).c_str());
    }

    /// A long skid-steered base turns so slowly that its wheels are not faster than the top speed.
    void wheelsKeepTheTopSpeedInTurns() {
        for (const double wheelBase : {0.2, 0.4, 0.6}) {
            RobotDesign design = usualDesign(BaseShape::SkidSteer);
            design.wheelBase = wheelBase;
            const double rim = squareDrive(design).turnRate * design.wheelSeparation / 2 * skidFactor(design);
            QVERIFY2(rim <= design.topSpeed, qPrintable(QString::number(rim)));
        }
    }

    void wheelsFollowTheHull() {
        for (const BaseShape base : kBaseShapes) {
            const RobotDesign usual = usualDesign(base);
            RobotDesign same = usual;
            placeWheels(same, true, true);
            QCOMPARE(same.wheelSeparation, usual.wheelSeparation);
            QCOMPARE(same.wheelBase, usual.wheelBase);
            for (const auto& [value, to] :
                 {std::pair{&RobotDesign::width, 1.}, {&RobotDesign::wheelRadius, 0.15}, {&RobotDesign::length, 1.}}) {
                RobotDesign design = usual;
                design.*value = to;
                placeWheels(design, true, true);
                QVERIFY2(chooseMotor(design).ok(), failure(design).c_str());
                if (value == &RobotDesign::length && hasWheelBase(base)) QVERIFY(design.wheelBase > 0.6);
                placeWheels(design = usual, false, false);
                QCOMPARE(design.wheelSeparation, usual.wheelSeparation);
            }
        }
    }

    void aSkidSteeredBaseMustTurnOnTheSpot() {
        RobotDesign design = usualDesign(BaseShape::SkidSteer);
        design.mass = 250;
        design.wheelRadius = 0.09;
        design.wheelBase = 1.5;
        design.length = 1.6;
        design.topSpeed = 4;
        const QString said = QString::fromStdString(failure(design));
        QVERIFY2(said.startsWith("No motor is strong enough to turn on the spot: each wheel needs "), qPrintable(said));
    }
};
QTEST_APPLESS_MAIN(WizardTest)
#include "wizard_test.moc"
