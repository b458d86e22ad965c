// Completion, fixes, hover, definitions, uses, find and replace, format: with real keys.

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>

#include "editor/text/hover.h"
#include "editor/text/navigation.h"
#include "editor/text/text_window.h"
#include "eventually.h"

using namespace trundle;
using trundle::test::TextWindow;

namespace {

constexpr char kDrive[] = R"(#import parts.sim
Tick = 0.01
Robot one { Config=Ball size=0.2 }
Robot two { Config=Ball body.ball.Mass=2 }
PoseLog log { Robot=one Interval=100 ms }
)";
constexpr char kParts[] = R"(Material red { ColorRGB=1,0,0 }
RobotConfig Ball {
  Param size = 0.1
  Body body {
    Sphere ball { Radius=$(size*2) Mass=1 Material=red }
  }
}
)";

struct Window : TextWindow {
    std::string parts;
    Window() {
        parts = write("parts.sim", kParts);
        open(write("drive.sim", kDrive));
    }
    [[nodiscard]] QWidget* child(const char* name) { return panel.window()->findChild<QWidget*>(QLatin1String(name)); }
    template <class T> [[nodiscard]] T* child(const char* name) { return panel.window()->findChild<T*>(QLatin1String(name)); }
    [[nodiscard]] bool listShown() { return child("completionPopup") && child("completionPopup")->isVisible(); }
    [[nodiscard]] QByteArray selected() {
        const TextRange r = edit().selection();
        return shown().mid(r.begin, r.size());
    }
};

} // namespace

class HelpTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void completesWhileTyping();
    void completionIsOneEntry();
    void aSignThatTheChoiceBroughtIsNotDoubled();
    void behindItsNameABlockIsGoneOnWith();
    void enterAfterAWholeWordIsANewLine();
    void enterBehindANumberIsANewLine();
    void escapeClosesTheList();
    void theListGoesWithWhatItWasFor();
    void valuesFollowAKey();
    void fixesByAltEnter();
    void problemsAreMarked();
    void hovers_data();
    void hovers();
    void goesToDefinitions_data();
    void goesToDefinitions();
    void listsUses();
    void findsInAllFiles();
    void replacesAllAsOneEntry();
    void replacesOneByOne();
    void aWrongExpressionIsSaid();
    void formatsAsOneEntry();
    void aBrokenTextIsNotFormatted();
};

void HelpTest::completesWhileTyping() {
    Window w;
    w.caretAt("Robot one");
    w.keys("Dur");
    EVENTUALLY(w.listShown());
    auto* list = w.child<QTreeWidget>("completionList");
    QCOMPARE(list->topLevelItem(0)->text(0), QStringLiteral("Duration"));
    QVERIFY(!w.child<QLabel>("completionHelp")->text().isEmpty());
    const QWidget* popup = w.child("completionPopup"); // its border is seen all round
    for (const QWidget* part : {static_cast<QWidget*>(list), w.child("completionHelp")})
        QVERIFY(popup->rect().adjusted(1, 1, -1, -1).contains(part->geometry()));
    w.key(Qt::Key_Return);
    QVERIFY(!w.listShown());
    w.keys("9 ");
    EVENTUALLY(w.text().contains("Duration = 9 Robot one"));
}

void HelpTest::completionIsOneEntry() {
    Window w;
    w.caretAt("Robot one");
    w.key(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(w.listShown());
    w.keys("Mat");
    QCOMPARE(w.child<QTreeWidget>("completionList")->topLevelItem(0)->text(0), QStringLiteral("Material"));
    w.key(Qt::Key_Tab);
    w.panel.flush();
    QVERIFY(w.text().contains("Material material { }Robot"));
    QCOMPARE(w.selected(), QByteArray("material"));
    QCOMPARE(w.history().last(), QStringLiteral("Complete Material"));
    while (w.document.history().canUndo()) w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.shown(), QByteArray(kDrive));
}

void HelpTest::aSignThatTheChoiceBroughtIsNotDoubled() {
    Window w;
    w.caretAt("Robot one");
    w.keys("Dur");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Return);
    w.keys("= 9 ");
    w.panel.flush();
    QVERIFY2(w.text().contains("Duration = 9 Robot one"), w.text());
    w.caretAt("size=0.2");
    w.keys("bo");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Tab);
    w.keys(".");
    w.panel.flush();
    QVERIFY2(w.text().contains("body.size=0.2"), w.text());
    w.keys("."); // a second one was meant, whatever for
    w.panel.flush();
    QVERIFY2(w.text().contains("body..size=0.2"), w.text());
}

void HelpTest::behindItsNameABlockIsGoneOnWith() {
    Window w;
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.keys("Rob");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Tab);
    QCOMPARE(w.selected(), QByteArray("robot"));
    w.keys("three");
    w.key(Qt::Key_Tab);
    EVENTUALLY(w.listShown()); // what fits there
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY2(w.text().contains("Robot three {\n  Config = Ball\n}"), w.text());
    // What needs nothing: its first line.
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.key(Qt::Key_Return);
    w.keys("StaticC");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Return);
    w.key(Qt::Key_Return); // the name is good as it is
    w.keys("Box");
    w.panel.flush();
    QVERIFY2(w.text().contains("StaticConfig staticConfig {\n  Box\n}"), w.text());
}

void HelpTest::enterAfterAWholeWordIsANewLine() {
    Window w;
    w.caretAt("Config=Ball body", 11);
    w.key(Qt::Key_Backspace);
    w.keys("l");
    EVENTUALLY(!w.page().pending());
    QVERIFY(!w.listShown()); // Ball is typed out
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY(w.text().contains("Config=Ball\n"));
}

void HelpTest::theListGoesWithWhatItWasFor() {
    Window w;
    w.caretAt("Robot one");
    w.keys("Mat");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!w.listShown());
    w.keys("Mat");
    EVENTUALLY(w.listShown());
    QTest::mouseClick(w.panel.findChild<QWidget*>(QStringLiteral("textFiles"))->parentWidget(), Qt::LeftButton); // takes no focus
    QVERIFY(!w.listShown());
}

void HelpTest::enterBehindANumberIsANewLine() {
    Window w;
    w.caretAt("Robot one");
    w.keys("Gravity = 0,0,-0.5"); // the sign before the digits has called for a list
    w.panel.flush();
    QVERIFY(!w.listShown());
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY2(w.text().contains("Gravity = 0,0,-0.5\nRobot one"), w.text());
    w.caretAt("\nRobot one");
    w.key(Qt::Key_Space, Qt::ControlModifier); // asked for, units are listed
    QVERIFY(w.listShown());
}

void HelpTest::escapeClosesTheList() {
    Window w;
    w.caretAt("Robot one");
    w.key(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(w.listShown());
    w.key(Qt::Key_Escape);
    QVERIFY(!w.listShown());
    w.key(Qt::Key_Space, Qt::ControlModifier);
    w.key(Qt::Key_Left);
    EVENTUALLY(!w.listShown());
}

void HelpTest::valuesFollowAKey() {
    Window w;
    w.caretAt("Robot one");
    w.keys("Solv");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Return);
    EVENTUALLY(w.listShown()); // its choices
    w.keys("ex");
    EVENTUALLY_EQUAL(w.child<QTreeWidget>("completionList")->topLevelItem(0)->text(0), QStringLiteral("exact"));
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY(w.text().contains("Solver = exactRobot"));
}

void HelpTest::fixesByAltEnter() {
    Window w;
    w.caretAt("Tick");
    w.key(Qt::Key_Delete);
    EVENTUALLY(!w.page().problems().empty());
    w.key(Qt::Key_Return, Qt::AltModifier);
    auto* menu = w.panel.findChild<QMenu*>(QStringLiteral("fixMenu"));
    QVERIFY(menu && menu->isVisible());
    QCOMPARE(menu->activeAction()->text(), QStringLiteral("Tick"));
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(w.text(), QByteArray(kDrive));
    QCOMPARE(w.shown(), QByteArray(kDrive));
    QCOMPARE(w.history().last(), QStringLiteral("Fix: Tick"));
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(w.text().contains("\nick = 0.01"));
}

void HelpTest::problemsAreMarked() {
    Window w;
    const auto squiggle = [&](qsizetype at) {
        return w.edit().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 8UL, static_cast<long>(at)) != 0;
    };
    const qsizetype at = w.shown().indexOf("Config=Ball size") + 7;
    QVERIFY(!squiggle(at));
    w.caretAt("Config=Ball size", 11);
    w.keys("s");
    EVENTUALLY(squiggle(at));
    QVERIFY(!squiggle(at - 8));
    w.caretAt("Tick");
    w.keys("// more before it");
    w.key(Qt::Key_Return);
    QVERIFY(squiggle(at + 18)); // the mark goes with its word at once
    w.panel.flush();
    while (w.document.history().canUndo()) w.document.undo();
    QVERIFY(!squiggle(at));
}

void HelpTest::hovers_data() {
    QTest::addColumn<QString>("word");
    QTest::addColumn<bool>("inParts");
    QTest::addColumn<QStringList>("says");
    const auto row = [](const char* name, const char* word, bool inParts, std::initializer_list<const char*> says) {
        QStringList list;
        for (const char* s : says) list << QString::fromUtf8(s);
        QTest::newRow(name) << QString::fromUtf8(word) << inParts << list;
    };
    row("a kind", "Sphere", true, {"Sphere", "Needs Radius."});
    row("a property", "Radius", true, {"Radius", "m, above 0", "required"});
    row("a setting", "Tick", false, {"Tick", "default 0.01"});
    row("an expression", "$(size", true, {"= 0.2"});
    row("a Param", "size = 0.1", true, {"Param size", "= 0.1"});
    row("a material", "=red", true, {});
    row("a config", "Ball size", false, {"RobotConfig Ball {", "parts.sim, line 2"});
    row("a Param that is set", "size=0.2", false, {"Param size = 0.1"});
    row("a part in an override", "body.ball", false, {"Body body {"});
    row("a property in an override", "Mass=2", false, {"Mass", "kg"});
    row("a number with a unit", "100 ms", false, {"= 0.1 s"});
    row("an import", "parts.sim", false, {"parts.sim"});
    row("a name", "one {", false, {"one, a Robot"});
}

void HelpTest::hovers() {
    QFETCH(QString, word);
    QFETCH(bool, inParts);
    QFETCH(QStringList, says);
    Window w;
    const FileId file = inParts ? 1 : 0;
    const qsizetype at = QByteArray(inParts ? kParts : kDrive).indexOf(word.toUtf8());
    QVERIFY(at >= 0);
    const std::string html = hoverHtml(hoverAt(*w.document.loaded(), file, static_cast<std::uint32_t>(at)), {});
    for (const QString& s : says) QVERIFY2(QString::fromStdString(html).contains(s), html.c_str());
}

void HelpTest::goesToDefinitions_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<bool>("inParts"); // where it is asked
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<bool>("toParts");
    QTest::newRow("config") << QByteArray("Ball size") << false << QByteArray("Ball {") << true;
    QTest::newRow("Param set by a robot") << QByteArray("size=0.2") << false << QByteArray("size = 0.1") << true;
    QTest::newRow("Param in an expression") << QByteArray("size*2") << true << QByteArray("size = 0.1") << true;
    QTest::newRow("material") << QByteArray("red }") << true << QByteArray("red {") << true;
    QTest::newRow("part of an override") << QByteArray("ball.Mass") << false << QByteArray("ball {") << true;
    QTest::newRow("robot of a log") << QByteArray("one Interval") << false << QByteArray("one {") << false;
    QTest::newRow("import") << QByteArray("parts.sim") << false << QByteArray("Material red") << true;
}

void HelpTest::goesToDefinitions() {
    QFETCH(QByteArray, from);
    QFETCH(bool, inParts);
    QFETCH(QByteArray, to);
    QFETCH(bool, toParts);
    Window w;
    if (inParts) {
        w.panel.openFile(w.parts);
        w.edit().setFocus();
    }
    w.caretAt(from.constData(), 1);
    w.key(Qt::Key_F12);
    QCOMPARE(w.page().file() == w.parts, toParts);
    QCOMPARE(w.edit().selection().begin, static_cast<std::uint32_t>(w.shown().indexOf(to)));
    QVERIFY(w.edit().hasFocus());
}

void HelpTest::listsUses() {
    Window w;
    w.caretAt("Config=Ball", 8);
    w.key(Qt::Key_F12, Qt::ShiftModifier);
    auto* list = w.child<QTreeWidget>("usesList");
    QVERIFY(list->isVisible());
    QStringList rows;
    for (int i = 0; i < list->topLevelItemCount(); ++i) rows << list->topLevelItem(i)->text(0);
    QCOMPARE(rows, (QStringList{QStringLiteral("parts.sim:2"), QStringLiteral("drive.sim:3"), QStringLiteral("drive.sim:4")}));
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(w.shown().mid(w.edit().selection().begin).startsWith("Ball body.ball"));
}

void HelpTest::findsInAllFiles() {
    Window w;
    w.caretAt("Tick");
    w.key(Qt::Key_F, Qt::ControlModifier);
    auto* find = w.child<QLineEdit>("findText");
    EVENTUALLY(find->hasFocus());
    QTest::keyClicks(find, QStringLiteral("ball"));
    QCOMPARE(w.selected(), QByteArray("Ball"));
    QCOMPARE(w.child<QLabel>("findSaid")->text(), QStringLiteral("1 of 3"));
    QTest::keyClick(find, Qt::Key_Return);
    QCOMPARE(w.child<QLabel>("findSaid")->text(), QStringLiteral("2 of 3"));
    w.child<QCheckBox>("findEverywhere")->click();
    QVERIFY(w.child<QLabel>("findSaid")->text().endsWith(QStringLiteral("of 5")));
    for (int i = 0; i < 5 && w.page().file() != w.parts; ++i) QTest::keyClick(find, Qt::Key_Return);
    QCOMPARE(w.page().file(), w.parts);
    QCOMPARE(w.selected(), QByteArray("Ball"));
    QTest::keyClick(find, Qt::Key_Return, Qt::ShiftModifier);
    QVERIFY(w.page().file() != w.parts);
    QTest::keyClick(find, Qt::Key_Escape);
    QVERIFY(!find->isVisible());
    QVERIFY(w.edit().hasFocus());
}

void HelpTest::replacesAllAsOneEntry() {
    Window w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("Ball"));
    w.child<QAbstractButton>("findCase")->click();
    w.child<QAbstractButton>("findWords")->click();
    w.child<QCheckBox>("findEverywhere")->click();
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("Sphere1"));
    QTest::mouseClick(w.child<QPushButton>("replaceAll"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config=Sphere1"), 2);
    QVERIFY(w.text(w.parts).contains("RobotConfig Sphere1 {"));
    QVERIFY(w.text(w.parts).contains("Sphere ball"));
    QCOMPARE(w.history(), QStringList{QStringLiteral("Replace All")});
    QCOMPARE(w.child<QLabel>("findSaid")->text(), QStringLiteral("3 replaced"));
    w.document.undo();
    QCOMPARE(w.text(), QByteArray(kDrive));
    QCOMPARE(w.text(w.parts), QByteArray(kParts));
    // What was found is marked where it stands again.
    const auto marked = [&w](qsizetype at) {
        return w.edit().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 11UL, static_cast<long>(at)) != 0;
    };
    const qsizetype found = w.shown().indexOf("Ball");
    QVERIFY(!marked(found - 1) && marked(found) && marked(found + 3) && !marked(found + 4));
}

void HelpTest::replacesOneByOne() {
    Window w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("(\\w+)=Ball"));
    w.child<QAbstractButton>("findRegex")->click();
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("\\1 = Ball"));
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config = Ball"), 1);
    QCOMPARE(w.selected(), QByteArray("Config=Ball")); // the next one
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config = Ball"), 2);
    QCOMPARE(w.shown(), w.text());
}

void HelpTest::aWrongExpressionIsSaid() {
    Window w;
    w.key(Qt::Key_F, Qt::ControlModifier);
    w.child<QAbstractButton>("findRegex")->click();
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("(a"));
    QVERIFY(w.child<QLabel>("findSaid")->text().contains(QStringLiteral("parenthes")));
    QTest::keyClick(w.child<QLineEdit>("findText"), Qt::Key_Return);
}

void HelpTest::formatsAsOneEntry() {
    TextWindow w;
    w.open(w.write("a.sim", "StaticConfig A {\n      Box b { Size=1,1,1 }   \n}\n\n\nTick = 0.01"));
    w.caretAt("Size");
    w.key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(w.text().startsWith("StaticConfig A {\n  Box b { Size=1,1,1 }\n}\n"));
    QVERIFY(w.text().endsWith("Tick = 0.01\n"));
    QCOMPARE(w.history(), QStringList{QStringLiteral("Format")});
    QVERIFY(w.shown().mid(w.edit().caret()).startsWith("Size"));
}

void HelpTest::aBrokenTextIsNotFormatted() {
    TextWindow w;
    w.open(w.write("a.sim", "StaticConfig A {\n      Box b { \n"));
    w.key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(w.text(), QByteArray("StaticConfig A {\n      Box b { \n"));
}

QTEST_MAIN(HelpTest)
#include "help_test.moc"
