// Completion, fixes, hover, definitions, references and formatting, with real keys.

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTreeWidget>

#include "editor/text/symbols/hover.h"
#include "editor/text/symbols/text_navigation.h"
#include "editor/text/two_balls.h"
#include "eventually.h"

using namespace trundle;
using namespace trundle::test;

class HelpTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void completesWhileTyping();
    void completionIsOneEntry();
    void doesNotRepeatInsertedSign();
    void completesBlockAfterName();
    void enterAfterWholeWordInsertsNewLine();
    void enterBehindANumberIsANewLine();
    void escapeClosesTheList();
    void completionClosesWithItsContext();
    void valuesFollowAKey();
    void fixesByAltEnter();
    void fixesOnTheLineOfTheCaret();
    void problemsAreMarked();
    void hovers_data();
    void hovers();
    void aHoverSaysAllPlacesOfAKind();
    void aHoverSaysThatEveryPartGivesAParam();
    void goesToDefinitions_data();
    void goesToDefinitions();
    void listsUses();
    void aMissingImportIsAFix();
    void formatsAsOneEntry();
    void aBrokenTextIsNotFormatted();
};

void HelpTest::completesWhileTyping() {
    TwoBalls w;
    w.caretAt("Robot one");
    w.keys("Dur");
    EVENTUALLY(w.listShown());
    auto* list = w.child<QTreeWidget>("completionList");
    QCOMPARE(list->topLevelItem(0)->text(0), QStringLiteral("Duration"));
    QVERIFY(!w.child<QLabel>("completionHelp")->text().isEmpty());
    const QWidget* popup = w.child("completionPopup"); // the border is visible on all sides
    for (const QWidget* part : {static_cast<QWidget*>(list), w.child("completionHelp")})
        QVERIFY(popup->rect().adjusted(1, 1, -1, -1).contains(part->geometry()));
    w.key(Qt::Key_Return);
    QVERIFY(!w.listShown());
    w.keys("9 ");
    EVENTUALLY(w.text().contains("Duration = 9 Robot one"));
}

void HelpTest::completionIsOneEntry() {
    TwoBalls w;
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
    while (w.document.edits().history().canUndo()) w.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(w.shown(), QByteArray(kTwoBalls));
}

void HelpTest::doesNotRepeatInsertedSign() {
    TwoBalls w;
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
    w.keys("."); // a second dot is inserted
    w.panel.flush();
    QVERIFY2(w.text().contains("body..size=0.2"), w.text());
}

void HelpTest::completesBlockAfterName() {
    TwoBalls w;
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.keys("Rob");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Tab);
    QCOMPARE(w.selected(), QByteArray("robot"));
    w.keys("three");
    w.key(Qt::Key_Tab);
    EVENTUALLY(w.listShown()); // entries that are allowed there
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY2(w.text().contains("Robot three {\n  Config = Ball\n}"), w.text());
    // A block without required properties: the caret goes to its first line.
    w.key(Qt::Key_End, Qt::ControlModifier);
    w.key(Qt::Key_Return);
    w.keys("StaticC");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Return);
    w.key(Qt::Key_Return); // accepts the suggested name
    w.keys("Box");
    w.panel.flush();
    QVERIFY2(w.text().contains("StaticConfig staticConfig {\n  Box\n}"), w.text());
}

void HelpTest::enterAfterWholeWordInsertsNewLine() {
    TwoBalls w;
    w.caretAt("Config=Ball body", 11);
    w.key(Qt::Key_Backspace);
    w.keys("l");
    EVENTUALLY(!w.page().pending());
    QVERIFY(!w.listShown()); // Ball is complete
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY(w.text().contains("Config=Ball\n"));
}

void HelpTest::completionClosesWithItsContext() {
    TwoBalls w;
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
    TwoBalls w;
    w.caretAt("Robot one");
    w.keys("Gravity = 0,0,-0.5"); // the sign before the digits has opened a list
    w.panel.flush();
    QVERIFY(!w.listShown());
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY2(w.text().contains("Gravity = 0,0,-0.5\nRobot one"), w.text());
    w.caretAt("\nRobot one");
    w.key(Qt::Key_Space, Qt::ControlModifier); // on request, units are listed
    QVERIFY(w.listShown());
}

void HelpTest::escapeClosesTheList() {
    TwoBalls w;
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
    TwoBalls w;
    w.caretAt("Robot one");
    w.keys("Solv");
    EVENTUALLY(w.listShown());
    w.key(Qt::Key_Return);
    EVENTUALLY(w.listShown()); // the values of a choice
    w.keys("ex");
    EVENTUALLY_EQUAL(w.child<QTreeWidget>("completionList")->topLevelItem(0)->text(0), QStringLiteral("exact"));
    w.key(Qt::Key_Return);
    w.panel.flush();
    QVERIFY(w.text().contains("Solver = exactRobot"));
}

void HelpTest::fixesByAltEnter() {
    TwoBalls w;
    w.caretAt("Tick");
    w.key(Qt::Key_Delete);
    EVENTUALLY(!w.page().problems().empty());
    w.key(Qt::Key_Return, Qt::AltModifier);
    auto* menu = w.panel.findChild<QMenu*>(QStringLiteral("fixMenu"));
    QVERIFY(menu && menu->isVisible());
    QCOMPARE(menu->activeAction()->text(), QStringLiteral("Tick"));
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(w.text(), QByteArray(kTwoBalls));
    QCOMPARE(w.shown(), QByteArray(kTwoBalls));
    QCOMPARE(w.history().last(), QStringLiteral("Fix: Tick"));
    w.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(w.text().contains("\nick = 0.01"));
}

/// Where no problem is at the caret, those of its line are offered, and no others.
void HelpTest::fixesOnTheLineOfTheCaret() {
    TwoBalls w;
    w.caretAt("Tick");
    w.key(Qt::Key_Delete);
    EVENTUALLY(!w.page().problems().empty());
    w.key(Qt::Key_Down);
    w.key(Qt::Key_Return, Qt::AltModifier);
    QVERIFY(!w.panel.findChild<QMenu*>(QStringLiteral("fixMenu")));
    w.key(Qt::Key_Up);
    w.key(Qt::Key_End);
    w.key(Qt::Key_Return, Qt::AltModifier);
    auto* menu = w.panel.findChild<QMenu*>(QStringLiteral("fixMenu"));
    QVERIFY(menu && menu->isVisible());
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(w.text(), QByteArray(kTwoBalls));
}

void HelpTest::problemsAreMarked() {
    TwoBalls w;
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
    QVERIFY(squiggle(at + 18)); // the squiggle moves with its word at once
    w.panel.flush();
    while (w.document.edits().history().canUndo()) w.document.edits().undo();
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
    TwoBalls w;
    const FileId file = inParts ? 1 : 0;
    const qsizetype at = QByteArray(inParts ? kBallConfig : kTwoBalls).indexOf(word.toUtf8());
    QVERIFY(at >= 0);
    const std::string html = hoverHtml(hoverAt(*w.document.loaded(), file, static_cast<std::uint32_t>(at)), {});
    for (const QString& s : says) QVERIFY2(QString::fromStdString(html).contains(s), html.c_str());
}

static QString hoverOf(TextFixture& w, const QByteArray& text, const char* word) {
    w.open(w.write("a.sim", text));
    const qsizetype at = text.indexOf(word);
    if (at < 0) qFatal("no such word: %s", word);
    return QString::fromStdString(hoverHtml(hoverAt(*w.document.loaded(), 0, static_cast<std::uint32_t>(at)), {}));
}

void HelpTest::aHoverSaysAllPlacesOfAKind() {
    TextFixture w;
    const QByteArray text = "RobotConfig A { Body b { Mass=1 }\n Imu g { Body=b } }\nPoseLog l { Robot=\"*\" }\n";
    const QString device = hoverOf(w, text, "Imu");
    QVERIFY2(device.contains(QStringLiteral("Allowed in RobotConfig, StaticConfig, PartConfig, Repeat or Ring.")),
             qPrintable(device));
    const QString log = hoverOf(w, text, "PoseLog");
    QVERIFY2(log.contains(QStringLiteral("Allowed in Repeat or Ring, and at the top level.")), qPrintable(log));
    const QString config = hoverOf(w, text, "RobotConfig");
    QVERIFY2(config.contains(QStringLiteral("Allowed at the top level.")), qPrintable(config));
}

void HelpTest::aHoverSaysThatEveryPartGivesAParam() {
    const QByteArray text = "PartConfig Wheel { Body wheel { Mass=1 } Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 } }\n"
                            "PartConfig Side { Body rail { Mass=1 } Part front { Config=Wheel carrier=rail }\n"
                            "  Part rear { Config=Wheel carrier=$hull } }\n"
                            "RobotConfig R { Body box { Mass=1 } Part left { Config=Side hull=box rear.carrier=box } }\n"
                            "Robot r { Config=R left.hull=box left.front.carrier=box }\n";
    TextFixture w;
    for (const char* word :
         {"$carrier", "carrier=rail", "carrier=$hull", "$hull", "hull=box", "carrier=box", "hull=box left.front"}) {
        const QString shown = hoverOf(w, text, word);
        QVERIFY2(shown.contains(QStringLiteral("Every Part gives it")),
                 qPrintable(QLatin1String(word) + QLatin1String(": ") + shown));
        QVERIFY2(!shown.contains(QStringLiteral("has no value")), qPrintable(shown));
    }
}

void HelpTest::goesToDefinitions_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<bool>("inParts"); // where it is requested
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
    TwoBalls w;
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
    TwoBalls w;
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

void HelpTest::aMissingImportIsAFix() {
    TextFixture w;
    (void)w.write("parts.sim", kBallConfig);
    w.open(w.write("drive.sim", "Tick = 0.01\nRobot one { Config=Ball }\n"));
    w.caretAt("Ball", 1);
    w.key(Qt::Key_Return, Qt::AltModifier);
    auto* menu = w.panel.findChild<QMenu*>(QStringLiteral("fixMenu"));
    QVERIFY(menu);
    QCOMPARE(menu->actions().at(1)->text(), QStringLiteral("#import parts.sim"));
    menu->actions().at(1)->trigger();
    menu->close();
    QCOMPARE(w.text(), QByteArray("#import parts.sim\nTick = 0.01\nRobot one { Config=Ball }\n"));
    QVERIFY(!w.document.loaded()->diagnostics.hasErrors());
}

void HelpTest::formatsAsOneEntry() {
    TextFixture w;
    w.open(w.write("a.sim", "StaticConfig A {\n      Box b { Size=1,1,1 }   \n}\n\n\nTick = 0.01"));
    w.caretAt("Size");
    w.key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(w.text().startsWith("StaticConfig A {\n  Box b { Size=1,1,1 }\n}\n"));
    QVERIFY(w.text().endsWith("Tick = 0.01\n"));
    QCOMPARE(w.history(), QStringList{QStringLiteral("Format")});
    QVERIFY(w.shown().mid(w.edit().caret()).startsWith("Size"));
}

void HelpTest::aBrokenTextIsNotFormatted() {
    TextFixture w;
    w.open(w.write("a.sim", "StaticConfig A {\n      Box b { \n"));
    w.key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(w.text(), QByteArray("StaticConfig A {\n      Box b { \n"));
}

QTEST_MAIN(HelpTest)
#include "help_test.moc"
