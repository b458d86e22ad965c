// What is copied or dragged in the window of one project and put into that of another.

#include <QClipboard>
#include <QDir>
#include <QGuiApplication>
#include <QMimeData>

#include "outlined.h"

using namespace trundle;

class BetweenProjectsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsDraggedFromAnotherWindowIsCopied();
    void aPasteFromAnotherProjectImportsAsItsAuthorWould();
    void aPasteFromAnotherProjectBringsWhatItNames();
    void aPlanInAFileOfItsProjectComesAlong();
    void aPasteBringsTheParamsItTakes();
};

void BetweenProjectsTest::whatIsDraggedFromAnotherWindowIsCopied() {
    Outlined o, other; // both have a robot1
    QVERIFY(o.open(kRovers));
    QVERIFY(other.open(kRovers));
    const std::unique_ptr<QMimeData> mime(other.model().mimeData({other.at("robot1")}));
    QVERIFY(o.model().dropMimeData(mime.get(), Qt::MoveAction, 0, 0, o.at("robot0").parent()));
    QCOMPARE(o.document.loaded()->experiment->robots.size(), std::size_t(3));
    QCOMPARE(o.errors(), QString());
    o.document.undo();
    QCOMPARE(o.text(), kRovers);
}

void BetweenProjectsTest::aPasteFromAnotherProjectImportsAsItsAuthorWould() {
    Outlined from, to;
    QVERIFY(from.open("#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot Pos=0,0,0 }\n"));
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"r"}).ok());
    QVERIFY(to.edits.paste({}).ok());
    QVERIFY2(to.text().contains("#import robots/simple_robot.sim\n"), to.text());
    QCOMPARE(to.errors(), QString());
    to.document.undo();
    // Here that path means another file.
    QVERIFY(QDir(to.folder.path()).mkpath(QStringLiteral("robots")));
    QVERIFY(to.write("robots/simple_robot.sim", "RobotConfig Other { }\n"));
    QVERIFY(to.edits.paste({}).ok());
    QVERIFY2(to.text().contains("#import /"), to.text());
    QCOMPARE(to.errors(), QString());
}

void BetweenProjectsTest::aPasteFromAnotherProjectBringsWhatItNames() {
    Outlined from, to;
    QVERIFY(from.open(
        "#loadModule controllers/linear_motion\n" + kRovers +
        "Material brick { ColorRGB=1,0,0 }\nRobotConfig Sled { Body b { Box x { Size=1,1,1 Material=brick Mass=1 } } }\n"
        "StaticConfig Yard { Box wall { Size=1,1,1 Material=brick } }\n"
        "Robot sled { Config=Sled Pos=3,0,0 LinearMotion brain { Distance=1 Speed=0.1 } }\n"));
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"sled"}).ok());
    QVERIFY(!QGuiApplication::clipboard()->text().contains(QStringLiteral("RobotConfig"))); // another editor gets what was copied
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.errors(), QString());
    QCOMPARE(to.document.loaded()->experiment->robots.size(), std::size_t(1));
    QVERIFY(to.text().contains("#loadModule controllers/linear_motion"));
    QVERIFY2(to.text().contains("Material brick") && to.text().indexOf("Material brick") < to.text().indexOf("RobotConfig"),
             to.text());
    QCOMPARE(to.selected(), QStringLiteral("sled"));
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.text().count("RobotConfig Sled"), 1);
    to.document.undo();
    to.document.undo();
    QCOMPARE(to.text(), QByteArray("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"StaticConfig.Yard.wall"}).ok()); // where no module has to be found first
    QVERIFY(to.edits.insertKind(*to.document.loaded()->registry->find("StaticConfig"), {}).ok());
    QVERIFY(to.edits.paste(to.selection.current()).ok());
    QVERIFY2(to.text().contains("Material brick"), to.text());
    QCOMPARE(to.errors(), QString());
}

/// Its plan stands in a file of a project that the other one cannot import from.
void BetweenProjectsTest::aPlanInAFileOfItsProjectComesAlong() {
    Outlined from, to;
    QVERIFY(from.write("rover.sim", "Param track = 0.2\nMaterial red { ColorRGB=1,0,0 }\n"
                                    "RobotConfig Rover { Body b { Box x { Size=$track,1,1 Material=red Mass=1 } } }\n"));
    QVERIFY(from.open("#import rover.sim\nRobot r { Config=Rover Pos=0,0,0 }\n"));
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"r"}).ok());
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.refusals, QStringList());
    QCOMPARE(to.errors(), QString());
    QVERIFY2(!to.text().contains("#import") && to.text().contains("RobotConfig Rover"), to.text());
    QCOMPARE(to.document.loaded()->experiment->robots.size(), std::size_t(1));
    QCOMPARE(to.selected(), QStringLiteral("r"));
    QVERIFY(from.edits.paste({}).ok()); // at home the file is there
    QVERIFY2(!from.text().contains("RobotConfig") && from.text().count("#import") == 1, from.text());
    QCOMPARE(from.errors(), QString());
}

void BetweenProjectsTest::aPasteBringsTheParamsItTakes() {
    Outlined from, bare, other;
    QVERIFY(from.open("Param wall = 0.05   // of all\nParam side = $(40*wall)\nParam high = 9\nParam idle = 1\n"
                      "StaticConfig Yard {\n  Param high = 0.3\n  Box north { Size=$side,$wall,$high Pos=0,$(side/2),0.15 }\n}\n"
                      "Static yard { Config=Yard }\n"));
    QVERIFY(from.edits.copy({"StaticConfig.Yard"}).ok());
    QVERIFY(bare.open("Tick = 0.01\n"));
    QVERIFY(bare.edits.paste({}).ok());
    QCOMPARE(bare.errors(), QString());
    QVERIFY2(bare.text().contains("Param wall = 0.05\n") && bare.text().contains("Param side = $(40*wall)\n"), bare.text());
    QVERIFY2(!bare.text().contains("idle") && !bare.text().contains("Param high = 9"), bare.text()); // not used, its own
    QCOMPARE(bare.selected(), QStringLiteral("StaticConfig.Yard"));
    QCOMPARE(bare.document.history().entries().size(), std::size_t(1));
    bare.document.undo();
    QCOMPARE(bare.text(), QByteArray("Tick = 0.01\n"));

    // One of the name that is there stays and serves. What is named on the way brings its Params too.
    QVERIFY(other.open("Param wall = 0.1\n"));
    QVERIFY(from.edits.copy({"yard"}).ok());
    QVERIFY(other.edits.paste({}).ok());
    QCOMPARE(other.errors(), QString());
    QVERIFY2(other.text().startsWith("Param wall = 0.1\n") && other.text().count("Param wall") == 1, other.text());
    QCOMPARE(other.document.loaded()->experiment->statics.at(0).geoms->at(0).size.x(), 4.0);
    QVERIFY(other.edits.paste({}).ok()); // once is enough
    QCOMPARE(other.text().count("Param side"), 1);
    QCOMPARE(other.errors(), QString());
}

QTEST_MAIN(BetweenProjectsTest)
#include "between_projects_test.moc"
