// Reading and writing the text of values.
#include <QTest>

#include "project/objects/value_text.h"

using namespace trundle;

class ValueTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void words_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("written");
        QTest::newRow("word") << "linear_motion.csv"
                              << "linear_motion.csv";
        QTest::newRow("path") << "a/b-c.png"
                              << "a/b-c.png";
        QTest::newRow("blank") << "two words"
                               << "\"two words\"";
        QTest::newRow("up") << "../x.csv"
                            << "\"../x.csv\"";
        QTest::newRow("digit first") << "3d.png"
                                     << "\"3d.png\"";
        QTest::newRow("number") << "12"
                                << "\"12\"";
        QTest::newRow("true") << "true"
                              << "\"true\"";
        QTest::newRow("quotes") << "say \"hi\""
                                << "\"say \\\"hi\\\"\"";
        QTest::newRow("backslash") << "a\\"
                                   << "a\\";
        QTest::newRow("backslash and blank") << "a\\ b"
                                             << "\"a\\\\ b\"";
        QTest::newRow("comment") << "http://x"
                                 << "\"http://x\"";
        QTest::newRow("Param") << "$name"
                               << "$name";
        QTest::newRow("expression") << "$(a+1)"
                                    << "$(a+1)";
        QTest::newRow("a dollar that is none") << "$"
                                               << "\"$\"";
        QTest::newRow("in quotes already") << "\"as typed\""
                                           << "\"as typed\"";
        QTest::newRow("one quote") << "\""
                                   << "\"\\\"\"";
        QTest::newRow("braces") << "}{"
                                << "\"}{\"";
        QTest::newRow("empty") << ""
                               << "\"\"";
        QTest::newRow("list") << "a,b"
                              << "\"a,b\"";
    }
    void words() {
        QFETCH(QString, typed);
        QFETCH(QString, written);
        const std::string text = wordOrQuoted(typed.toStdString(), false).text();
        QCOMPARE(QString::fromStdString(text), written);
        QVERIFY(ParsedValue(text).status().ok());
        const bool raw = typed.startsWith(QLatin1Char('$')) || typed.startsWith(QLatin1Char('"'));
        if (!raw || typed.size() < 2) QCOMPARE(QString::fromStdString(plainText(text)), typed);
    }

    void notOneValue() {
        for (const char* text : {"", " ", "3 }", "3 } x {", "a = 3", "3 // c", "1,", ",1", "\"open", "$(1+", "3 4", "Box b { }",
                                 "3\nTick = 4", "{", "/*"})
            QVERIFY2(!ParsedValue(text).status().ok(), text);
        for (const char* text : {"3", "12 cm", "1, 2 ,3", "$a", "$(a + 1)", "\"a b\"", "true", "x/y.png,z", "-1e-3 m/s"})
            QVERIFY2(ParsedValue(text).status().ok(), text);
    }

    void arithmeticGetsItsBrackets() {
        const auto with = [](const char* text, bool onlyNumbers) {
            return QString::fromStdString(withArithmetic(text, onlyNumbers).text());
        };
        QCOMPARE(with("0.25/2", true), QStringLiteral("$(0.25/2)"));
        QCOMPARE(with("0.1+0.2", false), QStringLiteral("$(0.1+0.2)"));
        QCOMPARE(with("track/2", true), QStringLiteral("$(track/2)"));
        for (const char* asItIs : {"3", "-3", "12 cm", "1e-3", "$track", "$(track/2)", "abc", "1,2", "3 }", "3 // c", ""})
            QCOMPARE(with(asItIs, true), QString::fromLatin1(asItIs));
        QCOMPARE(with("pictures/deck.png", false), QStringLiteral("pictures/deck.png"));
    }

    void numbers() {
        QCOMPARE(plainNumber(0.1), std::string("0.1"));
        QCOMPARE(plainNumber(-0.0), std::string("0"));
        QCOMPARE(plainNumber(200000), std::string("200000"));
        QCOMPARE(plainNumber(1e300), std::string("1e+300"));
        Property degrees;
        degrees.unit = "deg";
        degrees.scale = 3.14159265358979323846 / 180;
        for (const double angle : {90.0, 30.0, -45.0, 0.1, 179.999, 33.3})
            QCOMPARE(numberOf(degrees, angle * degrees.scale), plainNumber(angle));
    }

    void ranges() {
        Property p;
        p.unit = "ohm";
        p.minimum = 1e-6;
        p.maximum = 1e9;
        QCOMPARE(unitAndRange(p), std::string("ohm, from 1e-6 to 1e9"));
        p.minimum = 0;
        p.minExclusive = true;
        QCOMPARE(unitAndRange(p), std::string("ohm, above 0, at most 1e9"));
        p.minimum = -HUGE_VAL;
        p.maximum = HUGE_VAL;
        QCOMPARE(unitAndRange(p), std::string("ohm"));
    }
};

QTEST_APPLESS_MAIN(ValueTextTest)
#include "value_text_test.moc"
