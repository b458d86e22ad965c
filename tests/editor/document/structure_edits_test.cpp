// Structural edits of a config: for all its instances, or in a copy; and where a value is written.

#include <QTest>

#include <fstream>

#include "editor/document/structure_edits.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

const char* const kBall = "Body arm { Sphere ball { Radius=0.1 Mass=1 } }";

/// A second experiment that uses the same robot as the first one.
const char* const kOther = "#import robots/rover.sim\nRobot other { Config=Rover }\n";

class Asked {
public:
    Asked(Document& document, ShareChoice choice) {
        document.structure().setShareQuestionHandler(
            [this, choice](const ShareQuestion& question, const StructureEdits::ShareAnswer& answer) {
                questions.push_back(question);
                answer(choice);
            });
    }
    std::vector<ShareQuestion> questions;
};

Status insert(Document& d, const std::string& at, const std::string& block = kBall) {
    return d.structure().apply(u"Insert"_qs, {at}, [=](const LoadedProject& loaded, const auto& renamed) {
        return planInsert(loaded, renamed(at), block);
    });
}

/// Everything below a folder counts as shipped.
class OtherShipment final : public Application {
public:
    OtherShipment(Application& application, std::string shipped) : m_application(application), m_shipped(std::move(shipped)) {}
    std::shared_ptr<const Registry> builtIn() const override { return m_application.builtIn(); }
    std::vector<Kind> moduleKinds(const OpenOptions& options) const override { return m_application.moduleKinds(options); }
    const Locations& locations() const override { return m_application.locations(); }
    Result<std::shared_ptr<const LoadedProject>> open(const std::string& path, const OpenOptions& options) override {
        auto loaded = m_application.open(path, options);
        if (!loaded) return loaded;
        auto other = std::make_shared<LoadedProject>(*loaded.value());
        other->shippedConfigs = m_shipped;
        return std::shared_ptr<const LoadedProject>(std::move(other));
    }
    std::unique_ptr<Runner> makeRunner(const LoadedProject& loaded, RunOptions options, Diagnostics& diagnostics) override {
        return m_application.makeRunner(loaded, std::move(options), diagnostics);
    }

private:
    Application& m_application;
    std::string m_shipped;
};

} // namespace

class StructureEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void changesForAll() {
        const DocumentFixture fixture;
        fixture.write("configs/other.sim", kOther);
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::ChangeForAll);
        QVERIFY(insert(d, "robot0").ok());
        QCOMPARE(asked.questions.size(), 1u);
        const ShareQuestion& q = asked.questions[0];
        QCOMPARE(q.config, u"Rover"_qs);
        QCOMPARE(q.file, u"robots/rover.sim"_qs);
        QCOMPARE(q.users, (QStringList{u"main.sim"_qs, u"other.sim"_qs}));
        QVERIFY(holds(*d.texts().text(fixture.robot), "Body arm"));
        QCOMPARE(*d.texts().text(fixture.main), kMain);
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.robot});
        QVERIFY(insert(d, "robot1").ok()); // once per config
        QCOMPARE(asked.questions.size(), 1u);
    }

    void makesACopy() {
        const DocumentFixture fixture;
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::MakeCopy);
        QSignalSpy selected(&d, &Document::selectionRequested), notices(&d, &Document::notice);
        QVERIFY(insert(d, "robot0.chassis", "Sphere ball { Radius=0.1 Pos=0,0,0.2 }").ok());
        QCOMPARE(asked.questions.at(0).copyFor, (QStringList{u"robot0"_qs, u"robot1"_qs}));
        QCOMPARE(*d.texts().text(fixture.robot), kRover);
        const std::string main = *d.texts().text(fixture.main);
        QVERIFY2(holds(main, "RobotConfig Rover2 {\n  Body chassis {"), main.c_str());
        QVERIFY2(holds(main, "// two kilograms"), main.c_str());
        QVERIFY2(holds(main, "Config=Rover2   Pos=0,0,0  // start"), main.c_str());
        QVERIFY(main.find("RobotConfig Rover2") < main.find("Robot robot0"));
        QCOMPARE(messages(*d.loaded()), "");
        QCOMPARE(selected.at(0).at(0).value<std::vector<std::string>>(), std::vector<std::string>{"robot0.chassis.ball"});
        QVERIFY2(holds(reportOf(notices), "Rover2"), reportOf(notices).c_str());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.main});
        d.edits().undo();
        QCOMPARE(*d.texts().text(fixture.main), kMain);
        QVERIFY(d.texts().modifiedFiles().empty());
    }

    /// A path that starts with the config's own name is mapped to the copy as well.
    void aCopyOfTheConfigByItsOwnPath() {
        const DocumentFixture fixture;
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::MakeCopy);
        QVERIFY(d.structure().rename(u"Rename"_qs, "RobotConfig.Rover.leftAxle", "axle").ok());
        QCOMPARE(*d.texts().text(fixture.robot), kRover);
        QVERIFY(holds(*d.texts().text(fixture.main), "Hinge axle { Parent=chassis"));
        QCOMPARE(messages(*d.loaded()), "");
    }

    /// Two instances in one file: the edited robot gets the copy, the other one keeps the config.
    void aCopyForOneOfTwo() {
        const DocumentFixture fixture;
        const std::string file =
            fixture.write("configs/one.sim", std::string(kRover) + "Robot a { Config=Rover }\nRobot b { Config=Rover }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        const Asked asked(d, ShareChoice::MakeCopy);
        QVERIFY(insert(d, "b").ok());
        QCOMPARE(asked.questions.at(0).copyFor, QStringList{u"b"_qs});
        QVERIFY(holds(*d.texts().text(file), "Robot a { Config=Rover }\n"));
        QVERIFY(holds(*d.texts().text(file), "Robot b { Config=Rover2 }\n"));
        QVERIFY(insert(d, "b").ok()); // no other instance uses it, so there is no question
        QCOMPARE(asked.questions.size(), 1u);
    }

    void cancelChangesNothing() {
        const DocumentFixture fixture;
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::Cancel);
        (void)insert(d, "robot0");
        (void)insert(d, "robot0");
        QCOMPARE(asked.questions.size(), 2u); // closing the question cancels the edit
        QVERIFY(!d.texts().isModified());
        QVERIFY(d.edits().history().entries().empty());
    }

    /// The texts may have changed before the question is answered.
    void answeredLater() {
        const DocumentFixture fixture;
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        StructureEdits::ShareAnswer answer;
        d.structure().setShareQuestionHandler([&](const ShareQuestion&, const StructureEdits::ShareAnswer& a) { answer = a; });
        QVERIFY(insert(d, "robot0").ok());
        QVERIFY(!d.texts().isModified());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
        answer(ShareChoice::MakeCopy);
        QVERIFY(holds(*d.texts().text(fixture.main), "Tick = 0.02"));
        QVERIFY(holds(*d.texts().text(fixture.main), "RobotConfig Rover2"));
        QCOMPARE(d.edits().history().entries().size(), 2u);
    }

    void doesNotAskAboutUnsharedConfig() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/one.sim", std::string(kRover) + "Robot a { Config=Rover }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        const Asked asked(d, ShareChoice::Cancel);
        QVERIFY(insert(d, "a").ok());
        QVERIFY(insert(d, "", "Light sun { Mode=sun }").ok());
        QVERIFY(d.opening().open(fixture.robot).ok()); // other files use it, but main.sim is not loaded here
        QVERIFY(asked.questions.empty());
    }

    void shippedConfigsAreCopied() {
        const DocumentFixture fixture;
        const std::string main =
            fixture.write("configs/mine.sim", "#import robots/simple_robot.sim\n\nRobot r { Config=SimpleRobot }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(main).ok());
        const std::string shipped = m_application->locations().configs + "/robots/simple_robot.sim", before = bytesOf(shipped);
        QVERIFY(d.texts().text(canonicalPath(shipped)));
        const Asked asked(d, ShareChoice::ChangeForAll);
        QVERIFY(insert(d, "r").ok());
        QVERIFY(asked.questions.empty());
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{main});
        QCOMPARE(messages(*d.loaded()), "");
        QVERIFY(holds(*d.texts().text(main), "Robot r { Config=SimpleRobot2 }"));
        QVERIFY(d.saving().save().ok());
        QCOMPARE(bytesOf(shipped), before);
        // A value of the config itself is handled in the same way.
        QVERIFY(d.structure().rename(u"Rename"_qs, "RobotConfig.SimpleRobot2", "Mine").ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"RobotConfig.SimpleRobot.wheelRadius", "0.06"}}).ok());
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{main});
        QVERIFY(holds(*d.texts().text(main), "Param wheelRadius = 0.06"));
        const std::size_t entries = d.edits().history().entries().size();
        QVERIFY(!d.structure().setValues(u"Set"_qs, {{"RobotConfig.SimpleRobot.wheelRadius", "-6"}}).ok());
        QCOMPARE(d.edits().history().entries().size(), entries);
        // A drag makes one copy and one history entry.
        for (const char* radius : {"0.07", "0.08", "0.09"})
            QVERIFY(d.structure().setValues(u"Set"_qs, {{"RobotConfig.SimpleRobot.wheelRadius", radius}}, "drag").ok());
        QCOMPARE(d.edits().history().entries().size(), entries + 1);
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{main});
    }

    /// A change inside what a config's block imports, for one experiment only.
    void aCopyOfWhatABlockImports() {
        const DocumentFixture fixture;
        fixture.write("configs/robots/rover.sim", "RobotConfig Rover {\n  #import parts.sim\n}\n");
        const std::string kept = "Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 } }\n",
                          application = fixture.write("configs/robots/parts.sim", kept);
        fixture.write("configs/other.sim", kOther);
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        QCOMPARE(messages(*d.loaded()), "");
        const Asked asked(d, ShareChoice::MakeCopy);
        QCOMPARE(why(insert(d, "robot0.chassis", "Sphere nose { Radius=0.1 Mass=1 }")), "");
        QCOMPARE(messages(*d.loaded()), "");
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.main});
        QCOMPARE(*d.texts().text(application), kept);
        QVERIFY2(holds(*d.texts().text(fixture.main), "Sphere nose"), d.texts().text(fixture.main)->c_str());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QCOMPARE(d.loaded()->experiment->robots[0].config->bodies[0].geoms.size(), 2u);
    }

    /// A shipped file inside the block of one's own config: the block gets its text, and everything in it can be edited.
    void expandsShippedImportInOwnBlock_data() {
        QTest::addColumn<QString>("imported"); ///< by the block
        QTest::newRow("directly") << "../shipped/body.sim";
        QTest::newRow("by another shipped file") << "../shipped/all.sim";
        QTest::newRow("by files of one's own") << "outer.sim";
    }
    void expandsShippedImportInOwnBlock() {
        QFETCH(QString, imported);
        const DocumentFixture fixture;
        const std::string kept = "// The body.\nBody chassis {\n  Box hull { Size=0.3,0.2,0.1 Mass=2 }\n}\n";
        const std::string shipped = fixture.write("configs/shipped/body.sim", kept);
        fixture.write("configs/shipped/all.sim", "#import body.sim\n");
        fixture.write("configs/robots/outer.sim", "#import inner.sim\n");
        fixture.write("configs/robots/inner.sim", "#import ../shipped/all.sim\n");
        fixture.write("configs/robots/rover.sim",
                      "RobotConfig Rover {\n  #import " + imported.toStdString() + " // the body\n}\n");
        for (const int edit : {0, 1, 2, 3}) {
            OtherShipment application(*m_application, fixture.path("configs/shipped"));
            Document d(application);
            QVERIFY(d.opening().open(fixture.main).ok());
            QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
            QSignalSpy notices(&d, &Document::notice);
            if (edit == 0) QCOMPARE(why(insert(d, "robot0.chassis", "Sphere nose { Radius=0.1 Mass=1 }")), "");
            if (edit == 1) QCOMPARE(why(insert(d, "RobotConfig.Rover.chassis", "Sphere nose { Radius=0.1 Mass=1 }")), "");
            if (edit == 2) QCOMPARE(why(d.structure().rename(u"Rename"_qs, "RobotConfig.Rover.chassis", "nose")), "");
            if (edit == 3)
                QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"RobotConfig.Rover.chassis.hull.Mass", "2.5"}})), "");
            QCOMPARE(messages(*d.loaded()), "");
            QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.robot});
            const std::string text = *d.texts().text(fixture.robot);
            QVERIFY2(holds(text, "  Body ") && holds(text, "    Box hull") && holds(text, "// The body.") &&
                         holds(text, edit == 3 ? "Mass=2.5" : "nose"),
                     text.c_str());
            QVERIFY2(holds(reportOf(notices), "Rover has its text instead of the import"), reportOf(notices).c_str());
            QCOMPARE(d.edits().history().entries().size(), 1u);
            QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
            d.edits().undo();
            QVERIFY(holds(*d.texts().text(fixture.robot), "#import " + imported.toStdString() + " // the body"));
            QCOMPARE(bytesOf(shipped), kept);
        }
    }

    /// A fix in a shipped config is made in a copy.
    void fixesCopiesOfShippedConfigs() {
        const DocumentFixture fixture;
        const std::string kept =
            "// Drives.\n  RobotConfig Rover {\n    Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 kg } }\n  }\n";
        const std::string shipped = fixture.write("configs/robots/rover.sim", kept);
        OtherShipment application(*m_application, fixture.path("configs/robots"));
        Document d(application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::ChangeForAll);
        const auto value = static_cast<std::uint32_t>(kept.find("2 kg")),
                   line = static_cast<std::uint32_t>(kept.find("    Body")),
                   end = static_cast<std::uint32_t>(kept.find(" }\n  }"));
        const FileId file = static_cast<FileId>(std::ranges::find(d.loaded()->paths, shipped) - d.loaded()->paths.begin());
        Diagnostic found;
        found.fixes.push_back({"Mass=3",
                               {{{file, {value, value + 4}}, "3"},
                                {{file, {line, line}}, "    // fixed\n"},
                                {{file, {end, end}}, "\n    Sphere nose { Radius=0.1 Mass=1 }"}}});
        found.fixes.push_back({"outside", {{{file, {0, 0}}, "// x\n"}}});
        const auto fixes = applicableFixes(*d.loaded(), found);
        QCOMPARE(fixes.size(), 1u);
        QCOMPARE(fixes[0]->title, "Mass=3");
        QCOMPARE(why(d.structure().applyFix(*fixes[0])), "");
        QCOMPARE(messages(*d.loaded()), "");
        QVERIFY(asked.questions.empty());
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.main});
        QVERIFY2(holds(*d.texts().text(fixture.main),
                       "RobotConfig Rover2 {\n    // fixed\n  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=3 }\n"
                       "    Sphere nose { Radius=0.1 Mass=1 } }\n}\n"),
                 d.texts().text(fixture.main)->c_str());
        QCOMPARE(d.loaded()->experiment->robots[0].config->name, "Rover2");
        QCOMPARE(d.edits().history().entries().size(), 1u);
        d.edits().undo();
        QCOMPARE(*d.texts().text(fixture.main), kMain);
        QCOMPARE(bytesOf(shipped), kept);
    }

    /// Materials and surfaces of shipped files are copied, and with them the shipped configs that use them.
    void shippedDefinitionsAreCopied() {
        const DocumentFixture fixture;
        const std::string text = "#import robots/simple_robot.sim\n\nRobot r { Config=SimpleRobot }\n"
                                 "Robot s { Config=SimpleRobot chassis.bumper.Material=lightgrey }\n",
                          main = fixture.write("configs/mine.sim", text), colour = "Material.lightgrey.ColorRGB";
        Document d(*m_application);
        QVERIFY(d.opening().open(main).ok());
        const Asked asked(d, ShareChoice::ChangeForAll);
        QSignalSpy notices(&d, &Document::notice), refused(&d, &Document::refused);
        bool isShown = false; // the status line removes a notice at the next change
        connect(&d, &Document::changed, this, [&] { isShown = false; });
        connect(&d, &Document::notice, this, [&] { isShown = true; });
        const auto isCopied = [&](const std::string& block, const std::string& use) {
            const std::string now = *d.texts().text(main);
            const bool fits = isShown && messages(*d.loaded()).empty() && holds(now, block.c_str()) && holds(now, use.c_str()) &&
                              holds(now, "Robot r { Config=SimpleRobot2 }") && d.edits().history().entries().size() == 1 &&
                              d.texts().modifiedFiles() == std::vector<std::string>{main} && asked.questions.empty();
            if (!fits) qWarning("%s%s", messages(*d.loaded()).c_str(), now.c_str());
            d.edits().undo();
            return fits && *d.texts().text(main) == text && holds(reportOf(notices), "read-only");
        };
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{colour, "0,0.9,0"}})), "");
        QVERIFY(isCopied("Material lightgrey2 { ColorRGB=0,0.9,0 }", "chassis.bumper.Material=lightgrey2"));
        for (const char* green : {"0,0.7,0", "0,0.8,0"})
            QVERIFY(d.structure().setValues(u"Drag"_qs, {{colour, green}}, "drag").ok());
        QVERIFY(isCopied("Material lightgrey2 { ColorRGB=0,0.8,0 }", "Mass=2.0  Material=lightgrey2"));
        QCOMPARE(why(d.structure().rename(u"Rename"_qs, "Material.lightgrey", "paint")), "");
        QVERIFY(isCopied("Material paint {", "chassis.bumper.Material=paint"));
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Surface.plastic.Friction", "0.3"}}).ok());
        QVERIFY(isCopied("Surface plastic2 { Friction=0.3", "Material=lightgrey  Surface=plastic2"));
        QVERIFY(!d.structure().setValues(u"Set"_qs, {{colour, "7"}}).ok()); // invalid: without a copy, too
        QVERIFY(!d.texts().isModified());
        QVERIFY(!d.edits().apply(u"Remove"_qs, planRemove(*d.loaded(), {"Material.concrete"})).ok());
        QVERIFY(refused.takeLast().at(0).toString().contains(u"read-only"_qs));
    }

    void shippedParamsAreCopied() {
        const DocumentFixture fixture;
        fixture.write("configs/shipped/hall.sim", "Param wide = 3 // m\nStaticConfig Hall { Box b { Size=$wide,1,1 } }\n");
        fixture.write("configs/own.sim", "#import shipped/hall.sim\nStaticConfig Own { Box b { Size=$wide,1,1 } }\n");
        const std::string main = fixture.write("configs/mine.sim", "#import shipped/hall.sim\n#import own.sim\n"
                                                                   "Param far = $(wide+1)\nStatic hall { Config=Hall }\n"
                                                                   "Static own { Config=Own Pos=$far,0,0 }\n");
        OtherShipment application(*m_application, fixture.path("configs/shipped"));
        Document d(application);
        QVERIFY(d.opening().open(main).ok());
        QSignalSpy notices(&d, &Document::notice);
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"wide", "5"}})), "");
        QVERIFY(!d.loaded()->diagnostics.hasErrors() && holds(*d.texts().text(main), "Param wide2 = 5\n"));
        const auto& statics = d.loaded()->experiment->statics;
        QCOMPARE(statics.at(0).geoms->at(0).size.x(), 5.0);
        QCOMPARE(statics.at(1).pose.position.x(), 6.0);
        QCOMPARE(statics.at(1).geoms->at(0).size.x(), 3.0); // a file of one's own that other experiments may use
        QVERIFY(holds(reportOf(notices), "own.sim does not use"));
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{main});
    }

    /// A rename also changes texts of the project that the experiment does not load: one entry, one undo.
    void renamesInTextsThatAreNotLoaded_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("own");   // is in rover.sim afterwards
        QTest::addColumn<QString>("other"); // is in other.sim afterwards
        QTest::newRow("config") << "RobotConfig.Rover"
                                << "Buggy"
                                << "RobotConfig Buggy {"
                                << "Config=Buggy chassis.hull.Mass=3";
        QTest::newRow("body") << "RobotConfig.Rover.chassis"
                              << "base"
                              << "Parent=base Child=leftWheel"
                              << "Config=Rover base.hull.Mass=3";
        QTest::newRow("through the robot") << "robot0.chassis"
                                           << "base"
                                           << "Body base {"
                                           << "Config=Rover base.hull.Mass=3";
    }
    void renamesInTextsThatAreNotLoaded() {
        QFETCH(QString, path);
        QFETCH(QString, to);
        QFETCH(QString, own);
        QFETCH(QString, other);
        const DocumentFixture fixture;
        const std::string before = "#import robots/rover.sim\nRobot other { Config=Rover chassis.hull.Mass=3 }\n";
        const std::string file = fixture.write("configs/other.sim", before);
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::ChangeForAll);
        QSignalSpy notices(&d, &Document::notice);
        QVERIFY(d.structure().rename(u"Rename"_qs, path.toStdString(), to.toStdString()).ok());
        QVERIFY2(holds(*d.texts().text(fixture.robot), own.toStdString().c_str()), d.texts().text(fixture.robot)->c_str());
        QVERIFY(d.texts().text(file));
        QVERIFY2(holds(*d.texts().text(file), other.toStdString().c_str()), d.texts().text(file)->c_str());
        QVERIFY2(holds(reportOf(notices), "other.sim (") && reportOf(notices).ends_with(")"), reportOf(notices).c_str());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QVERIFY(d.texts().isModified(file));
        d.edits().undo();
        QCOMPARE(*d.texts().text(file), before);
        QCOMPARE(*d.texts().text(fixture.robot), kRover);
        QVERIFY(!d.texts().isModified());
        d.edits().redo();
        QVERIFY(d.saving().save().ok());
        QVERIFY(holds(bytesOf(file), other.toStdString().c_str()));
    }

    /// The original stays as it is, and so do its users.
    void renamesInACopyOnly() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/other.sim", kOther);
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        const Asked asked(d, ShareChoice::MakeCopy);
        QVERIFY(d.structure().rename(u"Rename"_qs, "robot0.chassis", "base").ok());
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.main});
    }

    void valuesGoToTheirTarget() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/one.sim", std::string(kRover) + "Robot a { Config=Rover }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"a.chassis.hull.Mass", "3"}}).ok());
        QVERIFY(holds(*d.texts().text(file), "Mass=3 } } // two kilograms"));
        QVERIFY(holds(*d.texts().text(file), "Robot a { Config=Rover }\n"));
        // The choice holds for the whole drag.
        for (const char* mass : {"4", "5"})
            QVERIFY(d.structure().setValues(u"Set"_qs, {{"a.chassis.hull.Mass", mass}}, "drag").ok());
        QVERIFY(holds(*d.texts().text(file), "Mass=5 } } // two kilograms"));
        QVERIFY(d.opening().open(fixture.main).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"robot1.chassis.hull.Mass", "3"}}).ok());
        QCOMPARE(d.texts().modifiedFiles(), std::vector<std::string>{fixture.main});
        QVERIFY(holds(*d.texts().text(fixture.main), "chassis.hull.Mass=3"));
    }

private:
    std::unique_ptr<Application> m_application;
};

QTEST_GUILESS_MAIN(StructureEditsTest)
#include "structure_edits_test.moc"
