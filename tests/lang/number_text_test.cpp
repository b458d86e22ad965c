// Numbers that are changed in the text of a value, as by dragging: what was written otherwise is kept.
#include <QtTest>

#include "lang/number_text.h"

using namespace trundle;

class NumberTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void steppedNumbers_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        QTest::addColumn<QString>("text");
        int row = 0;
        const auto add = [&](double value, double step, const char* text) {
            QTest::addRow("%d %s", ++row, text) << value << step << text;
        };
        add(0.35, 0.01, "0.35");
        add(0.354, 0.01, "0.35");
        add(0.356, 0.01, "0.36");
        add(-1.5, 0.001, "-1.5");
        add(-0.0004, 0.001, "0");
        add(0.0004, 0.001, "0");
        add(100, 0.01, "100");
        add(120, 1, "120");
        add(120.6, 1, "121");
        add(120.6, 10, "121");
        add(0.123456789, 1e-6, "0.123457");
        add(0.25, 0.25, "0.2"); // as many digits as 0.1 has
        add(0.5, 0.5, "0.5");
        add(1e-13, 1e-15, "0");
        add(1.5e-12, 1e-15, "0.000000000002");
        add(123456789012, 0.1, "123456789012");
    }
    void steppedNumbers() {
        QFETCH(double, value);
        QFETCH(double, step);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(steppedNumber(value, step)), text);
    }

    void hugeNumbers() {
        QCOMPARE(steppedNumber(1e300, 0.1).size(), std::size_t{301});
        QCOMPARE(steppedNumber(-1e300, 0.1).size(), std::size_t{302});
    }

    void replacedNumbers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QList<double>>("before");
        QTest::addColumn<QList<double>>("after");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("result");
        const auto row = [](const char* text, const QList<double>& before, const QList<double>& after, const char* unit,
                            const char* result) { QTest::newRow(text) << text << before << after << unit << result; };
        row("1,2,3", {1, 2, 3}, {1, 5.25, 3}, "m", "1,5.25,3");
        row("1 , 2 ,  3", {1, 2, 3}, {4, 2, 6}, "m", "4 , 2 ,  6");
        row("$(2*3), 1", {6, 1}, {6, 2}, "m", "$(2*3), 2");
        row("$(2*3), 2", {6, 2}, {7, 2}, "m", "7, 2");
        row("$a, $b", {1, 2}, {1, 2.5}, "m", "$a, 2.5");
        row("25 cm, 1", {0.25, 1}, {0.3, 1}, "m", "30 cm, 1");
        row("25cm", {0.25}, {0.257}, "m", "26cm"); // the step is a centimetre
        row("250 mm", {0.25}, {0.2513}, "m", "251 mm"); // never finer than one
        row("0.5 rad", {28.6478897565412}, {57.2957795130823}, "deg", "1 rad");
        row("1, 2", {1, 2}, {1.0000004, 2.1}, "m", "1, 2.1"); // the same number
        row("1, 2", {1, 2}, {1.006, 2}, "m", "1.01, 2");
        row("", {}, {1, 2.5}, "m", "1,2.5");
        row("7", {7}, {1, 2.5}, "m", "1,2.5");
        row("1, 2", {1}, {3, 4}, "m", "3,4");
        row("1e3", {1000}, {1001}, "m", "1001");
        // What differs between the members of a Repeat still does.
        row("$(0.1*index), 0", {0.2, 0}, {0.25, 0}, "m", "$(0.1*index + 0.05), 0");
        row("$( 0.1*index2 )", {0.2}, {0.15}, "m", "$(0.1*index2 - 0.05)");
        row("$index", {1}, {1.5}, "m", "$(index + 0.5)");
        row("$(0.1*index + 0.05)", {0.25}, {0.28}, "m", "$(0.1*index + 0.08)");
        row("$(0.1*index + 0.05)", {0.25}, {0.1}, "m", "$(0.1*index - 0.1)");
        row("$(0.1*index - 0.05)", {0.15}, {0.2}, "m", "$(0.1*index)");
        row("$(0.1*index-0.05)", {0.15}, {0.16}, "m", "$(0.1*index - 0.04)");
        row("$(1 + index)", {2}, {2.5}, "m", "$(1 + index + 0.5)");
        row("$(index*2 - 3*0.5)", {0.5}, {1}, "m", "$(index*2 - 3*0.5 + 0.5)");
        row("$(index + (0.5))", {1.5}, {2}, "m", "$(index + (0.5) + 0.5)");
        row("$(10 cm*index + 5 cm)", {0.15}, {0.25}, "m", "$(10 cm*index + 5 cm + 0.1)");
        row("$(if(index > 1, 0.3, 0.1))", {0.1}, {0.2}, "m", "$(if(index > 1, 0.3, 0.1) + 0.1)");
        row("$(90*index),0,0", {90, 0, 0}, {60, 0, 0}, "deg", "$(90*index - 30),0,0");
        row("$(0.1*indexer)", {0.2}, {0.25}, "m", "0.25");
    }
    void replacedNumbers() {
        QFETCH(QString, text);
        QFETCH(QList<double>, before);
        QFETCH(QList<double>, after);
        QFETCH(QString, unit);
        QFETCH(QString, result);
        const std::vector<double> was(before.begin(), before.end()), now(after.begin(), after.end());
        QCOMPARE(QString::fromStdString(withNumbers(text.toStdString(), was, now, unit.toLatin1(), 0.01)), result);
    }

    void formulasThatBecomeNumbers() {
        using Texts = std::vector<std::string>;
        QCOMPARE(replacedFormulas("$gap, 0.6, $(2*gap)", "1, 0.7, $(2*gap)"), Texts{"$gap"});
        QCOMPARE(replacedFormulas("$gap,$(2*gap)", "1,2"), (Texts{"$gap", "$(2*gap)"}));
        QCOMPARE(replacedFormulas("$place", "1,2,3"), Texts{"$place"}); // of three numbers
        QCOMPARE(replacedFormulas("$(0.1*index),1", "$(0.1*index + 0.05),2"), Texts());
        QCOMPARE(replacedFormulas("", "1,2,3"), Texts());
    }

    /// With a fine step, a change below a millionth still is one.
    void fineSteps() {
        const double before[] = {1}, after[] = {1.0000001};
        QCOMPARE(withNumbers("1", before, after, "m", 1e-9), std::string("1.0000001"));
        QCOMPARE(withNumbers("1", before, after, "m", 1e-3), std::string("1"));
    }
};

QTEST_APPLESS_MAIN(NumberTextTest)
#include "number_text_test.moc"
