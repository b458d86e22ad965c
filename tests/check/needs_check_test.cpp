// Robots without a device that their controller needs: found before a run, in C++ and in Python, with a fix that helps.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

const std::string kCart = R"(
RobotConfig Cart {
  Body chassis { Pos=0,0,0.08 Box hull { Size=0.3,0.2,0.06 Mass=2 } Sphere caster { Pos=-0.12,0,-0.05 Radius=0.03 Mass=0.1 } }
  Body leftWheel { Pos=0.1,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Body rightWheel { Pos=0.1,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Anchor=0.1,0.15,0.05 Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Anchor=0.1,-0.15,0.05 Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  RotaryMotor rightMotor { Joint=rightAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  DRIVE
}
)";
const std::string kDrive =
    "DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }";
const std::string kSkid = "SkidDrive base { LeftMotors=leftMotor RightMotors=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }";

QString cart(const std::string& devices) {
    return QString::fromStdString(kThings + kCart).replace("DRIVE", QString::fromStdString(devices));
}

} // namespace

class NeedsCheckTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

    /// The one error; its fix, where it is to have one, leaves no error.
    void checkText(const QString& text, const QString& message, const QString& fix) {
        const auto loaded = m_fixture.open(text.toStdString());
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const QByteArray all = QByteArray::fromStdString(CheckFixture::shown(*loaded, found));
        if (message.isEmpty()) {
            QVERIFY2(found.all().empty() && all.isEmpty(), all);
            return;
        }
        QVERIFY2(found.all().size() == 1, all);
        const Diagnostic& d = found.all()[0];
        QCOMPARE(d.code, Code::UnknownPort);
        QCOMPARE(d.severity, Severity::Error);
        QCOMPARE(QString::fromStdString(d.message), message);
        QVERIFY(d.range.known());
        if (fix.isEmpty()) {
            QVERIFY2(d.fixes.empty(), all);
            return;
        }
        QVERIFY2(d.fixes.size() == 1, all);
        QCOMPARE(QString::fromStdString(d.fixes[0].title), fix);
        const auto fixed = m_fixture.open(CheckFixture::applied(*loaded, d.fixes[0]));
        QVERIFY(fixed);
        const Diagnostics left = CheckFixture::check(*fixed);
        QVERIFY2(left.all().empty() && !fixed->diagnostics.hasErrors(), CheckFixture::shown(*fixed, left).c_str());
    }

private Q_SLOTS:
    void reportsWhatIsLacking_data() {
        QTest::addColumn<QString>("devices");
        QTest::addColumn<QString>("robots");
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("fix");
        const auto row = [](const char* name, const std::string& devices, const QString& robots, const QString& message,
                            const QString& fix) {
            QTest::newRow(name) << QString::fromStdString(devices) << robots << message << fix;
        };
        const QString robot = "Robot r { Config=Cart WallFollow brain { } }\n";
        const QString lacks = "r lacks the Lidar 'scan' that its controller WallFollow needs as its Lidar";
        const std::string lidar = "\n  Lidar scan { Body=chassis Pos=0,0,0.1 }";
        row("has all", kDrive + lidar, robot, "", "");
        row("has a drive with the same signals", kSkid + lidar, robot, "", "");
        row("no lidar", kDrive, robot, lacks, "add the Lidar scan to Cart");
        row("no lidar of that name", kDrive + "\n  Lidar eye { Body=chassis Pos=0,0,0.1 }", robot, lacks, "Lidar=eye");
        row("the other name is given", kDrive + lidar, "Robot r { Config=Cart WallFollow brain { Lidar=scam } }\n",
            "r lacks the Lidar 'scam' that its controller WallFollow needs as its Lidar", "Lidar=scan");
        row("two lidars", kDrive + "\n  Lidar a { Body=chassis Pos=0,0,0.1 }\n  Lidar b { Body=chassis Pos=0,0,0.1 }", robot,
            lacks, "");
        row("the name is that of another kind", kDrive + "\n  Imu scan { Body=chassis }", robot, lacks + ": scan is an Imu", "");
        row("an empty name needs nothing", kDrive, "Robot r { Config=Cart WallFollow brain { Lidar=\"\" } }\n", "", "");
        row("a crowd is one finding", kDrive, "Grid many { Config=Cart WallFollow brain { } Count=3,2 Spacing=1 }\n",
            "many_0 lacks the Lidar 'scan' that its controller WallFollow needs as its Lidar (and 5 more like it)",
            "add the Lidar scan to Cart");
        row("a crowd gets the name of what there is", kDrive + "\n  Lidar eye { Body=chassis Pos=0,0,0.1 }",
            "Grid many { Config=Cart WallFollow brain { } Count=3,2 Spacing=1 }\n",
            "many_0 lacks the Lidar 'scan' that its controller WallFollow needs as its Lidar (and 5 more like it)", "Lidar=eye");
        row("no drive", lidar, robot, "r lacks the DifferentialDrive 'base' that its controller WallFollow needs as its Drive",
            "add the DifferentialDrive base to Cart");
    }
    void reportsWhatIsLacking() {
        QFETCH(QString, devices);
        QFETCH(QString, robots);
        QFETCH(QString, message);
        QFETCH(QString, fix);
        for (const QString module : {"#loadModule controllers/wall_follow\n", "#loadModule python/wall_follow.py\n"}) {
            checkText(module + cart(devices.toStdString()) + robots, message, fix);
            if (QTest::currentTestFailed()) qWarning("with %s", qPrintable(module));
        }
    }

    /// A lidar on top of the body, sensors of the floor low at its front, on the side of their names.
    void whatIsAddedIsWhereItSenses() {
        const auto check = [&](const char* module, const char* kind, const std::map<std::string, std::string>& places) {
            const std::string robot = std::string("Robot r { Config=Cart ") + kind + " brain { } }\n";
            const auto loaded = m_fixture.open((module + cart(kDrive)).toStdString() + robot);
            const Diagnostics found = CheckFixture::check(*loaded);
            QCOMPARE(found.all().size(), places.size());
            for (const Diagnostic& d : found.all()) {
                QCOMPARE(d.fixes.size(), std::size_t(1));
                const std::string text = CheckFixture::applied(*loaded, d.fixes[0]);
                const auto isAdded = [&](const auto& place) {
                    const std::size_t at = text.find(place.first + " {");
                    return at != std::string::npos && text.find(" Pos=" + place.second + " ", at) < text.find('}', at);
                };
                QVERIFY2(std::ranges::count_if(places, isAdded) == 1, text.c_str());
            }
        };
        check("#loadModule controllers/wall_follow\n", "WallFollow", {{"Lidar scan", "0,0,0.05"}});
        check("#loadModule controllers/line_follow\n", "LineFollow",
              {{"GroundSensor leftGround", "0.15,0.05,-0.075"},
               {"GroundSensor middleGround", "0.15,0,-0.075"},
               {"GroundSensor rightGround", "0.15,-0.05,-0.075"}});
    }
};

QTEST_GUILESS_MAIN(NeedsCheckTest)
#include "needs_check_test.moc"
