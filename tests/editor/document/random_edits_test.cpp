// Random edits in any order: undoing all restores the original bytes, and isModified() is always right.

#include <QTest>

#include <algorithm>
#include <random>
#include <set>

#include "editor/document/group_edit.h"
#include "editor/document/structure_edits.h"
#include "project/edits/plan_group.h"
#include "project/journal/state_folder.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

/// A rover of two parts, of which one is mirrored.
const char* const kPartsRover = R"(// A rover.
PartConfig Wheel {
  Param r = 0.05 { Min=0.01 Max=60 Help="its radius" } // its radius
  Body wheel { Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }
}
RobotConfig Rover {
  SelfCollision=true NoContact=chassis,mast
  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 }
    Repeat stud { Count=2 Pos=$(0.1*index),0,0.1 Sphere knob { Radius=0.01 Mass=0.01 } } } // two kilograms
  Part left { Config=Wheel Pos=0,0.1,0.05 carrier=chassis }
  Part right { Config=Wheel Pos=0,-0.1,0.05 Mirror=y carrier=chassis }
  Body mast { In=chassis Box pole { Size=0.02,0.02,0.2 Pos=0,0,0.3 Mass=0.1 } }
  Fixed leftAxle { Parent=chassis Child=mast }
  Repeat roller { Count=2 Pos=$(0.1*index),0,0.4 Body rim { Sphere ball { Radius=0.02 Mass=0.1 } } Hinge pin { Parent=chassis Child=rim } }
  Ring bolt { In=mast Count=3 Radius=0.05 Pos=0,0,0.2 Body head { Sphere ball { Radius=0.01 Mass=0.01 } } Fixed nail { Parent=mast Child=head } }
  Spring strap { Parent=chassis Child=roller_0.rim Stiffness=10 Damping=0.1 }
  Latch magnet { Body=chassis Pos=0.15,0,0.1 }
  Gear belt { Joint=left.axle Other=roller_0.pin Ratio=1 }
}
RobotConfig TallRover { Config=Rover chassis.hull.Mass=3 } // a variant
StaticConfig Post { Param h = 1 Box wood { Size=0.1,0.1,$h Pos=0,0,$(h/2) } }
Repeat fence { Count=2 Pos=$(9 + index),0,0 Static post { Config=Post h=$(1 + index) } Grid pile { Config=Post Count=2 Spacing=1 Pos=0,3,0 }
  View side { Eye=0,-2,1 } SignalLog all { Signals="*" } }
Region goal { Pos=0,0,0.2 Size=0.4,0.4,0.4 }
)";

class RandomEdits {
public:
    RandomEdits(Document& document, const DocumentFixture& fixture, unsigned seed, bool parts)
        : m_document(document), m_fixture(fixture), m_seed(seed), m_parts(parts), m_random(seed) {
        document.structure().setShareQuestionHandler([this](const ShareQuestion&, const StructureEdits::ShareAnswer& answer) {
            static constexpr ShareChoice kChoices[] = {ShareChoice::Cancel, ShareChoice::MakeCopy, ShareChoice::Cancel,
                                                       ShareChoice::ChangeForAll};
            const ShareChoice choice = kChoices[(m_seed + m_asked++) % 4]; // all choices occur, in walks of any length
            ++answers[choice];
            answer(choice);
        });
    }

    void oneEdit() {
        switch (below(10)) {
        case 0:
        case 1: return setValue();
        case 2: return type();
        case 3: return plan();
        case 4: return m_document.edits().undo();
        case 5: return m_document.edits().redo();
        case 6: return leap();
        case 7:
        case 8: return changeStructure();
        default: return below(10) == 0 ? save() : setValue();
        }
    }

    /// Undoes until the text has no errors, so that edits other than typing are possible.
    void undoErrors() {
        while (m_document.loaded()->diagnostics.hasErrors() && m_document.edits().history().canUndo()) m_document.edits().undo();
    }

    /// Makes an edit that creates a file.
    void group() {
        if (m_document.loaded()->diagnostics.hasErrors()) return;
        const std::string name = "Piece" + std::to_string(created.size());
        GroupPlan group;
        group.file = m_fixture.path("configs/objects/" + name + ".sim");
        group.text = "StaticConfig " + name + " { Box b { Size=1,1,1 } }\n";
        group.plan.edits[0] = {{{0, {0, 0}}, "#import objects/" + name + ".sim\nStatic s" + name + " { Config=" + name + " }\n"}};
        if (applyGroup(m_document, u"Group"_qs, group)) created.push_back(group.file);
    }

    std::size_t below(std::size_t count) { return m_random() % count; }

    std::map<ShareChoice, int> answers; ///< answers given, by choice
    std::vector<std::string> created;   ///< created files
    std::set<std::string> valuesSet;    ///< the paths of values that were set
    int structures = 0, copies = 0;     ///< structural edits made, and how many of them made a copy

private:
    void setValue() {
        const std::string number = std::to_string(below(50) + 1);
        std::vector<ValueEdit> choices{{"robot0.Pos", number + ",0,0"},
                                       {"robot1.Pos", "0," + number + ",0"},
                                       {"robot0.chassis.hull.Mass", number},
                                       {"RobotConfig.Rover.chassis.hull.Mass", number + " kg"},
                                       {"Tick", number + " ms"},
                                       {"Seed", number},
                                       {"robot1.HPR", "-" + number + ",0,0"},
                                       {"Tick", "-" + number},
                                       {"robot7.Pos", "0,0,0"}};
        if (m_parts)
            choices.insert(choices.end(), {{"robot0.left.wheel.tyre.Mass", number},
                                           {"robot1.right.r", "0." + number},
                                           {"RobotConfig.Rover.left.wheel.tyre.Mass", number + " kg"},
                                           {"RobotConfig.Rover.right.Pos", "0,-0." + number + ",0.05"},
                                           {"RobotConfig.Rover.left.Mirror", number.size() % 2 ? "x" : "none"},
                                           {"RobotConfig.Rover.roller.Count", std::to_string(below(4) + 1)},
                                           {"robot0.roller_1.rim.ball.Mass", number},
                                           {"robot1.roller.rim.ball.Mass", number},
                                           {"PartConfig.Wheel.r", "0." + number},
                                           {"RobotConfig.Rover.bolt.Count", std::to_string(below(4) + 1)},
                                           {"RobotConfig.Rover.mast.Pos", "0,0,0." + number},
                                           {"RobotConfig.Rover.mast.In", below(2) ? "chassis" : "left.wheel"},
                                           {"robot0.bolt_2.head.ball.Mass", number},
                                           {"robot1.strap.Stiffness", number},
                                           {"RobotConfig.Rover.magnet.MaxForce", number},
                                           {"RobotConfig.Rover.belt.Ratio", number},
                                           {"fence.Count", std::to_string(below(4) + 1)},
                                           {"fence_1.post.h", number},
                                           {"fence_0.pile.Spacing", number},
                                           {"goal.Size", number + ",1,1"},
                                           {"RobotConfig.TallRover.roller.rim.ball.Mass", number}});
        std::vector<ValueEdit> values{choices[below(choices.size())]};
        if (below(3) == 0) values.push_back(choices[below(choices.size())]);
        if (m_document.structure().setValues(u"Set"_qs, values, below(2) ? "" : "drag " + values[0].path.text()))
            for (const ValueEdit& value : values) valuesSet.insert(value.path.text());
    }

    /// Through an instance, in the config, or in a copy of the config that an earlier edit made.
    void changeStructure() {
        const LoadedProject& before = *m_document.loaded();
        std::vector<std::string> objects{"robot0", "robot1"};
        for (const Part* config : before.outline->configs.all())
            if (config->kind) objects.push_back(config->kind->name + "." + config->name);
        const std::string object = objects[below(objects.size())], body = object + ".chassis";
        const std::size_t configs = before.outline->configs.all().size(), which = below(m_parts ? 11 : 4);
        const std::string name = "part" + std::to_string(below(100));
        const Status done = m_document.structure().apply(
            u"Structure"_qs, {object}, [&](const LoadedProject& loaded, const auto& renamed) -> Result<EditPlan> {
                switch (which) {
                case 0: return planInsert(loaded, renamed(object), "Body " + name + " { Sphere ball { Radius=0.1 Mass=1 } }");
                case 1: return planDuplicate(loaded, {renamed(body)}, Vec3(0.1, 0, 0));
                case 2: return planRename(loaded, renamed(object + ".leftAxle"), name);
                case 3: return planRemove(loaded, {renamed(object + ".rightAxle")});
                case 4: return planDuplicate(loaded, {renamed(object + ".left")}, Vec3(0, 0.1, 0));
                case 5: return planRemove(loaded, {renamed(object + ".right")});
                case 6:
                    return planInsert(loaded, renamed(object),
                                      "Part " + name + " { Config=Wheel carrier=chassis Pos=0.2,0,0.1 }");
                case 7: return planRename(loaded, renamed(object + ".roller_1.rim"), name);
                case 8: return planRename(loaded, renamed(object + ".roller"), name);
                case 9: return planDuplicate(loaded, {renamed(object + ".roller")}, Vec3(0, 0.1, 0));
                default: return planRename(loaded, renamed(object + ".left.wheel"), name);
                }
            });
        structures += done.ok();
        copies += m_document.loaded()->outline->configs.all().size() > configs;
    }

    void type() {
        const std::string file = below(2) ? m_fixture.main : m_fixture.robot;
        std::string text = *m_document.texts().text(file);
        const std::vector<std::string> bits{"x",    " ",  "{",  "}",          "\n", "// word", "Robot r { Config=Rover }\n",
                                            "\xff", "\r", "\"", "#import a\n"};
        const std::size_t at = below(text.size() + 1);
        if (below(3) == 0) text.erase(at, below(5));
        else text.insert(at, bits[below(bits.size())]);
        (void)m_document.edits().replaceText(u"Typing"_qs, file, std::move(text), below(2) ? "typing " + file : "");
        // Errors in the text prevent the other edits, so most are undone at once.
        if (m_document.loaded()->diagnostics.hasErrors() && below(4) != 0) m_document.edits().undo();
    }

    void plan() {
        EditPlan plan;
        for (FileId file = 0; file < m_document.texts().files().size(); ++file) {
            if (file > 0 && below(2)) continue;
            const auto size = static_cast<std::uint32_t>(m_document.texts().text(m_document.texts().files()[file])->size());
            plan.edits[file].push_back({{file, {size, size}}, "// planned " + std::to_string(below(100)) + "\n"});
            if (below(2)) plan.edits[file].push_back({{file, {0, 0}}, "// first\n"});
        }
        (void)m_document.edits().apply(u"Plan"_qs, plan);
    }

    /// Undoes or redoes a few entries: most edits are undone at the end.
    void leap() {
        const std::size_t at = m_document.edits().history().position() + below(9);
        m_document.edits().moveTo(at < 4 ? 0 : at - 4);
    }

    void save() { (void)m_document.saving().save(); }

    Document& m_document;
    const DocumentFixture& m_fixture;
    const unsigned m_seed;
    const bool m_parts; ///< the rover is made of parts
    unsigned m_asked = 0;
    std::mt19937 m_random;
};

} // namespace

class RandomEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void undoAllRedoAll_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<bool>("parts");
        for (unsigned seed = 1; seed <= 4; ++seed) QTest::addRow("seed %u", seed) << seed << false;
        for (unsigned seed = 5; seed <= 8; ++seed) QTest::addRow("parts, seed %u", seed) << seed << true;
    }
    void undoAllRedoAll() {
        QFETCH(unsigned, seed);
        QFETCH(bool, parts);
        const int edits = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 1000 : 100;
        const DocumentFixture fixture;
        if (parts) (void)fixture.write("configs/robots/rover.sim", kPartsRover);
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        RandomEdits random(d, fixture, seed, parts);
        for (int i = 0; i < edits; ++i) {
            if (i % 10 == 0) random.undoErrors();
            if (i % 10 == 9) random.group();
            else random.oneEdit();
            bool isModified = false;
            for (const std::string& file : random.created) {
                isModified = isModified || d.texts().isModified(file);
                QVERIFY(!std::filesystem::exists(file) || !bytesOf(file).empty());
            }
            for (const std::string& file : {fixture.main, fixture.robot}) isModified = isModified || d.texts().isModified(file);
            QCOMPARE(d.texts().isModified(), isModified);
            std::vector<std::string> files = random.created;
            files.insert(files.end(), {fixture.main, fixture.robot});
            for (const std::string& file : files) QCOMPARE(d.texts().isModified(file), bytesOf(file) != *d.texts().text(file));
        }
        QVERIFY(random.structures > 0);
        m_structures += random.structures;
        m_valuesSet.merge(random.valuesSet);
        m_edits += edits;
        QVERIFY(!random.answers.empty());
        m_answers.merge(random.answers);
        m_copies += random.copies;
        d.edits().moveTo(d.edits().history().entries().size());
        QVERIFY(d.edits().history().entries().size() > 5);
        const std::string endMain = *d.texts().text(fixture.main), endRobot = *d.texts().text(fixture.robot);
        while (d.edits().history().canUndo()) d.edits().undo();
        QCOMPARE(*d.texts().text(fixture.main), kMain);
        QCOMPARE(*d.texts().text(fixture.robot), parts ? kPartsRover : kRover);
        QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
        while (d.edits().history().canRedo()) d.edits().redo();
        QCOMPARE(*d.texts().text(fixture.main), endMain);
        QCOMPARE(*d.texts().text(fixture.robot), endRobot);
        QVERIFY(!random.created.empty());
        d.edits().moveTo(random.below(d.edits().history().entries().size()));
        std::map<std::string, std::string> texts;
        random.created.insert(random.created.end(), {fixture.main, fixture.robot});
        for (const std::string& file : random.created) texts[file] = *d.texts().text(file);
        recoversAll(d, fixture, texts);
    }

    void everyActionRan() {
        QCOMPARE(m_answers.size(), 3u);
        QVERIFY(m_copies > 0);
        const auto isOf = [&](const char* name) {
            return std::ranges::any_of(m_valuesSet,
                                       [&](const std::string& path) { return path.find(name) != std::string::npos; });
        };
        for (const char* name :
             {"left.", "roller", "bolt", "mast", "strap", "magnet", "belt", "TallRover", "PartConfig", "fence", "pile", "goal"})
            QVERIFY2(isOf(name), name);
        QVERIFY2(m_structures > m_edits / 50, qPrintable(QString::number(m_structures)));
    }

private:
    /// After a kill, recovery restores the same texts, and saving them writes the same files.
    void recoversAll(Document& killed, const DocumentFixture& fixture, const std::map<std::string, std::string>& texts) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [] { QCoreApplication::exit(0); }, Qt::QueuedConnection);
        QCoreApplication::exec(); // journals pending changes when it quits
        const std::filesystem::path folder = projectStateFolder(fixture.path("configs")) + "/journal";
        std::map<std::string, std::string> journals;
        std::error_code none;
        for (std::filesystem::directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
            journals[at->path().string()] = bytesOf(at->path().string());
        QCOMPARE(journals.empty(), !killed.texts().isModified());
        killed.opening().close();
        std::filesystem::create_directories(folder);
        for (const auto& [path, bytes] : journals) std::ofstream(path, std::ios::binary) << bytes;
        Document d(*m_application);
        QVERIFY(d.opening().open(fixture.main).ok());
        for (const Recovery& recovery : d.recovery().recoveries()) QCOMPARE(why(d.recovery().recover(recovery)), "");
        QCOMPARE(why(d.saving().save()), "");
        for (const auto& [path, text] : texts) {
            QCOMPARE(bytesOf(path), text);
            if (path != fixture.main) QCOMPARE(std::filesystem::exists(path), !text.empty() || path == fixture.robot);
        }
    }

    std::unique_ptr<Application> m_application;
    std::map<ShareChoice, int> m_answers;
    std::set<std::string> m_valuesSet;
    int m_copies = 0, m_structures = 0, m_edits = 0; ///< of all walks
};

QTEST_GUILESS_MAIN(RandomEditsTest)
#include "random_edits_test.moc"
