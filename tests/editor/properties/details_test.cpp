// What Properties shows below the rows: the curve of a motor, mass and balance.
#include <cmath>
#include <fstream>

#include <QLabel>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/properties/motor_curve.h"
#include "editor/properties/properties_panel.h"
#include "editor/running/session.h"
#include "eventually.h"

using namespace trundle;

namespace {

const char* const kCart = R"(RobotConfig Cart {
  Body hull { Box box { Size=0.4,0.2,0.1 Pos=0,0,0.05 Mass=2 } }
  Body arm { Pos=0,0,0.2  Box bar { Size=0.1,0.1,0.1 Density=1000 } }
  Hinge axle { Parent=hull Child=arm Axis=0,1,0 }
  Slider rail { Parent=hull Child=arm Axis=0,0,1 }
  RotaryMotor motor {
    Joint=axle TorqueConstant=0.02 BackEmfConstant=0.02 Resistance=2 GearRatio=10 MaxVoltage=12
    FrictionTorque=0.002 Efficiency=0.8
  }
  Servo servo { Joint=axle MaxTorque=1.5 MaxSpeed=6 }
  LinearMotor lift { Joint=rail MaxForce=20 MaxSpeed=0.1 }
}
Robot cart { Config=Cart Pos=1,0,0 }
)";

struct DetailsFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    RunSession session{document, *application};
    PropertiesPanel panel{document, selection, &session};

    DetailsFixture() {
        const std::string path = folder.filePath(QStringLiteral("main.sim")).toStdString();
        std::ofstream(path, std::ios::binary) << kCart;
        panel.resize(340, 700);
        panel.show();
        if (!document.opening().open(path)) qFatal("not opened");
    }
    /// "Total mass 3 kg; Centre ...", of what is visible.
    [[nodiscard]] QStringList massValues() const {
        QStringList values;
        for (int row = 0; row < 6; ++row) {
            const auto* label = panel.findChild<QLabel*>(QStringLiteral("massValue%1").arg(row));
            if (label && label->isVisible()) values << label->text();
        }
        return values;
    }
    [[nodiscard]] const MotorCurve& curve() const { return *panel.findChild<MotorCurve*>(); }
};

} // namespace

class DetailsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rotaryMotorHasItsLosses() {
        const DetailsFixture fixture;
        const auto motor = motorCharacteristic(*fixture.document.loaded(), "cart.motor");
        QVERIFY(motor && motor->hasCurrent && !motor->isLinear);
        QCOMPARE(motor->voltage, 12.0);
        const auto &stall = motor->samples.front(), &free = motor->samples.back();
        QCOMPARE(stall.current, 6.0);
        QVERIFY(std::abs(stall.effort - 0.8 * 10 * (0.02 * 6 - 0.002)) < 1e-12);
        QVERIFY(std::abs(free.current - 0.1) < 1e-9); // FrictionTorque / TorqueConstant
        QVERIFY(std::abs(free.speed - (12 - 0.1 * 2) / 0.02 / 10) < 1e-9);
        QVERIFY(std::abs(free.effort) < 1e-12);
    }

    /// Without load kt (V - emf W) / R = dry + viscous W at the rotor.
    void rotaryMotorTurnsSlowerWithViscousFriction() {
        DetailsFixture fixture;
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("set"), {{"cart.motor.ViscousFriction", "0.0001"}}).ok());
        const auto motor = motorCharacteristic(*fixture.document.loaded(), "cart.motor");
        QVERIFY(motor);
        const auto &stall = motor->samples.front(), &free = motor->samples.back();
        QVERIFY(std::abs(stall.effort - 0.8 * 10 * (0.02 * 6 - 0.002)) < 1e-12); // it does not move
        QVERIFY(std::abs(free.speed - (0.02 * 6 - 0.002) / (0.02 * 0.02 / 2 + 0.0001) / 10) < 1e-9);
        QVERIFY(std::abs(free.current - (12 - 10 * free.speed * 0.02) / 2) < 1e-9);
        QVERIFY(std::abs(free.effort) < 1e-12);
        for (const auto& part : motor->parts) QVERIFY(std::abs(part.samples.back().effort) < 1e-12);
    }

    /// At a quarter of the voltage a quarter of the current at stall, less the same friction.
    void rotaryMotorAtPartsOfItsVoltage() {
        const DetailsFixture fixture;
        const auto motor = motorCharacteristic(*fixture.document.loaded(), "cart.motor");
        QVERIFY(motor);
        QCOMPARE(motor->parts.size(), std::size_t(3));
        for (const auto& part : motor->parts) {
            QVERIFY(std::abs(part.samples.front().effort - 0.8 * 10 * (0.02 * part.voltage / 2 - 0.002)) < 1e-12);
            QVERIFY(std::abs(part.samples.back().speed - (part.voltage - 0.1 * 2) / 0.02 / 10) < 1e-9);
        }
        QCOMPARE(motor->parts[0].voltage, 3.0);
    }

    /// The friction of its gear holds it at the lowest one.
    void aPartOfTheVoltageMayNotTurnIt() {
        DetailsFixture fixture;
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("set"), {{"cart.motor.FrictionTorque", "0.04"}}).ok());
        const auto motor = motorCharacteristic(*fixture.document.loaded(), "cart.motor");
        QVERIFY(motor);
        QCOMPARE(motor->parts.size(), std::size_t(2)); // 0.02 * 3 / 2 is below 0.04
    }

    void servosAreLines() {
        const DetailsFixture fixture;
        const auto servo = motorCharacteristic(*fixture.document.loaded(), "cart.servo"),
                   lift = motorCharacteristic(*fixture.document.loaded(), "cart.lift");
        QVERIFY(servo && lift && !servo->hasCurrent);
        QVERIFY(lift->isLinear && !servo->isLinear);
        QCOMPARE(servo->samples.front().effort, 1.5);
        QCOMPARE(lift->samples.back().speed, 0.1);
        QVERIFY(!motorCharacteristic(*fixture.document.loaded(), "cart.axle"));
    }

    void theCurveFollowsEdits() {
        DetailsFixture fixture;
        fixture.selection.select("cart.motor");
        QVERIFY(fixture.curve().isVisible());
        QVERIFY2(fixture.curve().summary().startsWith(QStringLiteral("Stall 0.944 Nm, 6 A")),
                 qPrintable(fixture.curve().summary()));
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("set"), {{"cart.motor.CurrentLimit", "3"}}).ok());
        QVERIFY2(fixture.curve().summary().startsWith(QStringLiteral("Stall 0.464 Nm, 3 A")),
                 qPrintable(fixture.curve().summary()));
        fixture.selection.select("cart.axle");
        QVERIFY(!fixture.curve().isVisible());
    }

    void massOfRobotAndBody() {
        DetailsFixture fixture;
        fixture.selection.select("cart");
        QStringList values = fixture.massValues(); // 2 kg at 0.05 m, 1 kg at 0.2 m
        QCOMPARE(values.size(), 5);
        QCOMPARE(values[0], QStringLiteral("3 kg"));
        QCOMPARE(values[1], QStringLiteral("0, 0, 0.1 m"));
        QCOMPARE(values[3], QStringLiteral("Stable: 100 mm to the edge"));
        QCOMPARE(values[4], QStringLiteral("forward 63°, backward 63°, left 45°, right 45°; least 45°"));
        fixture.selection.select("cart.arm");
        values = fixture.massValues();
        QCOMPARE(values.size(), 3);
        QCOMPARE(values[0], QStringLiteral("1 kg")); // of its density
        QCOMPARE(values[2], QStringLiteral("0.00167, 0.00167, 0.00167 kg m²"));
        fixture.selection.select("RobotConfig.Cart");
        QCOMPARE(fixture.massValues().size(), 5);
        fixture.selection.select("cart.axle");
        QVERIFY(fixture.massValues().empty());
    }

    /// Wherever the robot is and however it is turned.
    void centreOfMassIsInTheFrameOfTheConfig() {
        DetailsFixture fixture;
        const std::string path = fixture.folder.filePath(QStringLiteral("kit.sim")).toStdString();
        std::ofstream(path, std::ios::binary) << "RobotConfig Kit { Body hull { Pos=0.1,0,0 Box box { Size=0.4,0.2,0.1\n"
                                                 "  Pos=0.2,0.05,0.4 Mass=2 } } }\n"
                                                 "Robot kit { Config=Kit Pos=1,-2,0.5 HPR=90,0,0 }\n";
        QVERIFY(fixture.document.opening().open(path).ok());
        fixture.selection.select("kit");
        EVENTUALLY(fixture.massValues().size() > 1);
        QCOMPARE(fixture.massValues()[0], QStringLiteral("2 kg"));
        QCOMPARE(fixture.massValues()[1], QStringLiteral("0.3, 0.05, 0.4 m"));
    }

    /// Also of one that a Part of a Part uses.
    void massFollowsThePartConfigs() {
        DetailsFixture fixture;
        const std::string path = fixture.folder.filePath(QStringLiteral("kit.sim")).toStdString();
        std::ofstream(path, std::ios::binary) << "Robot kit { Config=Kit }\n"
                                                 "RobotConfig Kit { Body hull { Box box { Size=0.4,0.2,0.1 Mass=2 } }\n"
                                                 "  Part left { Config=Side Pos=0,0.5,0 }\n"
                                                 "  Part right { Config=Side Pos=0,-0.5,0 } }\n"
                                                 "PartConfig Side { Body rail { Box bar { Size=0.2,0.1,0.1 Mass=1 } }\n"
                                                 "  Part tip { Config=Tip Pos=0.3,0,0 } }\n"
                                                 "PartConfig Tip { Body ball { Sphere shape { Radius=0.1 Mass=1 } } }\n";
        QVERIFY(fixture.document.opening().open(path).ok());
        fixture.selection.select("kit");
        EVENTUALLY(!fixture.massValues().empty());
        QCOMPARE(fixture.massValues()[0], QStringLiteral("6 kg"));
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("set"), {{"PartConfig.Tip.ball.shape.Mass", "3"}}).ok());
        EVENTUALLY_EQUAL(fixture.massValues().value(0), QStringLiteral("10 kg"));
    }
};

QTEST_MAIN(DetailsTest)
#include "details_test.moc"
