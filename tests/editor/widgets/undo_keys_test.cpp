// Who gets Ctrl+Z and Ctrl+Shift+Z: a line of text that has something to undo, else the window.
#include <QAction>
#include <QLineEdit>
#include <QMainWindow>
#include <QtTest>

#include "editor/widgets/undo_keys.h"

using namespace trundle;

class UndoKeysTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLineKeepsThemWhileItHasSomethingToUndo() {
        UndoKeys keys;
        qApp->installEventFilter(&keys);
        QMainWindow window;
        int undone = 0, redone = 0;
        for (const auto& [sequence, count] : {std::pair("Ctrl+Z", &undone), {"Ctrl+Shift+Z", &redone}}) {
            auto* action = new QAction(&window);
            action->setShortcut(QKeySequence(QString::fromLatin1(sequence)));
            window.addAction(action);
            connect(action, &QAction::triggered, &window, [count = count] { ++*count; });
        }
        auto* line = new QLineEdit;
        window.setCentralWidget(line);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        line->setFocus();
        const auto undo = [&] { QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier); };
        const auto redo = [&] { QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); };
        undo(), redo();
        QCOMPARE(std::pair(undone, redone), std::pair(1, 1));
        QTest::keyClicks(line, QStringLiteral("ab"));
        undo(); // its own
        QVERIFY(line->text().isEmpty());
        QCOMPARE(undone, 1);
        undo(); // nothing is left
        QCOMPARE(undone, 2);
        redo(); // its own
        QCOMPARE(line->text(), QStringLiteral("ab"));
        QCOMPARE(redone, 1);
        redo();
        QCOMPARE(redone, 2);
    }
};

QTEST_MAIN(UndoKeysTest)
#include "undo_keys_test.moc"
