// The pieces that the checks are made of: extents, insides, figures in words; and places at which nothing is wrong.
#include "check/finding_rows.h"

#include "check/checks.h"
#include "check/extent.h"
#include "check/inside_mesh.h"

using namespace fixture;

namespace {

TriangleMesh tetrahedron(bool isInsideOut) {
    TriangleMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if (isInsideOut) reverseTriangles(mesh, std::vector<bool>(4, true));
    return mesh;
}

/// A base on the floor and a mast on a rail, which a motor lifts.
std::string lift(const std::string& joint, const std::string& more) {
    return "RobotConfig B {\n  Body base { Box b { Size=0.4,0.4,0.4 Mass=20 } }\n"
           "  Body mast { Pos=0.25,0,0 Box b { Size=0.1,0.1,0.1 Mass=0.5 } }\n  Slider rail { Parent=base Child=mast " +
           joint + " }\n" + more + "}\nRobot r { Config=B Pos=0,0,0.2 }\n";
}

/// A rover of 2.45 kg that pushes with 14 N.
const std::string kRover =
    "RobotConfig B {\n  Body chassis { Box hull { Pos=0,0,0.08 Size=0.3,0.2,0.06 Mass=2 } Sphere ball { Pos=-0.1,0,0.02 "
    "Radius=0.02 "
    "Mass=0.05 } }\n"
    "  Body left { Pos=0.05,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n"
    "  Body right { Pos=0.05,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n"
    "  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }\n  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }\n"
    "  RotaryMotor leftMotor { Joint=leftAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.002 SpeedConstant=500 GearRatio=30 }\n"
    "  RotaryMotor rightMotor { Joint=rightAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.002 SpeedConstant=500 GearRatio=30 "
    "}\n"
    "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }\n}\n"
    "Robot r { Config=B }\n";
std::string slope(const std::string& size, const std::string& pitch) {
    return "StaticConfig W { Box b { Size=" + size + " } }\nStatic wall { Config=W Pos=9,0,3 HPR=0," + pitch + ",0 }\n";
}

const std::string kTwo = "Robot a { Config=Crate Pos=0,0,0.1 }\nRobot c { Config=Crate Pos=0.2,0,0.1 }\n";

} // namespace

class PiecesTest : public QObject, FindingRows {
    Q_OBJECT

private Q_SLOTS:
    void findings_data() {
        columns();
        row("lifts just what it weighs",
            lift("Axis=0,0,1 LowStop=-0.1 HighStop=0.1", "  LinearMotor m { Joint=rail MaxForce=4.905 MaxSpeed=0.1 }\n"), "");
        row("lifts a little less",
            lift("Axis=0,0,1 LowStop=-0.1 HighStop=0.1", "  LinearMotor m { Joint=rail MaxForce=4.9 MaxSpeed=0.1 }\n"),
            "m of B cannot lift what is on rail");
        row("two that lift",
            lift("Axis=0,0,1 LowStop=-0.1 HighStop=0.1", "  LinearMotor m { Joint=rail MaxForce=9 MaxSpeed=0.1 }\n"
                                                         "  LinearMotor n { Joint=rail MaxForce=9 MaxSpeed=0.1 }\n"),
            "n and m move the same joint, rail");
        row("a rail with a spring",
            lift("Axis=0,0,1 LowStop=-0.1 HighStop=0.1 Stiffness=500 Damping=20",
                 "  LinearMotor m { Joint=rail MaxForce=1 MaxSpeed=0.1 }\n"),
            "");
        const auto arm = [](const char* place, const char* box, const char* torque,
                            const char* mode) { // of 1 kg, which hangs down at the start
            return "RobotConfig B {\n  Body base { Box b { Size=0.4,0.4,0.4 Mass=20 } }\n  Body arm { Pos=0,0.25," +
                   std::string(place) + " Box b { Pos=0,0," + box +
                   " Size=0.02,0.02,0.2 Mass=1 } }\n  Hinge tip { Parent=base Child=arm Axis=0,1,0 Anchor=0,0.25,0.2 LowStop=-90 "
                   "HighStop=90 }\n"
                   "  Servo m { Joint=tip MaxSpeed=3 MaxTorque=" +
                   torque + mode + " }\n}\nRobot r { Config=B Pos=0,0,0.2 }\n";
        };
        row("an arm that it can hold", arm("0.1", "0", "1", ""), "");
        row("an arm that it cannot hold", arm("0.1", "0", "0.9", ""),
            "m of B cannot hold tip everywhere: at -90 degrees what hangs on it takes 0.981 N m");
        row("an arm whose mass is beside its origin", arm("0.2", "-0.1", "0.9", ""),
            "at -90 degrees what hangs on it takes 0.981 N m");
        row("a servo that is set by its speed", arm("0.1", "0", "0.9", " Mode=speed"), "");
        row("two joints between the same robots",
            kTwo +
                "Ball one { Parent=a.b Child=c.b Anchor=0.1,0.05,0.1 }\nBall two { Parent=a.b Child=c.b Anchor=0.1,-0.05,0.1 }\n",
            "");
        row("a rail between robots has no point",
            "Robot a { Config=Crate Pos=5,0,0.1 }\nRobot c { Config=Crate Pos=5.2,0,0.1 }\nSlider rail { Parent=a.b Child=c.b "
            "Axis=1,0,0 }\n",
            "");
        row("a joint beside a small ball",
            "RobotConfig Bead { Body b { Sphere s { Radius=0.01 Mass=0.1 } } }\nRobot a { Config=Bead Pos=0,0,0.01 }\n"
            "Ball string { Parent=world Child=a.b Anchor=0,0,0.05 }\n",
            "");
        row("a joint farther away from it",
            "RobotConfig Bead { Body b { Sphere s { Radius=0.01 Mass=0.1 } } }\nRobot a { Config=Bead Pos=0,0,0.01 }\n"
            "Ball string { Parent=world Child=a.b Anchor=0,0,0.08 }\n",
            "the Anchor of string is 60 mm away from a.b");
        row("held in the air from outside", "Robot a { Config=Crate Pos=0,0,2 }\nFixed hold { Parent=world Child=a.b }\n", "");
        row("a joint a little away from its bodies",
            "RobotConfig C { Body a { Box g { Size=0.2,0.2,0.2 Mass=2 } } Body e { Pos=0.3,0,0 Box g { Size=0.2,0.2,0.2 Mass=2 } "
            "}\n"
            "  Hinge h { Parent=a Child=e Axis=0,0,1 Anchor=0,1.1,0 } }\nRobot r { Config=C Pos=0,0,0.1 }\n",
            "");
        row("shapes of two bodies that do not collide",
            "RobotConfig B { Body chassis { Box hull { Pos=0,0,0.12 Size=0.3,0.2,0.04 Mass=1 } Box leg { Pos=0,0,0.05 "
            "Size=0.1,0.1,0.1 Mass=1 } }\n"
            "  Body one { Pos=0.1,0,0.1 Sphere s { Radius=0.01 Mass=0.1 Collide=false } }\n"
            "  Body two { Pos=0.1,0,0.1 Sphere s { Radius=0.01 Mass=0.1 Collide=false } }\n"
            "  Fixed a { Parent=chassis Child=one } Fixed b { Parent=chassis Child=two } }\nRobot r { Config=B }\n",
            "");
        row("a roller beside a box is no wheel",
            "RobotConfig H { Body a { Box g { Size=0.2,0.2,0.2 Mass=2 } } Body e { Pos=0.4,0,-0.06 Cylinder c { Radius=0.04 "
            "Length=0.2 HPR=0,0,90 Mass=1 } } }\n"
            "Robot r { Config=H Pos=0,0,0.1 }\n",
            "");
        row("a slope that it climbs", kRover + slope("1,1,0.3", "20"), "");
        row("a slope that is too steep for it", kRover + slope("1,1,0.3", "38"), "a slope of 38 degrees, that of wall/b, needs",
            "GearRatio=38.5");
        row("a wall that leans", kRover + slope("1,1,0.3", "60"), "");
        row("a block that is no ramp", kRover + slope("0.9,1,0.9", "38"), "");
    }
    void findings() { check(); }

    void figures() {
        for (const auto& [value, text] : {std::pair(999.4, "999"),
                                          {999.5, "1000"},
                                          {-999.6, "-1000"},
                                          {2500., "2500"},
                                          {0.012345, "0.0123"},
                                          {9.9e8, "990000000"},
                                          {1e9, "1e+09"}})
            QCOMPARE(figureText(value), std::string(text));
        for (const auto& [value, text] : {std::pair(0.9994, "999 mm"), {0.9996, "1 m"}, {-2., "-2 m"}, {-0.05, "-50 mm"}})
            QCOMPARE(lengthText(value), std::string(text));
    }

    /// Not beside its faces, and nowhere in one that is inside out.
    void insideOfAMesh() {
        const TriangleMesh mesh = tetrahedron(false), reversed = tetrahedron(true);
        for (double x = -0.35; x < 1.2; x += 0.1)
            for (double y = -0.33; y < 1.2; y += 0.1)
                for (double z = -0.37; z < 1.2; z += 0.1) {
                    QCOMPARE(isInside(mesh, {x, y, z}), x > 0 && y > 0 && z > 0 && x + y + z < 1);
                    QVERIFY(!isInside(reversed, {x, y, z}));
                }
    }

    /// Of a shape that is turned and moved, by its hull if it has one.
    void extents() {
        GeomSpec geom;
        geom.shape = GeomShape::Mesh;
        geom.mesh = std::make_shared<TriangleMesh>(tetrahedron(false));
        const Pose pose{Vec3(1, 2, 3), rotationFromHpr({M_PI / 2, 0, 0})}; // x becomes y
        const Extent own = extentAlong(geom, pose, Vec3::UnitY());
        QVERIFY(std::abs(own.low - 2) < 1e-12 && std::abs(own.high - 3) < 1e-12);
        auto hull = std::make_shared<TriangleMesh>(tetrahedron(false));
        hull->points[1] = {4, 0, 0};
        geom.hull = hull;
        const Extent wide = extentAlong(geom, pose, Vec3::UnitY());
        QVERIFY(std::abs(wide.low - 2) < 1e-12 && std::abs(wide.high - 6) < 1e-12);
        GeomSpec capsule;
        capsule.shape = GeomShape::Capsule;
        capsule.radius = 0.1;
        capsule.length = 1;
        const Extent tilted = extentAlong(capsule, {Vec3::Zero(), rotationFromHpr({0, M_PI / 3, 0})}, Vec3::UnitZ());
        QVERIFY(std::abs(tilted.high - 0.35) < 1e-12 && std::abs(tilted.low + 0.35) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(PiecesTest)
#include "pieces_test.moc"
