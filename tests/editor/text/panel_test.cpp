// The text editor as a user works with it: real keys, a real document.

#include <random>

#include <QApplication>
#include <QClipboard>
#include <QInputMethodEvent>
#include <QPushButton>
#include <QSettings>

#include "editor/document/structure_edits.h"
#include "editor/text/text_fixture.h"
#include "eventually.h"

using namespace trundle;
using namespace trundle::test;

class PanelTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void showsTheOpenedFile();
    void typedWordIsOneEntry();
    void aBurstIsReadOnce();
    void undoGivesTheSameBytes_data();
    void undoGivesTheSameBytes();
    void undoRestoresCaretPosition();
    void othersFindWhatIsTyped();
    void editsElsewhereKeepTheCaret();
    void editsElsewhereKeepWhatIsTyped();
    void editsElsewhereKeepFolds();
    void lineCommandsAreOneEntry();
    void enterIndents();
    void pasteKeepsLineEnds();
    void lettersAreNoShortcuts();
    void commandsTypeNothing();
    void linesWrapInNarrowPanes();
    void undoRestoresTypedText_data();
    void undoRestoresTypedText();
    void inputMethods();
    void deleteRemovesSelection();
    void deletedLinesLeaveTheRightColours();
    void rejectedTypingIsReverted();
};

void PanelTest::showsTheOpenedFile() {
    TextFixture w;
    openDrive(w);
    QCOMPARE(w.shown(), QByteArray(kDrive));
    QCOMPARE(w.panel.pages().size(), std::size_t{1});
    QCOMPARE(w.edit().styling().styleAt(0), TextStyle::Comment);
    QCOMPARE(w.edit().styling().styleAt(static_cast<std::uint32_t>(w.shown().indexOf("Material red"))), TextStyle::Kind);
    QVERIFY(w.page().problems().empty());
    QVERIFY(!w.document.edits().history().canUndo());
}

void PanelTest::typedWordIsOneEntry() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Material red");
    w.keys("Duration = 12 ");
    QCOMPARE(w.text(), QByteArray(kDrive)); // not yet in the document
    EVENTUALLY(w.text().contains("Duration = 12 Material"));
    QCOMPARE(w.history(), (QStringList{QStringLiteral("Type “Duration” at drive.sim:4"),
                                       QStringLiteral("Type “=” at drive.sim:4"), QStringLiteral("Type “12” at drive.sim:4")}));
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(w.text().contains("Duration = Material"));
    QCOMPARE(w.shown(), w.text());
    w.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(w.text().contains("Duration = 12 Material"));
}

void PanelTest::aBurstIsReadOnce() {
    TextFixture w;
    openDrive(w);
    const QSignalSpy changed(&w.document, &Document::changed);
    w.caretAt("One ball");
    w.keys("Thirty-letters-in-one-go-here");
    EVENTUALLY_EQUAL(changed.count(), 1);
    QCOMPARE(w.document.loaded()->parses, std::size_t{1}); // the imported file is not parsed again
    QCOMPARE(w.history().size(), 1);
    w.keys("more"); // the same word, after a pause
    EVENTUALLY_EQUAL(changed.count(), 2);
    QCOMPARE(w.history().size(), 1);
}

void PanelTest::undoGivesTheSameBytes_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray drive("Tick = 0.01\nSeed = 3\nStaticConfig Floor {\n  Plane ground { }\n}\n");
    QTest::newRow("LF") << drive;
    QTest::newRow("CR LF") << QByteArray(drive).replace("\n", "\r\n");
    QTest::newRow("BOM") << QByteArray("\xEF\xBB\xBF") + drive;
    QTest::newRow("two BOMs") << QByteArray("\xEF\xBB\xBF\xEF\xBB\xBF") + drive;
    QTest::newRow("tabs") << QByteArray("Robot r {\n\tConfig=X\n\t\tPos = 1,2,3\n}\n");
    QTest::newRow("mixed ends") << QByteArray("Tick = 0.01\r\nSeed = 1\rDuration = 2\n\r\n");
    QTest::newRow("no end") << QByteArray("Tick = 0.01");
    QTest::newRow("umlauts") << QByteArray("// Gr\xC3\xB6\xC3\x9F"
                                           "e \xF0\x9F\xA4\x96\nTitle = \"\xC3\x9C"
                                           "ber\"\n");
    QTest::newRow("no UTF-8") << QByteArray("// \xE4\xF6 \xFF\nTick = 0.01\n");
    QTest::newRow("NUL") << QByteArray("Tick = 0.01\n// a\0b\n", 18);
    QTest::newRow("line separators of Unicode") << QByteArray("// a\xE2\x80\xA8"
                                                              "b\xC2\x85"
                                                              "c\nTick=1\n");
    QTest::newRow("empty") << QByteArray();
}

void PanelTest::undoGivesTheSameBytes() {
    QFETCH(QByteArray, bytes);
    TextFixture w;
    w.open(w.write("drive.sim", bytes));
    QCOMPARE(w.shown(), bytes);
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.keys("Seed = 4");
    w.key(Qt::Key_Return);
    w.keys("// \xC3\xA4\xE2\x82\xAC");
    w.key(Qt::Key_Home, Qt::ControlModifier);
    w.key(Qt::Key_Delete);
    w.keys("x");
    w.panel.flush();
    QCOMPARE(w.shown(), w.text());
    QVERIFY(w.text() != bytes);
    const QByteArray typed = w.text();
    while (w.document.edits().history().canUndo()) w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.text(), bytes);
    QCOMPARE(w.shown(), bytes);
    while (w.document.edits().history().canRedo()) w.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(w.text(), typed);
    QCOMPARE(w.shown(), typed);
}

void PanelTest::undoRestoresCaretPosition() {
    TextFixture w;
    openDrive(w);
    w.caretAt("ColorRGB");
    w.keys("Opacity=1 ");
    w.panel.flush();
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.edit().caret(), static_cast<std::uint32_t>(w.shown().indexOf("ColorRGB")));
}

void PanelTest::othersFindWhatIsTyped() {
    TextFixture w;
    openDrive(w);
    QPushButton other(QStringLiteral("Save"));
    QByteArray seen;
    connect(&other, &QPushButton::pressed, &other, [&] { seen = w.text(); });
    other.show();
    w.caretAt("Tick");
    w.keys("Seed=1 ");
    QVERIFY(!w.text().contains("Seed=1"));
    QTest::mousePress(&other, Qt::LeftButton);
    QVERIFY(seen.contains("Seed=1 Tick"));
}

void PanelTest::editsElsewhereKeepTheCaret() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Config=Ball", 7);
    const QByteArray behind = w.shown().mid(w.edit().caret());
    QVERIFY(w.document.structure().setValues(QStringLiteral("Move"), {{"Tick", "0.002"}, {"floor.Pos", "1,2,3"}}));
    QCOMPARE(w.shown(), w.text());
    QVERIFY(w.shown().contains("Tick = 0.002"));
    QCOMPARE(w.shown().mid(w.edit().caret()), behind);
    w.keys("X");
    w.panel.flush();
    QVERIFY(w.text().contains("Config=XBall"));
}

void PanelTest::editsElsewhereKeepWhatIsTyped() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Pos=0,0,1", 9);
    w.keys("  HPR=5,0,0");
    QVERIFY(w.page().pending());
    QVERIFY(w.document.structure().setValues(QStringLiteral("Tick"), {{"Tick", "0.002"}})); // as a property row does
    w.panel.flush();
    QVERIFY(w.text().contains("Pos=0,0,1  HPR=5,0,0"));
    QVERIFY(w.text().contains("Tick = 0.002"));
    QCOMPARE(w.shown(), w.text());
    QCOMPARE(w.history(), (QStringList{QStringLiteral("Tick"), QStringLiteral("Type “HPR=5,0,0” at drive.sim:9")}));
    w.document.edits().undo();
    w.document.edits().undo();
    QCOMPARE(w.text(), QByteArray(kDrive));
    QCOMPARE(w.shown(), QByteArray(kDrive));
}

void PanelTest::editsElsewhereKeepFolds() {
    TextFixture w;
    openDrive(w);
    w.edit().styling().foldEverything(true);
    const auto visible = [&](int line) {
        return w.edit().SendScintilla(QsciScintillaBase::SCI_GETLINEVISIBLE, static_cast<unsigned long>(line)) != 0;
    };
    QVERIFY(visible(6));
    QVERIFY(!visible(7));
    QVERIFY(w.document.structure().setValues(QStringLiteral("Tick"), {{"Tick", "0.002"}, {"floor.Pos", "1,2,3"}}));
    QVERIFY(visible(6));
    QVERIFY(!visible(7));
}

void PanelTest::lineCommandsAreOneEntry() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Material red");
    w.key(Qt::Key_D, Qt::ControlModifier);
    w.panel.flush();
    QCOMPARE(w.text().count("Material red"), 2);
    w.key(Qt::Key_Slash, Qt::ControlModifier);
    w.panel.flush();
    QVERIFY(w.text().contains("}\n// Material red"));
    w.key(Qt::Key_Up, Qt::AltModifier);
    w.panel.flush();
    QVERIFY(w.text().contains("// Material red { ColorRGB=1,0,0 }\nMaterial red"));
    QCOMPARE(w.history().size(), 3);
    for (int i = 0; i < 3; ++i) w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.text(), QByteArray(kDrive));
}

void PanelTest::enterIndents() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Config=Ball", 11);
    w.key(Qt::Key_Return);
    w.keys("Pos=1,1,1");
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.keys("StaticConfig X {");
    w.key(Qt::Key_Return);
    w.keys("Box b { }");
    w.key(Qt::Key_Return);
    w.keys("}");
    w.panel.flush();
    QVERIFY(w.text().contains("  Config=Ball\n  Pos=1,1,1\n"));
    QVERIFY(w.text().endsWith("StaticConfig X {\n  Box b { }\n}"));
}

void PanelTest::pasteKeepsLineEnds() {
    TextFixture w;
    w.open(w.write("drive.sim", "Tick = 0.01\r\nSeed = 1\r\n"));
    QGuiApplication::clipboard()->setText(QStringLiteral("Duration = 1\nTitle = x\n"));
    w.key(Qt::Key_V, Qt::ControlModifier);
    w.panel.flush();
    QCOMPARE(w.text(), QByteArray("Duration = 1\r\nTitle = x\r\nTick = 0.01\r\nSeed = 1\r\n"));
    QCOMPARE(w.history().size(), 1);
}

void PanelTest::lettersAreNoShortcuts() {
    TextFixture w;
    openDrive(w);
    int triggered = 0;
    for (const char* keys : {"F", "Shift+F", "5", "End", "Del", "Ctrl+D", "Ctrl+Z", "Ctrl+X"}) {
        auto* action = new QAction(&w.panel);
        action->setShortcut(QKeySequence(QLatin1String(keys)));
        connect(action, &QAction::triggered, this, [&] { ++triggered; });
        w.panel.addAction(action);
    }
    w.caretAt("Tick");
    w.keys("fF5");
    w.key(Qt::Key_End);
    w.key(Qt::Key_D, Qt::ControlModifier);
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(triggered, 0);
    w.panel.flush();
    QVERIFY(w.text().contains("fF5Tick"));
}

void PanelTest::commandsTypeNothing() {
    TextFixture w;
    openDrive(w);
    w.caretAt("Tick");
    for (const Qt::KeyboardModifiers held : {Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ControlModifier | Qt::ShiftModifier,
                                             Qt::KeyboardModifiers(Qt::MetaModifier), Qt::KeyboardModifiers(Qt::AltModifier)})
        for (const auto& [key, text] : {std::pair(Qt::Key_Period, "."), std::pair(Qt::Key_E, "e"), std::pair(Qt::Key_1, "1"),
                                        std::pair(Qt::Key_BraceRight, "}")})
            QTest::sendKeyEvent(QTest::Click, &w.edit(), key, QLatin1String(text), held); // as the window system sends them
    w.panel.flush();
    QCOMPARE(w.shown(), QByteArray(kDrive));
    w.key(Qt::Key_Right, Qt::ControlModifier); // keys that move the caret still work
    QVERIFY(w.edit().caret() > static_cast<std::uint32_t>(w.shown().indexOf("Tick")));
    QTest::sendKeyEvent(QTest::Click, &w.edit(), Qt::Key_BraceLeft, QStringLiteral("{"), Qt::GroupSwitchModifier); // AltGr
    w.panel.flush();
    QCOMPARE(w.shown().size(), qsizetype(sizeof(kDrive)));
}

void PanelTest::linesWrapInNarrowPanes() {
    QSettings().clear();
    const QByteArray text = "// " + QByteArray("word ").repeated(40) + "\nTick = 0.01\n";
    TextFixture w;
    w.open(w.write("long.sim", text));
    const auto rows = [&w] { return w.edit().SendScintilla(QsciScintillaBase::SCI_WRAPCOUNT, 0UL); };
    QAction& wrap = w.actions.at("text.wrap");
    w.panel.resize(1400, 500);
    EVENTUALLY(!w.edit().wrapping().wraps());
    QCOMPARE(rows(), 1L);
    QVERIFY(!wrap.isChecked());
    w.panel.resize(400, 500);
    EVENTUALLY(w.edit().wrapping().wraps());
    EVENTUALLY(rows() > 1L);
    QVERIFY(wrap.isChecked());
    w.edit().select({static_cast<std::uint32_t>(text.indexOf("Tick")), static_cast<std::uint32_t>(text.indexOf("Tick"))});
    QCOMPARE(w.shown(), text); // nothing is inserted
    wrap.trigger();
    QVERIFY(!w.edit().wrapping().wraps());
    QVERIFY(loadPreferences().wrapLines == WrapLines::Never);
    wrap.trigger();
    w.panel.resize(1400, 500);
    QVERIFY(w.edit().wrapping().wraps());
    QVERIFY(loadPreferences().wrapLines == WrapLines::Always);
    QSettings().clear();
}

void PanelTest::undoRestoresTypedText_data() {
    QTest::addColumn<QByteArray>("lineEnd");
    QTest::newRow("LF") << QByteArray("\n");
    QTest::newRow("CR LF") << QByteArray("\r\n");
}

/// Keys, commands, edits from elsewhere and undo steps in any order: the document always has the text that is shown; undoing all
/// restores the first bytes, redoing all the last.
void PanelTest::undoRestoresTypedText() {
    QFETCH(QByteArray, lineEnd);
    TextFixture w;
    (void)w.write("parts.sim", kParts);
    const QByteArray start = QByteArray(kDrive).replace("\n", lineEnd);
    w.open(w.write("drive.sim", start));
    std::mt19937 random(lineEnd.size());
    const int steps = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 3000 : 150;
    for (int i = 0; i < steps; ++i) {
        switch (random() % 16) {
        case 0: w.key(Qt::Key_Return); break;
        case 1: w.key(Qt::Key_Backspace); break;
        case 2: w.key(Qt::Key_Delete); break;
        case 3: w.key(Qt::Key_D, Qt::ControlModifier); break;
        case 4: w.key(Qt::Key_Slash, Qt::ControlModifier); break;
        case 5: w.key(random() % 2 ? Qt::Key_Up : Qt::Key_Down, Qt::AltModifier); break;
        case 6: w.key(Qt::Key_Right, Qt::ShiftModifier | Qt::ControlModifier); break;
        case 7: w.key(Qt::Key_Tab); break;
        case 8: w.key(Qt::Key_Z, Qt::ControlModifier); break;
        case 9: w.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); break;
        case 10: (void)w.document.structure().setValues(QStringLiteral("Row"), {{"Tick", i % 2 ? "0.002" : "0.003"}}); break;
        case 11: EVENTUALLY(!w.page().pending()); break;
        case 12: {
            const auto at = static_cast<std::uint32_t>(random() % static_cast<std::size_t>(w.shown().size() + 1));
            w.edit().select({at, at});
            break;
        }
        case 13: w.keys("Mass = 2 "); break;
        case 14: w.keys("{ \xC3\xA4 }"); break;
        default: w.key(Qt::Key_Down); break;
        }
        if (random() % 4 == 0) w.panel.flush();
        if (!w.page().pending()) QCOMPARE(w.shown(), w.text());
    }
    w.panel.flush();
    const QByteArray end = w.text();
    QCOMPARE(w.shown(), end);
    while (w.document.edits().history().canRedo()) w.document.edits().redo();
    const QByteArray last = w.text();
    while (w.document.edits().history().canUndo()) {
        w.document.edits().undo();
        QCOMPARE(w.shown(), w.text());
    }
    QCOMPARE(w.shown(), start);
    while (w.document.edits().history().canRedo()) w.document.edits().redo();
    QCOMPARE(w.shown(), last);
}

void PanelTest::inputMethods() {
    TextFixture w;
    w.open(w.write("drive.sim", "Tick = 1\n"));
    const auto compose = [&](const char* shown, const char* done) {
        QInputMethodEvent event(QString::fromUtf8(shown), {});
        event.setCommitString(QString::fromUtf8(done));
        QApplication::sendEvent(&w.edit(), &event);
    };
    compose("n", "");
    compose("ni", "");
    compose("", "\xE4\xBD\xA0");
    w.panel.flush();
    QCOMPARE(w.text(), QByteArray("\xE4\xBD\xA0Tick = 1\n"));
    QCOMPARE(w.shown(), w.text());
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.text(), QByteArray("Tick = 1\n"));
    QCOMPARE(w.shown(), w.text());
}

void PanelTest::deleteRemovesSelection() {
    TextFixture w;
    w.open(w.write("drive.sim", "Tick = 1\n"));
    w.edit().select({0, 7});
    QVERIFY(w.panel.hasKeyboard());
    QVERIFY(w.panel.apply("edit.delete"));
    w.key(Qt::Key_Delete);
    w.panel.flush();
    QCOMPARE(w.text(), QByteArray("\n"));
    QVERIFY(!w.panel.apply("tool.move"));
}

/// At the end of the text the widget scrolls when lines vanish, before it reports that they did.
void PanelTest::deletedLinesLeaveTheRightColours() {
    const QByteArray line = "Material red { ColorRGB=1,0,0 }\n", comment = "// a longer line of comment\n";
    TextFixture w;
    w.open(w.write("long.sim", line.repeated(100) + comment.repeated(16) + line.repeated(3)));
    const auto style = [&w](long at) { return w.edit().SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT, at); };
    const auto wholeIsStyled = [&] {
        const long size = w.shown().size();
        if (w.edit().SendScintilla(QsciScintillaBase::SCI_GETENDSTYLED) < size) return false;
        for (long at = 0; at < size; ++at)
            if (style(at) != style(at % line.size())) return false;
        return true;
    };
    w.key(Qt::Key_End, Qt::ControlModifier);
    EVENTUALLY(w.edit().SendScintilla(QsciScintillaBase::SCI_GETENDSTYLED) == w.shown().size());
    for (int i = 0; i < 3; ++i) w.key(Qt::Key_Up);
    for (int i = 0; i < 16; ++i) w.key(Qt::Key_Up, Qt::ShiftModifier);
    w.key(Qt::Key_Delete);
    QCOMPARE(w.shown(), line.repeated(103));
    EVENTUALLY(wholeIsStyled());
}

void PanelTest::rejectedTypingIsReverted() {
    TextFixture first, w; // a second window with the same project
    const std::string path = openDrive(first);
    w.open(path);
    QVERIFY(w.document.access().isReadOnly());
    QSignalSpy refused(&w.document, &Document::refused);
    w.caretAt("Material red", 3);
    w.keys("XY");
    EVENTUALLY(!w.page().pending());
    QCOMPARE(w.shown(), QByteArray(kDrive));
    QCOMPARE(w.edit().caret(), static_cast<std::uint32_t>(w.shown().indexOf("Material red") + 3));
    w.key(Qt::Key_Backspace);
    EVENTUALLY(!w.page().pending());
    QCOMPARE(w.shown(), QByteArray(kDrive));
    QVERIFY(!refused.isEmpty());
    QVERIFY(refused[0][0].toString().contains(QStringLiteral("this window has it read-only")));
    w.document.access().editAnyway();
    w.caretAt("Tick");
    w.keys("Seed=1 ");
    w.panel.flush();
    QVERIFY(w.text().contains("Seed=1 Tick"));
    QCOMPARE(w.shown(), w.text());
}

QTEST_MAIN(PanelTest)
#include "panel_test.moc"
