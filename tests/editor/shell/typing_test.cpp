// The work that one key in the text causes, as counts: one load, one image, no list row rebuilt.

#include <QAbstractItemModel>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

#include "editor/shell/window_fixture.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kText = "Tick = 0.01\n"
                         "#import robots/simple_robot.sim\n"
                         "Robot front { Config=SimpleRobot Pos=1,0,0 }\n"
                         "Robot middle { Config=SimpleRobot Pos=0.0,0,0 }\n"
                         "Robot back { Config=SimpleRobot Pos=-1,0,0 }\n";

} // namespace

class TypingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        const QString path = m_folder.filePath(QStringLiteral("mine.sim"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(kText);
        file.close();
        m_window = m_fixture.window();
        m_window->resize(1200, 800);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        QVERIFY(m_window->open(path));
        EVENTUALLY(m_window->document().isOpen());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
    }
    void cleanup() { m_window.reset(); }

    void enterInTheTreePutsTheCaretInTheText() {
        m_window->selection().select("middle");
        auto* tree = m_window->findChild<QTreeView*>(QStringLiteral("outlineTree"));
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Return);
        TextPanel& text = m_window->text();
        EVENTUALLY(text.hasKeyboard());
        CodeEdit& edit = text.page()->edit();
        QCOMPARE(edit.selection().size(), 0u);
        QCOMPARE(edit.caret(), static_cast<std::uint32_t>(kText.indexOf("Robot middle")));
        QTest::keyClick(&edit, Qt::Key_X); // does not replace the selection
        text.flush();
        QCOMPARE(QByteArray::fromStdString(edit.bytes()), QByteArray(kText).replace("Robot middle", "xRobot middle"));
    }

    void aKey_data() {
        QTest::addColumn<QByteArray>("behind"); // text before the caret
        QTest::addColumn<char>("letter");
        QTest::addColumn<std::string>("selected");
        QTest::addColumn<int>("selections");
        QTest::newRow("a letter of a name") << QByteArray("Robot middle") << 'x' << std::string("middlex") << 1;
        QTest::newRow("a digit of a place") << QByteArray("Pos=0.0") << '5' << std::string("middle") << 0;
        QTest::newRow("a blank") << QByteArray("Robot middle") << ' ' << std::string("middle") << 0;
    }
    void aKey() {
        QFETCH(QByteArray, behind);
        QFETCH(char, letter);
        QFETCH(std::string, selected);
        QFETCH(int, selections);
        CodeEdit& edit = m_window->text().page()->edit();
        const auto at = std::uint32_t(kText.indexOf(behind) + behind.size());
        edit.setFocus();
        edit.select({at, at});
        m_window->selection().select("middle");
        EVENTUALLY(m_window->isSettled());
        View& view = m_window->viewport().views().current();
        auto* tree = m_window->findChild<QTreeView*>(QStringLiteral("outlineTree"));
        const QPointer<QWidget> row = m_window->findChild<QWidget*>(QStringLiteral("row.Pos"));
        QVERIFY(row && row->isVisible());
        const int pictures = view.image().redraws(), finer = view.image().refinements();

        QSignalSpy changed(&m_window->document(), &Document::changed), selection(&m_window->selection(), &Selection::changed),
            reset(tree->model(), &QAbstractItemModel::modelReset), inserted(tree->model(), &QAbstractItemModel::rowsInserted),
            removed(tree->model(), &QAbstractItemModel::rowsRemoved);
        QTest::keyClick(&edit, letter);
        EVENTUALLY_EQUAL(changed.size(), 1);
        EVENTUALLY(m_window->isSettled()); // including the refined image, so that nothing is pending
        QCOMPARE(m_window->selection().current(), selected);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(selection.size(), selections);
        QCOMPARE(reset.size() + inserted.size() + removed.size(), 0);
        QVERIFY2(row && row == m_window->findChild<QWidget*>(QStringLiteral("row.Pos")), "the rows were made anew");
        QCOMPARE(view.image().redraws() - pictures, 1);
        QCOMPARE(view.image().refinements() - finer, 1);
    }

private:
    QTemporaryDir m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TypingTest)
#include "typing_test.moc"
