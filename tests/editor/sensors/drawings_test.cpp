// What the widgets of the Sensors dock draw: gauges, dials, rings, bars and traces, compared with computed places.

#include <cmath>
#include <limits>
#include <numbers>

#include <QVBoxLayout>
#include <QtTest>

#include "editor/sensors/battery_gauge.h"
#include "editor/sensors/card_columns.h"
#include "editor/sensors/heading_dial.h"
#include "editor/sensors/polar_plot.h"
#include "editor/sensors/reading_row.h"
#include "editor/viewport/paint_record.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/theme.h"
#include "run/live/live_state.h"

using namespace trundle;

namespace {

using Drawn = PaintedShape::Kind;

PaintRecord drawn(QWidget& widget) {
    PaintRecord record(widget.size());
    widget.render(&record, {}, {}, QWidget::RenderFlags());
    return record;
}

bool isSolid(const QColor& colour, Ink which) { return colour.rgb() == ink(which).rgb(); }

/// A reading of one number, which a test sets.
struct Source {
    double value = 0, trueValue = 0;
    [[nodiscard]] Reading reading(const char* unit, bool hasTrue = false) {
        Reading reading;
        reading.name = "number";
        reading.signal = "r/d/number";
        reading.unit = unit;
        reading.read = [this](const LiveSnapshot&, double* numbers) { *numbers = value; };
        if (hasTrue) reading.readTrue = [this](const LiveSnapshot&, double* numbers) { *numbers = trueValue; };
        return reading;
    }
};

LiveSnapshot snapshotAt(double time) {
    LiveSnapshot snapshot;
    snapshot.time = time;
    return snapshot;
}

/// The lines of a trace in this colour, each with its number of points.
QList<int> piecesOf(const PaintRecord& record, Ink which) {
    QList<int> pieces;
    for (const PaintedShape& line : record.of(Drawn::Polyline, ink(which)))
        if (!line.points.isEmpty()) pieces << int(line.points.size());
    return pieces;
}

} // namespace

class SensorDrawingsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void gaugeOfABattery_data() {
        QTest::addColumn<double>("level");
        QTest::addColumn<double>("share"); // of the width that is filled
        QTest::addColumn<int>("colour");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, double level, double share, Ink colour, const char* text) {
            QTest::newRow(name) << level << share << int(colour) << QString::fromLatin1(text);
        };
        row("empty", 0, 0, Ink::Error, "0.0 %");
        row("almost empty", 0.099, 0.099, Ink::Error, "9.9 %");
        row("low", 0.1, 0.1, Ink::Warning, "10.0 %");
        row("still low", 0.199, 0.199, Ink::Warning, "19.9 %");
        row("good", 0.2, 0.2, Ink::Good, "20.0 %");
        row("seven tenths", 0.7, 0.7, Ink::Good, "70.0 %");
        row("more than full", 1.3, 1, Ink::Good, "100.0 %");
        row("less than empty", -0.1, 0, Ink::Error, "0.0 %");
    }
    void gaugeOfABattery() {
        QFETCH(double, level);
        QFETCH(double, share);
        QFETCH(int, colour);
        QFETCH(QString, text);
        BatteryGauge gauge;
        gauge.resize(212, 30);
        QVERIFY(drawn(gauge).texts().isEmpty()); // not known yet
        gauge.setLevel(0.5);
        gauge.setLevel(level);
        const PaintRecord record = drawn(gauge);
        QCOMPARE(record.texts(), QStringList{text});
        double filled = 0; // the inside is 12 pixels narrower
        for (const PaintedShape& shape : record.of(Drawn::Polygon))
            if (isSolid(shape.brush.color(), Ink(colour))) filled = std::max(filled, shape.points.boundingRect().width());
        QVERIFY2(std::abs(filled - 200 * share) < 0.01, QByteArray::number(filled));
        gauge.setLevel(std::nullopt);
        QVERIFY(drawn(gauge).texts().isEmpty());
    }

    /// x of the world is to the right, headings go counter-clockwise; the head of a needle opens backwards.
    void needlesOfADial() {
        HeadingDial dial;
        dial.resize(200, 140);
        QVERIFY(drawn(dial).of(Drawn::Line, ink(Ink::Accent)).empty());
        dial.setHeading(0.3, {});
        for (const auto& [heading, trueHeading] : {std::pair(0.5, 2.0), {-2.2, 0.1}, {-2.2, -1.2}}) {
            dial.setHeading(heading, trueHeading);
            const PaintRecord record = drawn(dial);
            for (const auto& [angle, colour] : {std::pair(heading, Ink::Accent), {trueHeading, Ink::Good}}) {
                const auto needle = record.of(Drawn::Line, ink(colour));
                QCOMPARE(needle.size(), std::size_t(3));
                const QPointF middle(100, 70), way = needle[0].points[1] - middle;
                QVERIFY((needle[0].points[0] - middle).manhattanLength() < 1e-9);
                QVERIFY(std::abs(std::remainder(std::atan2(-way.y(), way.x()) - angle, 2 * std::numbers::pi)) < 1e-9);
                for (const int barb : {1, 2}) {
                    QVERIFY((needle[std::size_t(barb)].points[0] - needle[0].points[1]).manhattanLength() < 1e-9);
                    const QPointF end = needle[std::size_t(barb)].points[1] - middle;
                    QVERIFY(std::hypot(end.x(), end.y()) < std::hypot(way.x(), way.y()));
                }
            }
        }
        const auto placeOf = [&](const QString& words) {
            for (const PaintedShape& text : drawn(dial).of(Drawn::Text))
                if (text.text == words) return text.points[0];
            return QPointF(-1, -1);
        };
        QVERIFY(placeOf(QStringLiteral("0°")).x() > 140 && placeOf(QStringLiteral("180°")).x() < 60);
        QVERIFY(placeOf(QStringLiteral("90°")).y() < 30 && placeOf(QStringLiteral("-90°")).y() > 110);
        dial.setHeading(std::numeric_limits<double>::quiet_NaN(), {});
        QVERIFY(drawn(dial).of(Drawn::Line, ink(Ink::Accent)).empty() && drawn(dial).of(Drawn::Line, ink(Ink::Good)).empty());
    }

    void ringsOfAPlot_data() {
        QTest::addColumn<double>("reach");
        QTest::addColumn<QList<double>>("rings");
        QTest::newRow("4 m") << 4. << QList<double>{2, 4};
        QTest::newRow("0.5 m") << 0.5 << QList<double>{0.2, 0.4};
        QTest::newRow("3 m") << 3. << QList<double>{1, 2, 3};
        QTest::newRow("11 m") << 11. << QList<double>{5, 10};
        QTest::newRow("60 m") << 60. << QList<double>{20, 40, 60};
    }
    /// At most three, at round distances; another sensor has its own.
    void ringsOfAPlot() {
        QFETCH(double, reach);
        QFETCH(QList<double>, rings);
        PolarPlot plot;
        plot.resize(606, 606);
        const auto show = [&](double range) {
            auto fan = std::make_shared<RangeModel>();
            fan->maxRange = range;
            fan->beams = 1;
            fan->layers = 1;
            fan->directions = {Vec3::UnitX()};
            plot.setFan(fan);
            return plot.grab().toImage();
        };
        (void)show(1.7 * reach);
        const QImage image = show(reach);
        const double scale = 300 / reach;
        const auto isRing = [&](double distance) { // to the lower left, where no number is
            const double at = distance * scale * std::sqrt(0.5);
            const QColor ground = plot.palette().color(QPalette::AlternateBase);
            for (const double d : {-2., -1., 0., 1., 2.}) {
                const QColor c = image.pixelColor(int(std::lround(303 - at + d)), int(std::lround(303 + at - d)));
                if (std::abs(c.red() - ground.red()) > 5) return true;
            }
            return false;
        };
        for (int i = 4; i < 60; ++i) {
            const double distance = reach * i / 60;
            const bool near = std::ranges::any_of(rings, [&](double ring) { return std::abs(ring - distance) < 0.02 * reach; });
            if (!near) QVERIFY2(!isRing(distance), QByteArray::number(distance));
        }
        for (const double ring : rings) QVERIFY2(isRing(std::min(ring, reach * 0.9995)), QByteArray::number(ring));
    }

    /// A heading that passes half a turn jumps, and so does a reading that was interrupted or is not there.
    void aTraceHasGaps_data() {
        QTest::addColumn<bool>("isAngle");
        QTest::addColumn<QList<double>>("values"); // 99: not measured; 77: interrupted before
        QTest::addColumn<QList<int>>("pieces");
        QTest::newRow("plain") << false << QList<double>{3, 3.1, -3.1, -3} << QList<int>{4};
        QTest::newRow("angle") << true << QList<double>{3, 3.1, -3.1, -3} << QList<int>{2, 2};
        QTest::newRow("angle that jumps twice") << true << QList<double>{3, -3, 3, 2} << QList<int>{2};
        QTest::newRow("angle of less than half a turn") << true << QList<double>{1.5, -1.5, 0} << QList<int>{3};
        QTest::newRow("not measured") << false << QList<double>{1, 2, 99, 3, 4, 5} << QList<int>{2, 3};
        QTest::newRow("interrupted") << false << QList<double>{1, 2, 3, 77, 4, 5} << QList<int>{3, 2};
    }
    void aTraceHasGaps() {
        QFETCH(bool, isAngle);
        QFETCH(QList<double>, values);
        QFETCH(QList<int>, pieces);
        Source source;
        Reading reading = source.reading("rad");
        reading.isAngle = isAngle;
        ReadingRow row(reading);
        row.resize(300, row.sizeHint().height());
        double time = 0;
        for (const double value : values) {
            if (value == 77) {
                row.interrupt();
                continue;
            }
            source.value = value;
            row.take(snapshotAt(time += 0.5), value != 99);
        }
        QCOMPARE(piecesOf(drawn(row), Ink::Accent), pieces);
    }

    /// From the oldest value at the left to the newest at the right, high values higher; true values in a colour of their own.
    void placesOfATrace() {
        Source source;
        ReadingRow row(source.reading("V", true));
        row.showTrue(true);
        row.resize(301, row.sizeHint().height());
        for (const auto& [time, value] : {std::pair(10., 2.), {11., 6.}, {14., -2.}}) {
            source.value = value;
            source.trueValue = value == 6 ? 4 : value;
            row.take(snapshotAt(time), true);
        }
        const PaintRecord record = drawn(row);
        const auto measured = record.of(Drawn::Polyline, ink(Ink::Accent)), real = record.of(Drawn::Polyline, ink(Ink::Good));
        QVERIFY(!measured.empty() && !real.empty());
        const QPolygonF& points = measured.back().points;
        QCOMPARE(points.size(), 3);
        QVERIFY(std::abs(points[0].x()) < 1e-6 && std::abs(points[1].x() - 301 / 4.) < 1e-6 &&
                std::abs(points[2].x() - 301) < 1e-6);
        const double perUnit = (points[2].y() - points[1].y()) / 8; // 8 V and a margin of 8 % on both sides in 24 pixels
        QVERIFY(std::abs(perUnit - 24 / (1.16 * 8)) < 1e-6);
        QVERIFY(std::abs(points[0].y() - points[1].y() - 4 * perUnit) < 1e-6);
        QVERIFY(std::abs(real.back().points[1].y() - points[1].y() - 2 * perUnit) < 1e-6);
        const auto zero = record.of(Drawn::Line, ink(Ink::Line));
        QCOMPARE(zero.size(), std::size_t(1));
        QVERIFY(std::abs(zero[0].points[0].y() - (points[2].y() - 2 * perUnit)) < 1e-6);
        QVERIFY(points[2].y() < row.height() && points[1].y() > row.height() - 32);
    }

    /// Limits widen to values beyond them; without limits noise of rounding is no trace.
    void heightOfATrace_data() {
        QTest::addColumn<QList<double>>("limits");
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<double>("swing"); // between both values, as part of the height
        QTest::newRow("within limits") << QList<double>{0, 4} << QList<double>{1, 2} << 0.25;
        QTest::newRow("above them") << QList<double>{0, 4} << QList<double>{1, 6} << 5. / 6;
        QTest::newRow("below them") << QList<double>{0, 4} << QList<double>{-1, 1} << 2. / 5;
        QTest::newRow("without limits") << QList<double>{} << QList<double>{1, 2} << 1 / 1.16;
        QTest::newRow("without a change") << QList<double>{} << QList<double>{1000, 1000.1} << 0.1 / 1.1;
    }
    void heightOfATrace() {
        QFETCH(QList<double>, limits);
        QFETCH(QList<double>, values);
        QFETCH(double, swing);
        Source source;
        Reading reading = source.reading("V");
        if (!limits.isEmpty()) reading.limits = std::pair(limits[0], limits[1]);
        ReadingRow row(reading);
        row.resize(300, row.sizeHint().height());
        for (qsizetype i = 0; i < values.size(); ++i) {
            source.value = values[i];
            row.take(snapshotAt(double(i)), true);
        }
        const auto lines = drawn(row).of(Drawn::Polyline, ink(Ink::Accent));
        QVERIFY(!lines.empty());
        const QPolygonF& points = lines.back().points;
        QVERIFY2(std::abs((points[0].y() - points[1].y()) / 24 - swing) < 0.01,
                 QByteArray::number((points[0].y() - points[1].y()) / 24));
    }

    void barsBeginAtZero_data() {
        QTest::addColumn<QList<double>>("limits");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("from"); // parts of the width
        QTest::addColumn<double>("to");
        QTest::newRow("above 0") << QList<double>{-2, 6} << 4. << 0.25 << 0.75;
        QTest::newRow("below 0") << QList<double>{-2, 6} << -1. << 0.125 << 0.25;
        QTest::newRow("beyond the limit") << QList<double>{-2, 6} << 60. << 0.25 << 1.;
        QTest::newRow("0 below the limits") << QList<double>{2, 6} << 3. << 0. << 0.25;
        QTest::newRow("0 above the limits") << QList<double>{-6, -2} << -3. << 0.75 << 1.;
    }
    /// The mark is the true value.
    void barsBeginAtZero() {
        QFETCH(QList<double>, limits);
        QFETCH(double, value);
        QFETCH(double, from);
        QFETCH(double, to);
        Source source{value, 0.75 * limits[0] + 0.25 * limits[1]};
        Reading reading = source.reading("N", true);
        reading.limits = std::pair(limits[0], limits[1]);
        ReadingRow row(reading);
        row.showTrue(true);
        row.resize(400, row.sizeHint().height());
        row.take(snapshotAt(1), true);
        const PaintRecord record = drawn(row);
        QRectF bar, mark;
        for (const PaintedShape& shape : record.of(Drawn::Polygon)) {
            if (isSolid(shape.brush.color(), Ink::Accent)) bar = shape.points.boundingRect();
            if (isSolid(shape.brush.color(), Ink::Good)) mark = shape.points.boundingRect();
        }
        QVERIFY2(std::abs(bar.left() - 400 * from) < 0.01 && std::abs(bar.right() - 400 * to) < 0.01,
                 QByteArray::number(bar.left()) + " " + QByteArray::number(bar.right()));
        QVERIFY2(std::abs(mark.center().x() - 100) < 0.01, QByteArray::number(mark.center().x()));
    }

    void textsOfReadings() {
        Source source;
        Reading named = source.reading("");
        named.names = std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"", "wall", "box"});
        Reading pressed = source.reading("");
        pressed.type = SignalType::Boolean;
        ReadingRow object(named), flag(pressed);
        QCOMPARE(object.text(), QStringLiteral("–"));
        for (const auto& [value, name, is] : {std::tuple(-1., "none", "true"),
                                              {0., "none", "false"},
                                              {1., "wall", "true"},
                                              {2., "box", "true"},
                                              {3., "none", "true"}}) {
            source.value = value;
            object.take(snapshotAt(value), true);
            flag.take(snapshotAt(value), true);
            QCOMPARE(object.text(), QLatin1String(name));
            QCOMPARE(flag.text(), QLatin1String(is));
        }
        flag.take(snapshotAt(9), false);
        QCOMPARE(flag.text(), QStringLiteral("–"));
        Reading command = source.reading("V");
        QVERIFY(!ReadingRow(command).toolTip().contains(QStringLiteral("command")));
        command.commanded = true;
        QVERIFY(ReadingRow(command).toolTip().contains(QStringLiteral("command")));
        QVERIFY(ReadingRow(command).toolTip().contains(QStringLiteral("r/d/number")));
    }

    /// Only the same quantity is taken over, with its new source and its trace.
    void anotherBindingOfAReading() {
        Source source{1, 2}, other{7, 8};
        Reading reading = source.reading("m", true);
        reading.limits = std::pair(0., 9.);
        ReadingRow row(reading);
        row.take(snapshotAt(1), true);
        const auto changed = [&](auto change) {
            Reading another = other.reading("m", true);
            another.limits = std::pair(0., 5.);
            change(another);
            return row.rebind(another);
        };
        QVERIFY(!changed([](Reading& r) { r.name = "numbers"; }));
        QVERIFY(!changed([](Reading& r) { r.signal += "s"; }));
        QVERIFY(!changed([](Reading& r) { r.count = 2; }));
        QVERIFY(!changed([](Reading& r) { r.unit = "s"; }));
        QVERIFY(!changed([](Reading& r) { r.readTrue = nullptr; }));
        QVERIFY(!changed([](Reading& r) { r.limits.reset(); }));
        row.take(snapshotAt(2), true);
        QCOMPARE(row.text(), QStringLiteral("1.000 m"));
        QVERIFY(changed([](Reading&) {}));
        row.take(snapshotAt(3), true);
        QCOMPARE(row.text(), QStringLiteral("7.000 m"));
        QCOMPARE(row.trueText(), QStringLiteral("8.000 m"));
        QCOMPARE(row.trace().size(), std::size_t(3));
        QCOMPARE(row.trace().value(2, 1), 8.);
    }

    /// More than two numbers have a line of their own; what has limits a bar, what is no time and no object a trace.
    void heightsOfRows() {
        Source source;
        const auto high = [&](auto change, bool showsTrue = false) {
            Reading reading = source.reading("m", true);
            change(reading);
            ReadingRow row(reading);
            row.showTrue(showsTrue);
            return row.sizeHint().height();
        };
        const auto same = [](Reading&) {};
        const int one = high(same), line = high(same, true) - one;
        QVERIFY(line > 8);
        QCOMPARE(high([](Reading& r) { r.count = 2; }), one);
        QCOMPARE(high([](Reading& r) { r.count = 3; }), one + line);
        QCOMPARE(high([](Reading& r) { r.limits = std::pair(0., 1.); }), one + 9);
        QCOMPARE(high([](Reading& r) { r.limits = std::pair(0., 1.), r.count = 2; }), one);
        QCOMPARE(high([](Reading& r) { r.name = "time"; }), one - 29);
        QCOMPARE(high([](Reading& r) { r.names = std::make_shared<const std::vector<std::string>>(); }), one - 29);
        QCOMPARE(high([](Reading& r) { r.readTrue = nullptr; }, true), one);
    }

    /// Each card is put below the shortest column so far.
    void cardsFillTheShortestColumn() {
        CardColumns columns;
        columns.resize(2 * (scaledToFont(250) + 6) + 10, 100);
        std::vector<QWidget*> cards;
        for (const int high : {100, 40, 30, 50, 20}) {
            auto* card = new QWidget;
            card->setFixedHeight(high);
            auto* layout = new QVBoxLayout(card);
            layout->addSpacing(high);
            layout->setContentsMargins({});
            cards.push_back(card);
        }
        columns.setCards(cards);
        const int left = cards[0]->x(), right = cards[1]->x();
        QVERIFY(left > 0 && right > left + cards[0]->width());
        QCOMPARE(right + cards[1]->width() + left, columns.width() - (columns.width() - 6) % 2);
        const auto is = [&](int card, int x, int y) { return cards[std::size_t(card)]->pos() == QPoint(x, y); };
        QVERIFY(is(0, left, 6) && is(1, right, 6));
        QVERIFY(is(2, right, 6 + 40 + 6));
        QVERIFY(is(3, right, 6 + 40 + 6 + 30 + 6)); // 88 is above 112
        QVERIFY(is(4, left, 6 + 100 + 6));
        QCOMPARE(columns.minimumHeight(), 6 + 40 + 6 + 30 + 6 + 50 + 6);
        columns.resize(300, 100); // one column
        columns.arrange();
        QVERIFY(is(4, left, 6 + 100 + 6 + 40 + 6 + 30 + 6 + 50 + 6));
    }
};

QTEST_MAIN(SensorDrawingsTest)
#include "drawings_test.moc"
