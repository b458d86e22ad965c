// Copying and dragging objects from the window of one project to that of another.

#include <QClipboard>
#include <QDir>
#include <QGuiApplication>
#include <QMimeData>

#include "editor/outline/block_mime.h"
#include "outline_fixture.h"

using namespace trundle;

class BetweenProjectsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void dragFromOtherWindowCopies();
    void aPasteFromAnotherProjectImportsAsItsAuthorWould();
    void pasteCopiesReferencedObjects();
    void copiesImportedPlan();
    void pasteCopiesUsedParams();
    void copiedParamsComeAfterThoseTheyUse();
    void copiesReferencedObjects();
    void copiesPiecesOfPlan();
};

void BetweenProjectsTest::dragFromOtherWindowCopies() {
    OutlineFixture o, other; // both have a robot1
    QVERIFY(o.open(kRovers));
    QVERIFY(other.open(kRovers));
    const std::unique_ptr<QMimeData> mime(other.model().mimeData({other.at("robot1")}));
    QVERIFY(o.model().dropMimeData(mime.get(), Qt::MoveAction, 0, 0, o.at("robot0").parent()));
    QCOMPARE(o.document.loaded()->experiment->robots.size(), std::size_t(3));
    QCOMPARE(o.errors(), QString());
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

void BetweenProjectsTest::aPasteFromAnotherProjectImportsAsItsAuthorWould() {
    OutlineFixture from, to;
    QVERIFY(from.open("#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot Pos=0,0,0 }\n"));
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"r"}).ok());
    QVERIFY(to.edits.paste({}).ok());
    QVERIFY2(to.text().contains("#import robots/simple_robot.sim\n"), to.text());
    QCOMPARE(to.errors(), QString());
    to.document.edits().undo();
    // In the other project the path refers to a different file.
    QVERIFY(QDir(to.folder.path()).mkpath(QStringLiteral("robots")));
    QVERIFY(to.write("robots/simple_robot.sim", "RobotConfig Other { }\n"));
    QVERIFY(to.edits.paste({}).ok());
    QVERIFY2(to.text().contains("#import /"), to.text());
    QCOMPARE(to.errors(), QString());
}

void BetweenProjectsTest::pasteCopiesReferencedObjects() {
    OutlineFixture from, to;
    QVERIFY(from.open(
        "#loadModule controllers/linear_motion\n" + kRovers +
        "Material brick { ColorRGB=1,0,0 }\nRobotConfig Sled { Body b { Box x { Size=1,1,1 Material=brick Mass=1 } } }\n"
        "StaticConfig Yard { Box wall { Size=1,1,1 Material=brick } }\n"
        "Robot sled { Config=Sled Pos=3,0,0 LinearMotion brain { Distance=1 Speed=0.1 } }\n"));
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"sled"}).ok());
    QVERIFY(!QGuiApplication::clipboard()->text().contains(QStringLiteral("RobotConfig"))); // other text editors can paste it
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.errors(), QString());
    QCOMPARE(to.document.loaded()->experiment->robots.size(), std::size_t(1));
    QVERIFY(to.text().contains("#loadModule controllers/linear_motion"));
    QVERIFY2(to.text().contains("Material brick") && to.text().indexOf("Material brick") < to.text().indexOf("RobotConfig"),
             to.text());
    QCOMPARE(to.selected(), QStringLiteral("sled"));
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.text().count("RobotConfig Sled"), 1);
    to.document.edits().undo();
    to.document.edits().undo();
    QCOMPARE(to.text(), QByteArray("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"StaticConfig.Yard.wall"}).ok()); // from a config, so that no module has to be found first
    QVERIFY(to.edits.insertKind(*to.document.loaded()->registry->find("StaticConfig"), {}).ok());
    QVERIFY(to.edits.paste(to.selection.current()).ok());
    QVERIFY2(to.text().contains("Material brick"), to.text());
    QCOMPARE(to.errors(), QString());
}

/// The config is in a file that the other project cannot import.
void BetweenProjectsTest::copiesImportedPlan() {
    OutlineFixture from, to;
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
    QVERIFY(from.edits.paste({}).ok()); // in its own project the file exists
    QVERIFY2(!from.text().contains("RobotConfig") && from.text().count("#import") == 1, from.text());
    QCOMPARE(from.errors(), QString());
}

void BetweenProjectsTest::pasteCopiesUsedParams() {
    OutlineFixture from, bare, other;
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
    QCOMPARE(bare.document.edits().history().entries().size(), std::size_t(1));
    bare.document.edits().undo();
    QCOMPARE(bare.text(), QByteArray("Tick = 0.01\n"));

    // An existing block with the same name and the same content is reused. Params of referenced blocks are copied too.
    QVERIFY(from.edits.copy({"yard"}).ok());
    QVERIFY(other.open("Param wall = 0.1\n"));
    QVERIFY(!other.edits.paste({}).ok());
    QCOMPARE(other.refusals,
             QStringList(QStringLiteral("Param wall is 0.1 here, and 0.05 where this comes from; rename one of the two first")));
    QCOMPARE(other.text(), QByteArray("Param wall = 0.1\n"));
    QVERIFY(other.open("StaticConfig Yard { }\n"));
    QVERIFY(!other.edits.paste({}).ok());
    QCOMPARE(other.refusals.last(),
             QStringLiteral("StaticConfig Yard differs here from the source; rename one of the two first"));
    QVERIFY(other.open("Param wall =  0.05\n"));
    QVERIFY(other.edits.paste({}).ok());
    QCOMPARE(other.errors(), QString());
    QVERIFY2(other.text().startsWith("Param wall =  0.05\n") && other.text().count("Param wall") == 1, other.text());
    QVERIFY(other.edits.paste({}).ok()); // one copy is enough
    QCOMPARE(other.text().count("Param side"), 1);
    QCOMPARE(other.errors(), QString());

    // In its own project, references keep their current meaning.
    QVERIFY(from.document.edits()
                .replaceText(QStringLiteral("Type"), from.document.path(), from.text().replace("0.05", "0.07").toStdString())
                .ok());
    QVERIFY(from.edits.paste({}).ok());
    QCOMPARE(from.refusals, QStringList());
    QCOMPARE(from.document.loaded()->experiment->statics.size(), std::size_t(2));
    QVERIFY(from.document.edits()
                .replaceText(QStringLiteral("Type"), from.document.path(), from.text().replace("0.15", "0.25").toStdString())
                .ok());
    QVERIFY(from.edits.paste({}).ok()); // the config was changed since it was copied
    QCOMPARE(from.refusals, QStringList());
    QCOMPARE(from.document.loaded()->experiment->statics.size(), std::size_t(3));
}

/// The copied block uses the last one of a chain, whose names are in no order.
void BetweenProjectsTest::copiedParamsComeAfterThoseTheyUse() {
    OutlineFixture from;
    QVERIFY(from.open("Param m = 0.3\nParam z = $(m+0.1)\nParam a = $(z*2)\nParam idle = 1\n"
                      "StaticConfig Yard { Box north { Size=$a,1,1 } }\nStatic yard { Config=Yard }\n"));
    QCOMPARE(from.errors(), QString());
    for (const char* path : {"StaticConfig.Yard", "yard"}) {
        const std::unique_ptr<QMimeData> mime(mimeOf(*from.document.loaded(), {path}));
        const Result<Blocks> blocks = blocksIn(*mime, [](const std::string&) { return false; });
        QVERIFY(blocks.ok());
        QStringList params;
        for (const std::string& param : blocks.value().params) params << QString::fromStdString(param);
        QCOMPARE(params.join(u'|'), QStringLiteral("Param m = 0.3|Param z = $(m+0.1)|Param a = $(z*2)"));
    }
}

void BetweenProjectsTest::copiesReferencedObjects() {
    OutlineFixture from, to;
    QVERIFY(from.open(
        "Param Colour = paint\nParam tone = 0.5\nMaterial paint { ColorRGB=1,0,0 }\nMaterial base { ColorRGB=$tone,1,0 }\n"
        "Material look { ColorRGB=0,0,1 }\nMaterial idle { ColorRGB=1,1,1 }\n"
        "AntennaPattern dish { Model=patch BeamWidth=60 }\n"
        "RobotConfig Cart {\n  Param shade = paint\n  Body chassis { Box hull { Size=1,1,1 Mass=1 Material=$Colour } "
        "Box lid { Size=1,1,1 Mass=1 Material=$shade } }\n  Transceiver radio { Body=chassis Antenna=dish }\n}\n"
        "Robot r { Config=Cart chassis.hull.Material=base shade=look }\n"));
    QCOMPARE(from.errors(), QString());
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"r"}).ok());
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.refusals, QStringList());
    QCOMPARE(to.errors(), QString());
    for (const char* text : {"Material paint", "Material base", "Material look", "AntennaPattern dish", "Param tone = 0.5"})
        QVERIFY2(to.text().contains(text), to.text());
    QVERIFY2(!to.text().contains("idle"), to.text());
    QCOMPARE(to.selected(), QStringLiteral("r"));
}

/// Files that a config imports inside its block.
void BetweenProjectsTest::copiesPiecesOfPlan() {
    OutlineFixture from, to;
    QVERIFY(
        from.write("pieces.sim", "Body chassis { Box hull { Size=$side,1,1 Mass=1 Material=red } } // of all\n#import more.sim"));
    QVERIFY(from.write("more.sim", "Body wheel { Pos=0,2,0 Sphere { Radius=0.1 Mass=1 } } // round"));
    QVERIFY(from.open("Param side = 2\nMaterial red { ColorRGB=1,0,0 }\nRobotConfig Cart {\n  #import pieces.sim\n"
                      "  Hinge axle { Parent=chassis Child=wheel }\n}\nRobot r { Config=Cart }\n"));
    QCOMPARE(from.errors(), QString());
    QVERIFY(to.open("Tick = 0.01\n"));
    QVERIFY(from.edits.copy({"r"}).ok());
    QVERIFY(to.edits.paste({}).ok());
    QCOMPARE(to.refusals, QStringList());
    QCOMPARE(to.errors(), QString());
    QVERIFY2(!to.text().contains("#import") && to.text().contains("Body wheel") && to.text().contains("Param side = 2"),
             to.text());
    QVERIFY(from.edits.copy({"RobotConfig.Cart"}).ok());
    QVERIFY(from.edits.paste({}).ok()); // in its own project the file exists
    QCOMPARE(from.errors(), QString());
    QCOMPARE(from.text().count("#import pieces.sim"), 2);
}

QTEST_MAIN(BetweenProjectsTest)
#include "between_projects_test.moc"
