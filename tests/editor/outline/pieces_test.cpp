// Parts of the Scene and Library panels without their widgets: the items of the library, the problems of each block. The question
// before lists are shortened.

#include <fstream>

#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>
#include <QMessageBox>

#include "editor/document/structure_edits.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/kind_icons.h"
#include "editor/outline/library_items.h"
#include "editor/outline/problem_counts.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/widget_text.h"
#include "lang/tree.h"
#include "outline_fixture.h"

using namespace trundle;
namespace fs = std::filesystem;

namespace {

QString itemText(const LibraryItem& item) {
    QStringList imports;
    for (const std::string& import : item.imports) imports << QString::fromStdString(import);
    return QStringLiteral("%1 | %2 | %3 | %4 | %5 | %6 | %7\n%8")
        .arg(int(item.section))
        .arg(item.title, item.help, item.icon, QString::fromStdString(item.kind), imports.join(u','),
             QString::fromStdString(item.folder),
             QString::fromStdString(item.text).trimmed().replace(u'\n', QStringLiteral("\\n")));
}

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

} // namespace

class OutlinePiecesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachConfigOfAFolderIsAnItem() {
        QTemporaryDir made;
        const fs::path root = fs::canonical(made.path().toStdString());
        const std::string robot = "RobotConfig Rover { Body b { } Hinge h { } }\n", crate = "RobotConfig Crate { Body b { } }\n";
        write(root / "rover.sim", "\xEF\xBB\xBF//  A rover.\n// second line\n" + robot);
        write(root / "two.sim", "// Not of one.\n" + crate + "StaticConfig Yard { Plane p { } }\nStaticConfig { }\n");
        write(root / "inside.sim", "RobotConfig Inside { #import more.sim\n }\n");
        write(root / "objects/stone.sim", "StaticConfig Stone { Box b { } }");
        write(root / "placed.sim", "#import rover.sim\nTick = 0.01\nStaticConfig Yard2 { Box b { } }\nGrid g { Config=Yard2 }\n");
        write(root / "a/b/c/deep.sim", "RobotConfig Deep { Camera c { } }");
        write(root / "a/b/c/d/tooDeep.sim", robot);
        write(root / ".hidden/x.sim", robot);
        write(root / "notes.txt", robot);
        write(root / "empty.sim", "");
        write(root / "opened.sim", robot);
        write(root / "large.sim", robot + std::string((1 << 20) + 1, ' '));
        QStringList all;
        for (const LibraryItem& item : configItems({root.string(), "mine/"}, (root / "opened.sim").string())) {
            all << itemText(item).replace(QString::fromStdString(root.string()), QStringLiteral("ROOT"));
            const QString picture = QString::fromStdString(item.picture);
            const bool hasFloor = picture.contains(QStringLiteral("libraryFloor"));
            QVERIFY2(hasFloor != item.title.startsWith(QStringLiteral("Yard")) || item.title == QStringLiteral("Yard2"),
                     qPrintable(picture));
            QVERIFY2(picture.contains(QString::fromStdString(item.kind) + QStringLiteral(" shown { Config=") + item.title),
                     qPrintable(picture));
            QVERIFY(picture.contains(QStringLiteral("\n// "))); // changes with the file
        }
        const QStringList expected{
            QStringLiteral("0 | Deep |  | kind-robot | Robot | mine/a/b/c/deep.sim | ROOT\nRobot robot0 { Config=Deep Pos=0,0,0 "
                           "}"),
            QStringLiteral("0 | Inside |  | kind-robot | Robot | mine/inside.sim | ROOT\nRobot robot0 { Config=Inside Pos=0,0,0 "
                           "}"),
            QStringLiteral("2 | Stone |  | kind-static | Static | mine/objects/stone.sim | ROOT\nStatic stone { Config=Stone "
                           "Pos=0,0,0 }"),
            QStringLiteral(
                "1 | Yard2 |  | kind-static | Static |  | ROOT\n#import rover.sim\\nStaticConfig Yard2 { Box b { } }\\n"
                "Static yard2 { Config=Yard2 Pos=0,0,0 }"),
            QStringLiteral("0 | Rover | A rover. | kind-robot | Robot | mine/rover.sim | ROOT\nRobot robot0 { Config=Rover "
                           "Pos=0,0,0 }"),
            QStringLiteral(
                "2 | Crate |  | kind-object | Robot | mine/two.sim | ROOT\nRobot crate { Config=Crate Pos=0,0,0 }"),
            QStringLiteral(
                "1 | Yard |  | kind-static | Static | mine/two.sim | ROOT\nStatic yard { Config=Yard Pos=0,0,0 }")};
        QCOMPARE(all.join(u'\n'), expected.join(u'\n'));
    }

    void snippetsAreNamedByTheirComment() {
        QTemporaryDir made;
        const fs::path root = fs::canonical(made.path().toStdString());
        write(root / "bumper.sim", "// front bumper: it touches.\nBody bumper { }\nTouchSensor t { }\n");
        write(root / "front_wheel.sim", "// without a title\nHinge h { }\n");
        write(root / "no_comment.sim", "Camera eye { }\n");
        write(root / "below/other.sim", "Body x { }\n");
        write(root / "nothing.sim", "// Empty: nothing.\n");
        QStringList all;
        for (const LibraryItem& item : snippetItems(root.string())) {
            all << itemText(item).replace(QString::fromStdString(root.string()), QStringLiteral("ROOT"));
            QCOMPARE(item.picture.empty(), item.kind != "Body");
        }
        const QStringList expected{
            QStringLiteral("3 | Front bumper | It touches. | kind-body | Body |  | ROOT\nBody bumper { }\\nTouchSensor t { }"),
            QStringLiteral("3 | Front wheel | Without a title | kind-body | Hinge |  | \nHinge h { }"),
            QStringLiteral("3 | No comment |  | kind-body | Camera |  | \nCamera eye { }")};
        QCOMPARE(all.join(u'\n'), expected.join(u'\n'));
    }

    /// Of the kinds that the program has: section, icon and picture.
    void eachKindHasItsPlace() {
        const auto application = makeApplication();
        const auto builtIn = application->builtIn();
        QString all;
        for (const LibraryItem& item : kindItems(builtIn->all())) {
            QVERIFY(QFile::exists(resourcePath(QStringLiteral("icons/") + item.icon + QStringLiteral(".svg"))));
            all += itemText(item).section(u'|', 0, 4).replace(item.help, QStringLiteral("#")) +
                   QString::fromStdString(item.picture).section(u'\n', 0, 0) + u'\n';
        }
        std::vector<Kind> kinds(1);
        kinds[0].name = "Wander";
        kinds[0].role = Role::Controller;
        for (const char* module : {"/mods/libwander.so", "/mods/deep/wander.so", "/mods/deep/library.so"}) {
            kinds[0].module = module;
            all += itemText(moduleItems(kinds, "/mods").at(0));
        }
        all += kindIcon(nullptr) + u'\n';
        const QString difference = differenceFromKept(QStringLiteral("library-kinds"), all, {});
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }

    void aPictureShowsWhatAConfigNeeds() {
        const auto tree =
            parse(std::make_shared<const SourceText>("a.sim", "Tick = 1\n#import x.sim\nParam p = 2\nMaterial m { }\n"
                                                              "PoseLog l { }\nRobot r { }\nSurface s { }\n"
                                                              "RobotConfig A { }\nStaticConfig B { Plane p { } }\n"),
                  0);
        const auto block = [&](std::size_t item) { return *tree->items()[item].as<BlockItem>(); };
        const std::string needed = "#import x.sim\nParam p = 2\nMaterial m { }\nSurface s { }\nRobotConfig A { }\n"
                                   "StaticConfig B { Plane p { } }\n";
        const std::string robot = pictureOfConfig(*tree, block(7));
        QVERIFY2(robot.starts_with(needed + "Robot shown { Config=A }\nStaticConfig LibraryFloor"), robot.c_str());
        QCOMPARE(pictureOfConfig(*tree, block(8)), needed + "Static shown { Config=B }");
        for (const auto& [config, name] : {std::pair{"SimpleRobot", "simpleRobot"}, {"x", "x"}, {"", ""}, {"ABC", "aBC"}})
            QCOMPARE(nameFor(config), std::string(name));
    }

    void textsThatArePasted_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("found"); // kinds and names, or why it is refused
        const auto row = [](const char* text, const char* found) {
            QTest::newRow(text) << std::string(text) << QString::fromLatin1(found);
        };
        row("Box b { Size=1,1,1 }", "Box b");
        row("#import a.sim\n#loadModule m\nBox { }\nBody c { Box d { } }", "Box , Body c");
        row(" \t\r\n", "there is no text to insert");
        row("Box b {", "this text cannot be inserted: line 1: block `b` lacks its closing `}`");
        row("Box b { }\nTick = 1", "this text cannot be inserted: line 2 is a setting of its own; only blocks such as \"Box box "
                                   "{ Size=1,1,1 }\" can be");
        row("// a comment", "this text holds no block that could be inserted");
        row("#import a.sim", "this text holds no block that could be inserted");
    }
    void textsThatArePasted() {
        QFETCH(std::string, text);
        const Result<Blocks> blocks = blocksFrom(text);
        QStringList found;
        for (std::size_t i = 0; blocks && i < blocks.value().kinds.size(); ++i)
            found << QString::fromStdString(blocks.value().kinds[i] + " " + blocks.value().names[i]);
        const QString said = blocks ? found.join(QStringLiteral(", ")) : QString::fromStdString(blocks.error().message);
        QTEST(said, "found");
        if (blocks) QCOMPARE(blocks.value().text, text);
    }

    void pastesAreNamedInTheHistory() {
        OutlineFixture o;
        QVERIFY(o.open(kRovers));
        const auto name = [&] { return o.document.edits().history().entries().back().name; };
        QVERIFY(o.edits.copy({"robot1"}).ok() && o.edits.paste({}).ok());
        QCOMPARE(name(), QStringLiteral("Paste Robot robot1"));
        QGuiApplication::clipboard()->setText(QStringLiteral("Body { Sphere s { Radius=1 Mass=1 } }"));
        QVERIFY(o.edits.paste("RobotConfig.Rover").ok());
        QCOMPARE(name(), QStringLiteral("Paste Body"));
    }

    /// The question names what is deleted with a robot, and whose list only loses its name.
    void asksBeforeListsAreShortened() {
        OutlineFixture o;
        const QByteArray region = "Region goal { Size=1,1,1 Robots=robot0,robot1 }\n";
        QVERIFY(o.open(kRovers + region + "NoContact=robot0,robot1\n"));
        o.selection.select("robot0");
        o.edits.removeSelected();
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        QVERIFY(question);
        QCOMPARE(question->text(), QStringLiteral("robot0 is used by PoseLog path, NoContact, Region goal."));
        QVERIFY2(question->informativeText().contains(QStringLiteral("Also deleted: PoseLog path.")) &&
                     question->informativeText().contains(QStringLiteral(": NoContact, Region goal.")),
                 qPrintable(question->informativeText()));
        QTest::keyClick(question, Qt::Key_Return);
        QVERIFY2(!o.text().contains("robot0") && !o.text().contains("PoseLog"), o.text().constData());
        QVERIFY2(o.text().endsWith("Region goal { Size=1,1,1 Robots=robot1 }\n"), o.text().constData());
        QCOMPARE(o.errors(), QString());
        o.document.edits().undo();

        o.selection.select("robot1"); // is only in lists
        o.edits.removeSelected();
        question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        QVERIFY(question && question->text() == QStringLiteral("robot1 is used by NoContact, Region goal."));
        question->button(QMessageBox::Cancel)->click();
        QVERIFY(o.text().contains(region));
    }

    /// Deleting a part of one robot of several, with what depends on it or alone.
    void asksBeforeChangingASharedConfig() {
        OutlineFixture o;
        int asked = 0;
        o.document.structure().setShareQuestionHandler([&](const ShareQuestion&, const StructureEdits::ShareAnswer& answer) {
            ++asked;
            answer(ShareChoice::Cancel);
        });
        QVERIFY(o.open(kRovers));
        for (const char* path : {"robot0.chassis.bumper", "robot1.count", "robot0.leftWheel.tyre"}) {
            o.tree().expandAll();
            o.click(o.at(path));
            QCOMPARE(o.selected(), QLatin1String(path));
            QTest::keyClick(&o.tree(), Qt::Key_Delete);
            QCOMPARE(o.text(), kRovers);
        }
        QCOMPARE(asked, 3);
    }

    /// The object that was selected last is the current row.
    void theLastOfSeveralIsCurrent() {
        OutlineFixture o;
        QVERIFY(o.open(kRovers));
        for (const auto& [first, last] : {std::pair{"robot0", "robot1"}, {"robot1", "robot0"}}) {
            o.selection.set({first, last});
            QCOMPARE(o.tree().currentIndex(), o.at(last));
            QVERIFY(o.tree().selectionModel()->isSelected(o.at(first)) && o.tree().selectionModel()->isSelected(o.at(last)));
        }
    }

    /// Whichever of the objects it is, and also for what is in it.
    void aLockedObjectIsNotDeleted() {
        OutlineFixture o;
        QVERIFY(o.open(kRovers));
        o.marks.setLocked({"arena"}, true);
        for (const std::vector<std::string>& paths :
             {std::vector<std::string>{"arena"}, {"arena", "robot1"}, {"robot1", "arena"}, {"path", "robot1", "arena"}}) {
            o.refusals.clear();
            QVERIFY(!o.edits.remove(paths).ok());
            QCOMPARE(o.text(), kRovers);
            QCOMPARE(o.refusals.size(), 1);
            QVERIFY2(o.refusals[0].contains(QStringLiteral("arena")), qPrintable(o.refusals[0]));
            o.selection.set(paths);
            o.edits.removeSelected();
            QCOMPARE(o.text(), kRovers);
        }
        o.marks.setLocked({"RobotConfig.Rover.chassis"}, true);
        QVERIFY(!o.edits.remove({"robot1", "RobotConfig.Rover.chassis.bumper"}).ok());
        QCOMPARE(o.text(), kRovers);
        o.marks.setLocked({"arena"}, false);
        QVERIFY(o.edits.remove({"robot1", "arena"}).ok());
        QVERIFY(!o.text().contains("Robot robot1") && !o.text().contains("Static arena") && o.text().contains("Robot robot0"));
    }

    /// Members of a Grid or Scatter that are selected elsewhere: robots and scenery, the first and the last.
    void selectedMembersAreFound() {
        OutlineFixture o;
        QVERIFY(o.open(kRovers + "StaticConfig Stone { Box b { Size=0.1,0.2,0.3 } }\nStatic stone { Config=Stone Pos=0,9,0 }\n"
                                 "Grid stones { Config=Stone Pos=5,5,0 Count=3,2 Spacing=1 }\n"
                                 "Grid swarm { Config=Rover Pos=-5,5,0 Count=2,1 Spacing=1 }\n"
                                 "Grid rocks { Config=Stone Pos=5,-5,0 Count=1,2 Spacing=1 }\n"));
        for (const char* member : {"stones_0", "stones_5", "swarm_0", "rocks_1", "swarm_1", "rocks_0", "stone", "robot1"}) {
            o.selection.select(member);
            QCOMPARE(o.marked(), QLatin1String(member));
        }
        o.selection.select("stones_6"); // no such member
        QVERIFY(o.marked() != QStringLiteral("rocks_0"));
    }

    /// A problem counts for its block and all around it, up to the first byte behind the block.
    void problemsCountForTheirBlocks() {
        OutlineFixture o;
        QVERIFY(o.write("part.sim", "Robot far { Config=None }\n"));
        QVERIFY(o.open("#import part.sim\nTik = 1\nRobotConfig C {\n  Body b { Box g { Size=0,1,1 Mass=-1 } }Body c { Bx h { } "
                       "}\n  Wrong = 1\n}\n"
                       "Robot a { Config=None }Robot b { Config=None Pos=1 }\n"));
        const LoadedProject& loaded = *o.document.loaded();
        const ProblemCounts counts(loaded);
        const auto text = [](ProblemCounts::Count count) {
            return QStringLiteral("%1/%2").arg(count.errors).arg(count.warnings);
        };
        QStringList found;
        const auto walk = [&](const auto& self, const Part& part) -> void {
            found << QString::fromStdString(part.name) + u' ' + text(counts.of(part));
            for (const Part& inner : part.parts) self(self, inner);
        };
        for (const auto& part : loaded.outline->parts) walk(walk, *part);
        QCOMPARE(found.join(u' '), QStringLiteral("far 1/0 C 4/0 b 2/0 g 2/0 c 1/0 h 1/0 a 1/0 b 2/0"));
        QCOMPARE(text(counts.outside(*o.document.loaded())), QStringLiteral("1/0")); // Tik
        QCOMPARE(text(counts.ofFile(0)), QStringLiteral("8/0"));
        QCOMPARE(text(counts.ofFile(1)), QStringLiteral("1/0"));
        QCOMPARE(text(counts.ofFile(7)), QStringLiteral("0/0"));
        const auto first = std::uint32_t(o.text().indexOf("Tik"));
        QCOMPARE(text(counts.at({0, {first, first}})), QStringLiteral("1/0"));
        QCOMPARE(text(counts.at({0, {first + 1, first + 9}})), QStringLiteral("0/0"));
        QCOMPARE(text(counts.at({1, {0, 100}})), QStringLiteral("1/0"));
        // What is about a module has a row of its own.
        QVERIFY(o.open("#loadModule none\nTik = 1\n#loadModule neither\n", "modules.sim"));
        const LoadedProject& withModules = *o.document.loaded();
        QCOMPARE(text(ProblemCounts(withModules).outside(withModules)), QStringLiteral("1/0"));
        QCOMPARE(text(ProblemCounts(withModules).at(withModules.experiment->modules.at(1).range)), QStringLiteral("1/0"));
        QVERIFY(o.open("Robot r { Config=None }\n", "other.sim"));
        QVERIFY(o.open("Tick = 0.01\n", "good.sim"));
        QCOMPARE(text(ProblemCounts(*o.document.loaded()).outside(*o.document.loaded())), QStringLiteral("0/0"));
    }
};

QTEST_MAIN(OutlinePiecesTest)
#include "pieces_test.moc"
