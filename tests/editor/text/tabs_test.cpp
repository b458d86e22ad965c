// Tabs, breadcrumbs and the selection of the text editor.

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "editor/text/text_fixture.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"

using namespace trundle;
using namespace trundle::test;

class TabsTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tabsFollowTheDocument();
    void importsThatSaveAsRewritesAreShown();
    void namesOfFilesAreShownAsTheyAre();
    void closesTabsOfRemovedFiles();
    void closesTabsOfFilesThatUndoRemoves();
    void undoShowsTheTextThatItChanges();
    void takesOnlyTextThatIsDropped();
    void cursorSelects();
    void selectionIsMarked();
    void closedDocumentIsEmpty();
    void ctrlClickFollows();
    void revealKeepsKeyboardFocus();
    void themesChange();
    void namesOfFilesAreWhole();
};

/// Tabs that do not fit the pane are scrolled, not elided.
void TabsTest::namesOfFilesAreWhole() {
    TextFixture w;
    QByteArray imports;
    const QStringList names{QStringLiteral("obstacle_detection.sim"), QStringLiteral("linear_motion.sim"),
                            QStringLiteral("arc_motion.sim")};
    for (const QString& name : names) {
        w.write(name.toLatin1().constData(), "// nothing\n");
        imports += "#import " + name.toUtf8() + '\n';
    }
    w.open(w.write("drive.sim", imports));
    for (const std::string& file : w.document.texts().files()) QVERIFY(w.panel.openFile(file));
    const auto* bar = w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"))->tabBar();
    QCOMPARE(bar->count(), 4);
    w.panel.window()->resize(320, 400);
    EVENTUALLY(bar->width() < 330);
    for (int i = 0; i < bar->count(); ++i)
        QVERIFY(bar->tabRect(i).width() > bar->fontMetrics().horizontalAdvance(bar->tabText(i)));
}

void TabsTest::undoShowsTheTextThatItChanges() {
    TextFixture w;
    const std::string drive = openDrive(w);
    const std::string parts = w.document.texts().files().at(1);
    QVERIFY(w.panel.openFile(parts));
    w.edit().setFocus();
    const auto end = static_cast<std::uint32_t>(w.shown().size());
    w.edit().select({end, end});
    QTest::keyClicks(&w.edit(), QStringLiteral("// more"));
    QVERIFY(w.panel.openFile(drive));
    w.edit().setFocus();
    w.document.edits().undo(); // the last word
    QCOMPARE(w.page().file(), parts);
    QVERIFY(w.edit().hasFocus());
    QCOMPARE(w.edit().caret(), end + 3);
    QVERIFY(w.panel.openFile(drive));
    w.edit().setFocus();
    w.document.edits().redo();
    QCOMPARE(w.page().file(), parts);
    QCOMPARE(w.edit().caret(), end + 7);

    QVERIFY(w.panel.openFile(drive)); // and the keyboard is elsewhere
    w.edit().clearFocus();
    w.document.edits().undo();
    QCOMPARE(w.page().file(), drive);
}

void TabsTest::tabsFollowTheDocument() {
    TextFixture w;
    const std::string drive = openDrive(w);
    const std::string parts = w.document.texts().files().at(1);
    auto* tabs = w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"));
    QVERIFY(w.panel.openFile(parts));
    QCOMPARE(tabs->count(), 2);
    QCOMPARE(w.page().file(), parts);
    w.edit().setFocus();
    w.caretAt("0.1");
    w.keys("1");
    w.panel.flush();
    QVERIFY(w.text(parts).contains("Param size = 10.1"));
    QCOMPARE(tabs->tabText(1), QStringLiteral("parts.sim*"));
    QCOMPARE(tabs->tabText(0), QStringLiteral("drive.sim"));
    w.document.edits().undo();
    QCOMPARE(tabs->tabText(1), QStringLiteral("parts.sim"));
    const auto buttons = [tabs] { return tabs->findChildren<QToolButton*>(QStringLiteral("closeTab")); };
    QCOMPARE(buttons().size(), 1); // the opened file has no close button
    QTest::mouseClick(buttons().first(), Qt::LeftButton);
    QCOMPARE(tabs->count(), 1);
    EVENTUALLY(buttons().isEmpty());
    QVERIFY(tabs->tabBar()->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly).size() <= 2); // scroll buttons
    QVERIFY(w.document.saving().saveAs(w.folder.filePath(QStringLiteral("other.sim")).toStdString()));
    QCOMPARE(tabs->tabText(0), QStringLiteral("other.sim"));
    w.caretAt("Tick");
    w.keys("x");
    w.panel.flush();
    QVERIFY(w.text(w.document.path()).contains("xTick"));
    QVERIFY(w.document.path() != drive);
}

void TabsTest::importsThatSaveAsRewritesAreShown() {
    TextFixture w;
    const QDir folder(w.folder.path());
    QVERIFY(folder.mkpath(QStringLiteral("configs/deep")) && folder.mkpath(QStringLiteral("other")));
    (void)w.write("configs/parts.sim", kParts);
    w.open(w.write("configs/deep/drive.sim", QByteArray(kDrive).replace("parts.sim", "../parts.sim")));
    QVERIFY(w.document.saving().saveAs(folder.filePath(QStringLiteral("other/drive.sim")).toStdString()));
    const QByteArray saved = QByteArray(kDrive).replace("parts.sim", "\"parts.sim\"");
    QCOMPARE(w.text(w.document.path()), saved);
    QCOMPARE(w.shown(), saved);
    w.caretAt("Tick");
    w.keys("x");
    w.panel.flush();
    QCOMPARE(w.text(w.document.path()), QByteArray(saved).replace("Tick", "xTick"));
}

/// `&` is not a mnemonic.
void TabsTest::namesOfFilesAreShownAsTheyAre() {
    TextFixture w;
    const std::string drive = openDrive(w);
    const auto* tabs = w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"));
    const auto shown = [tabs] { return tabs->tabText(0); };
    QVERIFY(w.document.saving().saveAs(w.folder.filePath(QStringLiteral("a&b %1 <b>.sim")).toStdString()));
    QCOMPARE(shown(), QStringLiteral("a&&b %1 <b>.sim"));
    w.caretAt("Tick");
    w.keys("x");
    w.panel.flush();
    QCOMPARE(shown(), QStringLiteral("a&&b %1 <b>.sim*"));
    const std::string typed = w.document.edits().history().entries().back().name.toStdString();
    QVERIFY2(typed.find("a&b %1 <b>.sim:") != std::string::npos, typed.c_str()); // %1 is not substituted
}

void TabsTest::closesTabsOfRemovedFiles() {
    TextFixture w;
    openDrive(w);
    const std::string parts = w.document.texts().files().at(1);
    QVERIFY(w.panel.openFile(parts));
    QVERIFY(w.panel.openFile(w.document.texts().files().front()));
    w.edit().setFocus();
    w.caretAt("#import", 0);
    w.keys("// ");
    w.panel.flush();
    QVERIFY(w.page().file() != parts);
    w.key(Qt::Key_Z, Qt::ControlModifier);
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(w.panel.openFile(parts));
    QCOMPARE(w.shown(), QByteArray(kParts));
}

/// As after a group is made and undone; while the keyboard is in the tab it stays.
void TabsTest::closesTabsOfFilesThatUndoRemoves() {
    TextFixture w;
    const std::string drive = openDrive(w), piece = drive.substr(0, drive.rfind('/')) + "/piece.sim";
    auto* tabs = w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"));
    const int before = tabs->count();
    w.edit().setFocus();
    for (const bool typed : {false, true}) {
        QVERIFY(w.document.edits().replaceText(QStringLiteral("Group"), piece, "// a piece\n").ok());
        QCOMPARE(tabs->count(), before + 1);
        if (typed) {
            QVERIFY(w.panel.openFile(piece));
            w.edit().setFocus();
        }
        w.document.edits().undo();
        QCOMPARE(tabs->count(), before + typed);
        w.document.edits().redo();
        QCOMPARE(tabs->count(), before + 1);
        w.document.edits().undo();
    }
}

/// What the Library gives has no text of its own: its imports would be missing.
void TabsTest::takesOnlyTextThatIsDropped() {
    TextFixture w;
    w.open(w.write("main.sim", "Tick = 0.01\n"));
    for (const char* format : {"application/x-trundle-library", "text/plain"}) {
        QMimeData mime;
        mime.setData(QLatin1String(format), "Box box { Size=1,1,1 }");
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QApplication::sendEvent(w.edit().viewport(), &enter);
        QCOMPARE(enter.isAccepted(), mime.hasText());
    }
}

void TabsTest::cursorSelects() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Config=Ball");
    QVERIFY(w.selection.empty()); // only the user's caret moves select
    w.key(Qt::Key_Right);
    EVENTUALLY_EQUAL(w.selection.current(), std::string("ball"));
    QVERIFY(w.panel.openFile(w.document.texts().files().at(1)));
    w.edit().setFocus();
    w.caretAt("Radius");
    w.key(Qt::Key_Right);
    EVENTUALLY_EQUAL(w.selection.current(), std::string("RobotConfig.Ball.body.ball"));
    w.selection.select("ball.body.ball"); // the same text range, through the robot: the caret does not change it back
    w.key(Qt::Key_Right);
    EVENTUALLY(!w.panel.findChild<QTimer*>(QStringLiteral("caretTimer"))->isActive());
    QCOMPARE(w.selection.current(), std::string("ball.body.ball"));
}

void TabsTest::selectionIsMarked() {
    TextFixture w;
    openDrive(w);
    const auto marked = [&](const char* words) {
        const auto at = static_cast<unsigned long>(w.shown().indexOf(words));
        return w.edit().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 12UL, static_cast<long>(at)) != 0;
    };
    const std::uint32_t caret = w.edit().caret();
    w.selection.select("floor");
    QVERIFY(marked("Static floor"));
    QVERIFY(!marked("Robot ball"));
    w.selection.select("ball.body"); // its config is in a file without a tab, so the robot is marked
    QVERIFY(marked("Robot ball"));
    QCOMPARE(w.edit().caret(), caret);
    w.selection.clear();
    QVERIFY(!marked("Robot ball"));
}

void TabsTest::closedDocumentIsEmpty() {
    TextFixture w;
    openDrive(w);
    w.document.opening().close();
    QVERIFY(!w.panel.page());
    w.panel.flush();
    w.panel.reveal("nowhere.sim", {0, 1});
    openDrive(w);
    QCOMPARE(w.shown(), QByteArray(kDrive));
}

void TabsTest::ctrlClickFollows() {
    TextFixture w;
    openDrive(w);
    const auto at = static_cast<std::uint32_t>(w.shown().indexOf("parts.sim") + 2);
    const QPoint place = w.edit().geometry().placeOf(at) - QPoint(-2, w.edit().geometry().lineHeight() / 2);
    QTest::mouseClick(w.edit().viewport(), Qt::LeftButton, Qt::ControlModifier, place);
    QCOMPARE(w.page().file(), w.document.texts().files().at(1));
    QCOMPARE(w.shown(), QByteArray(kParts));
}

void TabsTest::revealKeepsKeyboardFocus() {
    TextFixture w;
    openDrive(w);
    w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"))->setFocusPolicy(Qt::StrongFocus);
    w.panel.findChild<QTabWidget*>(QStringLiteral("textTabs"))->setFocus();
    w.panel.reveal(w.document.texts().files().at(1), {0, 11});
    QCOMPARE(w.edit().selection(), (TextRange{0, 11}));
    QVERIFY(!w.edit().hasFocus());
    w.panel.reveal(w.document.texts().files().at(0), {0, 4}, true);
    QVERIFY(w.edit().hasFocus());
    w.panel.reveal(w.document.texts().files().at(0), {4000000, 4000001}); // beyond the end of the text
    QCOMPARE(w.edit().caret(), static_cast<std::uint32_t>(w.shown().size()));
}

void TabsTest::themesChange() {
    TextFixture w;
    openDrive(w);
    const auto back = [&] {
        return w.edit().SendScintilla(QsciScintillaBase::SCI_STYLEGETBACK, static_cast<unsigned long>(TextStyle::Kind));
    };
    applyTheme(*qApp, ThemeKind::Light);
    QCOMPARE(back(), 0xffffffL);
    applyTheme(*qApp, ThemeKind::Dark);
    QVERIFY(back() != 0xffffffL);
    applyTheme(*qApp, ThemeKind::Light);
    QCOMPARE(back(), 0xffffffL);
}

QTEST_MAIN(TabsTest)
#include "tabs_test.moc"
