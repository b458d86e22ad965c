// Conversion of units.
#include <QTest>
#include <cmath>

#include "base/units.h"

using namespace trundle;

class UnitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void conversions_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<double>("result");
        const auto row = [](double value, const char* from, const char* to, double result) {
            QTest::addRow("%g %s in %s", value, from, to) << value << QString(from) << QString(to) << result;
        };
        row(3, "cm", "m", 0.03);
        row(5, "mm", "m", 0.005);
        row(0.25, "m", "cm", 25);
        row(2, "km", "m", 2000);
        row(250, "g", "kg", 0.25);
        row(10, "ms", "s", 0.01);
        row(2, "min", "s", 120);
        row(180, "deg", "rad", 3.14159265358979312);
        row(1, "rad", "deg", 57.2957795130823229);
        row(60, "rpm", "rad/s", 6.28318530717958623);
        row(2.45, "GHz", "Hz", 2.45e9);
        row(50, "%", "", 0.5);
        row(3, "m/s", "m/s", 3);
        row(36, "km/h", "m/s", 10);
        row(2, "N/mm", "N/m", 2000);
        row(1, "g/cm^3", "kg/m^3", 1000);
        row(7, "dBm", "dBm", 7);
        row(7, "", "", 7);
    }
    void conversions() {
        QFETCH(double, value);
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(double, result);
        const auto converted = convertUnit(value, from.toStdString(), to.toStdString());
        QVERIFY(converted.has_value());
        QVERIFY2(std::abs(*converted - result) <= 1e-15 * std::abs(result), qPrintable(QString::number(*converted, 'g', 17)));
    }

    /// 3 cm converts to exactly the double 0.03: a text in cm and one in m give the same run.
    void roundNumbersStayRound() {
        for (int i = 1; i < 1000; ++i) {
            QCOMPARE(*convertUnit(i, "cm", "m"), i / 100.0);
            QCOMPARE(*convertUnit(i, "mm", "m"), i / 1000.0);
            QVERIFY(*convertUnit(i, "cm", "m") == i / 100.0);
            QVERIFY(*convertUnit(i, "ms", "s") == i / 1000.0);
        }
    }

    void rejectsImpossibleConversions() {
        QVERIFY(!convertUnit(1, "cm", "kg"));
        QVERIFY(!convertUnit(1, "dB", "dBm"));
        QVERIFY(!convertUnit(1, "dBi", "dB"));
        QVERIFY(!convertUnit(1, "cm", ""));
        QVERIFY(!convertUnit(1, "furlong", "m"));
        QVERIFY(!convertUnit(1, "m", "furlong"));
        QVERIFY(!findUnit("CM"));
        QVERIFY(!findUnit(""));
    }

    void thereAndBack() {
        const std::vector<std::string> names = allUnitNames();
        QVERIFY(names.size() > 40);
        for (const std::string& a : names) {
            QVERIFY(findUnit(a));
            for (const std::string& b : names) {
                const auto there = convertUnit(12.5, a, b);
                QCOMPARE(there.has_value(), findUnit(a)->dimension == findUnit(b)->dimension);
                if (there) QVERIFY(std::abs(*convertUnit(*there, b, a) - 12.5) < 1e-12);
            }
        }
    }
};

QTEST_APPLESS_MAIN(UnitsTest)
#include "units_test.moc"
