// Reading and writing the text of values.
#include <QTest>

#include "lang/tree.h"
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

    void listsOfWords_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QStringList>("words");
        const auto row = [](const char* typed, const QStringList& words) { QTest::newRow(typed) << typed << words; };
        row("a,b", {"a", "b"});
        row("a , b", {"a", "b"});
        row("two words, b", {"two words", "b"});
        row("a b,\"c,d e\",f", {"a b", "c,d e", "f"});
        row("x y,\"c \\\" d, e\",f", {"x y", "c \" d, e", "f"});
        row("3d, say \"hi\", true", {"3d", "say \"hi\"", "true"});
        row("robot*,arm?", {"robot*", "arm?"});
        row("one two", {"one two"});
    }
    /// What is typed into a field of names is written as a value of as many elements, each of which is read as it was typed.
    void listsOfWords() {
        QFETCH(QString, typed);
        QFETCH(QStringList, words);
        const ParsedValue value = listOfWords(typed.toStdString());
        QVERIFY2(value.status().ok(), value.text().c_str());
        QStringList read;
        for (const Element& e : value.value().elements)
            read << QString::fromStdString(plainText(value.text().substr(e.range.begin, e.range.size())));
        QCOMPARE(read, words);
    }

    void tidiedTexts() {
        QCOMPARE(tidied(" \t a b\r\n"), std::string("a b"));
        QCOMPARE(tidied("\xE2\x88\x92"
                        "1,\xE2\x88\x92"
                        "2"),
                 std::string("-1,-2"));
        QCOMPARE(tidied(" \n"), std::string());
    }

    /// The separator is that of the first list of the text, also one in a block.
    void separators() {
        const auto of = [](const char* text) {
            return separatorOf(*parse(std::make_shared<const SourceText>("t.sim", std::string(text)), 0));
        };
        QCOMPARE(of("Tick = 1\n"), std::string(","));
        QCOMPARE(of("x = 1, 2,3\ny = 1,2\n"), std::string(", "));
        QCOMPARE(of("A a { b = 3 B b { x = 1 , 2 } }\ny = 1, 2\n"), std::string(","));
        QCOMPARE(of("A a { b = 3 B b { x = 1, 2 } }\ny = 1,2\n"), std::string(", "));
    }

    void notOneValue() {
        for (const char* text : {"", " ", "3 }", "3 } x {", "a = 3", "3 // c", "1,", ",1", "\"open", "$(1+", "3 4", "Box b { }",
                                 "3\nTick = 4", "{", "/*"})
            QVERIFY2(!ParsedValue(text).status().ok(), text);
        for (const char* text : {"3", "12 cm", "1, 2 ,3", "$a", "$(a + 1)", "\"a b\"", "true", "x/y.png,z", "-1e-3 m/s"})
            QVERIFY2(ParsedValue(text).status().ok(), text);
    }

    void messagesNameOnlyWhatIsInTheText() {
        for (const auto& [text, message] : {std::pair{"}", "a value is missing"},
                                            {"// x", "a value is missing"},
                                            {"#import a.sim", "a value is missing"},
                                            {"1,", "an element is missing after this comma"},
                                            {"= 3", "one `=` is enough"},
                                            {"Box {", "a block is not a value"}})
            QCOMPARE(ParsedValue(text).status().error().message, std::string(message));
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
        QCOMPARE(plainNumber(1e-6), std::string("0.000001"));
        QCOMPARE(plainNumber(-9.5e-7), std::string("-9.5e-07"));
        QCOMPARE(plainNumber(-999999999999999.), std::string("-999999999999999"));
        QCOMPARE(plainNumber(1e15), std::string("1e+15"));
        for (double n = 1.0 / 3; n < 1e290; n *= 1234.56789) {
            QCOMPARE(std::strtod(plainNumber(n).c_str(), nullptr), n);
            QCOMPARE(std::strtod(plainNumber(-1 / n).c_str(), nullptr), -1 / n);
        }
        QCOMPARE(rounded(-0.0), std::string("0"));
        QCOMPARE(rounded(1234567.8), std::string("1.23457e+06"));
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
        p.minimum = -12345;
        p.maxExclusive = true;
        QCOMPARE(unitAndRange(p), std::string("ohm, above -12345"));
        p.minExclusive = false;
        p.maximum = 0.0001;
        QCOMPARE(unitAndRange(p), std::string("ohm, at least -12345, below 0.0001"));
        p.minimum = -HUGE_VAL;
        p.maximum = 250000;
        QCOMPARE(unitAndRange(p), std::string("ohm, below 250000"));
        p.maximum = 2.5e-5;
        QCOMPARE(unitAndRange(p), std::string("ohm, below 2.5e-5"));
        p.maximum = 1e10;
        p.unit.clear();
        QCOMPARE(unitAndRange(p), std::string("below 1e10"));
        p.type = PropertyType::Text;
        p.unit = "m";
        QCOMPARE(unitAndRange(p), std::string("m"));
    }
};

QTEST_APPLESS_MAIN(ValueTextTest)
#include "value_text_test.moc"
