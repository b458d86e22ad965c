// What a ChangeSet reports, compared with the texts of all values before and after.
#include <random>
#include <set>

#include <QTest>

#include "model/dotted_path.h"
#include "plan_fixture.h"
#include "project/edits/change_set.h"
#include "project/edits/value_edits.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kMain = R"(#loadModule walker
#import arena.sim
Param far = 4
Tick = 0.01
Material red { ColorRGB=1,0,0 }
RobotConfig Cart {
  Param size = 1
  #import wheel.sim
  Body chassis { Box hull { Size=1,$size,1 Mass=1 } Sphere { Radius=0.1 } Sphere { Radius=0.2 } }
  Hinge axle { Parent=chassis Child=wheel }
}
Static arena { Config=Yard }
Robot robot0 { Config=Cart chassis.hull.Mass=2 Walker brain { Speed=1 } }
Robot robot1 { Config=Cart Pos=$far,0,0 }
Grid swarm { Config=Cart Count=3 Spacing=4 Pos=9,9,9 }
PoseLog { Robot=robot0 }
)";
const std::map<std::string, std::string> kFiles{{"main.sim", kMain},
                                                {"wheel.sim", "Body wheel { Sphere tyre { Radius=0.1 Mass=1 } }\n"},
                                                {"arena.sim", "StaticConfig Yard { Box north { Size=1,1,1 } }\n"}};

using Texts = std::map<std::string, std::string>;

void add(const Outline& outline, const Part& part, const std::string& path, Texts& out) {
    std::string at = path;
    while (out.contains(at)) at += "'"; // a name that is used twice
    out[at] = part.block->type.text;
    for (const SourceAssignment& a : part.assignments.all()) out[at + "." + a.key] = outline.texts().slice(a.valueRange());
    for (const SourceParam& p : part.params) out[at + ".$" + p.name->text] = outline.texts().slice(p.valueFile, p.value->range);
    for (const Part& inner : part.parts) add(outline, inner, at + "." + inner.name, out);
}

/// The text of every value and the kind of every block, by path: slow, and all there is.
Texts textsOf(const LoadedProject& loaded) {
    const Outline& outline = *loaded.outline;
    Texts out;
    for (const SourceAssignment& a : outline.settings.all()) out[a.key] = outline.texts().slice(a.valueRange());
    for (const SourceParam& p : outline.params) out["$" + p.name->text] = outline.texts().slice(p.valueFile, p.value->range);
    for (const auto& part : outline.parts) {
        const NameSpace* space = part->kind ? outline.spaceOf(*part->kind) : nullptr;
        add(outline, *part, space && space != &outline.world ? part->kind->name + "." + part->name : part->name, out);
    }
    return out;
}

/// The changes applied to the texts of before.
Texts applied(const ChangeSet& changes) {
    Texts texts = textsOf(*changes.before());
    const Texts now = textsOf(*changes.after());
    const auto take = [&](const std::string& path) {
        if (const auto found = now.find(path); found != now.end()) texts[path] = found->second;
        else texts.erase(path);
    };
    for (const std::string& key : changes.settings()) take(key);
    for (const std::string& name : changes.params()) take("$" + name);
    const auto drop = [&](const std::string& path) {
        std::erase_if(texts, [&](const auto& t) { return startsWithPath(t.first, path); });
    };
    const auto takeAll = [&](const std::string& path) {
        drop(path);
        for (const auto& [at, text] : now)
            if (startsWithPath(at, path)) texts[at] = text;
    };
    for (const PartChange& change : changes.parts()) {
        for (const std::string& key : change.properties) take(pathInside(change.after, key));
        for (const std::string& name : change.params) take(pathInside(change.after, "$" + name));
        if (change.what == PartChange::What::Removed || change.what == PartChange::What::Renamed) drop(change.before);
    }
    for (const PartChange& change : changes.parts())
        if (change.what == PartChange::What::Added || change.what == PartChange::What::Renamed) takeAll(change.after);
    return texts;
}

QString shown(const ChangeSet& changes) {
    QStringList all;
    for (const std::string& key : changes.settings()) all += QString::fromStdString(key);
    for (const std::string& name : changes.params()) all += "$" + QString::fromStdString(name);
    for (const PartChange& c : changes.parts()) {
        QString line = QString("~+->").mid(c.what == PartChange::What::Edited    ? 0
                                           : c.what == PartChange::What::Added   ? 1
                                           : c.what == PartChange::What::Removed ? 2
                                                                                 : 3,
                                           1);
        line += QString::fromStdString(c.what == PartChange::What::Renamed ? c.before + ">" + c.after
                                       : c.after.empty()                   ? c.before
                                                                           : c.after);
        for (const std::string& key : c.properties) line += " " + QString::fromStdString(key);
        for (const std::string& name : c.params) line += " $" + QString::fromStdString(name);
        all += line;
    }
    if (changes.isEverything()) all += "everything";
    else if (changes.changesStructure()) all += "structure";
    else if (changes.isLocal()) all += "local";
    return all.join("; ");
}

} // namespace

class ChangeSetTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_fixture = std::make_unique<PlanFixture>();
        m_loaded = m_fixture->open(kFiles);
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
    }

    void reports_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("found");
        const auto row = [](const char* name, const char* from, const char* to, const char* found) {
            QTest::newRow(name) << from << to << found;
        };
        row("nothing", "Tick", "Tick", "local");
        row("blanks", "Tick = 0.01", "Tick   =  0.01 // s", "local");
        row("a value", "Speed=1", "Speed=2", "~robot0.brain Speed; local");
        row("a value of an instance", "Pos=$far,0,0", "Pos=$far,1,0", "~robot1 Pos; local");
        row("an override", "chassis.hull.Mass=2", "chassis.hull.Mass=3", "~robot0 chassis.hull.Mass; local");
        row("a value of a config", "Size=1,$size,1 Mass=1", "Size=1,$size,1 Mass=7",
            "~RobotConfig.Cart.chassis.hull Mass; local");
        row("a value more", "Sphere { Radius=0.1 }", "Sphere { Radius=0.1 Mass=3 }",
            "~RobotConfig.Cart.chassis.sphere Mass; local");
        row("a value less", "Config=Cart Pos=$far,0,0", "Config=Cart", "~robot1 Pos; local");
        row("a setting", "Tick = 0.01", "Tick = 0.02", "Tick");
        row("a Param", "far = 4", "far = 5", "$far");
        row("a Param of a config", "size = 1", "size = 2", "~RobotConfig.Cart $size");
        row("a new block", "Static arena", "Robot robot2 { Config=Cart }\nStatic arena", "+robot2; structure");
        row("a new inner block", "Box hull", "Box lid { Size=1,1,1 } Box hull", "+RobotConfig.Cart.chassis.lid; structure");
        row("a removed block", "Robot robot1 { Config=Cart Pos=$far,0,0 }\n", "", "-robot1; structure");
        row("a renamed block", "Robot robot1", "Robot rover", ">robot1>rover; structure");
        row("a renamed inner block", "Box hull", "Box body",
            ">RobotConfig.Cart.chassis.hull>RobotConfig.Cart.chassis.body; structure");
        row("another kind", "Box hull", "Sphere hull",
            "-RobotConfig.Cart.chassis.hull; +RobotConfig.Cart.chassis.hull; structure");
        row("an unnamed one before others", "Sphere { Radius=0.1 }", "Sphere { Radius=0.3 } Sphere { Radius=0.1 }",
            "+RobotConfig.Cart.chassis.sphere2; ~RobotConfig.Cart.chassis.sphere Radius; structure");
        row("another import", "#import wheel.sim", "#import other.sim", "everything");
        row("another module", "#loadModule walker", "", "everything");
    }
    void reports() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, found);
        std::string text = kMain;
        text.replace(text.find(from.toStdString()), from.toStdString().size(), to.toStdString());
        const ChangeSet changes(m_loaded, edited({{"main.sim", text}}));
        if (from == "Sphere { Radius=0.1 }" && to.count("Sphere") == 2) {
            QVERIFY(changes.changesStructure()); // which of three like blocks is the new one is not unique
        } else if (found == "everything") QVERIFY(changes.isEverything());
        else QCOMPARE(shown(changes), found);
        if (!changes.isEverything()) QCOMPARE(applied(changes), textsOf(*changes.after()));
    }

    /// The blocks of a file that is imported inside a block.
    void importedBlocks() {
        const ChangeSet changes(m_loaded, edited({{"wheel.sim", "Body wheel { Sphere tyre { Radius=0.2 Mass=1 } }\n"}}));
        QCOMPARE(shown(changes), QString("~RobotConfig.Cart.wheel.tyre Radius; local"));
        const ChangeSet both(m_loaded, edited({{"wheel.sim", "Body wheel { Sphere tyre { Radius=0.2 Mass=1 } }\n"},
                                               {"arena.sim", "StaticConfig Yard { Box north { Size=1,2,1 } }\n"}}));
        QCOMPARE(shown(both), QString("~StaticConfig.Yard.north Size; ~RobotConfig.Cart.wheel.tyre Radius; local"));
    }

    void anotherProjectIsEverything() {
        QVERIFY(ChangeSet(nullptr, m_loaded).isEverything());
        QVERIFY(ChangeSet(m_loaded, nullptr).isEverything());
        QVERIFY(ChangeSet::ofEverything(m_loaded, m_loaded).isEverything());
        QVERIFY(ChangeSet::ofEverything(m_loaded, m_loaded).before() == m_loaded);
    }

    /// Edits at random places: applied to the texts of before, the changes give the texts of after.
    void randomEdits() {
        std::mt19937 random(7);
        const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
        const std::vector<std::string> pieces{"Sphere { Radius=0.5 }",
                                              "Box extra { Size=2,2,2 }",
                                              " Mass=5",
                                              "Pos=1,2,3 ",
                                              "\n",
                                              "// note\n",
                                              "robot9",
                                              "}",
                                              "{",
                                              "Param k = 3\n",
                                              "7",
                                              "Robot more { Config=Cart }\n"};
        std::map<std::string, std::string> files = kFiles;
        auto before = m_loaded;
        int compared = 0;
        for (int i = 0; i < 1000; ++i) {
            std::string& text = files[i % 4 == 0 ? "wheel.sim" : "main.sim"];
            const std::string kept = text;
            const std::size_t at = below(text.size() + 1);
            if (below(3) == 0) text.erase(at, below(30));
            else text.insert(at, pieces[below(pieces.size())]);
            const auto after = edited(files, before);
            const ChangeSet changes(before, after);
            if (!changes.isEverything() && changes.after()->diagnostics.errorCount() < 5) {
                const bool isTwice =
                    std::ranges::any_of(textsOf(*before),
                                        [](const auto& t) { return t.first.find('\'') != std::string::npos; }) ||
                    std::ranges::any_of(textsOf(*after), [](const auto& t) { return t.first.find('\'') != std::string::npos; });
                if (!isTwice) {
                    QVERIFY2(applied(changes) == textsOf(*after),
                             (kept + "\n-----\n" + text + "\n" + shown(changes).toStdString()).c_str());
                    ++compared;
                }
            }
            if (after->diagnostics.errorCount() < 3) before = after;
            else text = kept;
        }
        QVERIFY2(compared > 150, std::to_string(compared).c_str());
    }

    /// The work is that of what changed: one block of 2,000, wherever it is.
    void comparesOnlyWhatChanged() {
        std::string text = "StaticConfig Yard { Box north { Size=1,1,1 } }\n";
        for (int i = 0; i < 2000; ++i)
            text += "Static s" + std::to_string(i) + " { Config=Yard Pos=" + std::to_string(i) + ",0,0 }\n";
        const auto before = m_fixture->open(text);
        for (const int which : {0, 999, 1999}) {
            const std::string name = "s" + std::to_string(which), was = "Pos=" + std::to_string(which) + ",0,0";
            std::string now = text;
            now.replace(now.find(was, now.find("Static " + name + " ")), was.size(), "Pos=0,7,0");
            const ChangeSet changes(before, edited({{"main.sim", now}}, before));
            QCOMPARE(shown(changes), QString("~%1 Pos; local").arg(QString::fromStdString(name)));
            QCOMPARE(changes.compared(), 1u);
        }
    }

    /// The text of a value arrives as it was typed, however long it is.
    void longValues() {
        const std::string formula = "1, $(1 + 2 * cos(30) + 3 * sin(45)), 0";
        const auto edits = editsForValues(*m_loaded, {{"robot1.Pos", formula}});
        QVERIFY(edits.ok());
        QCOMPARE(edits.value().at(0).at(0).text, formula);
    }

    /// Errors of the new value, also one that is as wrong as the old one; and of other values only those that it causes.
    void errorsOfTheNewValue() {
        const auto after = [&](const std::vector<ValueEdit>& values) {
            const auto edits = editsForValues(*m_loaded, values);
            const std::string text(m_loaded->trees[0]->source().bytes());
            return edits ? edited({{"main.sim", applyEdits(text, edits.value().at(0)).value()}}) : nullptr;
        };
        QVERIFY(ChangeSet(m_loaded, after({{"robot0.brain.Speed", "2"}})).valueErrors().empty());
        QCOMPARE(ChangeSet(m_loaded, after({{"robot0.brain.Speed", "2 kg"}})).valueErrors().size(), 1u);
        QVERIFY(!ChangeSet(m_loaded, after({{"RobotConfig.Cart.size", "-1"}})).valueErrors().empty()); // at the use, caused by it
        m_loaded = after({{"robot1.Pos", "1,1 kg,0"}, {"Tick", "-1"}});
        QVERIFY(m_loaded->diagnostics.errorCount() >= 2);
        QCOMPARE(ChangeSet(m_loaded, after({{"robot1.Pos", "2,1 kg,0"}})).valueErrors().size(), 1u);
        QVERIFY(ChangeSet(m_loaded, after({{"robot1.Pos", "2,1,0"}})).valueErrors().empty()); // that of Tick is not its own
        QVERIFY(ChangeSet(m_loaded, after({{"robot1.Pos", "2,1,0"}})).changesProblems());
        const ChangeSet elsewhere(m_loaded, after({{"robot0.brain.Speed", "2"}}));
        QVERIFY(elsewhere.valueErrors().empty());
        QVERIFY(!elsewhere.changesProblems()); // they have only moved
    }

private:
    std::shared_ptr<const LoadedProject> edited(const std::map<std::string, std::string>& files,
                                                std::shared_ptr<const LoadedProject> previous = nullptr) {
        std::map<std::string, std::string> texts;
        for (const auto& [name, text] : files) texts[m_fixture->path(name)] = text;
        m_fixture->options.previous = previous ? previous : m_loaded;
        return m_fixture->read(texts);
    }

    std::unique_ptr<PlanFixture> m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(ChangeSetTest)
#include "change_set_test.moc"
