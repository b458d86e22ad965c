// Fixes repair the cause: what they change makes the fault go away without another one. Where no change of one value does, none is offered.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

/// Wheels by a Part, so that robots can have other values of them.
const std::string kKit = R"(PartConfig W { Param r = 0.05 Param y = 0
  Body wheel { Pos=0,$y,0 Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge axle { Parent=$on Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 } }
RobotConfig Kit { Body hull { Box b { Size=0.3,0.2,0.1 Pos=0,0,0.1 Mass=2 } }
  Part fl { Config=W Pos=0.1,0.12,0.05 on=hull } Part fr { Config=W Pos=0.1,-0.12,0.05 on=hull }
  Part ml { Config=W Pos=0,0.12,0.05 on=hull } Part mr { Config=W Pos=0,-0.12,0.05 on=hull }
  Part bl { Config=W Pos=-0.1,0.12,0.05 on=hull } Part br { Config=W Pos=-0.1,-0.12,0.05 on=hull }
  SkidDrive base { LeftMotors=fl.motor,ml.motor,bl.motor RightMotors=fr.motor,mr.motor,br.motor WheelRadius=0.05 WheelSeparation=0.24 } }
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    return at == std::string::npos ? std::string() : text.replace(at, from.size(), to);
}

} // namespace

class FixesTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void fixes_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("said"); ///< of the first message; empty: nothing is reported
        QTest::addColumn<bool>("fix");
        const auto row = [](const char* name, const std::string& text, const char* said, bool fix) {
            QTest::newRow(name) << kThings + text << QString(said) << fix;
        };
        const std::string kit = kKit + "Robot r { Config=Kit }\n";
        row("as it should be", kit, "", false);
        row("two robots in one place", kit + "Robot s { Config=Kit Pos=0.01,0,0 }\n", "s starts inside r/", true);
        row("two robots in one place, a third beside",
            kit + "Robot s { Config=Kit Pos=0,0.02,0 }\nRobot t { Config=Kit Pos=0,0.3,0 }\n", "s starts inside r/", true);
        row("two robots in one place between walls",
            kit + "StaticConfig Walls { Box a { Size=1,0.02,0.2 Pos=0,0.2,0.1 } Box b { Size=1,0.02,0.2 Pos=0,-0.2,0.1 } Box c { "
                  "Size=0.02,1,0.2 Pos=0.3,0,0.1 } Box d { Size=0.02,1,0.2 Pos=-0.3,0,0.1 } }\nStatic walls { Config=Walls }\n"
                  "Robot s { Config=Kit Pos=0.01,0,0 }\n",
            "s starts inside r/", false);
        row("a hull lower than the wheels", changed(kit, "Pos=0,0,0.1 Mass=2", "Pos=0,0,0.04 Mass=2"),
            "r/hull/b is 10 mm deep in it, and would be thrown out; it reaches 10 mm lower than the wheels", false);
        row("a wheel farther out", changed(kit, "Part bl { Config=W", "Part bl { Config=W y=0.05"),
            "bl.wheel is 50 mm farther out than the other wheels of its side, from which the WheelSeparation of base is", false);
        row("a WheelSeparation of none of them", changed(kit, "WheelSeparation=0.24", "WheelSeparation=0.5"),
            "WheelSeparation of base is 500 mm, but", true);
        row("other wheels of one of two robots",
            kit + "Robot s { Config=Kit Pos=1,0,0.01 fl.r=0.06 fr.r=0.06 ml.r=0.06 mr.r=0.06 bl.r=0.06 br.r=0.06 }\n",
            "WheelRadius of base is 50 mm, but the wheels fl.wheel and br.wheel have a radius of 60 mm", false);
        const std::string spokes =
            "Cylinder tyre { Radius=0.02 Length=0.03 HPR=0,0,90 Mass=0.15 } Capsule a { Radius=0.005 Length=0.09 "
            "Mass=0.01 } Capsule b { Radius=0.005 Length=0.09 Mass=0.01 HPR=0,90,0 }";
        row("a wheel of spokes", changed(kit, "Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 }", spokes), "", false);
        row("a torque constant in mN m", changed(kit, "TorqueConstant=0.02", "TorqueConstant=20"),
            "TorqueConstant of fl.motor, 20 Nm/A, does not fit its SpeedConstant, 50 rad/s/V: it would give 1000 times the "
            "power",
            false);
        row("an anchor in millimetres", changed(kit, "Child=wheel Axis=0,1,0", "Child=wheel Anchor=0,0,50 Axis=0,1,0"),
            "fl.axle of Kit is 50 m away from hull or fl.wheel", false);
        row("two drives of the same motors",
            changed(kit, "  SkidDrive",
                    "  DifferentialDrive other { LeftMotor=fl.motor RightMotor=fr.motor WheelRadius=0.05 "
                    "WheelSeparation=0.24 }\n  SkidDrive"),
            "base and other command the same motor, fl.motor", false);
        row("motors of a thousandth of the voltage", changed(kit, "MaxVoltage=12", "MaxVoltage=0.012"), "it does not climb that",
            false);
        row("one wheel twice as large", changed(kit, "Part bl { Config=W", "Part bl { Config=W r=0.1"),
            "bl.wheel has a radius of 100 mm, and the WheelRadius of base is 50 mm", false);
        const std::string ramp =
            "StaticConfig Ramp { Box board { Size=4,4,0.02 } }\nStatic ramp { Config=Ramp Pos=3,0,1 HPR=0,-20,0 }\n";
        row("a robot on a ramp", kKit + ramp + "Robot r { Config=Kit Pos=2.9966,0,1.0095 HPR=0,-20,0 }\n", "", false);
        const std::string crawler =
            "RobotConfig Crawler { Body hull { Box b { Size=0.3,0.1,0.06 Pos=0,0,0.06 Mass=3 } Box l { "
            "Size=0.3,0.05,0.08 Pos=0,0.1,0.04 Mass=0.5 } Box r { Size=0.3,0.05,0.08 Pos=0,-0.1,0.04 Mass=0.5 } }\n"
            "  Track left { Geom=hull.l MaxSpeed=0.5 } Track right { Geom=hull.r MaxSpeed=0.5 }\n"
            "  TrackDrive base { LeftTrack=left RightTrack=right TrackSeparation=0.2 }\n}\nRobot c { Config=Crawler }\n";
        row("a crawler", crawler, "", false);
        row("a crawler with another TrackSeparation", changed(crawler, "TrackSeparation=0.2", "TrackSeparation=0.1"),
            "TrackSeparation of base is 100 mm, but the middles of its tracks are apart by 200 mm", true);
        const std::string table =
            "StaticConfig Table { Box top { Size=0.6,0.6,0.4 Pos=0,0,0.2 } }\nStatic table { Config=Table }\n";
        const std::string grid = "Grid g { Config=Crate Count=3 Spacing=1 Pos=0,0,0.4999 }\n";
        row("a Grid in the air", grid, "g_0 starts 400 mm above floor/ground", true);
        row("a Grid with one member on a table", table + grid, "starts 400 mm above floor/ground", false);
        row("a Grid with one member above a table", table + changed(grid, "0.4999", "0.8"),
            "g_0 starts 700 mm above floor/ground", false);
        row("a small robot in the air", kit + "Robot s { Config=Kit Pos=1,0,0.34 }\n", "s starts 340 mm above floor/ground",
            true);
    }
    void fixes() {
        QFETCH(const std::string, text);
        QFETCH(const QString, said);
        QFETCH(const bool, fix);
        const auto loaded = m_fixture.open(text);
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string shown = CheckFixture::shown(*loaded, found);
        QVERIFY2(found.all().empty() == said.isEmpty(), shown.c_str());
        if (said.isEmpty()) return;
        const Diagnostic& d = found.all()[0];
        QVERIFY2(QString::fromStdString(d.message).contains(said), shown.c_str());
        QVERIFY2(d.fixes.empty() != fix, shown.c_str());
        if (!fix) return;
        const std::string repaired = CheckFixture::applied(*loaded, d.fixes[0]);
        QVERIFY2(repaired.find("e-0") == std::string::npos, repaired.c_str()); // 0.0001, not 1e-04
        const auto again = m_fixture.open(repaired);
        const Diagnostics after = CheckFixture::check(*again);
        QVERIFY2(after.all().empty(), (repaired + CheckFixture::shown(*again, after)).c_str());
    }

    /// The robot goes out of the other one the shortest way: by how deep it is in it and no more than 1 mm farther, to no other side.
    void theShortestWayOut_data() {
        QTest::addColumn<Vec3>("offset"); ///< m, of two cubes with sides of 0.2 m
        QTest::addColumn<Vec3>("moved");  ///< until they touch
        QTest::newRow("along x") << Vec3(0.17, 0.05, 0) << Vec3(0.2, 0.05, 0);
        QTest::newRow("against x") << Vec3(-0.16, 0.06, 0) << Vec3(-0.2, 0.06, 0);
        QTest::newRow("along y") << Vec3(0.05, 0.15, 0) << Vec3(0.05, 0.2, 0);
        QTest::newRow("against y") << Vec3(-0.04, -0.16, 0) << Vec3(-0.04, -0.2, 0);
        QTest::newRow("onto it") << Vec3(0.17, 0.05, 0.18) << Vec3(0.17, 0.05, 0.2);
    }
    void theShortestWayOut() {
        QFETCH(const Vec3, offset);
        QFETCH(const Vec3, moved);
        const auto text = [](const Vec3& at) {
            return "Robot s { Config=Crate Pos=" + std::to_string(at.x()) + "," + std::to_string(at.y()) + "," +
                   std::to_string(at.z()) + " }\n";
        };
        const Vec3 first(2, -3, 0.1);
        const auto loaded = m_fixture.open(kThings + "Robot r { Config=Crate Pos=2,-3,0.1 }\n" + text(first + offset));
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY2(found.all().size() == 1 && found.all()[0].fixes.size() == 1, CheckFixture::shown(*loaded, found).c_str());
        const std::string repaired = CheckFixture::applied(*loaded, found.all()[0].fixes[0]);
        const auto again = m_fixture.open(repaired);
        QVERIFY2(again && again->experiment->robots.size() == 2, repaired.c_str());
        const Vec3 farther = again->experiment->robots[1].pose.position - (first + moved), way = (moved - offset).normalized();
        QVERIFY2(farther.dot(way) > 0 && farther.dot(way) < 1e-3, repaired.c_str());
        QVERIFY2((farther - farther.dot(way) * way).norm() < 1e-6, repaired.c_str());
        QVERIFY((again->experiment->robots[0].pose.position - first).norm() < 1e-12);
    }
};

QTEST_APPLESS_MAIN(FixesTest)
#include "fixes_test.moc"
