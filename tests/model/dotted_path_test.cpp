// What a path means, word by word.
#include <QTest>

#include "model/dotted_path.h"

using namespace trundle;

class DottedPathTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void parts_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QStringList>("parts"); // first, without the first, last, without the last
        QTest::addColumn<int>("words");
        QTest::newRow("top level") << "" << QStringList{"", "", "", ""} << 0;
        QTest::newRow("setting") << "Tick" << QStringList{"Tick", "", "Tick", ""} << 1;
        QTest::newRow("property") << "robot0.Pos" << QStringList{"robot0", "Pos", "Pos", "robot0"} << 2;
        QTest::newRow("override") << "robot0.leftMotor.Resistance"
                                  << QStringList{"robot0", "leftMotor.Resistance", "Resistance", "robot0.leftMotor"} << 3;
    }
    void parts() {
        QFETCH(QString, path);
        QFETCH(QStringList, parts);
        QFETCH(int, words);
        const std::string text = path.toStdString();
        const auto shown = [](std::string_view s) { return QString::fromUtf8(s.data(), qsizetype(s.size())); };
        QCOMPARE(shown(firstWord(text)), parts[0]);
        QCOMPARE(shown(withoutFirstWord(text)), parts[1]);
        QCOMPARE(shown(lastWord(text)), parts[2]);
        QCOMPARE(shown(withoutLastWord(text)), parts[3]);
        const DottedPath dotted(text);
        QCOMPARE(int(dotted.words().size()), words);
        QCOMPARE(dotted.empty(), words == 0);
        QVERIFY(dotted.isComplete());
        QCOMPARE(dotted.text(), text);
        std::string joined;
        for (const std::string& word : dotted.words()) joined = pathInside(joined, word);
        QCOMPARE(joined, text);
        if (words > 0) QCOMPARE(pathInside(withoutLastWord(text), lastWord(text)), text);
    }

    void aMissingWordIsIncomplete() {
        for (const char* path : {".", "a.", ".a", "a..b", "a.b."}) QVERIFY2(!DottedPath(path).isComplete(), path);
    }

    void insideIsWordByWord() {
        QVERIFY(startsWithPath("robot1", "robot1"));
        QVERIFY(startsWithPath("robot1.chassis", "robot1"));
        QVERIFY(startsWithPath("robot1.chassis", ""));
        QVERIFY(!startsWithPath("robot10", "robot1"));
        QVERIFY(!startsWithPath("robot10.chassis", "robot1"));
        QVERIFY(!startsWithPath("robot1", "robot1.chassis"));
        QVERIFY(!startsWithPath("robot1.chassisB", "robot1.chassis"));
    }
};

QTEST_APPLESS_MAIN(DottedPathTest)
#include "dotted_path_test.moc"
