// Antenna patterns and their gains.
#include <QtTest>

#include "radio/antenna_pattern.h"

using namespace trundle;

namespace {

constexpr double kDegree = M_PI / 180;

bool near(double a, double b, double tolerance = 0.001) { return std::abs(a - b) <= tolerance; }

/// cos^n with n = 2: 90 degrees between the points of half power.
AntennaPattern lobe(double n) { return AntennaPattern::of(AntennaModel::Cosine, 10 * std::log10(2 * (n + 1))); }

} // namespace

class AntennaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cosineLobes_data() {
        QTest::addColumn<double>("n");
        QTest::addColumn<double>("peak");
        QTest::addColumn<double>("width");
        QTest::newRow("1") << 1. << 6.0206 << 120.;
        QTest::newRow("2") << 2. << 7.7815 << 90.;
        QTest::newRow("4") << 4. << 10.0 << 65.53;
        QTest::newRow("8") << 8. << 12.5527 << 47.02;
    }
    void cosineLobes() {
        QFETCH(double, n);
        QFETCH(double, peak);
        QFETCH(double, width);
        const AntennaPattern p = lobe(n);
        QVERIFY(near(p.peak(), peak));
        QVERIFY(near(p.gain(width / 2 * kDegree, 0), peak - 3.0103, 0.01));
        QVERIFY(near(p.gain(0, -width / 2 * kDegree), peak - 3.0103, 0.01));
        QCOMPARE(p.gain(100 * kDegree, 0), AntennaPattern::kFloor);
        const AntennaPattern byWidth = AntennaPattern::of(AntennaModel::Cosine, {}, width * kDegree);
        QVERIFY(near(byWidth.peak(), peak, 0.005));
    }
    void cosineOffItsAxis() {
        const AntennaPattern p = AntennaPattern::of(AntennaModel::Cosine);
        for (const auto& [angle, gain] : {std::pair{30., 6.5321}, {45., 4.7712}, {60., 1.7609}, {80., -7.4251}})
            QVERIFY(near(p.gain(angle * kDegree, 0), gain));
    }
    /// 20 dB below its peak, behind it and wherever its lobe is weaker than that.
    void aPatchHasABackLobe() {
        const AntennaPattern p = AntennaPattern::of(AntennaModel::Patch);
        QVERIFY(near(p.gain(0, 0), p.peak()));
        for (const double angle : {88., 90., 91., 135., 180.}) {
            QVERIFY(near(p.gain(angle * kDegree, 0), p.peak() - 20));
            QVERIFY(near(p.gain(0, -angle * kDegree), p.peak() - 20));
        }
        QVERIFY(p.gain(70 * kDegree, 0) > p.peak() - 19);
    }
    void halfWaveDipole() {
        const AntennaPattern p = AntennaPattern::of(AntennaModel::Dipole);
        QVERIFY(near(p.peak(), 2.1509));
        QVERIFY(near(p.gain(2, 0), 2.1509));
        for (const auto& [fromAxis, gain] : {std::pair{60., .3900}, {45., -1.8909}, {30., -5.4299}}) {
            QVERIFY(near(p.gain(1, (90 - fromAxis) * kDegree), gain));
            QVERIFY(near(p.gain(-2, (fromAxis - 90) * kDegree), gain));
        }
        QCOMPARE(p.gain(0, M_PI / 2), AntennaPattern::kFloor);
    }
    void modelsRadiateWhatTheyGet_data() {
        QTest::addColumn<int>("model");
        for (int m = 0; m <= static_cast<int>(AntennaModel::Cosine); ++m) QTest::addRow("%d", m) << m;
    }
    void modelsRadiateWhatTheyGet() {
        QFETCH(int, model);
        const AntennaPattern p = AntennaPattern::of(static_cast<AntennaModel>(model));
        QVERIFY2(near(p.radiated(), 1, 0.005), qPrintable(QString::number(p.radiated())));
        QVERIFY(near(p.gain(0, 0), p.peak(), 1e-9));
        const AntennaPattern lossy = AntennaPattern::of(static_cast<AntennaModel>(model), p.peak() - 3.0103);
        if (static_cast<AntennaModel>(model) != AntennaModel::Cosine) QVERIFY(near(lossy.radiated(), 0.5, 0.01));
    }
    void beamsHaveTheirWidth() {
        for (const AntennaModel model : {AntennaModel::Patch, AntennaModel::Yagi, AntennaModel::Cosine})
            for (const double width : {40., 60., 80.}) {
                const AntennaPattern p = AntennaPattern::of(model, {}, width * kDegree);
                QVERIFY(near(p.gain(width / 2 * kDegree, 0), p.peak() - 3.0103, 0.01));
                QVERIFY(near(p.gain(-width / 2 * kDegree, 0), p.peak() - 3.0103, 0.01));
            }
    }
    void tablesAreInterpolatedInDecibels() {
        const AntennaPattern p =
            AntennaPattern::fromCuts({{0, 6}, {90 * kDegree, 0}, {180 * kDegree, -10}, {-90 * kDegree, -4}}, {});
        QVERIFY(near(p.gain(0, 0), 6, 1e-9));
        QVERIFY(near(p.gain(45 * kDegree, 0), 3, 1e-9));
        QVERIFY(near(p.gain(135 * kDegree, 0), -5, 1e-9));
        QVERIFY(near(p.gain(-135 * kDegree, 0), -7, 1e-9));
        QVERIFY(near(p.gain(-45 * kDegree, 0), 1, 1e-9)); // across 360
        QVERIFY(near(p.gain(45 * kDegree, 1), 3, 1e-9));
        QCOMPARE(p.peak(), 6.);
    }
    void bothCutsCount() {
        const AntennaPattern p =
            AntennaPattern::fromCuts({{0, 6}, {180 * kDegree, -6}}, {{-90 * kDegree, -14}, {0, 6}, {90 * kDegree, -4}});
        QVERIFY(near(p.gain(0, 0), 6, 1e-9));
        QVERIFY(near(p.gain(0, 45 * kDegree), 1, 1e-9));
        QVERIFY(near(p.gain(M_PI, 0), -6, 1e-9));
        QVERIFY(near(p.gain(90 * kDegree, -45 * kDegree), 0 - 10, 1e-9));
    }
    void aFileFillsAGrid() {
        const Result<AntennaPattern> p =
            AntennaPattern::fromCsv("azimuth,elevation,gain\n0,-90,-10\n0,0,4\n0,90,-8\n180;-90;-10\n180 0 -6\r\n180,90,-8\n");
        QVERIFY2(p.ok(), p ? "" : p.error().message.c_str());
        QVERIFY(near(p.value().gain(0, 0), 4, 1e-9));
        QVERIFY(near(p.value().gain(90 * kDegree, 0), -1, 1e-9));
        QVERIFY(near(p.value().gain(-90 * kDegree, 0), -1, 1e-9));
        QVERIFY(near(p.value().gain(0, 45 * kDegree), -2, 1e-9));
    }
    void reportsBadFilesWithPosition_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("empty") << QByteArray("azimuth,elevation,gain\n") << QByteArray("no line");
        QTest::newRow("word") << QByteArray("0,0,1\n0,x,1\n") << QByteArray("line 2");
        QTest::newRow("two numbers") << QByteArray("0,0,1\n0,10\n") << QByteArray("line 2");
        QTest::newRow("hole") << QByteArray("0,0,1\n0,10,1\n90,0,1\n") << QByteArray("fill a grid of 2 azimuths and 2");
        QTest::newRow("twice") << QByteArray("0,0,1\n360,0,2\n") << QByteArray("line 2");
        QTest::newRow("elevation") << QByteArray("0,100,1\n") << QByteArray("between -90 and 90");
        QTest::newRow("infinite") << QByteArray("0,0,1\n0,0,inf\n") << QByteArray("line 2");
    }
    void reportsBadFilesWithPosition() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, words);
        const Result<AntennaPattern> p = AntennaPattern::fromCsv(text.toStdString());
        QVERIFY(!p.ok());
        QVERIFY2(QByteArray::fromStdString(p.error().message).contains(words), p.error().message.c_str());
    }
    void warnsAboutExcessGain() {
        QVERIFY(near(AntennaPattern::fromCuts({{0, 3}}, {}).radiated(), 1.995, 0.01));
        QVERIFY(AntennaPattern::of(AntennaModel::Dipole, 5).radiated() > 1.8);
    }
};

QTEST_APPLESS_MAIN(AntennaTest)
#include "antenna_test.moc"
