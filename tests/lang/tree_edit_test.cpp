// Edits change as little text as possible, keep its style, and undo restores the exact bytes.

#include <QTest>
#include <functional>

#include "lang/texts.h"
#include "lang/tree_edit.h"

using namespace trundle;
using namespace texts;

namespace {

const BlockItem* findBlock(const std::vector<Item>& items, std::string_view name) {
    for (const Item& item : items) {
        const auto* block = item.as<BlockItem>();
        if (!block) continue;
        if (block->name && block->name->text == name) return block;
        if (const BlockItem* inner = findBlock(block->items, name)) return inner;
    }
    return nullptr;
}

const Item* findItem(const std::vector<Item>& items, std::string_view name) {
    for (const Item& item : items) {
        if (const auto* a = item.as<AssignmentItem>(); a && a->path.back().text == name) return &item;
        const auto* block = item.as<BlockItem>();
        if (!block) continue;
        if (block->name && block->name->text == name) return &item;
        if (const Item* inner = findItem(block->items, name)) return inner;
    }
    return nullptr;
}

std::string applied(const Tree& tree, const TextEdit& edit) {
    auto result = applyEdits(tree.source().bytes(), std::span(&edit, 1));
    return result ? result.value() : "edit refused: " + result.error().message;
}

std::size_t errors(const Tree& tree) {
    return static_cast<std::size_t>(std::count_if(tree.diagnostics().begin(), tree.diagnostics().end(),
                                                  [](const Diagnostic& d) { return d.severity == Severity::Error; }));
}

/// The content of a tree, without source ranges and comments.
std::string meaning(const std::vector<Item>& items, const Item* without = nullptr) {
    std::string out;
    const auto valueOf = [&](const Value& v) {
        for (const Element& e : v.elements)
            out += std::to_string(static_cast<int>(e.kind)) + ":" + std::to_string(e.number) + e.text + e.unit + ",";
        out += ";";
    };
    for (const Item& item : items) {
        if (&item == without) continue;
        if (const auto* i = item.as<ImportItem>()) out += "import " + i->path + ";";
        if (const auto* m = item.as<ModuleItem>()) out += "module " + m->path + ";";
        if (const auto* p = item.as<ParamItem>()) out += "param " + p->name.text + "=", valueOf(p->value);
        if (const auto* a = item.as<AssignmentItem>()) {
            for (const Name& n : a->path) out += n.text + ".";
            out += "=";
            valueOf(a->value);
        }
        if (const auto* b = item.as<BlockItem>())
            out += b->type.text + " " + (b->name ? b->name->text : "") + "{" + meaning(b->items, without) + "}";
    }
    return out;
}

struct Place {
    const std::vector<Item>* siblings;
    const Item* item;
    const BlockItem* parent;
};

void collect(const std::vector<Item>& items, const BlockItem* parent, std::vector<Place>& places) {
    for (const Item& item : items) {
        places.push_back({&items, &item, parent});
        if (const auto* block = item.as<BlockItem>()) collect(block->items, block, places);
    }
}

std::size_t lineComments(const Tree& tree) {
    return static_cast<std::size_t>(std::count_if(tree.tokens().begin(), tree.tokens().end(),
                                                  [](const Token& t) { return t.kind == TokenKind::LineComment; }));
}

} // namespace

class TreeEditTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void settingAValueChangesItsCharactersOnly() {
        const auto tree = parsed("Robot r { Mass = 1.50 /* kg */ Pos=0, 0,\t0 } // end");
        const auto& robot = *findBlock(tree->items(), "r");
        const auto& mass = robot.items[0].as<AssignmentItem>()->value;
        const auto& pos = robot.items[1].as<AssignmentItem>()->value;
        QCOMPARE(q(applied(*tree, editSetValue(*tree, mass, "2"))),
                 QByteArray("Robot r { Mass = 2 /* kg */ Pos=0, 0,\t0 } // end"));
        QCOMPARE(q(applied(*tree, editSetValue(*tree, pos, "1,2,3"))),
                 QByteArray("Robot r { Mass = 1.50 /* kg */ Pos=1,2,3 } // end"));
    }

    void settingAValueKeepsCommentsBetweenItsElements() {
        const auto tree = parsed("Pos=0, // ahead\n  0, /* left */ 0.05 // end\nSize=1 /* a */, $(max(2,3)), \"x,y\"\n");
        const auto& pos = tree->items()[0].as<AssignmentItem>()->value;
        const auto& size = tree->items()[1].as<AssignmentItem>()->value;
        QCOMPARE(q(applied(*tree, editSetValue(*tree, pos, "1, 2,3"))),
                 QByteArray("Pos=1, // ahead\n  2, /* left */ 3 // end\nSize=1 /* a */, $(max(2,3)), \"x,y\"\n"));
        QCOMPARE(q(applied(*tree, editSetValue(*tree, size, "5,$(min(a,b)),\"u,v\""))),
                 QByteArray("Pos=0, // ahead\n  0, /* left */ 0.05 // end\nSize=5 /* a */, $(min(a,b)), \"u,v\"\n"));
        QCOMPARE(q(applied(*tree, editSetValue(*tree, pos, "$place"))), // another count: nowhere to keep them
                 QByteArray("Pos=$place // end\nSize=1 /* a */, $(max(2,3)), \"x,y\"\n"));
    }

    void settingAMissingValue() {
        const auto tree = parsed("A =\nB=\nC = 1\n");
        QCOMPARE(q(applied(*tree, editSetValue(*tree, tree->items()[0].as<AssignmentItem>()->value, "7"))),
                 QByteArray("A = 7\nB=\nC = 1\n"));
    }
    /// One space before the value, whether there is one already or not; none where the text has none.
    void settingAMissingValueBesideBlanks_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* before, const char* after) {
            QTest::newRow(before) << QByteArray(before) << QByteArray(after);
        };
        row("A = \nC = 1\n", "A = 7 \nC = 1\n"); // what follows stays
        row("A = // none\nC = 1\n", "A = 7 // none\nC = 1\n");
        row("A =// none\nC = 1\n", "A = 7 // none\nC = 1\n");
        row("A=\nC=1\n", "A=7\nC=1\n");
        row("A = ", "A = 7 ");
    }
    void settingAMissingValueBesideBlanks() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        const auto tree = parsed(before.constData());
        QCOMPARE(q(applied(*tree, editSetValue(*tree, tree->items()[0].as<AssignmentItem>()->value, "7"))), after);
    }

    void renaming() {
        const auto tree = parsed("Robot robot0 { leftMotor.Resistance=3 }");
        const auto& robot = *findBlock(tree->items(), "robot0");
        QCOMPARE(q(applied(*tree, editReplace(*tree, robot.name->range, "mouse"))),
                 QByteArray("Robot mouse { leftMotor.Resistance=3 }"));
    }

    void adding_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("block");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, std::string_view before, const char* block, std::string_view after) {
            QTest::newRow(name) << q(before) << QByteArray(block) << q(after);
        };
        row("one line", "Box b { Size=1 }", "b", "Box b { Size=1 K=9 }");
        row("one line, spaced", "Box b { Size = 1 }", "b", "Box b { Size = 1 K = 9 }");
        row("one line, tight", "Box b {Size=1}", "b", "Box b {Size=1 K=9 }");
        row("one line, empty", "Box b {}\nx=1", "b", "Box b { K=9 }\nx=1");
        row("one line, a blank", "Box b { }", "b", "Box b { K = 9 }");
        row("lines", "Box b {\n    Size=1\n}\n", "b", "Box b {\n    Size=1\n    K=9\n}\n");
        row("lines, CR LF", "Box b {\r\n\tSize = 1\r\n}\r\n", "b", "Box b {\r\n\tSize = 1\r\n\tK = 9\r\n}\r\n");
        row("lines, lone CR", "Box b {\r Size = 1\r}\r", "b", "Box b {\r Size = 1\r K = 9\r}\r");
        row("lines, empty", "Box b {\n}\n", "b", "Box b {\n  K = 9\n}\n");
        row("comment only", "Box b { // c\n}\n", "b", "Box b { // c\n  K = 9\n}\n");
        row("comment lines only", "Box b {\n   // c\n   // d\n}\n", "b", "Box b {\n   // c\n   // d\n  K = 9\n}\n");
        row("last line is commented", "Box b {\n  A=1 // why\n}", "b", "Box b {\n  A=1 // why\n  K=9\n}");
        row("comment before the brace", "Box b { A=1 // why\n}", "b", "Box b { A=1 // why\n  K=9\n}");
        row("brace behind the last item", "Box b { A=1\n  B=2 }", "b", "Box b { A=1\n  B=2\n  K=9\n}");
        row("nested on one line", "Body c {\n  Box b { A=1 }\n}\n", "b", "Body c {\n  Box b { A=1 K=9 }\n}\n");
        row("beside its like", "Body c {\n  Mass=1 // kg\n  Box b { A=1 }\n}\n", "c",
            "Body c {\n  Mass=1 // kg\n  K=9\n  Box b { A=1 }\n}\n");
        row("beside its like behind the brace", "Body c { Mass=1\n Box b { A=1 } }\n", "c",
            "Body c { Mass=1\n K=9\n Box b { A=1 } }\n");
        row("not within the line of its like", "Body c {\n  Mass=1 Box b { A=1 }\n}\n", "c",
            "Body c {\n  Mass=1 Box b { A=1 }\n  K=9\n}\n");
        row("not between a value and a comment on the next item", "Body c {\n  Mass=1 /* kg */ Box b { A=1 } // b\n}\n", "c",
            "Body c {\n  Mass=1 /* kg */ Box b { A=1 } // b\n  K=9\n}\n");
        row("one line, between the assignments and a block", "Robot r { Config=A Controller c { S=1 } }", "r",
            "Robot r { Config=A K=9 Controller c { S=1 } }");
        row("one line, behind the last assignment", "Robot r { Config=A Log l { S=1 } D=2 /* m */ Controller c { S=1 } }", "r",
            "Robot r { Config=A Log l { S=1 } D=2 K=9 /* m */ Controller c { S=1 } }");
        row("one line, nothing but blocks", "Body c { Box b { A=1 } }", "c", "Body c { K=9 Box b { A=1 } }");
        row("one line, nothing but blocks, tight", "Body c {Box b { A=1 }}", "c", "Body c { K=9 Box b { A=1 }}");
        row("one line, a block that could be a unit", "Body c { A=1 C { } }", "c", "Body c { A=1 C { } K=9 }");
        row("a block begins on the line of the brace", "Robot r { Config=A Controller c {\n  S=1\n} }\n", "r",
            "Robot r { Config=A K=9 Controller c {\n  S=1\n} }\n");
        row("in front of nothing but blocks", "Body c {\n  Box b { A=1 }\n}\n", "c", "Body c {\n  Box b { A=1 }\n  K=9\n}\n");
        row("the file", "A = 1\n", "", "A = 1\nK = 9\n");
        row("the file, tight", "A=1\n", "", "A=1\nK=9\n");
        row("the file, no final newline", "A = 1", "", "A = 1\nK = 9\n");
        row("the file, a comment last", "A = 1 // c", "", "A = 1 // c\nK = 9\n");
        row("the file, CR LF", "A = 1\r\nB=2", "", "A = 1\r\nB=2\r\nK = 9\r\n");
        row("the empty file", "", "", "K = 9\n");
        row("only a BOM", "\xEF\xBB\xBF", "", "\xEF\xBB\xBFK = 9\n");
        row("settings above blocks", "Tick = 1\n\nRobot r {\n}\n", "", "Tick = 1\nK = 9\n\nRobot r {\n}\n");
        row("the first setting, behind directives", "// About.\n#import a.sim\n#loadModule b // why\n\nRobot r {\n}\n", "",
            "// About.\n#import a.sim\n#loadModule b // why\nK = 9\n\nRobot r {\n}\n");
        row("the first setting, behind Params", "Param p = 1\r\nRobot r { }\r\n#import a.sim\r\n", "",
            "Param p = 1\r\nK = 9\r\nRobot r { }\r\n#import a.sim\r\n");
        row("the first setting, in front of a block", "// About.\n\n// The robot,\n/* of\n two */\nRobot r { }\n", "",
            "// About.\n\nK = 9\n\n// The robot,\n/* of\n two */\nRobot r { }\n");
        row("the first setting, behind a BOM", "\xEF\xBB\xBFRobot r { }\n", "", "\xEF\xBB\xBFK = 9\n\nRobot r { }\n");
        row("the first setting, on the line of a block", "Param p = 1 Robot r { }\n", "", "Param p = 1 Robot r { }\nK = 9\n");
        row("only directives", "#import a.sim\n", "", "#import a.sim\nK = 9\n");
        row("shared line", "Tick = 1   Duration = 2\n#import a.sim\n", "", "Tick = 1   Duration = 2\nK = 9\n#import a.sim\n");
    }
    void adding() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, block);
        const auto tree = parsed(before.toStdString());
        const BlockItem* to = block.isEmpty() ? nullptr : findBlock(tree->items(), block.toStdString());
        QTEST(q(applied(*tree, editAddAssignment(*tree, to, "K", "9"))), "after");
    }

    void addingParams_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, std::string_view before, std::string_view after) {
            QTest::newRow(name) << q(before) << q(after);
        };
        row("behind the last", "P b {\n  Param r = 1 { Min=0 } // r\n  Param s = 2\n\n  Body c { }\n}\n",
            "P b {\n  Param r = 1 { Min=0 } // r\n  Param s = 2\n  Param K = 9\n\n  Body c { }\n}\n");
        row("behind its comment", "P b {\r\n\tParam r = 1 // r\r\n\tBody c { }\r\n}\r\n",
            "P b {\r\n\tParam r = 1 // r\r\n\tParam K = 9\r\n\tBody c { }\r\n}\r\n");
        row("the first line", "P b { // of b\n    // of c\n    Body c { }\n}\n",
            "P b { // of b\n    Param K = 9\n    // of c\n    Body c { }\n}\n");
        row("one line", "P b { Body c { } }", "P b { Param K = 9 Body c { } }");
        row("one line, tight", "P b {Body c { }}", "P b { Param K = 9 Body c { }}");
        row("one line, behind the last", "P b { Param r=1 Body c { } }", "P b { Param r=1 Param K = 9 Body c { } }");
        row("nothing else", "P b {\n  Param r = 1\n}\n", "P b {\n  Param r = 1\n  Param K = 9\n}\n");
        row("empty", "P b { }", "P b { Param K = 9 }");
    }
    void addingParams() {
        QFETCH(QByteArray, before);
        const auto tree = parsed(before.toStdString());
        QTEST(q(applied(*tree, editAddParam(*tree, *findBlock(tree->items(), "b"), "K", "9"))), "after");
    }

    void addingItems_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("block");
        QTest::addColumn<QByteArray>("item");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, const char* before, const char* block, const char* item, const char* after) {
            QTest::newRow(name) << QByteArray(before) << QByteArray(block) << QByteArray(item) << QByteArray(after);
        };
        row("short into one line", "Body c { A=1 }", "c", "Box b { }", "Body c { A=1 Box b { } }");
        row("lines into one line", "Body c { A=1 }\n", "c", "Box b {\n  X=1\n}", "Body c { A=1\n  Box b {\n    X=1\n  }\n}\n");
        row("lines into lines", "Body c {\r\n\tA=1\r\n}\r\n", "c", "Box b {\n\tX=1\n}\n",
            "Body c {\r\n\tA=1\r\n\tBox b {\r\n\t\tX=1\r\n\t}\r\n}\r\n");
        row("indented text", "Body c {\n    A=1\n}\n", "c", "    Box b {\n      X=1\n    }",
            "Body c {\n    A=1\n    Box b {\n      X=1\n    }\n}\n");
        row("lines whose last one closes several", "Body c {\n    A=1\n}\n", "c", "Box b { X=1\n    Y { Z=2 } }",
            "Body c {\n    A=1\n    Box b { X=1\n        Y { Z=2 } }\n}\n");
        row("a directive into one line", "Static s { A=1 }\n", "s", "#import a.sim", "Static s { A=1\n  #import a.sim\n}\n");
        row("a line comment into one line", "Body c { A=1 }\n", "c", "Box b { } // note",
            "Body c { A=1\n  Box b { } // note\n}\n");
        row("a line comment into an empty block", "Body c { }\n", "c", "Box b { X=1 } //", "Body c {\n  Box b { X=1 } //\n}\n");
        row("a line comment into an inner block", "Robot r {\n  Body c { A=1 }\n}\n", "c", "Box b { } // note",
            "Robot r {\n  Body c { A=1\n    Box b { } // note\n  }\n}\n");
        row("into the file", "A = 1 // c", "", "Box b { }", "A = 1 // c\nBox b { }\n");
        row("behind a comment", "Body c { // c\n}", "c", "Box b { }", "Body c { // c\n  Box b { }\n}");
    }
    void addingItems() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, block);
        QFETCH(QByteArray, item);
        const auto tree = parsed(before.toStdString());
        const BlockItem* to = block.isEmpty() ? nullptr : findBlock(tree->items(), block.toStdString());
        QTEST(q(applied(*tree, editAddItem(*tree, to, item.toStdString()))), "after");
    }

    void removing_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("item");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, const char* before, const char* item, const char* after) {
            QTest::newRow(name) << QByteArray(before) << QByteArray(item) << QByteArray(after);
        };
        row("its line", "A=1\n  B=2\nC=3\n", "B", "A=1\nC=3\n");
        row("its lines", "A=1\nBox b {\n  X=1\n}\nC=3\n", "b", "A=1\nC=3\n");
        row("the first of a line", "A=1 B=2 // both\n", "A", "B=2 // both\n");
        row("the middle of a line", "A=1  B=2  C=3\n", "B", "A=1  C=3\n");
        row("the last of a line", "A=1  B=2\n", "B", "A=1\n");
        row("the only one of a block", "Box b { A=1 }", "A", "Box b { }");
        row("without blanks", "Box b {A=1}", "A", "Box b { }");
        row("beside a comment", "A=1 // of A\nB=2\n", "A", "// of A\nB=2\n");
        row("comments above stay", "// of the file\nA=1\nB=2\n", "A", "// of the file\nB=2\n");
        row("CR LF", "A=1\r\nB=2\r\nC=3\r\n", "B", "A=1\r\nC=3\r\n");
        row("the last, no final newline", "A=1\r\nB=2", "B", "A=1");
        row("all there is", "A=1", "A", "");
    }
    void removing() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, item);
        const auto tree = parsed(before.toStdString());
        QTEST(q(applied(*tree, editRemoveItem(*tree, *findItem(tree->items(), item.toStdString())))), "after");
    }

    void editsAreChecked() {
        const std::string text = "0123456789";
        const auto apply = [&](std::vector<TextEdit> edits) { return applyEdits(text, edits); };
        QCOMPARE(q(apply({{{0, {4, 6}}, "b"}, {{0, {0, 1}}, "a"}}).value()), QByteArray("a123b6789"));
        QCOMPARE(q(apply({{{0, {3, 3}}, "a"}, {{0, {3, 4}}, "b"}, {{0, {3, 3}}, "c"}}).value()), QByteArray("012acb456789"));
        QVERIFY(!apply({{{0, {0, 4}}, "a"}, {{0, {3, 5}}, "b"}}).ok());
        QVERIFY(!apply({{{0, {8, 11}}, ""}}).ok());
        QVERIFY(!apply({{{0, {5, 4}}, ""}}).ok());
        const auto tree = parsed("A=1");
        const TextEdit elsewhere{{7, {0, 1}}, "x"};
        QVERIFY(!applyEdits(*tree, std::span(&elsewhere, 1)).ok());
        const TextEdit here{{0, {2, 3}}, "2"};
        const auto edited = applyEdits(*tree, std::span(&here, 1));
        QVERIFY(edited.ok());
        QCOMPARE(q(print(*edited.value())), QByteArray("A=2"));
        QCOMPARE(edited.value()->file(), tree->file());
    }

    /// Each random edit has exactly its intended effect; undoing all of them restores the original bytes.
    void randomWalks() {
        RandomNumbers rng(3);
        const int walks = longRun() ? 10000 : 300;
        const std::vector<std::string> start = examples();
        for (int walk = 0; walk < walks; ++walk) {
            const std::string first = start[static_cast<std::size_t>(walk) % start.size()];
            auto tree = parsed(first);
            QCOMPARE(errors(*tree), std::size_t(0));
            std::vector<TextEdit> undo;
            for (int step = 0; step < 12; ++step) {
                std::vector<Place> places;
                collect(tree->items(), nullptr, places);
                TextEdit edit;
                std::string expected; // the meaning afterwards
                const std::string now = meaning(tree->items());
                const Place place = places.empty() ? Place{} : places[rng.below(places.size())];
                const BlockItem* block = place.item ? place.item->as<BlockItem>() : nullptr;
                const std::size_t kindOfStep = places.empty() ? 3 + rng.below(2) : rng.below(6);
                std::size_t comments = lineComments(*tree);
                if (kindOfStep <= 1) {
                    const auto* assignment = place.item->as<AssignmentItem>();
                    if (!assignment) continue;
                    edit = editSetValue(*tree, assignment->value, rng.chance(1, 2) ? "1, 2 cm" : "word");
                } else if (kindOfStep == 2) {
                    if (!block || !block->name) continue;
                    edit = editReplace(*tree, block->name->range, "renamed" + std::to_string(step));
                } else if (kindOfStep == 3) {
                    const bool isParam = block && rng.chance(1, 4);
                    edit = isParam ? editAddParam(*tree, *block, "New", "4, 5") : editAddAssignment(*tree, block, "New", "4, 5");
                } else if (kindOfStep == 4) {
                    edit = editAddItem(*tree, block, rng.chance(1, 2) ? "Box n { X=1 }" : "Box n {\n  X=1 // x\n  Y { }\n}\n");
                } else {
                    edit = editRemoveItem(*tree, *place.item);
                    expected = meaning(tree->items(), place.item);
                    if (block) comments = 0; // comments inside the block are removed with it
                }
                const std::string before(tree->source().bytes());
                const auto next = applyEdits(*tree, std::span(&edit, 1));
                QVERIFY(next.ok());
                const QByteArray story = q(before) + "\n---- step " + QByteArray::number(static_cast<int>(kindOfStep)) +
                                         " ----\n" + q(next.value()->source().bytes());
                QVERIFY2(errors(*next.value()) == 0, (story + q(messages(*next.value()))).constData());
                const std::string after = meaning(next.value()->items());
                if (!expected.empty()) QVERIFY2(after == expected, story.constData());
                if (kindOfStep == 3 || kindOfStep == 4) QVERIFY2(after.size() > now.size(), story.constData());
                QVERIFY2(lineComments(*next.value()) >= comments, story.constData());
                const TextRange r = edit.range.range;
                undo.push_back(
                    {{0, {r.begin, r.begin + static_cast<std::uint32_t>(edit.text.size())}}, before.substr(r.begin, r.size())});
                tree = next.value();
            }
            for (auto back = undo.rbegin(); back != undo.rend(); ++back) tree = applyEdits(*tree, std::span(&*back, 1)).value();
            QCOMPARE(q(tree->source().bytes()), q(first));
        }
    }
};

QTEST_APPLESS_MAIN(TreeEditTest)
#include "tree_edit_test.moc"
