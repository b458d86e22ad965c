// Same input, same bits: twenty worlds, each run several times in separate processes; all runs of a world have one hash.

#include "flow/cli.h"

namespace {

bool isLong() { return qEnvironmentVariableIsSet("TRUNDLE_LONG"); }

struct World {
    const char* name;
    const char* text;
};

const char* const kHead =
    "#import robots/simple_robot.sim\n#import robots/evbot.sim\n#import robots/amr.sim\n#import arenas/medium_arena.sim\n"
    "#loadModule controllers/linear_motion\n#loadModule controllers/arc_motion\n#loadModule controllers/bump_and_turn\n"
    "#loadModule controllers/random_drive\nStatic arena { Config=MediumArena }\n";

const char* const kPile =
    "RobotConfig Crate { Body b { Box g { Size=0.12,0.1,0.08 Mass=0.3 Surface=plastic Material=red } } }\n"
    "RobotConfig Ball { Body b { Sphere g { Radius=0.05 Mass=0.2 Surface=rubber Material=red } } }\n"
    "RobotConfig Can { Body b { Cylinder g { Radius=0.04 Length=0.1 Mass=0.2 Surface=plastic Material=red } } }\n";

const World kWorlds[] = {
    {"straight", "Robot r { Config=SimpleRobot LinearMotion b { Distance=1.2 Speed=0.3 } }"},
    {"arc", "Robot r { Config=SimpleRobot ArcMotion b { Speed=0.2 TurnRate=0.8 Angle=720 } }"},
    {"walk", "Robot r { Config=SimpleRobot HPR=40,0,0 BumpAndTurn b { Speed=0.4 } }"},
    {"evbot and amr", "Robot a { Config=EvBot Pos=-1,0,0 RandomDrive b {} }\nRobot c { Config=Amr Pos=1,0,0 RandomDrive b {} }"},
    {"ten wander", "Grid g { Config=SimpleRobot Count=5,2 Spacing=0.7 RandomDrive b { Speed=0.5 } }"},
    {"thirty in a crowd", "Grid g { Config=SimpleRobot Count=6,5 Spacing=0.5 RandomDrive b { Speed=0.6 TurnRate=2 } }"},
    {"scattered", "Scatter g { Config=SimpleRobot Count=12 Area=-1.6,-1.6,1.6,1.6 MinDistance=0.5 RandomDrive b {} }"},
    {"falling crates", "Grid g { Config=Crate Count=4,4 Spacing=0.2 Pos=0,0,0.3 HPR=10,20,30 }"},
    {"a pile that switches the solver", "Grid a { Config=Crate Count=5,5 Spacing=0.11 Pos=0,0,0.1 }\nGrid c { Config=Crate "
                                        "Count=5,5 Spacing=0.11 Pos=0.01,0.02,0.25 }"},
    {"balls", "Grid g { Config=Ball Count=6,6 Spacing=0.11 Pos=0,0,0.4 }\nGrid h { Config=Ball Count=5,5 Spacing=0.11 "
              "Pos=0.02,0.01,0.7 }"},
    {"cans", "Grid g { Config=Can Count=4,4 Spacing=0.1 Pos=0,0,0.3 HPR=0,50,20 }"},
    {"mixed pile", "Grid a { Config=Crate Count=3,3 Spacing=0.14 Pos=0,0,0.2 }\nGrid c { Config=Ball Count=3,3 Spacing=0.14 "
                   "Pos=0.02,0,0.4 }\nGrid d { Config=Can Count=3,3 Spacing=0.14 Pos=0,0.03,0.6 }"},
    {"robot against crates", "Robot r { Config=Amr Pos=-1,0,0 LinearMotion b { Distance=2 Speed=0.5 } }\nGrid g { Config=Crate "
                             "Count=2,3 Spacing=0.14 Pos=0.3,0,0.05 }"},
    {"quick throughout", "Solver=quick\nGrid g { Config=SimpleRobot Count=3,3 Spacing=0.6 RandomDrive b {} }"},
    {"exact throughout", "Solver=exact\nGrid g { Config=Crate Count=3,3 Spacing=0.15 Pos=0,0,0.2 }"},
    {"coarse tick", "Tick=0.03\nGrid g { Config=SimpleRobot Count=3,3 Spacing=0.8 RandomDrive b {} }"},
    {"fine tick", "Tick=0.002\nRobot r { Config=EvBot BumpAndTurn b { Speed=0.4 } }"},
    {"a mesh to drive on", "StaticConfig Ramp { Mesh m { File=\"ramp.obj\" Material=red Surface=rubber } }\nStatic ramp { "
                           "Config=Ramp Pos=0.4,0,0.005 }\n"
                           "Robot r { Config=SimpleRobot Pos=-1,0,0 LinearMotion b { Distance=2 Speed=0.3 } }"},
    {"a hull among balls",
     "RobotConfig Rock { Body b { Mesh m { File=\"ramp.obj\" Mass=1 Material=red Surface=plastic } } }\n"
     "Robot rock { Config=Rock Pos=0,0,0.5 HPR=30,40,50 }\nGrid g { Config=Ball Count=4,4 Spacing=0.12 Pos=0.2,0,0.2 }"},
    {"jointed", "RobotConfig Chain { Body a { Box g { Size=0.1,0.1,0.1 Mass=1 Surface=plastic Material=red } }\n Body c { "
                "Pos=0.2,0,0 Box g { Size=0.1,0.1,0.1 Mass=0.5 Surface=plastic Material=red } }\n"
                " Body d { Pos=0.4,0,0 Sphere g { Radius=0.05 Mass=0.5 Surface=rubber Material=red } }\n Ball j { Parent=a "
                "Child=c Anchor=0.1,0,0 }\n Universal k { Parent=c Child=d Anchor=0.3,0,0 Axis=0,1,0 Axis2=0,0,1 } }\n"
                "Grid g { Config=Chain Count=2,3 Spacing=0.8,0.4 Pos=0,0,0.5 HPR=20,30,0 }"},
};

/// A closed wedge mesh: 0.8 m long, 0.6 m wide, 0.1 m high.
const char* const kRamp = "v 0 -0.3 0\nv 0.8 -0.3 0\nv 0.8 0.3 0\nv 0 0.3 0\nv 0.8 -0.3 0.1\nv 0.8 0.3 0.1\n"
                          "f 1 3 2\nf 1 4 3\nf 1 2 5\nf 2 3 6\nf 2 6 5\nf 3 4 6\nf 1 5 6\nf 1 6 4\n";

} // namespace

class DeterminismFlowTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString write(const World& world) {
        const QString file = m_folder.filePath("world.sim");
        const QByteArray text = QByteArray(kHead) + kPile + world.text + "\n";
        return writeFile(file, text) ? file : QString();
    }
    Outcome run(const QString& file, const QString& ticks, QStringList more = {}) {
        return cli(QStringList{"run", file, "--hash", "--quiet", "--duration", ticks, "--log-dir", m_folder.filePath("logs")} +
                   more);
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(writeFile(m_folder.filePath("ramp.obj"), kRamp)); }

    void oneHashPerWorld_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(std::size(kWorlds)); ++i) QTest::newRow(kWorlds[i].name) << i;
    }
    void oneHashPerWorld() {
        QFETCH(int, index);
        const World& world = kWorlds[index];
        const QString file = write(world);
        const QByteArray text = world.text;
        const double tick = text.contains("Tick=0.03") ? 0.03 : text.contains("Tick=0.002") ? 0.002 : 0.01;
        const QString seconds = QString::number((isLong() ? 5000 : 300) * tick);
        const Outcome first = run(file, seconds);
        QVERIFY2(first.code == 0, shown(first));
        QVERIFY2(first.out.startsWith("state-hash "), shown(first));
        for (int again = 1; again < (isLong() ? 5 : 3); ++again) {
            const Outcome more = run(file, seconds, again == 1 ? QStringList{"--json"} : QStringList{});
            if (again == 1)
                QVERIFY2(first.out.contains(QJsonDocument::fromJson(more.out).object()["state_hash"].toString().toLatin1()),
                         shown(more));
            else QCOMPARE(more.out, first.out);
        }
    }

    // Robots are independent: another robot far away changes no bit of this robot's results.
    void distantRobotChangesNothing() {
        const World alone{"alone", "Robot robot0 { Config=SimpleRobot BumpAndTurn b { Speed=0.4 } }"};
        const World both{"both", "Robot robot0 { Config=SimpleRobot BumpAndTurn b { Speed=0.4 } }\nRobot other { Config=EvBot "
                                 "Pos=500,0,0 RandomDrive b {} }\n"
                                 "Robot another { Config=EvBot Pos=-500,0,0 RandomDrive b {} }"};
        const auto robot = [&](const World& world) {
            const Outcome outcome = run(write(world), "20", {"--json"});
            return QJsonDocument::fromJson(outcome.out).object()["robots"].toObject()["robot0"].toObject();
        };
        const QJsonObject first = robot(alone);
        QVERIFY(!first.isEmpty());
        QVERIFY(first["pos"].toArray()[0].toDouble() != 0);
        QCOMPARE(robot(both), first);
    }
};

QTEST_GUILESS_MAIN(DeterminismFlowTest)
#include "determinism_test.moc"
