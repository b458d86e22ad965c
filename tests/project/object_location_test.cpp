// Conversion between object paths and blocks of a text.
#include <QTest>

#include "plan_fixture.h"
#include "project/edits/path_after_edit.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kScene = R"(#loadModule walker
Material red { ColorRGB=1,0,0 }
StaticConfig Yard { Box north { Size=1,1,1 } }
RobotConfig Cart {
  #import wheel.sim
  Body chassis { Box hull { Size=1,1,1 Mass=1 } Sphere { Radius=0.1 } }
  Hinge axle { Parent=chassis Child=wheel }
}
Static arena { Config=Yard }
Robot robot0 { Config=Cart Walker brain { Speed=1 } }
Grid swarm { Config=Cart Count=3 Spacing=4 Pos=9,9,9 }
PoseLog { Robot=robot0 }
)";
const char* const kWheel = "Body wheel { Sphere tyre { Radius=0.1 Mass=1 } }\n";

} // namespace

class ObjectPlaceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open({{"main.sim", kScene}, {"wheel.sim", kWheel}});
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
    }

    void pathsAndBlocks_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("starts"); // the block's text starts with this
        QTest::addColumn<QString>("instance");
        QTest::addColumn<QString>("within");
        QTest::newRow("robot") << "robot0"
                               << "Robot robot0 {"
                               << "robot0"
                               << "";
        QTest::newRow("by kind") << "Robot.robot0"
                                 << "Robot robot0 {"
                                 << "robot0"
                                 << "";
        QTest::newRow("body") << "robot0.chassis"
                              << "Body chassis {"
                              << "robot0"
                              << "chassis";
        QTest::newRow("geom") << "robot0.chassis.hull"
                              << "Box hull {"
                              << "robot0"
                              << "chassis.hull";
        QTest::newRow("unnamed") << "robot0.chassis.sphere"
                                 << "Sphere {"
                                 << "robot0"
                                 << "chassis.sphere";
        QTest::newRow("imported") << "robot0.wheel.tyre"
                                  << "Sphere tyre {"
                                  << "robot0"
                                  << "wheel.tyre";
        QTest::newRow("controller") << "robot0.brain"
                                    << "Walker brain {"
                                    << "robot0"
                                    << "brain";
        QTest::newRow("config") << "RobotConfig.Cart"
                                << "RobotConfig Cart {"
                                << ""
                                << "";
        QTest::newRow("in config") << "RobotConfig.Cart.axle"
                                   << "Hinge axle {"
                                   << ""
                                   << "";
        QTest::newRow("material") << "Material.red"
                                  << "Material red {"
                                  << ""
                                  << "";
        QTest::newRow("scenery") << "arena.north"
                                 << "Box north {"
                                 << "arena"
                                 << "north";
        QTest::newRow("log") << "poseLog"
                             << "PoseLog {"
                             << ""
                             << "";
        QTest::newRow("grid") << "swarm"
                              << "Grid swarm {"
                              << "swarm"
                              << "";
        QTest::newRow("of a member") << "swarm_2.chassis"
                                     << "Body chassis {"
                                     << "swarm"
                                     << "chassis";
    }
    void pathsAndBlocks() {
        QFETCH(QString, path);
        QFETCH(QString, starts);
        QFETCH(QString, instance);
        QFETCH(QString, within);
        const auto place = placeOf(*m_loaded, path.toStdString());
        QVERIFY(place && place->part);
        const std::string text(m_loaded->sources.slice(blockOf(*m_loaded, path.toStdString())));
        QVERIFY2(text.starts_with(starts.toStdString()), text.c_str());
        QCOMPARE(place->instance ? place->instance->name : std::string(), instance.toStdString());
        QCOMPARE(place->within, within.toStdString());
        QCOMPARE(place->member, path.startsWith("swarm_"));
    }

    void rejectsUnknownPaths_data() {
        QTest::addColumn<QString>("path");
        for (const char* path :
             {"robot9", "robot0.chasis", "robot0.chassis.", ".robot0", "robot0..chassis", "Material", "Material.blue",
              "StaticConfig.Cart", "swarm_3", "swarm_", "swarm_x", "robot0_1", ".", "robot0.chassis.hull.Mass"})
            QTest::newRow(path) << path;
    }
    void rejectsUnknownPaths() {
        QFETCH(QString, path);
        QVERIFY(!placeOf(*m_loaded, path.toStdString()));
        QVERIFY(!blockOf(*m_loaded, path.toStdString()).known());
    }

    void theExperimentAndMembers() {
        const auto all = placeOf(*m_loaded, "");
        QVERIFY(all && !all->part);
        QCOMPARE(m_loaded->sources.slice(blockOf(*m_loaded, "")), std::string_view(kScene));
        const auto member = placeOf(*m_loaded, "swarm_1");
        QVERIFY(member && member->member && member->part == member->instance);
        QVERIFY(!placeOf(*m_loaded, "swarm")->member);
    }

    void findsObjectAtOffset() {
        const std::string text = kScene;
        const auto at = [&](const char* word, FileId file = 0) {
            const std::string& bytes = file ? std::string(kWheel) : text;
            return objectAt(*m_loaded, file, static_cast<std::uint32_t>(bytes.find(word)));
        };
        QCOMPARE(at("hull"), "RobotConfig.Cart.chassis.hull");
        QCOMPARE(at("Sphere {"), "RobotConfig.Cart.chassis.sphere");
        QCOMPARE(at("Hinge"), "RobotConfig.Cart.axle");
        QCOMPARE(at("#import"), "RobotConfig.Cart");
        QCOMPARE(at("#loadModule"), "");
        QCOMPARE(at("Speed=1"), "robot0.brain");
        QCOMPARE(at("ColorRGB"), "Material.red");
        QCOMPARE(at("PoseLog"), "poseLog");
        QCOMPARE(at("tyre", 1), "RobotConfig.Cart.wheel.tyre");
        QCOMPARE(objectAt(*m_loaded, 0, 4000000), "");
        QCOMPARE(objectAt(*m_loaded, 77, 0), "");
    }

    /// Every path returned by objectAt resolves to the same block.
    void thereAndBack() {
        for (FileId file = 0; file < 2; ++file) {
            const auto size = static_cast<std::uint32_t>(m_loaded->trees[file]->source().bytes().size());
            for (std::uint32_t offset = 0; offset < size; ++offset) {
                const std::string path = objectAt(*m_loaded, file, offset);
                const SourceRange block = blockOf(*m_loaded, path);
                QVERIFY2(path.empty() || (block.file == file && block.range.contains(offset)), path.c_str());
            }
        }
    }

    void pathsFollowRenames_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("now"); // empty: it is gone
        const auto row = [](const char* name, const char* path, const char* from, const char* to, const char* now) {
            QTest::newRow(name) << path << from << to << now;
        };
        row("itself", "robot0", "Robot robot0", "Robot rover", "rover");
        row("the instance", "robot0.chassis.hull", "Robot robot0", "Robot rover", "rover.chassis.hull");
        row("a body", "robot0.chassis.hull", "Body chassis", "Body base", "robot0.base.hull");
        row("its config", "robot0.chassis.hull", "Cart", "Wagon", "robot0.chassis.hull");
        row("in the config", "RobotConfig.Cart.chassis", "Cart", "Wagon", "RobotConfig.Wagon.chassis");
        row("imported", "robot0.wheel.tyre", "Robot robot0", "Robot rover", "rover.wheel.tyre");
        row("the controller", "robot0.brain", "Robot robot0", "Robot rover", "rover.brain");
        row("another one", "arena.north", "Robot robot0", "Robot rover", "arena.north");
        row("moved only", "robot0", "Static arena { Config=Yard }\n", "", "robot0");
        row("removed", "robot0", "Robot robot0 { Config=Cart Walker brain { Speed=1 } }\n", "", "");
        row("replaced by another kind", "arena", "Static arena { Config=Yard }", "Robot other { Config=Cart }", "");
        row("a name that existed", "robot0", "Robot robot0 { Config=Cart Walker brain { Speed=1 } }\nGrid swarm",
            "Grid swarm { Config=Cart Count=3 Spacing=4 Pos=9,9,0 }\nGrid robot1", "");
        row("a member", "swarm_2", "Robot robot0", "Robot rover", "swarm_2");
        row("the run", "", "Robot robot0", "Robot rover", "");
    }
    void pathsFollowRenames() {
        QFETCH(QString, path);
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, now);
        QString text = QString::fromLatin1(kScene).replace(from, to);
        text.replace(QStringLiteral("Robot=robot0"), QStringLiteral("Interval=1")); // which keeps the text without errors
        const auto after = m_fixture.open({{"main.sim", text.toStdString()}, {"wheel.sim", kWheel}});
        const auto found = pathAfterEdit(*m_loaded, *after, path.toStdString());
        QCOMPARE(QString::fromStdString(found.value_or("")), now);
        QCOMPARE(found.has_value(), path.isEmpty() || !now.isEmpty());
    }

    /// A duplicate name and an unknown kind have no path.
    void brokenTexts() {
        const auto loaded =
            m_fixture.open("Robot a { Config=Nothing }\nRobot a { Config=Nothing }\nGizmo x { Pos=1,2,3 }\nRobot b {");
        const std::string text(loaded->trees[0]->source().bytes());
        QCOMPARE(objectAt(*loaded, 0, 0), "a");
        QCOMPARE(objectAt(*loaded, 0, static_cast<std::uint32_t>(text.find("\nRobot a") + 3)), "");
        QCOMPARE(objectAt(*loaded, 0, static_cast<std::uint32_t>(text.find("Gizmo"))), "");
        QVERIFY(!placeOf(*loaded, "a.chassis"));
        QVERIFY(!placeOf(*loaded, "x"));
    }

private:
    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(ObjectPlaceTest)
#include "object_location_test.moc"
