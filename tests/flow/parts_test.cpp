// A robot made of parts moves to the same bits as its copy by hand, wherever parts can be.

#include "flow/cli.h"

namespace {

const char* const kHead =
    "Duration=1.5\n#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/open_floor.sim\n"
    "#loadModule controllers/linear_motion\nStatic floor { Config=OpenFloor }\n"
    "Surface roller { Friction=0.2 Friction2=0.9 FrictionHeading=45 }\n";

const char* const kParts =
    "PartConfig DrivenWheel { Param r = 0.05\n"
    "  Body wheel { Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 Material=black Surface=rubber }\n"
    "    Box cleat { Size=0.02,0.01,0.02 Pos=0.01,0.02,0.01 HPR=10,20,30 Mass=0.01 Material=red Surface=rubber } }\n"
    "  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 Damping=0.001 }\n"
    "  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }\n"
    "  Encoder encoder { Joint=axle CountsPerRevolution=512 } }\n"
    "PartConfig Caster {\n"
    "  Body fork { Box bar { Size=0.02,0.02,0.02 Pos=0.01,0.005,0 Mass=0.05 Material=grey Surface=plastic } }\n"
    "  Body ball { Pos=-0.02,0.01,-0.03 Sphere tyre { Radius=0.02 Mass=0.05 Material=black Surface=roller } }\n"
    "  Hinge swivel { Parent=$carrier Child=fork Axis=0,0,1 LowStop=-100 HighStop=170 }\n"
    "  Hinge roll { Parent=fork Child=ball Axis=0,1,0 } }\n"
    "PartConfig Bumper { Body plate { Box board { Size=0.01,0.1,0.04 Mass=0.05 Material=red Surface=plastic } }\n"
    "  Slider spring { Parent=$carrier Child=plate Axis=1,0.2,0 LowStop=-0.01 HighStop=0 Stiffness=200 Damping=2 }\n"
    "  TouchSensor touch { Geom=plate.board } }\n"
    "PartConfig Side { Part wheel { Config=DrivenWheel Pos=0.06,0.125,0.05 carrier=$base }\n"
    "  Part caster { Config=Caster Pos=-0.1,0.08,0.05 carrier=$base }\n"
    "  Part bumper { Config=Bumper Pos=0.16,0.06,0.07 carrier=$base } }\n";

const char* const kChassis = "RobotConfig Kit { Body chassis { Box hull { Size=0.3,0.2,0.06 Pos=0,0,0.1 Mass=2 Material=orange "
                             "Surface=plastic } }\n";
const char* const kDrive = " RightMotor=%2 WheelRadius=0.05 WheelSeparation=0.25 }\n}\n"
                           "Grid g { Config=Kit Count=2 Spacing=1 HPR=30,0,0 LinearMotion brain { Distance=0.3 Speed=0.3 } }\n";

/// One side by hand; its bodies A to D are in the order of the names of those of the parts. `s` is "" or "-", the sign of what is mirrored.
QString side(const QString& n, const QString& s) {
    const QString m = s.isEmpty() ? QStringLiteral("-") : QString();
    const QString low = QString::fromLatin1(s.isEmpty() ? "-100" : "-170"),
                  high = QString::fromLatin1(s.isEmpty() ? "170" : "100");
    const QString roller = QString::fromLatin1(s.isEmpty() ? "roller" : "roller2");
    QString text =
        QStringLiteral(
            "Body @nD { Pos=0.06,@s0.125,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,@s90 Mass=0.15 Material=black "
            "Surface=rubber }\n Box cleat { Size=0.02,0.01,0.02 Pos=0.01,@s0.02,0.01 HPR=@s10,20,@s30 Mass=0.01 Material=red "
            "Surface=rubber } }\n"
            "Body @nC { Pos=-0.1,@s0.08,0.05 Box bar { Size=0.02,0.02,0.02 Pos=0.01,@s0.005,0 Mass=0.05 Material=grey "
            "Surface=plastic } }\n"
            "Body @nB { Pos=$(-0.1-0.02),$(@s0.08+@s0.01),$(0.05-0.03) Sphere tyre { Radius=0.02 Mass=0.05 Material=black "
            "Surface=@roller } }\n"
            "Body @nA { Pos=0.16,@s0.06,0.07 Box board { Size=0.01,0.1,0.04 Mass=0.05 Material=red Surface=plastic } }\n") +
        QStringLiteral("Hinge @nAxle { Parent=chassis Child=@nD Axis=0,1,0 Damping=0.001 }\n"
                       "Hinge @nSwivel { Parent=chassis Child=@nC Axis=0,0,1 LowStop=@low HighStop=@high }\n"
                       "Hinge @nRoll { Parent=@nC Child=@nB Axis=0,1,0 }\n"
                       "Slider @nSpring { Parent=chassis Child=@nA Axis=1,@s0.2,0 LowStop=-0.01 HighStop=0 "
                       "Stiffness=200 Damping=2 }\n"
                       "RotaryMotor @nMotor { Joint=@nAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 "
                       "MaxVoltage=12 }\n"
                       "Encoder @nEncoder { Joint=@nAxle CountsPerRevolution=512 }\n"
                       "TouchSensor @nTouch { Geom=@nA.board }\n");
    for (const auto& [word, value] :
         {std::pair{"@roller", roller}, {"@low", low}, {"@high", high}, {"@n", n}, {"@s", s}, {"@m", m}})
        text.replace(QLatin1String(word), value);
    return text;
}

QByteArray hashOf(const Outcome& run) {
    for (const QByteArray& line : (run.out + "\n" + run.err).split('\n'))
        if (line.contains("hash")) return line.simplified();
    return {};
}

} // namespace

class PartsFlowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Driven wheels, casters with stops, sprung bumpers with sensors: parts in parts, the right side mirrored.
    void movesLikeItsCopyByHand() {
        QTemporaryDir folder;
        const QString parts = kHead + QString(kParts) + kChassis +
                              "Part left { Config=Side base=chassis }\nPart right { Config=Side Mirror=y base=chassis }\n"
                              "DifferentialDrive base { LeftMotor=left.wheel.motor" +
                              QString(kDrive).replace("%2", "right.wheel.motor");
        const QString hand = kHead + QStringLiteral("Surface roller2 { Friction=0.2 Friction2=0.9 FrictionHeading=-45 }\n") +
                             kChassis + side("left", "") + side("right", "-") + "DifferentialDrive base { LeftMotor=leftMotor" +
                             QString(kDrive).replace("%2", "rightMotor");
        QVERIFY(writeFile(folder.filePath("parts.sim"), parts.toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"), hand.toUtf8()));
        const Outcome a = cli({"run", folder.filePath("parts.sim"), "--hash"}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash"});
        QVERIFY2(a.code == 0, a.err);
        QVERIFY2(b.code == 0, b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
    }
};

QTEST_GUILESS_MAIN(PartsFlowTest)
#include "parts_test.moc"
