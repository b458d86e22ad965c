// A robot made of parts moves to the same bits as its copy by hand, wherever parts can be.

#include <map>
#include <optional>

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

/// One side by hand, with other names. `s` is "" or "-", the sign of what is mirrored.
QString side(const QString& n, const QString& s) {
    const QString m = s.isEmpty() ? QStringLiteral("-") : QString();
    const QString low = QString::fromLatin1(s.isEmpty() ? "-100" : "-170"),
                  high = QString::fromLatin1(s.isEmpty() ? "170" : "100");
    const QString roller = QString::fromLatin1(s.isEmpty() ? "roller" : "roller2");
    QString text =
        QStringLiteral(
            "Body @n1 { Pos=0.06,@s0.125,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,@s90 Mass=0.15 Material=black "
            "Surface=rubber }\n Box cleat { Size=0.02,0.01,0.02 Pos=0.01,@s0.02,0.01 HPR=@s10,20,@s30 Mass=0.01 Material=red "
            "Surface=rubber } }\n"
            "Body @n2 { Pos=-0.1,@s0.08,0.05 Box bar { Size=0.02,0.02,0.02 Pos=0.01,@s0.005,0 Mass=0.05 Material=grey "
            "Surface=plastic } }\n"
            "Body @n3 { Pos=$(-0.1-0.02),$(@s0.08+@s0.01),$(0.05-0.03) Sphere tyre { Radius=0.02 Mass=0.05 Material=black "
            "Surface=@roller } }\n"
            "Body @n4 { Pos=0.16,@s0.06,0.07 Box board { Size=0.01,0.1,0.04 Mass=0.05 Material=red Surface=plastic } }\n") +
        QStringLiteral("Hinge @nAxle { Parent=chassis Child=@n1 Axis=0,1,0 Damping=0.001 }\n"
                       "Hinge @nSwivel { Parent=chassis Child=@n2 Axis=0,0,1 LowStop=@low HighStop=@high }\n"
                       "Hinge @nRoll { Parent=@n2 Child=@n3 Axis=0,1,0 }\n"
                       "Slider @nSpring { Parent=chassis Child=@n4 Axis=1,@s0.2,0 LowStop=-0.01 HighStop=0 "
                       "Stiffness=200 Damping=2 }\n"
                       "RotaryMotor @nMotor { Joint=@nAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 "
                       "MaxVoltage=12 }\n"
                       "Encoder @nEncoder { Joint=@nAxle CountsPerRevolution=512 }\n"
                       "TouchSensor @nTouch { Geom=@n4.board }\n");
    for (const auto& [word, value] :
         {std::pair{"@roller", roller}, {"@low", low}, {"@high", high}, {"@n", n}, {"@s", s}, {"@m", m}})
        text.replace(QLatin1String(word), value);
    return text;
}

const char* const kStand = "RobotConfig Kit { Body base { Box foot { Size=0.1,0.1,0.1 Mass=5 Material=grey Surface=plastic } }\n"
                           "Fixed hold { Parent=world Child=base }\n";

/// A limb, or its mirror image: places by the signs of their axes, angles by the product of the two others.
QString limb(const QString& n, const QString& on, const std::array<int, 3>& signs, bool isReversed) {
    const auto triple = [](double x, double y, double z) {
        const auto text = [](double v) { return QString::number(v == 0 ? 0.0 : v); };
        return text(x) + u',' + text(y) + u',' + text(z);
    };
    const auto place = [&](double x, double y, double z) { return triple(signs[0] * x, signs[1] * y, signs[2] * z); };
    const auto angles = [&](double heading, double pitch, double roll) {
        return triple(signs[0] * signs[1] * heading, signs[0] * signs[2] * pitch, signs[1] * signs[2] * roll);
    };
    const QString stops = isReversed ? "LowStop=-80 HighStop=30 RestAngle=-20" : "LowStop=-30 HighStop=80 RestAngle=20";
    return "Body " + n + "A { Pos=" + place(0.1, 0.05, 0.3) + " HPR=" + angles(10, 20, 30) +
           " Box b { Size=0.1,0.05,0.02 Pos=" + place(0.02, 0.01, 0.03) + " HPR=" + angles(5, -15, 25) +
           " Mass=0.4 Material=red Surface=roller } }\n" + "Body " + n + "B { Pos=" + place(0.2, 0.1, 0.3) +
           " HPR=" + angles(-20, 5, 40) + " Sphere s { Radius=0.03 Pos=" + place(0.01, 0.02, 0) +
           " Mass=0.2 Material=red Surface=rubber } }\n" + "Hinge " + n + "J { Parent=" + on + " Child=" + n +
           "A Anchor=" + place(0.05, 0.02, 0.25) + " Axis=0,1,0 " + stops + " Stiffness=0.4 Damping=0.01 }\n" + "Slider " + n +
           "K { Parent=" + n + "A Child=" + n + "B Axis=" + place(0.6, 0.8, 0) +
           " LowStop=-0.05 HighStop=0.02 Stiffness=50 Damping=0.5 RestPosition=0.01 }\n" + "Spring " + n + "S { Parent=" + on +
           " Child=" + n + "B Anchor=" + place(0, 0.1, 0.5) + " Anchor2=" + place(0.2, 0.1, 0.32) +
           " Length=0.2 Stiffness=20 Damping=0.1 }\n";
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

    /// A cylinder that lies on its side is its own mirror image: the copy by hand may keep its turn or reverse it.
    void wheelsByHandMayKeepTheirTurn() {
        QTemporaryDir folder;
        const auto hashWith = [&](const QString& config, const QString& right) {
            const QString text =
                kHead + QString(kParts) + config + kChassis +
                "Part left { Config=DrivenWheel Pos=0.06,0.125,0.05 carrier=chassis }\nPart right { Config=" + right +
                " Pos=0.06,-0.125,0.05 carrier=chassis }\nDifferentialDrive base { LeftMotor=left.motor" +
                QString(kDrive).replace("%2", "right.motor");
            return writeFile(folder.filePath("a.sim"), text.toUtf8()) ? hashOf(cli({"run", folder.filePath("a.sim"), "--hash"}))
                                                                      : "";
        };
        const QByteArray mirrored = hashWith("", "DrivenWheel Mirror=y");
        QVERIFY(!mirrored.isEmpty());
        QString copy = QString(kParts).section("PartConfig Caster", 0, 0).replace("DrivenWheel", "Copy");
        copy.replace("Pos=0.01,0.02,0.01 HPR=10,20,30", "Pos=0.01,-0.02,0.01 HPR=-10,20,-30");
        for (const char* turn : {"HPR=0,0,90", "HPR=0,0,-90"})
            QCOMPARE(hashWith(QString(copy).replace("HPR=0,0,90", turn), "Copy"), mirrored);
    }

    void mirrorImagesMoveLikeTheirCopies_data() {
        QTest::addColumn<QString>("mirrors"); // from inside
        for (const char* mirrors : {"x", "y", "z", "yx", "zxy", "xx"}) QTest::newRow(mirrors) << QString(mirrors);
    }
    /// A limb on a hinge with stops, a sprung slider and a spring, mirrored along each axis, and in mirrored parts.
    void mirrorImagesMoveLikeTheirCopies() {
        QFETCH(QString, mirrors);
        std::array<int, 3> signs{1, 1, 1};
        bool isReversed = false; // the hinge about y: its positive sense stays that about +y
        QString parts = "PartConfig Limb {\n" + limb("", "$on", signs, false) + "}\n", inner = "Limb", name = "p";
        for (const QChar axis : mirrors) {
            signs[std::size_t(axis.unicode() - 'x')] *= -1;
            isReversed = isReversed != (axis != u'y');
            const bool isLast = name.size() == mirrors.size();
            const QString part = "Part p { Config=" + inner + " Mirror=" + axis + " on=" + (isLast ? "base" : "$on") + " }\n";
            if (isLast) parts += kStand + part + "}\n";
            else {
                inner = "Outer" + QString::number(name.size());
                parts += "PartConfig " + inner + " { " + part + "}\n";
                name += "p";
            }
        }
        const QString image = signs[0] * signs[1] * signs[2] < 0 ? "-45" : "45";
        const QString hand = "Surface image { Friction=0.2 Friction2=0.9 FrictionHeading=" + image + " }\n" + kStand +
                             limb(name, "base", signs, isReversed).replace("Surface=roller", "Surface=image") + "}\n";
        const QString robot = "Robot r { Config=Kit Pos=0,0,0.5 }\n";
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("parts.sim"), (kHead + parts + robot).toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"), (kHead + hand + robot).toUtf8()));
        QVERIFY(
            writeFile(folder.filePath("other.sim"), (kHead + QString(hand).replace("Mass=0.4", "Mass=0.41") + robot).toUtf8()));
        const Outcome a = cli({"run", folder.filePath("parts.sim"), "--hash"}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash"}),
                      other = cli({"run", folder.filePath("other.sim"), "--hash"});
        QVERIFY2(a.code == 0, a.err);
        QVERIFY2(b.code == 0, b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
        QVERIFY(hashOf(a) != hashOf(other));
    }

    /// A conveyor of 50 driven rollers, written once, with values that depend on the number.
    void repeatedRollersMoveLikeTheirCopies() {
        const QString roller =
            "Body @b { Pos=$(0.12*@i),0,0.1 HPR=0,0,90 Cylinder tyre { Radius=$(0.05+0.0001*@i) Length=0.4 Mass=$(0.2+0.01*@i) "
            "Material=black Surface=rubber } }\n"
            "Hinge @h { Parent=frame Child=@b Axis=0,1,0 Damping=$(0.001*@i) }\n"
            "RotaryMotor @m { Joint=@h TorqueConstant=0.02 SpeedConstant=50 Resistance=$(2+@i) GearRatio=30 MaxVoltage=12 }\n";
        const auto numbered = [&](const QString& b, const QString& h, const QString& m, const QString& i) {
            QString text = roller;
            return text.replace("@b", b).replace("@h", h).replace("@m", m).replace("@i", i);
        };
        QString copies;
        for (int i = 0; i < 50; ++i) {
            const QString n = QString::number(i);
            copies += numbered("r" + n, "h" + n, "m" + n, n);
        }
        const QString frame =
            kHead + QStringLiteral("RobotConfig Belt {\nBody frame { Pos=3,0,0 Box bed { Size=6,0.5,0.08 Pos=0,0,0.04 Mass=50 "
                                   "Material=grey Surface=plastic } }\n");
        const QString box = "}\nRobot belt { Config=Belt }\nRobotConfig Crate { Body b { Box c { Size=0.5,0.3,0.2 Mass=3 "
                            "Material=red Surface=rubber } } }\nRobot crate { Config=Crate Pos=1,0,0.5 HPR=10,5,0 }\n";
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("once.sim"),
                          (frame + "Repeat roller { Count=50\n" + numbered("b", "h", "m", "index") + "}\n" + box).toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"), (frame + copies + box).toUtf8()));
        const Outcome a = cli({"run", folder.filePath("once.sim"), "--hash"}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash"});
        QVERIFY2(a.code == 0, a.err);
        QVERIFY2(b.code == 0, b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
    }

    /// Wheels of a Repeat in a mirrored Part, in a Grid in which every robot has another number of them.
    void repeatedWheelsInPartsMoveLikeTheirCopies() {
        const QString part = "PartConfig Side { Param n = 2\n Repeat axle { Count=$n Pos=$(0.2*index),0,0.05\n"
                             "  Part wheel { Config=DrivenWheel carrier=$base r=$(0.05+0.001*index) } } }\n";
        const auto robot = [](const QString& name, int n, bool once) {
            QString text =
                "RobotConfig " + name + " { Param n = " + QString::number(n) +
                " Body chassis { Box hull { Size=0.9,0.2,0.06 Pos=0.2,0,0.15 Mass=2 Material=orange Surface=plastic } }\n";
            for (const char* side : {"left", "right"}) {
                const bool isLeft = side[0] == 'l';
                const QString y = isLeft ? "0.125" : "-0.125", mirror = isLeft ? "" : " Mirror=y";
                if (once) {
                    text += "Part " + QString(side) + " { Config=Side base=chassis n=$n Pos=0," + y + ",0" + mirror + " }\n";
                    continue;
                }
                for (int i = 0; i < n; ++i)
                    text += QStringLiteral(
                                "Part %1%2 { Config=DrivenWheel carrier=chassis Pos=$(0.2*%2),%3,0.05 %4 r=$(0.05+0.001*%2) }\n")
                                .arg(side)
                                .arg(i)
                                .arg(y, mirror);
            }
            return text + "}\n";
        };
        const QString head = kHead + QString(kParts);
        QTemporaryDir folder;
        const QString wheels = QString(head).replace("PartConfig Side {", "PartConfig Other {");
        QVERIFY(writeFile(
            folder.filePath("once.sim"),
            (wheels + part + robot("Kit", 2, true) + "Grid g { Config=Kit Count=1,3 Spacing=1 n=$(1+index2) }\n").toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"),
                          (wheels + robot("A", 1, false) + robot("B", 2, false) + robot("C", 3, false) +
                           "Robot ra { Config=A Pos=0,-1,0 }\nRobot rb { Config=B }\nRobot rc { Config=C "
                           "Pos=0,1,0 }\n")
                              .toUtf8()));
        const Outcome a = cli({"run", folder.filePath("once.sim"), "--hash"}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash"});
        QVERIFY2(a.code == 0, a.err);
        QVERIFY2(b.code == 0, b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
    }

    /// A variant is the config with its values in place, and its blocks at the end.
    void variantsMoveLikeTheirCopies() {
        const auto cart = [](const QString& name, const char* r, const char* mass, const char* damping, const char* more) {
            return "RobotConfig " + name + " { Param r = " + r +
                   "\n Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,$(r+0.05) Mass=" + mass +
                   " Material=orange Surface=plastic } }\n Repeat wheel { Count=4 Body rim { "
                   "Pos=$(0.2*mod(index,2)-0.1),$(0.26*floor(index/2)-0.13),$r HPR=0,0,90 Cylinder tyre { Radius=$r Length=0.03 "
                   "Mass=0.15 "
                   "Material=black Surface=rubber } }\n  Hinge axle { Parent=chassis Child=rim Axis=0,1,0 Damping=" +
                   damping + " } }\n" + more + "}\n";
        };
        const char* const mast =
            "Body mast { Box pole { Size=0.02,0.02,0.4 Pos=0.1,0,0.38 Mass=0.5 Material=grey Surface=plastic } }\n"
            "Fixed foot { Parent=chassis Child=mast }\n";
        const QString robot = "Robot r { Config=Tall HPR=20,3,5 Pos=0,0,0.1 wheel_2.axle.Damping=0.01 }\n";
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("variant.sim"),
                          (kHead + cart("Cart", "0.05", "2", "0", "") +
                           "RobotConfig Tall { Config=Cart r=0.08 chassis.hull.Mass=3 wheel.axle.Damping=0.001\n" + mast + "}\n" +
                           robot)
                              .toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"), (kHead + cart("Tall", "0.08", "3", "0.001", mast) + robot).toUtf8()));
        const Outcome a = cli({"run", folder.filePath("variant.sim"), "--hash"}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash"});
        QVERIFY2(a.code == 0, a.err);
        QVERIFY2(b.code == 0, b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
    }

    /// A device on a body from outside is placed by the Part's Pos and HPR, which count in that body.
    void placesDevicesOnABodyFromOutside() {
        const QJsonObject now =
            signalsOf("PartConfig Head { Gps gps { Body=$on Pos=0.1,0.02,0.2 } Compass north { Body=$on HPR=10,0,0 } }\n"
                      "PartConfig Neck { Part head { Config=Head Pos=0,0,0.5 Mirror=y on=$on } }\n"
                      "RobotConfig Kit { Body hull { Box b { Size=0.1,0.1,0.1 Material=red Surface=plastic Mass=1 } }\n"
                      "  Part a { Config=Head on=hull }\n  Part b { Config=Head Pos=0,1,0.3 HPR=90,0,0 on=hull }\n"
                      "  Part c { Config=Head Pos=1,1,0 Mirror=x on=hull }\n  Part d { Config=Neck Pos=0,1,0 on=hull }\n}\n"
                      "Robot r { Config=Kit }\n",
                      "0");
        const std::map<const char*, std::array<double, 4>> expected{{"a.", {0.1, 0.02, 0.2, 10}},
                                                                    {"b.", {-0.02, 1.1, 0.5, 100}},
                                                                    {"c.", {0.9, 1.02, 0.2, 170}},
                                                                    {"d.head.", {0.1, 0.98, 0.7, -10}}};
        for (const auto& [part, numbers] : expected) {
            for (int k = 0; k < 3; ++k)
                QVERIFY2(std::abs(now[QString(part) + "gps/position"][k].toDouble() - numbers[std::size_t(k)]) < 1e-12, part);
            const double heading = now[QString(part) + "north/heading"].toDouble();
            QVERIFY2(std::abs(heading - numbers[3]) < 1e-9, qPrintable(QStringLiteral("%1 %2").arg(part).arg(heading)));
        }
    }

    /// The left motor of a base is on its right in its mirror image by y: it turns to the same side under the same command.
    void mirroredBasesExchangeTheirSides() {
        for (const char* mirror : {"none", "y"}) {
            const QJsonObject now = signalsOf(
                QByteArray("#loadModule controllers/arc_motion\n") + kParts +
                    "PartConfig Base { Body hull { Box b { Size=0.3,0.2,0.06 Pos=0,0,0.1 Mass=2 Material=orange Surface=plastic "
                    "}\n"
                    "    Sphere slider { Radius=0.02 Pos=-0.12,0,0.02 Mass=0.05 Material=grey Surface=slick } }\n"
                    "  Part l { Config=DrivenWheel Pos=0.06,0.125,0.05 carrier=hull }\n"
                    "  Part r { Config=DrivenWheel Pos=0.06,-0.125,0.05 carrier=hull Mirror=y }\n"
                    "  DifferentialDrive drive { LeftMotor=l.motor RightMotor=r.motor WheelRadius=0.05 WheelSeparation=0.25 } }\n"
                    "RobotConfig Kit { Part base { Config=Base Mirror=" +
                    mirror +
                    " } }\nRobot r { Config=Kit ArcMotion brain { Drive=\"base.drive\" Speed=0.1 TurnRate=0.5 Angle=25 } }\n",
                "2");
            for (const char* pose : {"base.drive/pose", "base.drive/odometry"})
                QVERIFY2(std::abs(now[QLatin1String(pose)][2].toDouble() - 25) < 1, mirror + QJsonDocument(now).toJson());
        }
    }

    /// Its rollers are mirrored too, so that each wheel takes the place of the one across.
    void theMirrorImageOfAMecanumBaseTurnsTheSameWay() {
        const char* const kTurn = "import trundle\nclass Turn(trundle.Controller):\n    \"\"\"Drives an arc.\"\"\"\n"
                                  "    def setup(self, robot): self.drive = robot.port('base.drive')\n"
                                  "    def update(self, dt):\n        self.drive.set('linearVelocity', 0.3)\n"
                                  "        self.drive.set('angularVelocity', 0.6)\n";
        std::optional<double> heading; ///< deg, the same for all
        for (const char* mirror : {"none", "y", "x"}) {
            const QJsonObject now = signalsOf(
                QByteArray("#loadModule turn.py\nSurface mecanum { Friction=0.8 Friction2=0 FrictionHeading=-45 }\n"
                           "PartConfig Wheel { Body wheel { Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 Material=black "
                           "Surface=mecanum } }\n  Hinge axle { Parent=$c Child=wheel Axis=0,1,0 }\n"
                           "  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=0.5 GearRatio=15 MaxVoltage=12 } }\n"
                           "PartConfig Base { Body hull { Box h { Size=0.3,0.2,0.06 Pos=0,0,0.1 Mass=3 Material=blue Surface=plastic } }\n"
                           "  Part fl { Config=Wheel c=hull Pos=0.15,0.15,0.05 }\n"
                           "  Part fr { Config=Wheel c=hull Pos=0.15,-0.15,0.05 Mirror=y }\n"
                           "  Part bl { Config=Wheel c=hull Pos=-0.15,0.15,0.05 Mirror=y }\n"
                           "  Part br { Config=Wheel c=hull Pos=-0.15,-0.15,0.05 }\n"
                           "  MecanumDrive drive { FrontLeftMotor=fl.motor FrontRightMotor=fr.motor BackLeftMotor=bl.motor "
                           "BackRightMotor=br.motor WheelRadius=0.05 WheelSeparation=0.3 WheelBase=0.3 } }\n"
                           "RobotConfig Kit { Part base { Config=Base Mirror=") +
                    mirror + " } }\nRobot r { Config=Kit Turn brain { } }\n",
                "1.5", "turn.py", kTurn);
            heading = heading.value_or(now["pose"][3].toDouble());
            QVERIFY2(*heading > 40 && std::abs(now["pose"][3].toDouble() - *heading) < 1e-6, mirror + QJsonDocument(now).toJson());
            for (const char* pose : {"base.drive/pose", "base.drive/odometry"})
                QVERIFY2(std::abs(now[QLatin1String(pose)][2].toDouble() - *heading) < 1, mirror + QJsonDocument(now).toJson());
        }
    }

    void aMirroredBeltRunsTheMirroredWay() {
        struct Row {
            const char *mirror, *heading;
            double way; ///< deg
        };
        for (const Row& row : {Row{"none", "30", 50}, {"y", "30", -50}, {"x", "30", 130}, {"none", "0", 20}, {"x", "0", 160}, {"y", "0", -20}}) {
            QTemporaryDir folder;
            QVERIFY(writeFile(folder.filePath("push.py"), "import trundle\nclass Push(trundle.Controller):\n    \"\"\"Runs a belt.\"\"\"\n"
                                                          "    def setup(self, robot): self.belt = robot.port('line.belt')\n"
                                                          "    def update(self, dt): self.belt.set('speed', 0.3)\n"));
            QVERIFY(writeFile(folder.filePath("belt.sim"),
                              kHead + QByteArray("#loadModule push.py\nPartConfig Line { Box deck { Size=3,1,0.1 Pos=0,0,0.15 HPR=20,0,0 Material=grey "
                                                 "Surface=rubber }\n  Belt belt { Geom=deck MaxSpeed=1 Heading=") +
                                  row.heading + " } }\nStaticConfig Hall { Part line { Config=Line Mirror=" + row.mirror +
                                  " } }\nRobotConfig Parcel { Body b { Box b { Size=0.1,0.1,0.1 Mass=0.4 Material=red Surface=rubber } } }\n"
                                  "Static hall { Config=Hall Push brain { } }\nRobot parcel { Config=Parcel Pos=0,0,0.2501 }\n"));
            const Outcome run = cli({"run", folder.filePath("belt.sim"), "--trust", "--json"});
            const QJsonArray at = QJsonDocument::fromJson(run.out)["robots"]["parcel"]["pos"].toArray();
            QVERIFY2(at.size() == 3 && std::hypot(at[0].toDouble(), at[1].toDouble()) > 0.2, shown(run));
            const double way = std::atan2(at[1].toDouble(), at[0].toDouble()) * 180 / M_PI;
            QVERIFY2(std::abs(way - row.way) < 0.1, qPrintable(QString("%1 %2: %3").arg(row.mirror, row.heading).arg(way)));
        }
    }

    void basesWithoutMirrorImageAreRefused() {
        QTemporaryDir folder;
        const QByteArray car = "PartConfig Base { Body hull { Box b { Size=0.3,0.2,0.06 Mass=2 Material=orange Surface=plastic } }\n"
                               "  Part l { Config=DrivenWheel carrier=hull } Part r { Config=DrivenWheel carrier=hull }\n"
                               "  OmniDrive drive { Motors=l.motor,r.motor,l.motor WheelRadius=0.05 WheelDistance=0.1 } }\n"
                               "RobotConfig Kit { Part base { Config=Base Mirror=y } }\nRobot r { Config=Kit }\n";
        const auto refuses = [&](const QByteArray& text, const QByteArray& base) {
            const QString file = folder.filePath("base.sim");
            if (!writeFile(file, kHead + QByteArray(kParts) + text)) return false;
            const Outcome check = cli({"check", file});
            return check.code != 0 && check.err.contains("error E306: " + base + " drive has no mirror image");
        };
        QVERIFY(refuses(car, "OmniDrive"));
        QByteArray mecanum = car;
        mecanum.replace(
            "OmniDrive drive { Motors=l.motor,r.motor,l.motor WheelRadius=0.05 WheelDistance=0.1",
            "MecanumDrive drive { FrontLeftMotor=l.motor FrontRightMotor=r.motor BackLeftMotor=l.motor BackRightMotor=r.motor "
            "WheelRadius=0.05 WheelSeparation=0.2 WheelBase=0.2");
        QVERIFY(!refuses(mecanum, "MecanumDrive"));
        QVERIFY(refuses(mecanum.replace("Mirror=y", "Mirror=z"), "MecanumDrive"));
    }

    /// A wrong value that a joint uses is the one error: the body is not called loose besides.
    void aWrongValueIsTheOnlyError() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("door.sim"), "#import common/materials.sim\n#import common/surfaces.sim\n"
                                                       "StaticConfig Door { Param k = 1 { Min=0 Max=5 }\n"
                                                       "  Body leaf { Pos=0,0,0.5 Box b { Size=0.4,0.02,0.3 Mass=1 Material=blue Surface=slick } }\n"
                                                       "  Hinge hinge { Parent=world Child=leaf Stiffness=$k } }\nStatic door { Config=Door k=9 }\n"));
        const Outcome check = cli({"check", folder.filePath("door.sim")});
        QVERIFY2(check.err.contains("error E203: k is 9") && !check.err.contains("E302"), shown(check));
    }

private:
    /// Of robot r, at the end.
    QJsonObject signalsOf(const QByteArray& blocks, const char* duration, const char* module = "", const QByteArray& code = {}) {
        QTemporaryDir folder;
        if (!writeFile(folder.filePath("robot.sim"), kHead + blocks)) return {};
        if (*module && !writeFile(folder.filePath(module), code)) return {};
        const Outcome run = cli({"run", folder.filePath("robot.sim"), "--duration", duration, "--json", "--trust"});
        return QJsonDocument::fromJson(run.out)["robots"]["r"]["signals"].toObject();
    }
};

QTEST_GUILESS_MAIN(PartsFlowTest)
#include "parts_test.moc"
