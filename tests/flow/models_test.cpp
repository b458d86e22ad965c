// `check --model`: the robot models of a file by themselves, on a plain floor.
#include "flow/cli.h"

namespace {

const char* const kImports = "#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/open_floor.sim\nStatic "
                             "floor { Config=OpenFloor }\n";

/// Built with y upwards and its origin in the middle of its hull.
const char* const kYUp =
    "RobotConfig Y {\n"
    " Body chassis { Box hull { Size=0.3,0.1,0.2 Mass=2 Material=red Surface=plastic }\n"
    "  Sphere slider { Radius=0.02 Pos=-0.12,-0.07,0 Mass=0.05 Material=grey Surface=slick } }\n"
    " Body left { Pos=0.06,-0.04,-0.125 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.15 Material=black Surface=rubber } }\n"
    " Body right { Pos=0.06,-0.04,0.125 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.15 Material=black Surface=rubber } }\n"
    " Hinge leftAxle { Parent=chassis Child=left Axis=0,0,-1 }\n Hinge rightAxle { Parent=chassis Child=right Axis=0,0,-1 }\n"
    " RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }\n"
    " RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }\n"
    " DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.25 } }\n";

} // namespace

class ModelsFlowTest : public QObject {
    Q_OBJECT

    Outcome checked(const QByteArray& text) {
        return writeFile(m_folder.filePath("models.sim"), text) ? cli({"check", "--model", m_folder.filePath("models.sim")})
                                                                : Outcome();
    }
    QTemporaryDir m_folder;

private Q_SLOTS:
    /// Places are in the file of the models.
    void modelsAreCheckedWithoutTheirExperiment() {
        const QByteArray text =
            kImports + QByteArray("RobotConfig Cube { Body b { Box hull { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=1 "
                                  "Material=red Surface=plastic } } }\n"
                                  "Robot one { Config=Cube }\nRobot two { Config=Cube Pos=0.5,0,0 }\n"
                                  "Ball rope { Parent=one.b Child=two.b Anchor=0.25,0,0.1 }\nPoseLog p { Robot=one }\n");
        const Outcome check = checked(text);
        QVERIFY2(check.code == 0 && check.err.isEmpty(), shown(check));
        const Outcome below = checked(QByteArray(text).replace("Pos=0,0,0.1", "Pos=0,0,-0.5"));
        QVERIFY2(below.err.contains("models.sim:5:13: warning E326: Cube starts below plain_floor/floor"), shown(below));
    }

    void aModelIsUprightAsItsFirstRobotIs_data() {
        QTest::addColumn<QByteArray>("robot");
        QTest::addColumn<bool>("isUpright");
        QTest::newRow("on the floor") << QByteArray("Robot r { Config=Y HPR=0,0,90 Pos=2,3,0.09 }\n") << true;
        QTest::newRow("on a table") << QByteArray("Robot r { Config=Y HPR=0,0,90 Pos=2,3,0.79 }\n") << true;
        QTest::newRow("in y-up gravity") << QByteArray("Gravity=0,-9.81,0\nRobot r { Config=Y Pos=2,0.09,0 }\n") << true;
        QTest::newRow("on its side") << QByteArray("Robot r { Config=Y Pos=0,0,0.14 }\n") << false;
    }
    void aModelIsUprightAsItsFirstRobotIs() {
        QFETCH(QByteArray, robot);
        QFETCH(bool, isUpright);
        const Outcome check = checked(kImports + QByteArray(kYUp) + robot);
        QVERIFY2(check.code == 0 && check.err.isEmpty() == isUpright, shown(check));
    }

    /// A model without a robot is placed with its origin on the floor.
    void aModelWithoutARobot() {
        const Outcome check = checked(kImports + QByteArray(kYUp));
        QVERIFY2(check.err.contains("Y starts below plain_floor/floor") ||
                     check.err.contains("Y starts inside plain_floor/floor"),
                 shown(check));
    }
};

QTEST_GUILESS_MAIN(ModelsFlowTest)
#include "models_test.moc"
