// Where in a text the caret is: for completion from the tokens before it, for other help from the tree; and the files of a project.

#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "editor/text/completion/completion_context.h"
#include "editor/text/symbols/project_files.h"
#include "editor/text/symbols/text_location.h"
#include "editor/text/text_fixture.h"

using namespace trundle;
using namespace trundle::test;
namespace fs = std::filesystem;

namespace {

/// Text with a | at the caret; the offset of the caret.
std::pair<std::string, std::uint32_t> marked(const char* text) {
    std::string bytes = text;
    const std::size_t caret = bytes.find('|');
    bytes.erase(caret, 1);
    return {bytes, static_cast<std::uint32_t>(caret)};
}

template <class Words> QString joined(const Words& words) {
    QStringList all;
    for (const std::string& word : words) all << QString::fromStdString(word);
    return all.join(u'.');
}

} // namespace

class PlacesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsBeingTyped_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("context"); // place, word, path, and what else is known
        const auto row = [](const char* text, const char* context) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(context);
        };
        row("|", "statement '' in ");
        row("#|", "directive '#' in ");
        row("  #im|", "directive '#im' in ");
        row("#import |", "import '' in ");
        row("#import robots/si|mple", "import 'robots/si' in ");
        row("#import \"robots/si|", "import 'robots/si' in ");
        row("#loadModule con|", "module 'con' in ");
        row("#other x|", "nowhere 'x' in ");
        row("// #import x|", "nowhere '' in ");
        row("/* a */|", "nowhere '' in ");
        row("Ti|ck = 1", "statement 'Tick' in ");
        row("Tick = |", "value '' in Tick blank");
        row("Tick=|", "value '' in Tick");
        row("Tick = 1|", "number '' in Tick");
        row("Tick = 1 |", "number '' in Tick blank");
        row("Tick = 1 m|", "number 'm' in Tick blank");
        row("Tick = 1m|", "number 'm' in Tick");
        row("Tick = 1\n|", "statement '' in  blank");
        row("Tick = 1\nDu|", "statement 'Du' in  blank");
        row("Pos=1,|", "value '' in Pos");
        row("Pos=1,2 |", "number '' in Pos blank");
        row("Robot r { Config=Sim|", "value 'Sim' in Config");
        row("Robot r { Config=\"Sim|\" }", "value 'Sim' in Config quoted");
        row("Robot r { Config=\"Sim\"|", "nowhere '' in ");
        row("Robot r { Config=\"Sim\" |", "statement '' in  blank");
        row("Robot \"a|\"", "nowhere 'a' in  quoted");
        row("Robot |", "nowhere '' in  blank");
        row("Robot r|", "nowhere 'r' in  blank");
        row("Robot r { |", "statement '' in  blank");
        row("Robot r { a.b.|", "override '' in a.b");
        row("Robot r { left.Ma|", "override 'Ma' in left");
        row("Robot r { left.Mass=|", "value '' in left.Mass");
        row("Robot r { Pos=1,1,0 left.|", "override '' in left");
        row("Robot r { Config=Rover |", "statement '' in  blank");
        row("Robot r { Config=Rover\n|", "statement '' in  blank");
        row("Param a = |", "value '' in a of Param blank");
        row("Param a = $|", "param '$' in a of Param blank");
        row("Mass = $wid|th", "param '$width' in Mass blank");
        row("Mass = $(a + |", "expression '' in  blank");
        row("Mass = $(a + (b|)", "expression 'b' in ");
        row("Mass = $(a) |", "statement '' in  blank");
        row("Mass = $a |", "statement '' in  blank");
        row("Box b { Geom=chassis.|", "value '' in Geom before chassis.");
    }
    void whatIsBeingTyped() {
        QFETCH(QString, text);
        const auto [bytes, caret] = marked(text.toUtf8().constData());
        const auto tree = parse(std::make_shared<const SourceText>("a.sim", bytes), 0);
        const CompletionContext c = completionContext(*tree, caret);
        static const char* const kPlaces[] = {"nowhere",  "directive", "import", "module",     "statement",
                                              "override", "value",     "number", "expression", "param"};
        QString found = QStringLiteral("%1 '%2' in %3")
                            .arg(QLatin1String(kPlaces[int(c.where)]),
                                 QString::fromStdString(bytes.substr(c.word.begin, c.word.size())), joined(c.path));
        if (c.ofParam) found += QStringLiteral(" of Param");
        if (c.blank) found += QStringLiteral(" blank");
        if (c.quoted) found += QStringLiteral(" quoted");
        if (!c.before.empty()) found += QStringLiteral(" before ") + QString::fromStdString(c.before);
        QTEST(found, "context");
    }

    void blocksAroundAPlace_data() {
        QTest::addColumn<QString>("before"); // the caret is behind it
        QTest::addColumn<QString>("place");
        const auto row = [](const char* before, const char* place) {
            QTest::newRow(before) << QString::fromLatin1(before) << QString::fromLatin1(place);
        };
        row("Tick", "settings parts  config  instance  params top");
        row("RobotConfig Cart {", "RobotConfig parts Cart config Cart instance  params width.top");
        row("Mass=2", "Box parts Cart.chassis.hull config Cart instance  params width.top");
        row("Size=1,1,1 ", "Box parts Cart.chassis.hull config Cart instance  params width.top");
        row("Mass=2 ", "Box parts Cart.chassis.hull config Cart instance  params width.top"); // directly before its brace
        row("Mass=2 }", "Body parts Cart.chassis config Cart instance  params width.top");
        row("Mass=2 } ", "Body parts Cart.chassis config Cart instance  params width.top");
        row("hull.Mass=3 ", "Robot parts one config Cart instance one params top");
        row("Config=Yard ", "Static parts yard config Yard instance yard params top");
        row("Parent=chassis", "Hinge parts Cart.axle config Cart instance  params width.top");
        row("Robot one {", "Robot parts one config Cart instance one params top");
        row("chassis.hull", "Robot parts one config Cart instance one params top");
        row("Static yard { ", "Static parts yard config Yard instance yard params top");
        row("} // behind", "settings parts  config  instance  params top");
    }
    void blocksAroundAPlace() {
        QFETCH(QString, before);
        TextFixture w;
        const std::string text =
            "Tick = 0.01\nParam top = 1\nRobotConfig Cart {\n  Param width = 0.2\n"
            "  Body chassis { Box hull { Size=1,1,1 Mass=2 } }\n  Body wheel { Pos=1,0,0 Sphere s { Radius=1 Mass=1 } }\n"
            "  Hinge axle { Parent=chassis Child=wheel }\n}\nStaticConfig Yard { Box b { Size=1,1,1 } }\n"
            "Robot one { Config=Cart chassis.hull.Mass=3 }\nStatic yard { Config=Yard } // behind\n";
        w.open(w.write("a.sim", QByteArray::fromStdString(text)));
        const LoadedProject& loaded = *w.document.loaded();
        const auto offset = static_cast<std::uint32_t>(text.find(before.toStdString()) + std::size_t(before.size()));
        const TextLocation place = placeAt(loaded, 0, offset);
        QStringList parts, params;
        for (const Part* part : place.parts) parts << QString::fromStdString(part->name);
        for (const SourceParam* param : paramsAt(loaded, place)) params << QString::fromStdString(param->name->text);
        const auto name = [](const Part* part) { return part ? QString::fromStdString(part->name) : QString(); };
        const QString kind = !place.kind            ? QString()
                             : place.blocks.empty() ? QStringLiteral("settings")
                                                    : QString::fromStdString(place.kind->name);
        QTEST(QStringLiteral("%1 parts %2 config %3 instance %4 params %5")
                  .arg(kind, parts.join(u'.'), name(place.config), name(place.instance), params.join(u'.')),
              "place");
        // Properties by their path, from here.
        const auto has = [&](std::vector<std::string> path) { return propertyOf(place, path) != nullptr; };
        const bool inRobot = place.instance && place.instance->name == "one";
        QCOMPARE(has({"chassis", "hull", "Mass"}), inRobot);
        QCOMPARE(has({"chassis", "hull", "None"}), false);
        QCOMPARE(has({"hull", "Mass"}), false);
        QCOMPARE(has({"SelfCollision"}), inRobot || kind == QStringLiteral("RobotConfig")); // of its config
        QVERIFY(!has({}));
    }

    void filesAndModulesBelowFolders() {
        QTemporaryDir made;
        const fs::path root = fs::canonical(made.path().toStdString());
        const auto put = [&](const char* name) {
            fs::create_directories((root / name).parent_path());
            std::ofstream(root / name) << "x";
        };
        for (const char* name :
             {"one/a.sim", "one/b.png", "one/sub/c.sim", "one/1/2/3/4/5/6/deep.sim", "one/1/2/3/4/5/6/7/deeper.sim",
              "one/.hidden/d.sim", "one/.e.sim", "one/f.simx", "two/a.sim", "two/g.sim", "mods/libalpha.so", "mods/beta.so",
              "mods/deep/library.so", "mods/notes.txt", "mods/gamma.so.1"})
            put(name);
        fs::create_symlink(root / "one/a.sim", root / "two/same.sim");
        const std::vector<std::string> folders{(root / "one").string(), {}, (root / "two").string(), (root / "none").string()};
        QCOMPARE(joined(filesBelow(folders, {"sim"})).replace(QStringLiteral(".sim"), QString()),
                 QStringLiteral("1/2/3/4/5/6/deep.a.g.sub/c"));
        QCOMPARE(joined(filesBelow({(root / "one").string()}, {"png", "simx"})), QStringLiteral("b.png.f.simx"));
        QVERIFY(filesBelow(folders, {}).empty());
        QCOMPARE(joined(modulesBelow({(root / "mods").string(), {}})), QStringLiteral("alpha.beta.deep/rary"));
    }
};

QTEST_MAIN(PlacesTest)
#include "places_test.moc"
