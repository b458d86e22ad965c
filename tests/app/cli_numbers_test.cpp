// Numbers in the summaries and the manual of the command line program.
#include <cmath>
#include <limits>

#include <QTest>

#include "cli/numbers.h"

using namespace trundle;

class CliNumbersTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void shortTexts_data() {
        QTest::addColumn<double>("number");
        QTest::addColumn<int>("digits");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](double number, int digits, const char* text) {
            QTest::newRow(text) << number << digits << QByteArray(text);
        };
        row(857.2, 3, "857");
        row(0.014249, 3, "0.0142");
        row(999.4, 3, "999");
        row(999.5, 3, "1000");
        row(-999.7, 3, "-1000");
        row(99999.9, 4, "100000");
        row(1234567, 3, "1230000");
        row(12345678.9, 9, "12345678.9");
        row(0, 3, "0");
        row(2.5e14, 3, "2.5e+14");
        row(2.5e-7, 3, "2.5e-07");
        row(std::numeric_limits<double>::infinity(), 3, "inf");
    }
    void shortTexts() {
        QFETCH(double, number);
        QFETCH(int, digits);
        QCOMPARE(QByteArray::fromStdString(shortText(number, digits)), QTest::currentDataTag());
    }

    void fixedTexts() {
        QCOMPARE(fixedText(-0.004, 2), std::string("0.00"));
        QCOMPARE(fixedText(-0.006, 2), std::string("-0.01"));
        QCOMPARE(fixedText(1234.5678, 1), std::string("1234.6"));
    }

    void counts() {
        QCOMPARE(counted(1, "tick"), std::string("1 tick"));
        QCOMPARE(counted(0, "tick"), std::string("0 ticks"));
    }
};

QTEST_APPLESS_MAIN(CliNumbersTest)
#include "cli_numbers_test.moc"
