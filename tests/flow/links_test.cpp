// What is between robots, from the text to the signals: joints and springs at the top level, regions, pairs that do not touch each other.
#include "devices/sensor_world.h"
#include "flow/cli.h"

using namespace trundle;
using namespace trundle::test;

namespace {

const std::string kBlock = "Surface rubber { Friction=0.8 }\n"
                           "StaticConfig Floor { Plane floor { Surface=rubber } }\nStatic floor { Config=Floor }\n"
                           "RobotConfig Block { Body body { Box box { Size=0.2,0.1,0.1 Mass=1 Surface=rubber } } }\n";

QString text(const std::string& all) { return QString::fromStdString(all); }

/// Two blocks in the air, the second on a hinge below the first, which hangs on the world.
const std::string kTwoRobots = kBlock +
                               "Robot upper { Config=Block Pos=0,0,1 }\nRobot lower { Config=Block Pos=0.2,0,1 }\n"
                               "Hinge top { Parent=world Child=upper.body Anchor=-0.1,0,1 Axis=0,1,0 }\n"
                               "Hinge elbow { Parent=upper.body Child=lower.body Anchor=0.1,0,1 Axis=0,1,0 Damping=0.01 }\n";
const std::string kOneRobot =
    kBlock + "RobotConfig Both { Body body { Pos=0,0,1 Box box { Size=0.2,0.1,0.1 Mass=1 Surface=rubber } }\n"
             " Body second { Pos=0.2,0,1 Box box { Size=0.2,0.1,0.1 Mass=1 Surface=rubber } }\n"
             " Hinge top { Parent=world Child=body Anchor=-0.1,0,1 Axis=0,1,0 }\n"
             " Hinge elbow { Parent=body Child=second Anchor=0.1,0,1 Axis=0,1,0 Damping=0.01 } }\nRobot both { Config=Both }\n";

double radiusOf(SensorWorld& world, const std::string& body, const Vec3& point, const Vec3& centre) {
    const Vec3 at = world.pose(body) * point - centre;
    return std::hypot(at.x(), at.y());
}

} // namespace

class LinksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A joint between two robots moves them as the same joint inside one.
    void joinsAsInOneRobot() {
        SensorWorld two(kTwoRobots), one(kOneRobot);
        QVERIFY2(two.ok(), two.failure().c_str());
        QVERIFY2(one.ok(), one.failure().c_str());
        QVERIFY(two.run(300));
        QVERIFY(one.run(300));
        const Pose a = two.pose("lower"), b = one.pose("both/second");
        QVERIFY2((a.position - b.position).norm() < 1e-9, qPrintable(QString::number((a.position - b.position).norm())));
        QVERIFY(std::abs(two.value("elbow/position")) > 0.01);
        QVERIFY(std::abs(two.value("elbow/position") - one.value("both/elbow/position")) < 1e-9);
        QVERIFY(std::abs(two.value("elbow/rate") - one.value("both/elbow/rate")) < 1e-8);
    }

    void springHasItsLength() {
        SensorWorld w(kBlock + "Robot a { Config=Block Pos=0,0,2 }\nRobot b { Config=Block Pos=0,0,1.5 }\n"
                               "Fixed hold { Parent=world Child=a.body }\n"
                               "Spring rope { Parent=a.body Child=b.body Stiffness=100 Damping=8 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(600));
        QVERIFY2(std::abs(w.value("rope/length") - (0.5 + 9.81 / 100)) < 1e-4,
                 qPrintable(QString::number(w.value("rope/length"))));
        QVERIFY(std::abs(w.value("rope/force") - 9.81) < 1e-3);
        QVERIFY((w.pose("a").position - Vec3(0, 0, 2)).norm() < 1e-4);
    }

    void placesWhatIsJoined() {
        SensorWorld w(kTwoRobots.substr(0, kTwoRobots.find("Hinge top")) +
                      "Ball hitch { Parent=upper.body Child=lower.body Anchor=0.1,0,1 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(5));
        Pose to = w.pose("upper");
        to.position += Vec3(3, -2, 1);
        QVERIFY(w.world().place("upper", to).ok());
        QVERIFY(w.run(5));
        QVERIFY(w.pose("lower").position.x() > 2.9);
        const Vec3 gap = w.pose("upper") * Vec3(0.1, 0, 0) - w.pose("lower") * Vec3(-0.1, 0, 0);
        QVERIFY2(gap.norm() < 1e-4, qPrintable(QString::number(gap.norm())));
        QVERIFY(w.world().robotFaults().ends.empty());
    }

    /// A drag of a whole train names each of its robots; a later placement in the same tick replaces an earlier one.
    void theLastPlacementOfATickCounts() {
        SensorWorld w(kTwoRobots.substr(0, kTwoRobots.find("Hinge top")) +
                      "Ball hitch { Parent=upper.body Child=lower.body Anchor=0.1,0,1 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        const auto moved = [&](const char* robot, double x) {
            Pose to = w.pose(robot);
            to.position.x() += x;
            return w.world().place(robot, to).ok();
        };
        QVERIFY(w.run(2));
        const auto isAt = [&](const char* robot, double x) { return std::abs(w.pose(robot).position.x() - x) < 1e-3; };
        QVERIFY(moved("upper", 1) && moved("lower", 1) && w.run(1));
        QVERIFY2(isAt("upper", 1) && isAt("lower", 1.2), qPrintable(QString::number(w.pose("upper").position.x())));
        QVERIFY(moved("upper", 2) && moved("lower", 0.5) && w.run(1));
        QVERIFY2(isAt("upper", 1.5) && isAt("lower", 1.7), qPrintable(QString::number(w.pose("upper").position.x())));
    }

    void aMoteStaysWhereItIsPlaced() {
        SensorWorld w("Engine=general\n#import robots/tmote_sky.sim\n#import arenas/open_floor.sim\n"
                      "Static floor { Config=OpenFloor }\nRobot mote { Config=TmoteSky }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(5));
        const Pose to{{0.5, -0.25, 0}, rotationFromHpr({0.7, 0, 0})};
        QVERIFY(w.world().place("mote", to).ok());
        for (int i = 0; i < 50; ++i) {
            QVERIFY(w.run(1));
            QVERIFY((w.pose("mote").position - to.position).norm() < 1e-5);
            QVERIFY(w.pose("mote").rotation.angularDistance(to.rotation) < 1e-5);
        }
    }

    void whatHoldsARobotToTheWorldIsPlacedWithIt_data() {
        QTest::addColumn<QString>("top");
        QTest::addColumn<bool>("two");
        const QString at = QStringLiteral(" top { Parent=world Child=body Anchor=-0.1,0,1 ");
        QTest::newRow("pendulum") << "Hinge" + at + "Axis=0,1,0 }" << false;
        QTest::newRow("top") << "Ball" + at + "}" << false;
        QTest::newRow("fixed") << "Fixed top { Parent=world Child=body }" << true;
        QTest::newRow("hinge") << "Hinge" + at + "Axis=0,1,0 Stiffness=2 Damping=0.05 HighStop=20 }" << true;
        QTest::newRow("ball") << "Ball" + at + "Axis=1,0,0 SwingStop=20 }" << true;
        QTest::newRow("universal") << "Universal" + at + "Axis=0,1,0 Axis2=0,0,1 Stiffness=2 Damping=0.05 HighStop=20 }" << true;
        QTest::newRow("slider") << "Slider top { Parent=world Child=body Axis=4,0,-3 Stiffness=50 HighStop=0.1 }" << true;
        QTest::newRow("spring") << "Spring top { Parent=world Child=body Anchor=0,0,1.5 Anchor2=0,0,1 Stiffness=200 }" << true;
    }
    /// It then moves as one that was placed where it was, elsewhere.
    void whatHoldsARobotToTheWorldIsPlacedWithIt() {
        QFETCH(QString, top);
        QFETCH(bool, two);
        const std::string box = "Box box { Size=0.2,0.1,0.1 Mass=1 Surface=rubber } }\n";
        std::string robot = kBlock + "RobotConfig Both { Body body { Pos=0,0,1 " + box + top.toStdString() + "\n";
        if (two)
            robot += "Body second { Pos=0.2,0,1 " + box + "Hinge elbow { Parent=body Child=second Anchor=0.1,0,1 Axis=0,1,0 }\n";
        robot += "}\nRobot both { Config=Both }\n";
        SensorWorld w(robot), same(robot);
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(25) && same.run(25));
        const Pose motion{{2, 1, 0.5}, rotationFromHpr({0.7, 0, 0})};
        QVERIFY(w.world().place("both", motion * w.world().robotPose(0)).ok());
        QVERIFY(same.world().place("both", same.world().robotPose(0)).ok());
        for (int i = 0; i < 60; ++i) {
            QVERIFY(w.run(1) && same.run(1));
            for (const char* path : {"both/body", "both/second"}) {
                if (!two && path == std::string("both/second")) continue;
                const Pose is = w.pose(path), expected = motion * same.pose(path);
                const double off = (is.position - expected.position).norm();
                QVERIFY2(off < 1e-6, qPrintable(QStringLiteral("%1 is off by %2 m after %3 ticks").arg(path).arg(off).arg(i)));
                QVERIFY(is.rotation.angularDistance(expected.rotation) < 1e-6);
            }
        }
        QVERIFY(w.world().robotFaults().ends.empty() && w.world().robotFaults().closedJoints.empty());
    }

    void whatIsHeldByJointsBetweenRobotsIsNotPlaced() {
        SensorWorld w(kTwoRobots), door(kTwoRobots.substr(0, kTwoRobots.find("Hinge top")) +
                                        "StaticConfig Door { Body leaf { Pos=0,3,1 Box box { Size=0.2,0.1,0.1 Mass=1 } }\n"
                                        " Hinge axle { Parent=world Child=leaf Axis=0,0,1 } }\nStatic door { Config=Door }\n"
                                        "Fixed closer { Parent=door.leaf Child=lower.body }\n"
                                        "Spring rope { Parent=world Child=upper.body Stiffness=1 }\n"); // gives way
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY2(door.ok(), door.failure().c_str());
        const Status refused = w.world().place("lower", {Vec3(3, 0, 1), Quat::Identity()});
        QVERIFY(!refused.ok());
        QCOMPARE(text(refused.error().message), QStringLiteral("lower cannot be placed: top holds upper to the world"));
        const Status closed = door.world().place("lower", {Vec3(3, 0, 1), Quat::Identity()});
        QVERIFY(!closed.ok());
        QCOMPARE(text(closed.error().message), QStringLiteral("lower cannot be placed: closer holds lower to door"));
        QVERIFY(door.world().place("upper", {Vec3(3, 0, 1), Quat::Identity()}).ok());
    }

    void springsReleaseARobotThatEnds_data() {
        QTest::addColumn<QString>("ends");
        QTest::addColumn<QString>("stays");
        QTest::newRow("child") << "lower"
                               << "upper";
        QTest::newRow("parent") << "upper"
                                << "lower";
    }
    void springsReleaseARobotThatEnds() {
        QFETCH(QString, ends);
        QFETCH(QString, stays);
        SensorWorld w("Gravity=0,0,0\n" + kBlock +
                      "Robot upper { Config=Block Pos=0,0,1 }\nRobot lower { Config=Block Pos=0.5,0,1 }\n"
                      "Spring rope { Parent=upper.body Child=lower.body Length=0.1 Stiffness=20 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(3));
        QVERIFY(w.value("rope/force") > 0.5);
        QVERIFY(w.world().push(ends.toStdString() + "/body", {0, 0, 1e7}, w.pose(ends.toStdString()).position).ok());
        QVERIFY(w.run(1));
        QCOMPARE(w.world().robotFaults().ends.size(), std::size_t(1));
        QCOMPARE(w.value("rope/force"), 0.0);
        const Vec3 before = w.vector(stays.toStdString() + "/velocity");
        QVERIFY(w.run(20));
        QVERIFY((w.vector(stays.toStdString() + "/velocity") - before).norm() < 1e-9);
        QCOMPARE(w.value("rope/force"), 0.0);
    }

    void reportsWhatIsUnknown_data() {
        QTest::addColumn<QString>("joint");
        QTest::addColumn<QString>("message");
        QTest::newRow("robot") << "Ball j { Parent=uper.body Child=lower.body }"
                               << "Parent names uper.body, but there is no such body of a robot (robot.body)";
        QTest::newRow("body") << "Ball j { Parent=upper.bdy Child=lower.body }"
                              << "Parent names upper.bdy, but there is no such body of a robot (robot.body)";
        QTest::newRow("robot alone") << "Ball j { Parent=upper Child=lower.body }"
                                     << "Parent names upper, a robot; it takes one of its bodies";
        QTest::newRow("scenery") << "Ball j { Parent=floor.body Child=lower.body }"
                                 << "Static floor has no bodies";
        QTest::newRow("itself") << "Ball j { Parent=lower.body Child=lower.body }"
                                << "the child of Ball j is its parent as well";
        QTest::newRow("itself, in a Repeat") << "Repeat r { Count=2 Pos=0,$(5+index),0 Robot a { Config=Block } Ball j { Parent=r_0.a.body Child=a.body } }"
                                             << "the child of Ball j is its parent as well";
        QTest::newRow("world below") << "Ball j { Parent=upper.body Child=world }"
                                     << "Child names world";
        QTest::newRow("grid") << "Ball j { Parent=swarm.body Child=lower.body }"
                              << "name one of its members, swarm_0.body";
        QTest::newRow("member") << "Ball j { Parent=swarm_7.body Child=lower.body }"
                                << "Parent names swarm_7.body";
        QTest::newRow("gear") << "Gear g { Joint=a Other=b Ratio=1 }"
                              << "not at the top level: it couples two joints of one robot, not of two";
        QTest::newRow("suspension") << "Suspension s { Parent=world Child=lower.body }"
                                    << "a Suspension needs a body as its Parent";
    }
    void reportsWhatIsUnknown() {
        QFETCH(QString, joint);
        QFETCH(QString, message);
        SensorWorld w(kTwoRobots.substr(0, kTwoRobots.find("Hinge top")) +
                      "Grid swarm { Config=Block Count=3 Spacing=1 Pos=0,3,1 }\n" + joint.toStdString() + "\n");
        QVERIFY(!w.ok());
        QVERIFY2(text(w.failure()).contains(message), w.failure().c_str());
    }

    void membersOfAGridAreJoined() {
        SensorWorld w(kBlock + "Grid train { Config=Block Count=3 Spacing=0.25 Pos=0,0,0.05 }\n"
                               "Ball a { Parent=train_0.body Child=train_1.body Anchor=-0.125,0,0.05 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(10));
    }

    void wheeledEngineRefuses() {
        SensorWorld w("Engine=wheeled\n" + kBlock +
                      "Robot a { Config=Block Pos=0,0,0.05 }\nRobot b { Config=Block Pos=0.3,0,0.05 }\n"
                      "Ball hitch { Parent=a.body Child=b.body }\n");
        QVERIFY(!w.ok());
        QVERIFY2(text(w.failure()).contains("hitch: it joins robots"), w.failure().c_str());
    }

    /// Joined bodies of a train overlap without a push, others touch.
    void joinedBodiesDoNotTouch() {
        const std::string joined = kBlock + "Robot a { Config=Block Pos=0,0,0.05 }\nRobot b { Config=Block Pos=0.15,0,0.05 }\n";
        SensorWorld w(joined + "Hinge pin { Parent=a.body Child=b.body Anchor=0.075,0,0.05 }\n"), loose(joined);
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(100));
        QVERIFY(loose.run(100));
        QVERIFY(std::abs(w.pose("b").position.x() - w.pose("a").position.x() - 0.15) < 1e-3);
        QVERIFY(loose.pose("b").position.x() - loose.pose("a").position.x() > 0.19);
    }

    void robotsWithoutContactPassThroughEachOther() {
        const std::string balls = kBlock + "RobotConfig Ball1 { Body b { Sphere s { Radius=0.1 Mass=1 } } }\n"
                                           "Robot low { Config=Ball1 Pos=0,0,0.1 }\nRobot high { Config=Ball1 Pos=0,0,0.5 }\n";
        SensorWorld apart("NoContact=low,high\n" + balls), touching(balls);
        QVERIFY2(apart.ok(), apart.failure().c_str());
        QVERIFY(apart.run(100));
        QVERIFY(touching.run(100));
        QVERIFY(std::abs(apart.pose("high").position.z() - 0.1) < 1e-3);
        QVERIFY(touching.pose("high").position.z() > 0.11 || std::abs(touching.pose("high").position.x()) > 0.05);
        SensorWorld odd("NoContact=low,high,low\n" + balls), unknown("NoContact=low,hihg\n" + balls);
        QVERIFY2(text(odd.failure()).contains("low has no second one"), odd.failure().c_str());
        QVERIFY2(text(unknown.failure()).contains("NoContact names hihg"), unknown.failure().c_str());
    }

    void swarmsWithoutContact() {
        SensorWorld w("NoContact=swarm,swarm\n" + kBlock + "Grid swarm { Config=Block Count=4 Spacing=0.05 Pos=0,0,0.05 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(50));
        QVERIFY(std::abs(w.pose("swarm_3").position.x() - 0.075) < 1e-3);
    }

    void bodiesWithoutContact() {
        const auto robot = [](const char* more) {
            return kBlock + "RobotConfig Pair { SelfCollision=true " + more +
                   " Body a { Pos=0,0,0.05 Box b { Size=0.1,0.1,0.1 Mass=5 Surface=rubber } }\n"
                   " Body b { Pos=0,0,0.3 Box b { Size=0.1,0.1,0.1 Mass=1 Surface=rubber } }\n"
                   " Body c { Pos=0,0,0.55 Box b { Size=0.05,0.05,0.05 Mass=1 Surface=rubber } } }\nRobot r { Config=Pair }\n";
        };
        SensorWorld apart(robot("NoContact=a,b, c,a, b,c")), touching(robot(""));
        QVERIFY2(apart.ok(), apart.failure().c_str());
        QVERIFY(apart.run(150));
        QVERIFY(touching.run(150));
        QVERIFY(std::abs(apart.pose("r/b").position.z() - 0.05) < 1e-3);
        QVERIFY(touching.pose("r/b").position.z() > 0.14);
        SensorWorld unknown(robot("NoContact=a,d"));
        QVERIFY2(text(unknown.failure()).contains("NoContact names d, but there is no such Body"), unknown.failure().c_str());
    }

    void regionCountsWhoIsInside() {
        SensorWorld w(kBlock + "RobotConfig Drop { Body b { Sphere s { Radius=0.05 Mass=1 } } }\n"
                               "Robot in { Config=Drop Pos=0,0,0.05 }\nRobot falls { Config=Drop Pos=0,0.5,1 }\n"
                               "Robot other { Config=Drop Pos=0,0.5,2 }\n"
                               "Region goal { Pos=0,0.25,0.3 Size=0.4,1,0.6 Robots=in,falls }\n"
                               "Region tilted { Pos=0,0,0 HPR=90,0,0 Size=1.2,0.1,0.4 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("goal/count"), 1.0);
        QCOMPARE(w.value("goal/entered"), 0.0);
        QVERIFY(w.values("goal/inside").size() == 2 && w.value("goal/inside") == 1 && w.value("goal/inside", 1) == 0);
        QVERIFY(w.values("tilted/inside").size() == 3);
        QCOMPARE(w.value("tilted/count"), 1.0);
        QVERIFY(w.run(100));
        QCOMPARE(w.value("goal/count"), 2.0);
        QCOMPARE(w.value("goal/entered"), 1.0);
        QCOMPARE(w.value("tilted/count"), 3.0); // the other one too: it lies beside, or on the first
        QVERIFY(w.world().place("in", {Vec3(3, 0, 0.05), Quat::Identity()}).ok());
        QVERIFY(w.run(2));
        QCOMPARE(w.value("goal/count"), 1.0);
        QCOMPARE(w.value("goal/left"), 1.0);
    }

    /// A robot that is outside at both ends of a tick has entered and left where its way leads through, but not where it is placed.
    void regionCountsWhoPassesWithinATick() {
        SensorWorld w("Gravity=0,0,0\nTick=0.01\n" + kBlock +
                      "RobotConfig Drop { Body b { Sphere s { Radius=0.05 Mass=1 } } }\nRobot quick { Config=Drop Pos=0.1,0,1 }\n"
                      "Region thin { Pos=1,0,1 HPR=0,20,0 Size=0.05,1,1 }\nRegion beside { Pos=1,1,1 Size=0.05,1,1 }\n"
                      "Region wide { Pos=3,0,1 Size=1,1,1 }\nRegion behind { Pos=8,0,1 Size=0.05,1,1 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.world().push("quick/b", {2000, 0, 0}, {0.1, 0, 1}).ok()); // 20 m/s
        QVERIFY(w.run(25));
        QVERIFY(w.pose("quick").position.x() > 4);
        for (const std::string passed : {"thin", "wide"})
            QVERIFY2(w.value(passed + "/entered") == 1 && w.value(passed + "/left") == 1 && w.value(passed + "/count") == 0,
                     passed.c_str());
        QCOMPARE(w.value("beside/entered"), 0.0);
        QVERIFY(w.world().place("quick", {Vec3(10, 0, 1), Quat::Identity()}).ok());
        QVERIFY(w.run(5));
        QCOMPARE(w.value("behind/entered"), 0.0);
        QVERIFY(w.world().push("quick/b", {-2000, 0, 0}, {10, 0, 1}).ok());
        QVERIFY(w.run(15));
        QCOMPARE(w.value("behind/entered"), 1.0);
    }

    void regionIsInLogsAndConsole() {
        QTemporaryDir folder;
        const std::string all = "Duration=1\n" + kBlock +
                                "Robot falls { Config=Block Pos=0,0,1 }\n"
                                "Region goal { Pos=0,0,0.25 Size=1,1,0.5 }\n"
                                "SignalLog log { Signals=\"goal/count\",\"goal/entered\" Interval=0.5 File=log.csv }\n";
        QVERIFY(writeFile(folder.filePath("goal.sim"), QByteArray::fromStdString(all)));
        const Outcome run = cli({"run", folder.filePath("goal.sim"), "--log-dir", folder.filePath("a")});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2((run.out + run.err).contains("falls entered"), shown(run));
        const QByteArray log = contentOf(folder.filePath("a/log.csv"));
        QVERIFY2(log.contains("goal/count") && log.trimmed().endsWith("1,1"), log);
    }

    /// Altafini, "Some properties of the general n-trailer", Int. J. Control 74 (2001): on a circle each trailer runs at
    /// r^2 = r0^2 + hitch^2 - length^2, where r0 is the radius of the axle in front of it.
    void trailersRunInsideOfTheTractor() {
        QFile file(configPath("experiments/train.sim"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        SensorWorld w(file.readAll().toStdString());
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(5600)); // more than one lap
        const Vec3 centre(0, 0.8, 0);
        const double tractor = radiusOf(w, "tractor/chassis", {0, 0, 0}, centre);
        const double first = radiusOf(w, "trailer0/frame", {-0.3, 0, 0}, centre),
                     second = radiusOf(w, "trailer1/frame", {-0.3, 0, 0}, centre);
        const auto behind = [](double radius, double hitch) { return std::sqrt(radius * radius + hitch * hitch - 0.3 * 0.3); };
        qInfo("tractor %.4f m, trailers %.4f and %.4f m; by the formula %.4f and %.4f m", tractor, first, second,
              behind(tractor, 0.08), behind(behind(tractor, 0.08), 0.1));
        QVERIFY(std::abs(tractor - 0.8) < 0.01);
        QVERIFY(std::abs(first / behind(tractor, 0.08) - 1) < 0.01);
        QVERIFY(std::abs(second / behind(behind(tractor, 0.08), 0.1) - 1) < 0.015);
        QCOMPARE(w.value("lapLine/entered"), 1.0); // and left twice
    }

    void armBuildsThePileUpAgain() {
        QFile file(configPath("experiments/stacking.sim"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        SensorWorld w(file.readAll().toStdString());
        QVERIFY2(w.ok(), w.failure().c_str());
        while (w.value("arm/brain/moved") < 3 && w.time() < 60) QVERIFY(w.run(20));
        QVERIFY(w.run(200)); // its hand is away
        qInfo("done after %.1f s", w.time());
        QCOMPARE(w.value("newPile/count"), 3.0);
        for (int i = 0; i < 3; ++i) {
            const Vec3 at = w.pose("crate" + std::to_string(i)).position; // of its centre
            qInfo("crate%d is at %.4f, %.4f, %.4f m", i, at.x(), at.y(), at.z());
            QVERIFY(std::hypot(at.x() - 0.32, at.y() + 0.18) < 0.01);
            QVERIFY(std::abs(at.z() - (0.03 + 0.06 * (2 - i))) < 0.002); // the highest was taken first
        }
    }

    /// Harrington and Voorhees, "The Challenges of Designing the Rocker-Bogie Suspension for the Mars Exploration Rover" (2004): the body
    /// has the mean of the rockers' angles, the load is spread over all wheels, and ledges as high as a wheel are climbed.
    void roverClimbsALedge() {
        QFile file(configPath("experiments/rover.sim"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        SensorWorld w(file.readAll().toStdString());
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(100)); // it has settled, and hardly moves yet
        std::map<std::string, double> loads;
        double all = 0;
        for (const WorldContact& c : w.world().contacts()) {
            loads[std::string(c.first)] += c.force;
            all += c.force;
        }
        QCOMPARE(loads.size(), std::size_t(6));
        for (const auto& [wheel, load] : loads) {
            qInfo("%s carries %.1f %%", wheel.c_str(), 100 * load / all);
            QVERIFY(std::abs(6 * load / all - 1) < 0.03);
        }
        double most = 0, tilt = 0;
        for (int i = 0; i < 48; ++i) {
            QVERIFY(w.run(100));
            const double left = w.value("rover/left.rockerPivot/position"), right = w.value("rover/right.rockerPivot/position");
            QVERIFY2(std::abs(left + right) < 2e-3, qPrintable(QString::number(left + right)));
            most = std::max(most, std::abs(left));
            const Pose body = w.pose("rover");
            tilt = std::max(tilt, std::acos((body.rotation * Vec3::UnitZ()).z()));
        }
        const Vec3 end = w.pose("rover").position;
        qInfo("rockers up to %.1f degrees, body up to %.1f, it ends at %.2f, %.2f, %.3f m", most * 180 / M_PI, tilt * 180 / M_PI,
              end.x(), end.y(), end.z());
        QVERIFY(end.x() > 1.9); // all wheels are on the ledge
        QVERIFY(std::abs(end.z() - 0.12) < 0.01);
        QVERIFY(tilt < 0.8); // when both front wheels are on the edge
        QVERIFY(w.world().robotFaults().closedJoints.empty());
    }
};

QTEST_GUILESS_MAIN(LinksTest)
#include "links_test.moc"
