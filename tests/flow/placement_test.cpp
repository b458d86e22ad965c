// Worlds written with Repeat, Ring and Grid, and bodies placed in other bodies, move to the same bits as their copies by hand.

#include "flow/cli.h"

namespace {

const char* const kWorld =
    "Duration=1\n#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/open_floor.sim\n"
    "#import robots/simple_robot.sim\n#loadModule controllers/linear_motion\nStatic floor { Config=OpenFloor }\n"
    "StaticConfig Post { Param h = 0.2 Box wood { Size=0.05,0.05,$h Pos=0,0,$(h/2) Material=grey Surface=plastic } }\n"
    "RobotConfig Crate { Body b { Box c { Size=0.1,0.1,0.1 Mass=0.3 Material=red Surface=rubber } } }\n";

QString hashIn(const QTemporaryDir& folder, const char* name, const QString& text) {
    if (!writeFile(folder.filePath(name), text.toUtf8())) return {};
    const Outcome o = cli({"run", folder.filePath(name), "--hash"});
    if (o.code != 0) qWarning() << o.err;
    for (const QByteArray& line : o.out.split('\n'))
        if (o.code == 0 && line.startsWith("state-hash")) return QString::fromUtf8(line);
    return {};
}

/// `text` with @i replaced by a number.
QString numbered(QString text, int i) { return text.replace("@i", QString::number(i)); }

} // namespace

class PlacementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void repeatedRobotsMoveLikeTheirCopies() {
        const QString member =
            "Robot r@n_cart { Config=SimpleRobot Pos=@x,0.1,0 LinearMotion brain { Distance=0.3 Speed=$(0.1+0.1*@i) } }\n"
            "Robot r@n_crate { Config=Crate Pos=@y,0.1,0.06 b.c.Mass=$(0.3+0.1*@i) }\n"
            "Static post@n { Config=Post h=$(0.2+0.1*@i) Pos=@z,0.1,0 }\n"
            "Spring tie@n { Parent=r@n_cart.chassis Child=r@n_crate.b Stiffness=3 Damping=0.2 }\n";
        const auto filled = [&](const QString& n, const QString& i, const QString& offset) {
            QString text = member;
            const auto at = [&](const char* number) {
                return offset.isEmpty() ? QString(number) : "$(" + offset + "+" + number + ")";
            };
            return text.replace("@n", n)
                .replace("@i", i)
                .replace("@x", at("0.25"))
                .replace("@y", at("0.75"))
                .replace("@z", at("-0.5"));
        };
        // The names sort alike in both: the hash goes by names.
        QString copies;
        for (int i = 0; i < 3; ++i) copies += filled(QString::number(i), QString::number(i), QStringLiteral("1.5*%1").arg(i));
        QTemporaryDir folder;
        const QString once = hashIn(folder, "once.sim",
                                    kWorld + ("Repeat row { Count=3 Pos=$(1.5*index),0,0\n" + filled("", "index", "") + "}\n"));
        QVERIFY(!once.isEmpty());
        QCOMPARE(once, hashIn(folder, "hand.sim", kWorld + copies));
        QVERIFY(once != hashIn(folder, "other.sim", kWorld + filled("", "0", "")));
    }

    void aRingOfRobotsMovesLikeItsCopies() {
        const QString one = "Robot r@i { Config=SimpleRobot Pos=@p HPR=@h,0,0 LinearMotion brain { Distance=0.3 } }\n";
        QString copies;
        const char* const places[] = {"2,0,0", "0,2,0", "-2,0,0", "0,-2,0"};
        for (int i = 0; i < 2; ++i) copies += numbered(one, i).replace("@p", places[i]).replace("@h", QString::number(90 * i));
        QTemporaryDir folder;
        const QString ring = "Ring c { Count=4 Radius=2 Robot r { Config=SimpleRobot LinearMotion brain { Distance=0.3 } } }\n";
        const QString repeat = "Repeat c { Count=4 Pos=$(2*index),0,0 HPR=$(30*index),0,0 Robot r { Config=SimpleRobot "
                               "LinearMotion brain { Distance=0.3 } } }\n";
        QString turned;
        for (int i = 0; i < 4; ++i)
            turned += numbered(one, i).replace("@p", QString::number(2 * i) + ",0,0").replace("@h", QString::number(30 * i));
        const QString once = hashIn(folder, "once.sim", kWorld + repeat);
        QVERIFY(!once.isEmpty());
        QCOMPARE(once, hashIn(folder, "hand.sim", kWorld + turned));
        QVERIFY(!hashIn(folder, "ring.sim", kWorld + ring).isEmpty());
    }

    /// Grids of robots and of scenery in a Repeat.
    void gridsInARepeatMoveLikeTheirCopies() {
        const QString grids = "Grid @na { Config=SimpleRobot Count=2 Spacing=0.5 Pos=@x,0,0 LinearMotion brain { Distance=0.3 "
                              "Speed=$(0.1+0.05*index) } }\n"
                              "Grid @np { Config=Post Count=2 Spacing=0.5 Pos=@x,-0.75,0 h=$(0.2+0.1*index) }\n";
        QString copies;
        for (int i = 0; i < 3; ++i)
            copies += QString(grids).replace("@n", "row" + QString::number(i)).replace("@x", QString::number(2 * i));
        QTemporaryDir folder;
        const QString once = hashIn(
            folder, "once.sim",
            kWorld + ("Repeat row { Count=3 Pos=$(2*index),0,0\n" + QString(grids).replace("@n", "").replace("@x", "0") + "}\n"));
        QVERIFY(!once.isEmpty());
        const QString byHand = hashIn(folder, "hand.sim", kWorld + copies);
        QVERIFY(!byHand.isEmpty());
        QVERIFY(once != hashIn(folder, "other.sim", kWorld + QString(copies).replace("Pos=4,0,0", "Pos=4,0.1,0")));
        QCOMPARE(once, byHand);
    }

    /// What is warned of in a Repeat is one text: it is reported for one member.
    void aWarningIsThereOnceForAllMembers() {
        QTemporaryDir folder;
        const QString text = "Repeat row { Count=4 Pos=0,$(2*index),0\n  Robot a { Config=Crate Pos=0,0,0.05 }\n  Robot b { "
                             "Config=Crate Pos=0.3,0,0.05 }\n  Hinge pin { Parent=a.b Child=b.b Anchor=0,0,1 Axis=0,1,0 } }\n";
        QVERIFY(writeFile(folder.filePath("row.sim"), (kWorld + text).toUtf8()));
        const Outcome check = cli({"check", folder.filePath("row.sim"), "--json"});
        QStringList warnings;
        for (const QJsonValue& found : QJsonDocument::fromJson(check.out).array())
            if (found["code"] == QString("E307")) warnings << found["message"].toString();
        QVERIFY2(warnings.size() == 2, shown(check)); // of both bodies
        QVERIFY2(warnings[0].contains("the Anchor of row_0.pin is") && warnings[1].contains("row_0.b.b"), shown(check));
    }

    void aGridOfSceneryStopsRobotsLikeItsCopies() {
        QString copies;
        const char* const places[] = {"0.25,-0.25,0", "0.75,-0.25,0", "0.25,0.25,0", "0.75,0.25,0"};
        for (int i = 0; i < 4; ++i) copies += numbered("Static p@i { Config=Post h=$(0.2+0.1*@i) Pos=", i) + places[i] + " }\n";
        const QString robot = "Robot r { Config=SimpleRobot Pos=-0.2,0.25,0 LinearMotion brain { Distance=1 Speed=0.4 } }\n";
        QTemporaryDir folder;
        const QString once =
            hashIn(folder, "once.sim",
                   kWorld + ("Grid p { Config=Post Count=2,2 Spacing=0.5 Pos=0.5,0,0 h=$(0.2+0.1*(index+2*index2)) }\n" + robot));
        QVERIFY(!once.isEmpty());
        QCOMPARE(once, hashIn(folder, "hand.sim", kWorld + copies + robot));
        QVERIFY(once != hashIn(folder, "free.sim", kWorld + robot)); // they were in its way
    }

    void bodiesInBodiesMoveLikeThoseInTheConfig() {
        const auto arm = [](const QString& lower, const QString& upper, const QString& wheels) {
            return "PartConfig Wheel { Body w { Sphere s { Radius=0.05 Mass=0.2 Material=black Surface=rubber } } Hinge h { "
                   "Parent=$on Child=w Axis=0,1,0 } }\n"
                   "RobotConfig Arm {\nBody base { Pos=0.25,0,0.05 Box b { Size=0.4,0.2,0.05 Mass=2 Material=grey Surface=rubber "
                   "} }\n"
                   "Body lower { " +
                   lower +
                   " Box b { Size=0.04,0.04,0.3 Pos=0,0,0.15 Mass=0.3 Material=red Surface=plastic } }\n"
                   "Body upper { " +
                   upper +
                   " HPR=0,20,0 Box b { Size=0.03,0.03,0.2 Pos=0,0,0.1 Mass=0.2 Material=red Surface=plastic } }\n"
                   "Hinge a { Parent=base Child=lower Axis=0,1,0 Damping=0.05 }\nHinge c { Parent=lower Child=upper Axis=1,0,0 "
                   "Damping=0.02 }\n" +
                   wheels + "}\nRobot r { Config=Arm Pos=0,0,0.05 }\n";
        };
        QTemporaryDir folder;
        const QString in = hashIn(folder, "in.sim",
                                  kWorld + arm("In=base Pos=0.125,0,0.05", "In=lower Pos=0,0.03125,0.3",
                                               "Part left { Config=Wheel In=base Pos=0.125,0.25,0 on=base }\n"));
        QVERIFY(!in.isEmpty());
        QCOMPARE(in, hashIn(folder, "world.sim",
                            kWorld + arm("Pos=$(0.25+0.125),0,$(0.05+0.05)", "Pos=$(0.25+0.125),0.03125,$(0.05+0.05+0.3)",
                                         "Part left { Config=Wheel Pos=$(0.25+0.125),0.25,0.05 on=base }\n")));
    }
};

QTEST_GUILESS_MAIN(PlacementTest)
#include "placement_test.moc"
