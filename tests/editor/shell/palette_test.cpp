// The command palette of the real window: every entry it lists exists, and is listed once.

#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QtTest>

#include "editor/shell/window_fixture.h"
#include "eventually.h"

using namespace trundle;

class PaletteTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        QVERIFY(m_window->open(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/linear_motion.sim")));
        EVENTUALLY(m_window->document().isOpen());
    }
    void cleanup() { m_window.reset(); }

    void findsInsertActionsOnce() {
        m_window->selection().select("robot0");
        QCOMPARE(found("Insert BumpAndTurn"), QStringList()); // its module is not loaded
        QCOMPARE(found("Insert PoseLog"), QStringList{QStringLiteral("Insert PoseLog")});
        QCOMPARE(found("Insert PoseLog"), QStringList{QStringLiteral("Insert PoseLog")}); // also the second time
    }

    /// The entries of the history have the names of what was edited.
    void undoIsLastUnlessItIsTyped() {
        m_window->selection().select("robot0");
        Document& document = m_window->document();
        const std::string text = *document.texts().text(document.path()) + "PoseLog path { Robot=robot0 }\n";
        QVERIFY(document.edits().replaceText(QStringLiteral("Add PoseLog"), document.path(), text).ok());
        const QString undo = QStringLiteral("Undo Add PoseLog");
        QCOMPARE(found("PoseLog"), (QStringList{QStringLiteral("Insert PoseLog"), undo}));
        QCOMPARE(found("undo").value(0), undo);
        QCOMPARE(found("und pose").value(0), undo);
    }

    void submenusHaveNoMnemonics() {
        QVERIFY2(found("Ground Plain") == QStringList{QStringLiteral("Test Drive Ground: Plain Floor")},
                 qPrintable(found("Plain Floor").join(u',')));
    }

    void panelsAreFoundByTheirNames() {
        QCOMPARE(found("radio show"), QStringList{QStringLiteral("Show Radio")});
        QLineEdit& search = open();
        QTest::keyClicks(&search, QStringLiteral("Show Radio"));
        QTest::keyClick(&search, Qt::Key_Return);
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.radios"))->isVisible());
    }

    void aPanelThatIsShownGetsTheKeyboard() {
        m_window->selection().select("robot0");
        for (const char* panel : {"properties", "scene", "history"}) {
            QLineEdit& search = open();
            QTest::keyClicks(&search, QStringLiteral("Show ") + QLatin1String(panel));
            QTest::keyClick(&search, Qt::Key_Return);
            const auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("dock.") + QLatin1String(panel));
            EVENTUALLY(dock->isAncestorOf(m_window->focusWidget()));
            QVERIFY(!qobject_cast<QAbstractItemView*>(m_window->focusWidget()) ||
                    panel != std::string("properties")); // its rows, not its live values
        }
    }

    void insertsChosenKind() {
        m_window->selection().clear();
        QLineEdit& search = open();
        QTest::keyClicks(&search, QStringLiteral("Insert PoseLog"));
        QTest::keyClick(&search, Qt::Key_Return);
        QCOMPARE(m_window->document().edits().history().entries().size(), 1u);
        QCOMPARE(m_window->document().edits().history().entries()[0].name, QStringLiteral("Add PoseLog"));
    }

    void replacesTheSelectedGridBySingleInstances() {
        Document& document = m_window->document();
        const std::string text =
            *document.texts().text(document.path()) + "Grid swarm { Config=SimpleRobot Pos=5,5,0 Count=2,2 Spacing=1 }\n";
        QVERIFY(document.edits().replaceText(QStringLiteral("Add"), document.path(), text).ok());
        const QAction& singles = m_window->actions().at("edit.singles");
        m_window->selection().select("robot0");
        QVERIFY(!singles.isEnabled());
        m_window->selection().select("swarm");
        QVERIFY(singles.isEnabled());
        QLineEdit& search = open();
        QTest::keyClicks(&search, QStringLiteral("single inst"));
        QTest::keyClick(&search, Qt::Key_Return);
        QCOMPARE(document.edits().history().entries().back().name, QStringLiteral("Replace swarm by single instances"));
        QCOMPARE(document.loaded()->experiment->robots.size(), 5u);
        QVERIFY(!singles.isEnabled());
    }

private:
    /// Opens the palette and handles events: entries removed from the menu are deleted by then.
    QLineEdit& open() {
        m_window->actions().at("edit.palette").trigger();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return *m_window->findChild<QLineEdit*>(QStringLiteral("paletteSearch"));
    }
    QStringList found(const char* typed) {
        QLineEdit& search = open();
        QTest::keyClicks(&search, QLatin1String(typed));
        QStringList names;
        const auto* list = m_window->findChild<QListWidget*>(QStringLiteral("paletteList"));
        for (int row = 0; row < list->count(); ++row) names << list->item(row)->text();
        search.window()->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return names;
    }

    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(PaletteTest)
#include "palette_test.moc"
