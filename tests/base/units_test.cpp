// Conversion of units.
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/units.h"

using namespace trundle;

namespace {

/// What a unit measures: its factor to SI, and the exponents of m, kg, s, A, rad, bit, K and cd.
struct Measure {
    double factor = 1;
    std::array<int, 8> exponents{};
};

struct Symbol {
    std::string text;
    Measure measure;
};

/// The symbols without prefixes; those of several letters first, so that the longest is taken.
const Symbol kSymbols[] = {{"rpm", {2 * M_PI / 60, {0, 0, -1, 0, 1, 0}}},
                           {"rad", {1, {0, 0, 0, 0, 1, 0}}},
                           {"deg", {M_PI / 180, {0, 0, 0, 0, 1, 0}}},
                           {"bit", {1, {0, 0, 0, 0, 0, 1}}},
                           {"min", {60, {0, 0, 1, 0, 0, 0}}},
                           {"ohm", {1, {2, 1, -3, -2, 0, 0}}},
                           {"Hz", {1, {0, 0, -1, 0, 0, 0}}},
                           {"m", {1, {1, 0, 0, 0, 0, 0}}},
                           {"g", {1e-3, {0, 1, 0, 0, 0, 0}}},
                           {"s", {1, {0, 0, 1, 0, 0, 0}}},
                           {"h", {3600, {0, 0, 1, 0, 0, 0}}},
                           {"N", {1, {1, 1, -2, 0, 0, 0}}},
                           {"V", {1, {2, 1, -3, -1, 0, 0}}},
                           {"A", {1, {0, 0, 0, 1, 0, 0}}},
                           {"H", {1, {2, 1, -2, -2, 0, 0}}},
                           {"W", {1, {2, 1, -3, 0, 0, 0}}},
                           {"J", {1, {2, 1, -2, 0, 0, 0}}},
                           {"C", {1, {0, 0, 1, 1, 0, 0}}},
                           {"K", {1, {0, 0, 0, 0, 0, 0, 1}}},
                           {"cd", {1, {0, 0, 0, 0, 0, 0, 0, 1}}},
                           {"lx", {1, {-2, 0, 0, 0, 0, 0, 0, 1}}}};

/// Multiplies out "kgm^2" or "rad/s/V"; empty for a name that it cannot read. A prefix stands before the first symbol of a factor.
std::optional<Measure> measureOf(std::string_view name) {
    Measure measure;
    int sign = 1;
    bool first = true;
    while (!name.empty()) {
        if (name.front() == '/') {
            sign = -1;
            first = true;
            name.remove_prefix(1);
            continue;
        }
        const auto symbolAt = [](std::string_view text) {
            return std::ranges::find_if(kSymbols, [&](const Symbol& s) { return text.starts_with(s.text); });
        };
        static const std::map<char, double> prefixes{{'c', 1e-2}, {'m', 1e-3}, {'u', 1e-6}, {'k', 1e3}, {'M', 1e6}, {'G', 1e9}};
        double prefix = 1;
        const auto known = prefixes.find(name.front());
        const bool alone = name.starts_with("min") || name.size() == 1 || name[1] == '/' || name[1] == '^';
        const bool prefixed = first ? !alone : symbolAt(name) == std::end(kSymbols);
        if (prefixed && known != prefixes.end() && symbolAt(name.substr(1)) != std::end(kSymbols)) {
            prefix = known->second;
            name.remove_prefix(1);
        }
        first = false;
        const auto symbol = symbolAt(name);
        if (symbol == std::end(kSymbols)) return std::nullopt;
        name.remove_prefix(symbol->text.size());
        int power = sign;
        if (name.size() > 1 && name.front() == '^') {
            power *= name[1] - '0';
            name.remove_prefix(2);
        }
        measure.factor *= std::pow(prefix * symbol->measure.factor, power);
        for (std::size_t i = 0; i < 8; ++i) measure.exponents[i] += power * symbol->measure.exponents[i];
    }
    return measure;
}

} // namespace

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
        row(2000, "mAh", "Ah", 2);
        row(2, "Ah", "C", 7200);
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

    /// Each unit of the table against its name: prefixes and symbols multiplied out. Those of one dimension measure the same.
    void eachUnitIsWhatItsNameSays() {
        std::map<std::string, Measure> dimensions;
        int checked = 0;
        for (const std::string& name : allUnitNames()) {
            if (name.starts_with("dB") || name == "%" || name == "ppm" || name == "degC") continue; // scales of their own
            const std::optional<Measure> measure = measureOf(name);
            QVERIFY2(measure, name.c_str());
            const UnitInfo* unit = findUnit(name);
            QVERIFY2(std::abs(unit->factor / measure->factor - 1) < 1e-12, name.c_str());
            Measure& first = dimensions.try_emplace(std::string(unit->dimension), *measure).first->second;
            QVERIFY2(first.exponents == measure->exponents, name.c_str());
            ++checked;
        }
        QVERIFY(checked > 60);
        QCOMPARE(findUnit("%")->factor, 0.01);
        for (const char* logarithmic : {"dB", "dBm", "dBi"}) QCOMPARE(findUnit(logarithmic)->factor, 1.0);
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

    void productsOfUnits_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<double>("factor"); // 0: not the same
        const auto row = [](const char* from, const char* to, double factor) {
            QTest::newRow(qPrintable(QString("%1 as %2").arg(from, to))) << QString(from) << QString(to) << factor;
        };
        row("kg m^2/s^2", "Nm", 1);
        row("kg m^2/s^2", "J", 1);
        row("kg m^2/s^2", "mNm", 1000);
        row("kg m^2/s^2", "Nm/deg", std::numbers::pi / 180);
        row("m rad/s", "km/h", 3.6);
        row("1/s", "rpm", 30 / std::numbers::pi);
        row("1/s", "Hz", 1);
        row("kN", "kg m/s^2", 1000);
        row("kg m^2/s^2", "N", 0);
        row("1/s", "", 0);
        row("", "1/s", 0);
        row("kg m^x", "kg", 0);
        row("kg furlong", "kg", 0);
    }
    void productsOfUnits() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(double, factor);
        const auto converted = convertUnit(2, from.toStdString(), to.toStdString());
        QCOMPARE(converted.has_value(), factor != 0);
        if (converted) QVERIFY(std::abs(*converted - 2 * factor) < 1e-12 * factor);
    }
    void namesOfProducts() {
        for (const std::string& unit : allUnitNames()) { // each unit is itself, or one of several that are alike
            const auto exponents = exponentsOf(unit);
            if (!exponents) continue;
            const std::string name = unitOfProduct(*exponents);
            QVERIFY2(convertUnit(1, name, unit).has_value(), (name + ", " + unit).c_str());
            QVERIFY(*exponentsOf(name) == *exponents);
        }
        QVERIFY(!exponentsOf("dBm") && !exponentsOf("degC") && !exponentsOf("furlong"));
        QCOMPARE(unitOfProduct({}), std::string());
        QCOMPARE(unitOfProduct({-1, 0, 0, 0, 0, 0}), std::string("1/m"));
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
