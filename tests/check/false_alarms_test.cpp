// What is right, or follows from another mistake, is not reported.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

/// A motor turns a pinion, a Gear a wheel three times as large: WheelRadius is what the motor has to be asked for.
const std::string kGeared = R"(
PartConfig Side {
  Body pinion { Pos=0,0.1,0.12 Cylinder c { Radius=0.01 Length=0.01 HPR=0,0,90 Mass=0.05 } }
  Body wheel { Pos=0,0.1,0.06 Cylinder c { Radius=0.06 Length=0.02 HPR=0,0,90 Mass=0.3 } }
  Hinge in { Parent=$on Child=pinion Axis=0,1,0 }
  Hinge out { Parent=$on Child=wheel Axis=0,1,0 }
  Gear belt { Joint=out Other=in Ratio=$(1/3) }
  RotaryMotor motor { Joint=in TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=10 MaxVoltage=12 }
}
RobotConfig Geared {
  Body chassis { Box b { Size=0.2,0.15,0.05 Pos=-0.02,0,0.08 Mass=2 } Sphere s { Radius=0.02 Pos=-0.1,0,0.02 Mass=0.05 } }
  Part l { Config=Side on=chassis }
  Part r { Config=Side on=chassis Mirror=y }
  DifferentialDrive base { LeftMotor=l.motor RightMotor=r.motor WheelRadius=0.02 WheelSeparation=0.2 }
}
Robot r { Config=Geared }
)";

} // namespace

class FalseAlarmsTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void wheelsBehindAGear() {
        const auto loaded = m_fixture.open(kThings + kGeared);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        for (const Diagnostic& d : found.all())
            QVERIFY2(d.severity == Severity::Hint, CheckFixture::shown(*loaded, found).c_str());
        std::string other = kThings + kGeared; // the same without the Gear is what the check is for
        other.erase(other.find("  Gear belt"), other.find("  RotaryMotor") - other.find("  Gear belt"));
        const auto wrong = m_fixture.open(other);
        const Diagnostics said = CheckFixture::check(*wrong);
        QVERIFY(std::ranges::any_of(said.all(), [](const Diagnostic& d) { return d.code == Code::WheelGeometry; }));
    }

    /// Upright 0.5 kg with its centre 0.05 m above the hinge: 0.245 N m * sin(angle), which 0.2 N m hold up to 54.6 degrees.
    void aServoNeedsToHoldItsArmBetweenItsStopsAlone_data() {
        QTest::addColumn<QString>("stops");
        QTest::addColumn<QString>("at"); ///< degrees where it is hardest; empty: nothing is reported
        QTest::newRow("both near") << "LowStop=-50 HighStop=40"
                                   << "";
        QTest::newRow("the other way") << "LowStop=-40 HighStop=50"
                                       << "";
        QTest::newRow("high stop far") << "LowStop=-50 HighStop=60"
                                       << "60 degrees";
        QTest::newRow("low stop far") << "LowStop=-60 HighStop=50"
                                      << "-60 degrees";
        QTest::newRow("both far") << "LowStop=-60 HighStop=70"
                                  << "70 degrees";
        QTest::newRow("no high stop") << "LowStop=-50"
                                      << "90";
        QTest::newRow("no low stop") << "HighStop=50"
                                     << "-90";
    }
    void aServoNeedsToHoldItsArmBetweenItsStopsAlone() {
        QFETCH(const QString, stops);
        QFETCH(const QString, at);
        const auto loaded =
            m_fixture.open(kThings +
                           "RobotConfig B { Body chassis { Box b { Size=0.3,0.2,0.1 Mass=5 } }\n"
                           "  Body mast { Pos=0,0,0.12 Box b { Size=0.04,0.04,0.1 Mass=0.5 } }\n"
                           "  Hinge tip { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,0.07 " +
                           stops.toStdString() +
                           " }\n  Servo arm { Joint=tip MaxTorque=0.2 MaxSpeed=3 } }\nRobot r { Config=B Pos=0,0,0.05 }\n");
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string shown = CheckFixture::shown(*loaded, found);
        QVERIFY2(found.all().size() == (at.isEmpty() ? 0u : 1u), shown.c_str());
        if (at.isEmpty()) return;
        QCOMPARE(found.all()[0].code, Code::WeakMotor);
        QVERIFY2(QString::fromStdString(found.all()[0].message).contains("cannot hold tip everywhere: at " + at), shown.c_str());
    }

    /// Materials and Surfaces that are used through an expression.
    void whatRestsExactlyOnABoxDoesNotFall_data() {
        QTest::addColumn<QString>("shape"); // 0.2 m high
        QTest::addColumn<double>("above");  // m, over the board
        QTest::addColumn<QString>("reported");
        QTest::newRow("box") << "Box c { Size=0.3,0.25,0.2 Mass=1.7 }" << 0. << "";
        QTest::newRow("ball") << "Sphere c { Radius=0.1 Mass=1.7 }" << 0. << "";
        QTest::newRow("rounded up") << "Box c { Size=0.3,0.25,0.2 Mass=1.7 }" << 1e-9 << "";
        QTest::newRow("higher") << "Box c { Size=0.3,0.25,0.2 Mass=1.7 }" << 0.07
                                << "starts 70 mm above board/c and falls onto it";
    }
    void whatRestsExactlyOnABoxDoesNotFall() {
        QFETCH(QString, shape);
        QFETCH(double, above);
        QFETCH(QString, reported);
        const auto loaded =
            m_fixture.open(QStringLiteral("StaticConfig F { Plane floor { } Box c { Size=1,1,0.1 Pos=0,0,0.05 } }\n"
                                          "Static board { Config=F }\nRobotConfig Crate { Body b { %1 } }\n"
                                          "Robot crate { Config=Crate Pos=0.1,-0.2,%2 }\n")
                               .arg(shape)
                               .arg(0.2 + above, 0, 'g', 17)
                               .toStdString());
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const auto unsupported = std::ranges::find(found.all(), Code::Unsupported, &Diagnostic::code);
        QCOMPARE(unsupported != found.all().end(), !reported.isEmpty());
        if (!reported.isEmpty())
            QVERIFY2(unsupported->message.find(reported.toStdString()) != std::string::npos, unsupported->message.c_str());
    }

    void namesInExpressions() {
        const std::string text = kThings + "Material mine { } Material yours { } Surface grip { } Surface ice { }\n"
                                           "StaticConfig F { Param colours = mine,yours  Param a = grip  Param b = ice\n"
                                           "  Repeat p { Count=2 Box b { Pos=$index,0,0.1 Size=0.1,0.1,0.2 "
                                           "Material=$(element(colours, index)) Surface=$(if(index == 0, a, b)) } } }\n"
                                           "Static f { Config=F }\nRobot r { Config=Crate Pos=0,2,0.1 }\n";
        const auto loaded = m_fixture.open(text);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY2(found.all().empty(), CheckFixture::shown(*loaded, found).c_str());
        const auto unused = m_fixture.open(text + "Material spare { }\n");
        const Diagnostics said = CheckFixture::check(*unused);
        QCOMPARE(said.all().size(), std::size_t(1));
        QCOMPARE(said.all()[0].message, std::string("Material spare is not used"));
    }

    /// Names that an import may have defined are not missed until it is there.
    void namesOfAMissingImport() {
        const auto loaded = m_fixture.open("#import common/materils.sim\n#import common/surfaces.sim\n"
                                           "RobotConfig R { Body b { Box a { Size=1,1,1 Mass=1 Material=steel Surface=rubber } "
                                           "Box c { Size=1,1,1 Mass=1 Material=red Surface=rubber } } }\nRobot r { Config=R }\n");
        QVERIFY(loaded);
        std::vector<Diagnostic> errors;
        for (const Diagnostic& d : loaded->diagnostics.all())
            if (d.severity == Severity::Error) errors.push_back(d);
        QVERIFY2(errors.size() == 1, CheckFixture::shown(*loaded, {}).c_str());
        QCOMPARE(errors[0].code, Code::ImportNotFound);
        QCOMPARE(errors[0].suggestions.at(0), std::string("common/materials.sim"));
    }
};

QTEST_GUILESS_MAIN(FalseAlarmsTest)
#include "false_alarms_test.moc"
