// Springs and gears from the text to the logs: a sprung, geared vehicle made of parts, a weight on a spring, warnings of fast springs.

#include "flow/cli.h"

namespace {

const char* const kHead =
    "Duration=1.5\n#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/open_floor.sim\n"
    "#loadModule controllers/linear_motion\nStatic floor { Config=OpenFloor }\nSurface runner { Friction=0 }\n";

const char* const kChassis =
    "RobotConfig Kit { Body chassis { Box hull { Size=0.3,0.16,0.06 Pos=0,0,0.13 Mass=3 Material=orange Surface=plastic }\n"
    " Sphere nose { Radius=0.02 Pos=0.14,0,0.02 Mass=0.1 Material=black Surface=runner }\n"
    " Sphere tail { Radius=0.02 Pos=-0.14,0,0.02 Mass=0.1 Material=black Surface=runner } }\n";

/// One side, as a part or by hand: names end with a letter that keeps their order. @s is "" or "-", the sign of what is mirrored.
QString side(const QString& n, const QString& carrier, const QString& s) {
    QString text = QStringLiteral(
        "Body @nA { Pos=0,@s0.11,0.05 Box bar { Size=0.12,0.01,0.02 Mass=0.2 Material=grey Surface=plastic } }\n"
        "Body @nF { Pos=-0.03,@s0.13,0.1 Box disc { Size=0.01,0.03,0.03 Mass=0.05 Material=red Surface=plastic } }\n"
        "Body @nR { Pos=-0.05,@s0.11,0.05 Box rotor { Size=0.02,0.02,0.02 Mass=0.05 Material=red Surface=plastic } }\n"
        "Body @nW { Pos=0,@s0.13,0.05 Cylinder tyre { Radius=0.05 Length=0.02 HPR=0,0,@s90 Mass=0.2 Material=black "
        "Surface=rubber } }\n"
        "Hinge @nPivot { Parent=@c Child=@nA Anchor=-0.1,@s0.11,0.05 Axis=0,1,0 }\n"
        "Hinge @nAxle { Parent=@nA Child=@nW Axis=0,1,0 }\n"
        "Hinge @nShaft { Parent=@nA Child=@nR Axis=0,1,0 }\n"
        "Hinge @nFly { Parent=@nA Child=@nF Axis=1,0,0 }\n"
        "Spring @nCoil { Parent=@c Child=@nA Anchor=0.03,@s0.1,0.16 Anchor2=0.03,@s0.11,0.06 Length=0.13 Stiffness=1500 "
        "Damping=60 }\n"
        "Gear @nBelt { Joint=@nAxle Other=@nShaft Ratio=0.25 }\n"
        "Gear @nBevel { Joint=@nFly Other=@nAxle Ratio=@s2 }\n"
        "RotaryMotor @nMotor { Joint=@nShaft TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=8 MaxVoltage=12 }\n");
    for (const auto& [word, value] : {std::pair{"@n", n}, {"@c", carrier}, {"@s", s}}) text.replace(QLatin1String(word), value);
    return text;
}

QString drive(const QString& left, const QString& right) {
    return QStringLiteral("DifferentialDrive base { LeftMotor=%1 RightMotor=%2 WheelRadius=0.0125 WheelSeparation=0.26 }\n}\n"
                          "Robot r { Config=Kit LinearMotion brain { Distance=0.3 Speed=0.3 } }\n"
                          "SignalLog log { Signals=\"r/*\" Interval=0.5 File=log.csv }\n")
        .arg(left, right);
}

QByteArray hashOf(const Outcome& run) {
    for (const QByteArray& line : (run.out + "\n" + run.err).split('\n'))
        if (line.contains("hash")) return line.simplified();
    return {};
}

/// The last value of a column of a log.
double lastOf(const QString& file, const QByteArray& column) {
    QFile log(file);
    if (!log.open(QIODevice::ReadOnly)) return qQNaN();
    QList<QByteArray> lines = log.readAll().trimmed().split('\n');
    while (!lines.isEmpty() && lines.first().startsWith('#')) lines.removeFirst();
    const auto names = lines.first().split(',');
    for (qsizetype i = 0; i < names.size(); ++i)
        if (names[i].trimmed().startsWith(column)) return lines.last().split(',').value(i).toDouble();
    return qQNaN();
}

} // namespace

class CouplingsFlowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Trailing arms on springs, belts to the wheels, bevel gears to flywheels; the right side mirrored has the bits of its copy by hand.
    void partsMoveLikeTheirCopyByHand() {
        QTemporaryDir folder;
        const QString parts = kHead + QStringLiteral("PartConfig Side {\n") + side("", "$base", "") + "}\n" + kChassis +
                              "Part left { Config=Side base=chassis }\nPart right { Config=Side Mirror=y base=chassis }\n" +
                              drive("left.Motor", "right.Motor");
        const QString hand = kHead + QString(kChassis) + side("left", "chassis", "") + side("right", "chassis", "-") +
                             drive("leftMotor", "rightMotor");
        QVERIFY(writeFile(folder.filePath("parts.sim"), parts.toUtf8()));
        QVERIFY(writeFile(folder.filePath("hand.sim"), hand.toUtf8()));
        const Outcome a = cli({"run", folder.filePath("parts.sim"), "--hash", "--log-dir", folder.filePath("a")}),
                      b = cli({"run", folder.filePath("hand.sim"), "--hash", "--log-dir", folder.filePath("b")});
        QVERIFY2(a.code == 0, a.out + a.err);
        QVERIFY2(b.code == 0, b.out + b.err);
        QVERIFY2(!hashOf(a).isEmpty(), a.out + a.err);
        QCOMPARE(hashOf(a), hashOf(b));
        const auto last = [&](const char* column) { return lastOf(folder.filePath("a/log.csv"), column); };
        const double axle = last("r/left.Axle/position");
        QVERIFY2(axle > 5, qPrintable(QString::number(axle))); // forwards by about 0.3 m
        QVERIFY(std::abs(last("r/right.Axle/position") / axle - 1) < 0.01);
        QVERIFY(std::abs(last("r/left.Shaft/position") / axle - 4) < 0.004);
        QVERIFY(std::abs(last("r/left.Fly/position") / axle - 2) < 0.002);
        QVERIFY(std::abs(last("r/right.Fly/position") / axle + 2) < 0.03);
        QVERIFY(last("r/left.Coil/force") < -5); // carries its share of 3.2 kg
    }

    void weightOnASpring() {
        QTemporaryDir folder;
        const QString text =
            QString(kHead).replace("Duration=1.5", "Duration=4") +
            "RobotConfig Weight { Body iron { Box b { Size=0.1,0.1,0.1 Mass=2 Material=grey Surface=plastic } }\n"
            " Spring coil { Parent=world Child=iron Anchor=0,0,1 Length=30cm Stiffness=500 Damping=20 } }\n"
            "Robot weight { Config=Weight Pos=0,0,0.6 }\n"
            "SignalLog log { Signals=\"weight/coil/*\" Interval=0.5 File=log.csv }\n";
        QVERIFY(writeFile(folder.filePath("weight.sim"), text.toUtf8()));
        const Outcome run = cli({"run", folder.filePath("weight.sim"), "--log-dir", folder.filePath("a")});
        QVERIFY2(run.code == 0, run.out + run.err);
        const auto last = [&](const char* column) { return lastOf(folder.filePath("a/log.csv"), column); };
        QVERIFY2(std::abs(last("weight/coil/force") - 2 * 9.81) < 1e-3, qPrintable(QString::number(last("weight/coil/force"))));
        QVERIFY(std::abs(last("weight/coil/length") - (0.3 + 2 * 9.81 / 500)) < 1e-5);
    }

    void warnsOfFastSprings() {
        QTemporaryDir folder;
        const QString text =
            QString(kHead) +
            "RobotConfig Weight { Body iron { Box b { Size=0.1,0.1,0.1 Mass=2 Material=grey Surface=plastic } }\n"
            " Spring coil { Parent=world Child=iron Anchor=0,0,2 Length=30cm Stiffness=1e6 } }\n"
            "Robot weight { Config=Weight Pos=0,0,1 }\n";
        QVERIFY(writeFile(folder.filePath("weight.sim"), text.toUtf8()));
        const Outcome check = cli({"check", folder.filePath("weight.sim")});
        QVERIFY2((check.out + check.err).contains("the spring coil in Weight swings at 113 Hz"), check.out + check.err);
        QVERIFY(!(check.out + check.err).contains("air"));
    }
};

QTEST_GUILESS_MAIN(CouplingsFlowTest)
#include "couplings_test.moc"
