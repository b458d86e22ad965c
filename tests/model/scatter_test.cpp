// Scatter: its members are clear of everything else that is placed, and leave the order of robots and scenery as it is written.
#include <QTest>

#include "model/resolve/obstacle_grid.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kConfigs = "Material g { } Surface s { }\n"
                             "RobotConfig Cart { Body b { Box hull { Size=1,0.6,1 Pos=0,0,0.5 Material=g Surface=s Mass=1 } } }\n"
                             "StaticConfig Post { Cylinder wood { Radius=0.3 Length=2 Pos=0,0,1 Material=g Surface=s } }\n"
                             "StaticConfig Can { Body b { Cylinder tin { Radius=0.2 Length=1 Pos=0,0,0.5 Material=g Surface=s "
                             "Mass=1 } } Hinge h { Parent=world Child=b Axis=0,0,1 } }\n";
constexpr double kCart = 0.58, kPost = 0.3, kCan = 0.2; // m, radius of a Cart whatever its heading, a little less than it is

Resolved world(const std::string& text) { return resolved(kConfigs + text, {}); }
QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

double distance(const Vec3& a, const Vec3& b) { return (a - b).head<2>().norm(); }

} // namespace

class ScatterTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void robotsAreClearOfAllOthers_data() {
        QTest::addColumn<std::string>("text");
        const std::string swarm = "Scatter swarm { Config=Cart Count=12 Area=-4,-4,4,4 MinDistance=0 }\n";
        QTest::newRow("robot before") << "Robot wide { Config=Cart Pos=1,1,0 }\n" + swarm;
        QTest::newRow("robot after") << swarm + "Robot wide { Config=Cart Pos=1,1,0 }\n";
        QTest::newRow("grid after") << swarm + "Grid row { Config=Cart Count=3,2 Spacing=2,3 }\n";
        QTest::newRow("another before") << "Scatter early { Config=Cart Count=8 Area=-4,-4,4,4 MinDistance=1.2 Seed=5 }\n" +
                                               swarm;
        QTest::newRow("in a Repeat")
            << "Repeat two { Count=2 Scatter some { Config=Cart Count=6 Area=-4,-4,4,4 MinDistance=1.2 } }\n" + swarm;
    }
    void robotsAreClearOfAllOthers() {
        QFETCH(std::string, text);
        const Resolved r = world(text);
        QCOMPARE(messagesOf(r), QString());
        int others = 0;
        for (const RobotSpec& a : r.experiment->robots)
            for (const RobotSpec& b : r.experiment->robots) {
                const bool isOther = !b.name.starts_with("swarm_");
                if (&a == &b || !a.name.starts_with("swarm_") || !isOther) continue;
                ++others;
                QVERIFY2(distance(a.pose.position, b.pose.position) > kCart + 0.3, (a.name + " " + b.name).c_str());
            }
        QVERIFY(others >= 12);
    }

    void sceneryIsClearOfRobotsAndOfOtherScenery() {
        const Resolved r =
            world("Scatter cans { Config=Can Count=10 Area=-2,-2,2,2 MinDistance=0 }\nRobot a { Config=Cart Pos=1,0,0 }\n"
                  "Grid posts { Config=Post Count=2 Spacing=1.5 }\nScatter more { Config=Post Count=3 Area=-2,-2,2,2 }\n");
        QCOMPARE(messagesOf(r), QString());
        const std::vector<StaticSpec>& statics = r.experiment->statics;
        QCOMPARE(statics.size(), std::size_t(15));
        for (std::size_t can = 0; can < 10; ++can) {
            QVERIFY(distance(statics[can].pose.position, Vec3(1, 0, 0)) > 0.3 + kCan);
            for (std::size_t post = 10; post < 15; ++post)
                QVERIFY(distance(statics[can].pose.position, statics[post].pose.position) > kCan + kPost);
        }
        QCOMPARE(r.experiment->robots.size(), std::size_t(11)); // the cans move
        for (std::size_t can = 0; can < 10; ++can) {
            QCOMPARE(r.experiment->robots[can + 1].name, "cans_" + std::to_string(can));
            QVERIFY(r.experiment->robots[can + 1].pose.position == statics[can].pose.position);
        }
    }

    /// As they are written, so that the run of a text whose Scatters were clear is the same as ever.
    void theOrderStays() {
        const Resolved r =
            world("Scatter a { Config=Cart Count=2 Area=-4,-4,4,4 }\nRobot b { Config=Cart }\n"
                  "Scatter c { Config=Cart Count=1 Area=-4,-4,4,4 }\nGrid d { Config=Cart Count=1 Pos=3,0,0 Spacing=1 }\n");
        std::string names;
        for (const RobotSpec& robot : r.experiment->robots) names += robot.name + " ";
        QCOMPARE(names, std::string("a_0 a_1 b c_0 d_0 "));
    }

    void aScatterWithoutRoomIsLeftOutAlone() {
        const Resolved r = world("Robot a { Config=Cart }\nScatter full { Config=Cart Count=2 Area=-0.2,-0.2,0.2,0.2 }\n"
                                 "Robot b { Config=Cart Pos=5,0,0 }\nScatter c { Config=Cart Count=1 Area=-4,-4,4,4 }\n");
        QCOMPARE(messagesOf(r),
                 QStringLiteral("E317 no free place for member 0 of Scatter full after 10000 tries; make Area larger, "
                                "or Count or MinDistance smaller\n"));
        std::string names;
        for (const RobotSpec& robot : r.experiment->robots) names += robot.name + " ";
        QCOMPARE(names, std::string("a b c_0 "));
    }

    /// What is above or below is not in the way.
    void heightsCount() {
        const Resolved r =
            world("Robot high { Config=Cart Pos=0,0,3 }\nScatter s { Config=Cart Count=1 Area=-0.1,-0.1,0.1,0.1 }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(2));
    }

    /// Whatever a footprint's size is beside the disc, the grid finds what asking each would.
    void theGridFindsWhatEachWould() {
        GeomSpec box;
        box.shape = GeomShape::Box;
        std::vector<Footprint> each;
        ObstacleGrid grid({Eigen::Vector2d(-3, -3), Eigen::Vector2d(3, 3)}, 0.2);
        std::uint64_t state = 1;
        const auto random = [&](double low, double high) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            return low + (high - low) * static_cast<double>(state >> 11) / 9007199254740992.0;
        };
        for (int i = 0; i < 60; ++i) {
            const double length = i % 10 == 0 ? random(5, 40) : random(0.01, 0.5);
            box.size = Vec3(length, random(0.01, 0.3), 1);
            const Pose pose{Vec3(random(-4, 4), random(-4, 4), 0.5), rotationFromHpr({random(-3, 3), 0, 0})};
            grid.add({box}, pose);
            for (Footprint& footprint : footprintsOf(box, pose)) each.push_back(std::move(footprint));
        }
        int met = 0;
        for (int i = 0; i < 2000; ++i) {
            const Eigen::Vector2d at(random(-3, 3), random(-3, 3));
            const bool meets = std::ranges::any_of(each, [&](const Footprint& f) { return f.meets(at, 0.2, 0, 1); });
            met += meets;
            QCOMPARE(grid.meets(at, 0, 1), meets);
        }
        QVERIFY(met > 200 && met < 1900);
    }
};

QTEST_APPLESS_MAIN(ScatterTest)
#include "scatter_test.moc"
