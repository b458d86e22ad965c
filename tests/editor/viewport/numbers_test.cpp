// The text of edited vectors: only changed numbers are rewritten, with as few digits as the step allows.
#include <QtTest>

#include "lang/number_text.h"

using namespace trundle;

class NumbersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aNumberHasAsFewDigitsAsItsStepAllows() {
        QCOMPARE(steppedNumber(0.35000000000000003, 1e-6), std::string("0.35"));
        QCOMPARE(steppedNumber(-1.5, 1e-6), std::string("-1.5"));
        QCOMPARE(steppedNumber(-1e-9, 1e-6), std::string("0"));
        QCOMPARE(steppedNumber(12, 1e-6), std::string("12"));
        QCOMPARE(steppedNumber(100, 1), std::string("100"));
        QCOMPARE(steppedNumber(0.123456789, 1e-3), std::string("0.123"));
        QCOMPARE(steppedNumber(1234567.5, 1e-4), std::string("1234567.5"));
        QCOMPARE(steppedNumber(1e300, 1e-6).size(), std::size_t(301));
    }

    void rewritesOnlyChangedNumbers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        // From 0.1, 0.2, 0.3 to 0.1, 0.25, 0.3.
        QTest::newRow("plain") << "0.1,0.2,0.3"
                               << "0.1,0.25,0.3";
        QTest::newRow("blanks stay") << "0.1 ,  0.2,\n  0.3"
                                     << "0.1 ,  0.25,\n  0.3";
        QTest::newRow("formulas stay") << "$x, 0.2, $(a/2)"
                                       << "$x, 0.25, $(a/2)";
        QTest::newRow("a formula that changes becomes a number") << "0.10, $(a + 1), .3"
                                                                 << "0.10, 0.25, .3";
        QTest::newRow("units stay") << "10cm, 20 cm, 300 mm"
                                    << "10cm, 25 cm, 300 mm";
        QTest::newRow("digits stay") << "1e-1, +0.2, 0.300"
                                     << "1e-1, 0.25, 0.300";
        QTest::newRow("nothing there") << ""
                                       << "0.1,0.25,0.3";
        QTest::newRow("two only") << "0.1,0.2"
                                  << "0.1,0.25,0.3";
        QTest::newRow("no value at all") << "} what {"
                                         << "0.1,0.25,0.3";
    }
    void rewritesOnlyChangedNumbers() {
        QFETCH(const QString, text);
        QFETCH(const QString, expected);
        const double before[] = {0.1, 0.2, 0.3}, after[] = {0.1, 0.25, 0.3};
        QCOMPARE(QString::fromStdString(withNumbers(text.toStdString(), before, after, "m", 1e-6)), expected);
    }

    void anglesKeepTheirUnit() {
        const double before[] = {0, 0, 90}, after[] = {45, 0, 90};
        QCOMPARE(withNumbers("0 deg, 0, 90", before, after, "deg", 1e-4), std::string("45 deg, 0, 90"));
        QCOMPARE(withNumbers("0 rad,0,90", before, after, "deg", 1e-4), std::string("0.785398 rad,0,90"));
    }
};

QTEST_APPLESS_MAIN(NumbersTest)
#include "numbers_test.moc"
