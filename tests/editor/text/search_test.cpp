// Find, replace and rename in texts, with real keys.

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>

#include "editor/text/two_balls.h"
#include "eventually.h"

using namespace trundle;
using namespace trundle::test;

class SearchTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void renamesWhatIsNamedAtTheCaret_data();
    void renamesWhatIsNamedAtTheCaret();
    void rejectsUnavailableNameInPlace();
    void rejectsRenameWithoutName();
    void listsWhatIsFoundInFiles();
    void findsInAllFiles();
    void countsInTheShownPage();
    void replacesAllAsOneEntry();
    void replacesOneByOne();
    void aReplacementIsNotSearched();
    void reportsInvalidExpression();
};

void SearchTest::renamesWhatIsNamedAtTheCaret_data() {
    QTest::addColumn<QByteArray>("word");
    QTest::addColumn<bool>("inParts");
    QTest::addColumn<QByteArray>("drive"); // the texts afterwards, with NEW as the new name
    QTest::addColumn<QByteArray>("parts");
    const auto row = [](const char* name, const char* word, bool inParts, std::initializer_list<const char*> places) {
        QByteArray drive = kTwoBalls, parts = kBallConfig;
        for (const char* place : places) { // [ ] marks the name: "$([size]*2)" is "size" in "$(size*2)"
            const QByteArray marked = place;
            const QByteArray plain = QByteArray(marked).replace("[", "").replace("]", "");
            const qsizetype from = marked.indexOf('['), to = marked.indexOf(']');
            const QByteArray after = marked.left(from) + "NEW" + marked.mid(to + 1);
            for (QByteArray* text : {&drive, &parts}) text->replace(plain, after);
        }
        QTest::newRow(name) << QByteArray(word) << inParts << drive << parts;
    };
    row("a config where it is used", "Ball size", false, {"Config=[Ball]", "RobotConfig [Ball]"});
    row("a config where it is given", "Ball {", true, {"Config=[Ball]", "RobotConfig [Ball]"});
    row("a Param where it is given", "size = 0.1", true, {"Param [size]", "$([size]*2)", "[size]=0.2"});
    row("a Param in an expression", "size*2", true, {"Param [size]", "$([size]*2)", "[size]=0.2"});
    row("a Param that an instance sets", "size=0.2", false, {"Param [size]", "$([size]*2)", "[size]=0.2"});
    row("a body in an override", "body.ball", false, {"[body].ball", "Body [body]"});
    row("a geom in an override", "ball.Mass", false, {"body.[ball]", "Sphere [ball]"});
    row("a material where it is used", "red }", true, {"Material=[red]", "Material [red]"});
    row("a robot in a log", "one Interval", false, {"Robot=[one]", "Robot [one]"});
}

void SearchTest::renamesWhatIsNamedAtTheCaret() {
    QFETCH(QByteArray, word);
    QFETCH(bool, inParts);
    QFETCH(QByteArray, drive);
    QFETCH(QByteArray, parts);
    TwoBalls w;
    if (inParts) {
        w.panel.openFile(w.parts);
        w.edit().setFocus();
    }
    w.caretAt(word.constData(), 1);
    w.key(Qt::Key_F2);
    auto* name = w.child<QLineEdit>("renameText");
    QVERIFY(name && name->isVisible());
    EVENTUALLY(name->hasFocus());
    QCOMPARE(name->selectedText(), name->text());
    QVERIFY(word.contains(name->text().toLatin1()));
    QTest::keyClicks(name, QStringLiteral("NEW"));
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(!name->isVisible());
    EVENTUALLY(w.edit().hasFocus());
    QCOMPARE(w.text(w.document.texts().files()[0]), drive);
    QCOMPARE(w.text(w.parts), parts);
    QCOMPARE(w.history().size(), 1);
    QVERIFY(w.history().last().startsWith(QStringLiteral("Rename ")));
    w.document.edits().undo();
    QCOMPARE(w.text(w.document.texts().files()[0]), QByteArray(kTwoBalls));
    QCOMPARE(w.text(w.parts), QByteArray(kBallConfig));
}

void SearchTest::rejectsUnavailableNameInPlace() {
    TwoBalls w;
    w.caretAt("one {", 1);
    w.key(Qt::Key_F2);
    auto* name = w.child<QLineEdit>("renameText");
    auto* error = w.child<QLabel>("renameError");
    QVERIFY(!error->isVisible());
    for (const char* wrong : {"two", "world", "9lives", ""}) {
        name->setText(QLatin1String(wrong));
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY2(error->isVisible() && !error->text().isEmpty(), wrong);
        QVERIFY(w.child("renameField")->rect().contains(error->geometry()));
    }
    QTest::keyClick(name, Qt::Key_A);
    QVERIFY(!error->isVisible());
    QTest::keyClick(name, Qt::Key_Escape);
    QVERIFY(!name->isVisible());
    EVENTUALLY(w.edit().hasFocus());
    QCOMPARE(w.text(), QByteArray(kTwoBalls));
    QVERIFY(!w.document.edits().history().canUndo());
}

void SearchTest::rejectsRenameWithoutName() {
    TwoBalls w;
    QSignalSpy reportOf(&w.panel, &TextPanel::messageRequested);
    int times = 0;
    for (const char* word : {"Tick", "0.01", "Robot one", "Mass=2", "parts.sim", "100 ms"}) {
        w.caretAt(word, 1);
        w.key(Qt::Key_F2);
        QVERIFY2(!w.child("renameField"), word);
        QCOMPARE(reportOf.count(), ++times);
    }
}

void SearchTest::listsWhatIsFoundInFiles() {
    TwoBalls w;
    w.key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    auto* find = w.child<QLineEdit>("findText");
    EVENTUALLY(find->hasFocus());
    QVERIFY(w.child<QCheckBox>("findEverywhere")->isChecked());
    auto* list = w.child<QTreeWidget>("foundList");
    QTest::keyClicks(find, QStringLiteral("ball"));
    QVERIFY(list->isVisible());
    QStringList rows, lines;
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        rows << list->topLevelItem(i)->text(0);
        lines << list->topLevelItem(i)->text(1);
    }
    QCOMPARE(rows, (QStringList{QStringLiteral("drive.sim:3"), QStringLiteral("drive.sim:4"), QStringLiteral("drive.sim:4"),
                                QStringLiteral("parts.sim:2"), QStringLiteral("parts.sim:5")}));
    QCOMPARE(lines.at(4), QStringLiteral("Sphere ball { Radius=$(size*2) Mass=1 Material=red }"));
    QCOMPARE(w.child<QLabel>("foundTitle")->text(), QStringLiteral("5 found in 2 files"));
    QVERIFY(w.child("foundPanel")->height() <= w.panel.height() / 3); // the text stays visible
    QTest::keyClick(find, Qt::Key_Down);
    EVENTUALLY(list->hasFocus());
    QTest::keyClick(list, Qt::Key_End);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(w.page().file(), w.parts);
    QCOMPARE(w.selected(), QByteArray("ball"));
    EVENTUALLY(w.edit().hasFocus());
    w.key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier); // searches for the selection
    QCOMPARE(find->text(), QStringLiteral("ball"));
    EVENTUALLY(find->hasFocus());
    QTest::keyClick(find, Qt::Key_Escape);
    QVERIFY(!list->isVisible() && !find->isVisible());
    EVENTUALLY(w.edit().hasFocus());
}

void SearchTest::findsInAllFiles() {
    TwoBalls w;
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

void SearchTest::countsInTheShownPage() {
    TwoBalls w;
    QVERIFY(w.panel.openFile(w.parts));
    auto* tabs = w.child<QTabWidget>("textTabs");
    tabs->setCurrentIndex(0);
    w.edit().setFocus();
    w.caretAt("Tick");
    w.key(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("robot"));
    const auto* shown = w.child<QLabel>("findSaid");
    QCOMPARE(shown->text(), QStringLiteral("1 of 3"));
    tabs->setCurrentIndex(1);
    QCOMPARE(shown->text(), QStringLiteral("1 found"));
    tabs->setCurrentIndex(0);
    QCOMPARE(shown->text(), QStringLiteral("1 of 3"));
    w.document.opening().close();
}

void SearchTest::replacesAllAsOneEntry() {
    TwoBalls w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("Ball"));
    w.child<QAbstractButton>("findCase")->click();
    w.child<QAbstractButton>("findWords")->click();
    w.child<QCheckBox>("findEverywhere")->click();
    QTest::keyClick(w.child<QLineEdit>("findText"), Qt::Key_Tab);
    QVERIFY(w.child<QLineEdit>("replaceText")->hasFocus());
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("Sphere1"));
    QTest::mouseClick(w.child<QPushButton>("replaceAll"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config=Sphere1"), 2);
    QVERIFY(w.text(w.parts).contains("RobotConfig Sphere1 {"));
    QVERIFY(w.text(w.parts).contains("Sphere ball"));
    QCOMPARE(w.history(), QStringList{QStringLiteral("Replace All")});
    QCOMPARE(w.child<QLabel>("findSaid")->text(), QStringLiteral("3 replaced"));
    w.document.edits().undo();
    QCOMPARE(w.text(), QByteArray(kTwoBalls));
    QCOMPARE(w.text(w.parts), QByteArray(kBallConfig));
    // Matches are marked again.
    const auto marked = [&w](qsizetype at) {
        return w.edit().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 11UL, static_cast<long>(at)) != 0;
    };
    const qsizetype found = w.shown().indexOf("Ball");
    QVERIFY(!marked(found - 1) && marked(found) && marked(found + 3) && !marked(found + 4));
}

void SearchTest::replacesOneByOne() {
    TwoBalls w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("(\\w+)=Ball"));
    w.child<QAbstractButton>("findRegex")->click();
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("\\1 = Ball"));
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config = Ball"), 1);
    QCOMPARE(w.selected(), QByteArray("Config=Ball")); // the next match
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QCOMPARE(w.text().count("Config = Ball"), 2);
    QCOMPARE(w.shown(), w.text());
}

void SearchTest::aReplacementIsNotSearched() {
    TwoBalls w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("Ball"));
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("BallBall"));
    const auto before = w.text().count("Ball");
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QTest::mouseClick(w.child<QPushButton>("replaceOne"), Qt::LeftButton);
    QCOMPARE(w.text().count("Ball"), before + 2);
    QVERIFY2(!w.text().contains("BallBallBall"), w.text().constData());
}

void SearchTest::reportsInvalidExpression() {
    TwoBalls w;
    w.key(Qt::Key_F, Qt::ControlModifier);
    w.child<QAbstractButton>("findRegex")->click();
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("(a"));
    QVERIFY(w.child<QLabel>("findSaid")->text().contains(QStringLiteral("parenthes")));
    QTest::keyClick(w.child<QLineEdit>("findText"), Qt::Key_Return);
}

QTEST_MAIN(SearchTest)
#include "search_test.moc"
