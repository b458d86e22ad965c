// The undo history: undo, redo, and edits that are merged, cancelled or discarded.
#include <QTest>

#include "editor/document/history.h"
#include "editor/document/selection.h"

#include <QSignalSpy>

using namespace trundle;

namespace {

/// Pushes edits as a document does: the current texts are the next edit's "before".
struct Texts {
    History history;
    FileTexts now;

    void edit(const char* name, const std::string& file, const std::string& text, const char* key = "") {
        const auto after = std::make_shared<const std::string>(text);
        history.push({QString::fromUtf8(name), {{file, now[file]}}, {{file, after}}, key});
        now[file] = after;
    }
    void go(std::size_t position) {
        for (const auto& [file, text] : history.moveTo(position)) now[file] = text;
    }
    std::string names() const {
        std::string all;
        for (const auto& entry : history.entries()) all += entry.name.toStdString() + " ";
        return all;
    }
};

Texts texts() {
    Texts t;
    t.now["a"] = std::make_shared<const std::string>("alpha");
    t.now["b"] = std::make_shared<const std::string>("beta");
    return t;
}

} // namespace

class HistoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void thereAndBack() {
        Texts t = texts();
        t.edit("one", "a", "alpha1");
        t.edit("two", "b", "");
        t.edit("three", "a", "x");
        QCOMPARE(t.history.position(), 3u);
        t.go(1);
        QCOMPARE(*t.now["a"], "alpha1");
        QCOMPARE(*t.now["b"], "beta");
        t.go(0);
        QCOMPARE(*t.now["a"], "alpha");
        QVERIFY(!t.history.canUndo());
        t.go(99);
        QCOMPARE(*t.now["a"], "x");
        QCOMPARE(*t.now["b"], "");
        QVERIFY(!t.history.canRedo());
    }

    void editDiscardsRedo() {
        Texts t = texts();
        t.edit("one", "a", "1");
        t.edit("two", "a", "2");
        t.go(1);
        t.edit("three", "a", "3");
        QCOMPARE(t.names(), "one three ");
        t.go(0);
        QCOMPARE(*t.now["a"], "alpha");
    }

    void aDragIsOneEntry() {
        Texts t = texts();
        t.edit("move", "a", "alpha 1", "drag");
        t.edit("move", "a", "alpha 23", "drag");
        t.edit("move", "b", "beta 1", "drag");
        QCOMPARE(t.names(), "move ");
        t.history.endMerge();
        t.edit("move", "a", "alpha 4", "drag");
        QCOMPARE(t.names(), "move move ");
        t.go(1);
        QCOMPARE(*t.now["a"], "alpha 23");
        QCOMPARE(*t.now["b"], "beta 1");
        t.go(0);
        QCOMPARE(*t.now["a"], "alpha");
        QCOMPARE(*t.now["b"], "beta");
        t.go(2);
        QCOMPARE(*t.now["a"], "alpha 4");
    }

    void keysThatAreEmptyOrOthersDoNotJoin() {
        Texts t = texts();
        t.edit("one", "a", "1");
        t.edit("two", "a", "2");
        t.edit("three", "a", "3", "k");
        t.edit("four", "a", "4", "l");
        QCOMPARE(t.names(), "one two three four ");
    }

    void afterUndoNothingJoins() {
        Texts t = texts();
        t.edit("one", "a", "1", "k");
        t.edit("two", "a", "2", "l");
        t.go(1);
        t.edit("three", "a", "3", "k");
        QCOMPARE(t.names(), "one three ");
    }

    void aDragThatEndsWhereItBeganIsNone() {
        Texts t = texts();
        t.edit("before", "b", "beta1");
        t.edit("move", "a", "alpha 1", "drag");
        t.edit("move", "a", "alpha", "drag");
        QCOMPARE(t.names(), "before ");
        QCOMPARE(t.history.position(), 1u);
        t.edit("move", "a", "alpha 2", "drag");
        t.go(1);
        QCOMPARE(*t.now["a"], "alpha");
        t.go(0);
        QCOMPARE(*t.now["b"], "beta");
    }

    void cancelledDragRestoresRedo() {
        Texts t = texts();
        t.edit("one", "a", "alpha1");
        t.edit("two", "b", "beta2");
        t.go(1);
        t.edit("move", "a", "alpha 1", "drag");
        t.edit("move", "a", "alpha 23", "drag");
        QCOMPARE(t.names(), "one move ");
        t.edit("move", "a", "alpha1", "drag"); // the start value again
        QCOMPARE(t.names(), "one two ");
        t.edit("move", "a", "alpha 4", "drag"); // and moved again
        QCOMPARE(t.names(), "one move ");
        QVERIFY(t.history.canDiscardMerge("drag"));
        QVERIFY(!t.history.canDiscardMerge("other") && !t.history.canDiscardMerge(""));
        t.go(1);
        t.history.dropDiscarded();
        QCOMPARE(t.names(), "one two ");
        QCOMPARE(*t.now["a"], "alpha1");
        t.go(2);
        QCOMPARE(*t.now["b"], "beta2");
        t.go(0);
        QCOMPARE(*t.now["a"], "alpha");
        QCOMPARE(*t.now["b"], "beta");
    }

    void finishedEditIsNotDiscarded() {
        Texts t = texts();
        QVERIFY(!t.history.canDiscardMerge("drag"));
        t.edit("move", "a", "alpha 1", "drag");
        t.history.endMerge();
        QVERIFY(!t.history.canDiscardMerge("drag"));
        t.edit("move", "a", "alpha 2", "drag");
        t.go(1);
        t.go(2);
        QVERIFY(!t.history.canDiscardMerge("drag"));
    }

    void historySurvivesRename() {
        Texts t = texts();
        t.edit("one", "a", "alpha1");
        t.history.renameFile("a", "c");
        t.now["c"] = t.now["a"];
        t.edit("two", "c", "alpha12");
        t.go(0);
        QCOMPARE(*t.now["c"], "alpha");
    }

    void selectionKeepsEachOnce() {
        Selection selection;
        QSignalSpy changed(&selection, &Selection::changed);
        selection.set({"robot0", "robot1", "robot0"});
        QCOMPARE(selection.paths(), (std::vector<std::string>{"robot0", "robot1"}));
        QCOMPARE(selection.current(), "robot1");
        selection.set({"robot0", "robot1"});
        QCOMPARE(changed.count(), 1);
        selection.toggle("robot0");
        QVERIFY(!selection.contains("robot0"));
        selection.toggle("");
        QCOMPARE(selection.current(), "");
        QVERIFY(selection.contains(""));
        selection.clear();
        QVERIFY(selection.empty());
        QCOMPARE(changed.count(), 4);
    }
};

QTEST_GUILESS_MAIN(HistoryTest)
#include "history_test.moc"
