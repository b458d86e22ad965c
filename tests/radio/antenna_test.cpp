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
        QVERIFY(near(p.gain(90 * kDegree, -45 * kDegree), (0 - 14) / 2., 1e-9));
    }
    /// Straight up is one direction, whatever its azimuth.
    void cutsMeetAtThePoles() {
        const AntennaPattern p =
            AntennaPattern::fromCuts({{-180 * kDegree, -20}, {-90 * kDegree, -10}, {0, 5}, {90 * kDegree, -10}},
                                     {{-90 * kDegree, -20}, {0, 5}, {45 * kDegree, 0}, {90 * kDegree, -5}});
        for (const double azimuth : {0., 1., 2.5, -3.}) {
            QVERIFY(near(p.gain(azimuth, 90 * kDegree), -5, 1e-9));
            QVERIFY(near(p.gain(azimuth, -90 * kDegree), -20, 1e-9));
        }
        QVERIFY(near(p.gain(90 * kDegree, 45 * kDegree), -15, 1e-9));
    }
    /// As data sheets have them, from 0 to 360 degrees: over the top to the side behind.
    void anElevationCutGoesAllAround() {
        const std::vector<GainPoint> around{{0, 6},
                                            {30 * kDegree, 3},
                                            {60 * kDegree, -3},
                                            {90 * kDegree, -6},
                                            {120 * kDegree, -9},
                                            {150 * kDegree, -10},
                                            {180 * kDegree, -12},
                                            {210 * kDegree, -13},
                                            {240 * kDegree, -14},
                                            {270 * kDegree, -15},
                                            {300 * kDegree, -9},
                                            {330 * kDegree, 0}};
        const AntennaPattern alone = AntennaPattern::fromCuts({}, around);
        const AntennaPattern both =
            AntennaPattern::fromCuts({{0, 8}, {90 * kDegree, 1}, {180 * kDegree, -5}, {270 * kDegree, 2}}, around);
        for (const auto& [azimuth, elevation, gain] : {std::tuple{0., 0., 6.},
                                                       {0., 30., 3.},
                                                       {0., -30., 0.},
                                                       {0., -60., -9.},
                                                       {0., 90., -6.},
                                                       {0., -90., -15.},
                                                       {180., 0., -12.},
                                                       {180., 60., -9.},
                                                       {180., -45., -13.5},
                                                       {90., 0., -3.},
                                                       {-90., 30., -3.5},
                                                       {70., 90., -6.},
                                                       {200., -90., -15.}})
            QVERIFY2(
                near(alone.gain(azimuth * kDegree, elevation * kDegree), gain, 1e-9),
                qPrintable(
                    QString("%1 %2: %3").arg(azimuth).arg(elevation).arg(alone.gain(azimuth * kDegree, elevation * kDegree))));
        QVERIFY(near(both.gain(0, 30 * kDegree), 8 - 3, 1e-9) && near(both.gain(180 * kDegree, 60 * kDegree), -5 + 3, 1e-9));
        QVERIFY(near(both.gain(90 * kDegree, 0), 1, 1e-9) &&
                near(both.gain(90 * kDegree, 30 * kDegree), 1 + (-3 + 2) / 2., 1e-9));
        const AntennaPattern upper = AntennaPattern::fromCuts({}, {{270 * kDegree, -15}, {0, 0}, {90 * kDegree, -6}});
        QVERIFY(near(upper.gain(2, -45 * kDegree), -7.5, 1e-9) && near(upper.gain(0, 45 * kDegree), -3, 1e-9));
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
    void aFileIsTheSameHoweverItIsWritten_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no heading") << QByteArray("0,-30,-9\n0,60,4\n90,-30,2\n90,60,-1\n250,-30,7\n250,60,0.5\n");
        QTest::newRow("other order") << QByteArray("a,e,g\n250,60,0.5\n90,-30,2\n0,60,4\n250,-30,7\n90,60,-1\n0,-30,-9\n");
        QTest::newRow("signs") << QByteArray("+0,-30,-9\n0,+60,+4\n90,-30,+2\n+90,60,-1\n250,-30,7\n250,60,+.5\n");
        QTest::newRow("separators") << QByteArray("0\t-30\t-9\n 0 ; 60 ; 4 \n90, -30, 2\n90 60 -1\n250;-30;7;\n250,60,0.5,\n");
        QTest::newRow("comments") << QByteArray("# a\n\n0,-30,-9\n# b\n0,60,4\n \t\n90,-30,2\n90,60,-1\n250,-30,7\n250,60,0.5");
        QTest::newRow("returns") << QByteArray("0,-30,-9\r\n0,60,4\r\n90,-30,2\r\n90,60,-1\r\n250,-30,7\r\n250,60,0.5\r\n");
        QTest::newRow("round once more") << QByteArray("360,-30,-9\n0,60,4\n450,-30,2\n-270,60,-1\n-110,-30,7\n610,60,0.5\n");
        QTest::newRow("a line twice") << QByteArray("0,-30,-9\n0,60,4\n90,-30,2\n90,60,-1\n250,-30,7\n250,60,0.5\n360,60,4\n");
    }
    void aFileIsTheSameHoweverItIsWritten() {
        QFETCH(QByteArray, text);
        const Result<AntennaPattern> p = AntennaPattern::fromCsv(text.toStdString());
        QVERIFY2(p.ok(), p ? "" : p.error().message.c_str());
        const std::tuple<double, double, double> gains[] = {{0, -30, -9},     {0, 60, 4},      {90, -30, 2},   {90, 60, -1},
                                                            {250, -30, 7},    {250, 60, 0.5},  {0, 15, -2.5},  {45, -30, -3.5},
                                                            {170, 60, -0.25}, {305, 60, 2.25}, {-55, -30, -1}, {45, 15, -1}};
        for (const auto& [azimuth, elevation, gain] : gains)
            QVERIFY2(near(p.value().gain(azimuth * kDegree, elevation * kDegree), gain, 1e-9),
                     qPrintable(QString("%1 %2").arg(azimuth).arg(elevation)));
        QCOMPARE(p.value().peak(), 7.);
        QVERIFY(near(p.value().gain(0, M_PI / 2), 4, 1e-9)); // beyond the last elevation
    }

    /// Cuts may be listed in any order, round more than once, and with the same angle again: then the last gain counts.
    void cutsAreReadInAnyOrder() {
        const AntennaPattern plain = AntennaPattern::fromCuts({{0, 6}, {100 * kDegree, 1}, {200 * kDegree, -7}},
                                                              {{-80 * kDegree, -14}, {0, 6}, {50 * kDegree, -4}});
        const AntennaPattern mixed =
            AntennaPattern::fromCuts({{-160 * kDegree, -7}, {360 * kDegree, 9}, {460 * kDegree, 1}, {0, 6}},
                                     {{50 * kDegree, -3}, {0, 6}, {-80 * kDegree, -14}, {50 * kDegree, -4}});
        for (int azimuth = -180; azimuth <= 360; azimuth += 15)
            for (int elevation = -90; elevation <= 90; elevation += 10)
                QVERIFY(near(plain.gain(azimuth * kDegree, elevation * kDegree),
                             mixed.gain(azimuth * kDegree, elevation * kDegree), 1e-9));
        QVERIFY(near(mixed.gain(0, 25 * kDegree), 1, 1e-9));
        QCOMPARE(mixed.peak(), plain.peak());
    }

    /// To the left is to the right; with the bits of a table that is written mirrored.
    void tablesHaveMirrorImages() {
        const std::vector<GainPoint> elevation{{-80 * kDegree, -14}, {0, 6}, {50 * kDegree, -4}};
        const AntennaPattern plain =
            AntennaPattern::fromCuts({{0, 6}, {100 * kDegree, 1}, {200 * kDegree, -7}, {290 * kDegree, 3}}, elevation);
        const AntennaPattern written =
            AntennaPattern::fromCuts({{0, 6}, {-100 * kDegree, 1}, {-200 * kDegree, -7}, {-290 * kDegree, 3}}, elevation);
        const AntennaPattern mirrored = plain.mirrored();
        for (int azimuth = -180; azimuth <= 360; azimuth += 7)
            for (int angle = -90; angle <= 90; angle += 10) {
                QCOMPARE(mirrored.gain(azimuth * kDegree, angle * kDegree), written.gain(azimuth * kDegree, angle * kDegree));
                QVERIFY(near(mirrored.mirrored().gain(azimuth * kDegree, angle * kDegree),
                             plain.gain(azimuth * kDegree, angle * kDegree), 1e-9));
            }
        QCOMPARE(mirrored.peak(), plain.peak());
    }

    /// Between the last azimuth and the first one they are interpolated across 0, whether a line has that azimuth or not.
    void tablesWithoutTheAzimuthZero() {
        const AntennaPattern p = AntennaPattern::fromCuts({{30 * kDegree, 3}, {150 * kDegree, -5}, {250 * kDegree, 1}}, {});
        const Result<AntennaPattern> file = AntennaPattern::fromCsv("30,0,3\n150,0,-5\n250,0,1\n");
        QVERIFY(file.ok());
        const AntennaPattern mirrored = p.mirrored();
        const std::pair<double, double> gains[] = {{30, 3},  {90, -1},   {150, -5},    {200, -2},    {250, 1},  {285, 1.5},
                                                   {320, 2}, {355, 2.5}, {0, 18. / 7}, {12.5, 2.75}, {-5, 2.5}, {372.5, 2.75}};
        for (const auto& [azimuth, gain] : gains) {
            QVERIFY2(near(p.gain(azimuth * kDegree, 0), gain, 1e-9), qPrintable(QString::number(azimuth)));
            QVERIFY2(near(file.value().gain(azimuth * kDegree, 0), gain, 1e-9), qPrintable(QString::number(azimuth)));
            QVERIFY2(near(mirrored.gain(-azimuth * kDegree, 0), gain, 1e-9), qPrintable(QString::number(azimuth)));
        }
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
        QTest::newRow("not a number") << QByteArray("0,0,1\n0,nan,1\n")
                                      << QByteArray("line 2: an azimuth, an elevation and a gain");
        QTest::newRow("no azimuth") << QByteArray("0,0,1\ninf,0,1\n")
                                    << QByteArray("line 2: an azimuth, an elevation and a gain");
        QTest::newRow("four numbers") << QByteArray("0,0,1\n0,1,1,1\n") << QByteArray("line 2");
        QTest::newRow("two signs") << QByteArray("0,0,1\n0,++1,1\n") << QByteArray("line 2");
        QTest::newRow("gain") << QByteArray("0,0,1\n0,10,101\n") << QByteArray("line 2: a gain lies between");
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
