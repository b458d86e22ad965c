// Changing numbers by dragging.
#include <QTest>

#include "editor/properties/editors/scrub.h"

using namespace trundle;

class ScrubTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void scrubbing_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<double>("steps");
        QTest::addColumn<QString>("to");
        QTest::newRow("unit stays") << "12 cm" << 3.0 << "15 cm";
        QTest::newRow("no blank") << "12cm" << -2.0 << "10cm";
        QTest::newRow("small") << "0.05" << 1.0 << "0.051";
        QTest::newRow("digits stay") << "0.0512" << 1.0 << "0.0522";
        QTest::newRow("zero") << "0" << 5.0 << "0.05";
        QTest::newRow("through zero") << "0.02" << -100.0 << "-0.08";
        QTest::newRow("large") << "1500" << 1.0 << "1600";
        QTest::newRow("none") << "1.25" << 0.2 << "1.25";
    }
    void scrubbing() {
        QFETCH(QString, from);
        QFETCH(double, steps);
        QFETCH(QString, to);
        Property metres;
        metres.unit = "m";
        metres.minimum = -HUGE_VAL;
        metres.maximum = HUGE_VAL;
        const auto scrub = Scrub::of(from.toStdString(), &metres);
        QVERIFY(scrub);
        QCOMPARE(QString::fromStdString(scrub->after(steps)), to);
        QVERIFY(!Scrub::of("$a", &metres) && !Scrub::of("1,2", &metres) && !Scrub::of("", &metres));
    }

    /// A Param has no property, hence neither limits nor a unit of its own.
    void scrubbingWithoutAProperty() {
        QCOMPARE(Scrub::of("0.02", nullptr)->after(-100), std::string("-0.08"));
        QCOMPARE(Scrub::of("5", nullptr)->after(1000), std::string("105"));
        QCOMPARE(Scrub::of("10 deg", nullptr)->after(3), std::string("13 deg"));
        Property turn, open, wide;
        turn.unit = "deg";
        turn.minimum = -HUGE_VAL;
        turn.maximum = HUGE_VAL;
        QCOMPARE(Scrub::of("0.5", &turn)->after(-2), std::string("-1.5"));
        QCOMPARE(Scrub::of("0.5 rad", &turn)->after(1), std::string("0.51 rad"));
        open.minimum = 0;
        open.maximum = 1;
        open.minExclusive = open.maxExclusive = true;
        QCOMPARE(Scrub::of("0.5", &open)->after(1000), std::string("0.99"));
        QCOMPARE(Scrub::of("0.5", &open)->after(-1000), std::string("0.01"));
        QCOMPARE(Scrub::of("7", &open)->after(-1), std::string("6.99")); // what is out of range comes back step by step
        wide.minimum = 0;
        wide.maximum = 0.5;
        QCOMPARE(Scrub::of("0", &wide)->after(1), std::string("0.01"));
        wide.maximum = 2;
        QCOMPARE(Scrub::of("0", &wide)->after(1), std::string("0.01"));
    }

    void scrubbingStaysInRange() {
        Property share;
        share.minimum = 0;
        share.maximum = 1;
        QCOMPARE(Scrub::of("0.5", &share)->after(1000), std::string("1"));
        QCOMPARE(Scrub::of("0.5", &share)->after(-1000), std::string("0"));
        Property length;
        length.unit = "m";
        length.minExclusive = true;
        length.maximum = HUGE_VAL;
        QCOMPARE(Scrub::of("5 cm", &length)->after(-1000), std::string("0.1 cm"));
        Property tick;
        tick.unit = "s";
        tick.minimum = 1e-5;
        tick.maximum = 0.1;
        QCOMPARE(Scrub::of("0.01", &tick)->after(-1000), std::string("0.00001"));
        QCOMPARE(Scrub::of("10 ms", &tick)->after(1000), std::string("100 ms"));
        Property count;
        count.type = PropertyType::Integer;
        count.minimum = 1;
        count.maximum = 10;
        QCOMPARE(Scrub::of("3", &count)->after(4), std::string("7"));
        Property loss; // its upper limit is 0
        loss.minimum = -200;
        loss.maximum = 0;
        QCOMPARE(Scrub::of("0", &loss)->after(-50), std::string("-0.5"));
        QCOMPARE(Scrub::of("0", &loss)->after(50), std::string("0"));
    }
};

QTEST_GUILESS_MAIN(ScrubTest)
#include "scrub_test.moc"
