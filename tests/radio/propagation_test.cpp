// Path loss models and shadowing.
#include <QtTest>

#include "radio/propagation.h"

using namespace trundle;

namespace {

const double kLambda = wavelength(2.45e9);

bool near(double a, double b, double tolerance = 0.0005) { return std::abs(a - b) <= tolerance; }

} // namespace

class PropagationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void freeSpace_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("power");
        const std::pair<double, double> rows[] = {{.5, -34.2105}, {1, -40.2311},  {2, -46.2517},  {5, -54.2105},
                                                  {10, -60.2311}, {20, -66.2517}, {50, -74.2105}, {100, -80.2311}};
        for (const auto& [distance, power] : rows) QTest::addRow("%g m", distance) << distance << power;
    }
    void freeSpace() {
        QFETCH(double, distance);
        QFETCH(double, power);
        QVERIFY(near(-freeSpaceLoss(distance, kLambda), power, 1e-4));
    }
    void freeSpaceAtOtherFrequencies() {
        QVERIFY(near(kLambda, .1223643, 1e-7));
        QVERIFY(near(-10 + 6 + 3.1 - freeSpaceLoss(7.5, wavelength(2.48e9)), -58.73804, 1e-4));
        QVERIFY(near(94 - freeSpaceLoss(488.03, kLambda), 0, 1e-3));
        QVERIFY(near(90 - freeSpaceLoss(307.92, kLambda), 0, 1e-3));
    }
    void receivedPowerIsAtMostSentPower() {
        QVERIFY(freeSpaceLoss(0, kLambda) > 20);
        QCOMPARE(freeSpaceLoss(0.001, kLambda), freeSpaceLoss(0.1, kLambda));
    }
    void twoRays_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<double>("permittivity");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("power");
        const double rows[][5] = {{.1, .1, 0, 1, -40.547},  {.1, .1, 0, 5, -67.981},   {.1, .1, 0, 10, -80.006},
                                  {.1, .1, 0, 20, -92.043}, {.1, .1, 15, 1, -40.738},  {.1, .1, 15, 5, -63.918},
                                  {.1, .1, 15, 10, -75.31}, {.1, .1, 15, 20, -87.018}, {.1, .3, 0, 5, -58.588},
                                  {.1, .3, 0, 20, -82.51}};
        for (const auto& r : rows)
            QTest::addRow("%g m and %g m high, permittivity %g, %g m", r[0], r[1], r[2], r[3])
                << r[0] << r[1] << r[2] << r[3] << r[4];
    }
    void twoRays() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(double, permittivity);
        QFETCH(double, distance);
        QFETCH(double, power);
        const Vec3 a(1, 2, low), b = a + Vec3(distance * .6, distance * .8, high - low);
        const double loss = twoRayLoss(a, b, kLambda, permittivity);
        QVERIFY2(near(-loss, power, 0.001), qPrintable(QString::number(-loss)));
        QCOMPARE(twoRayLoss(b, a, kLambda, permittivity), loss);
    }
    void logDistance_data() {
        QTest::addColumn<double>("exponent");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("power");
        const double rows[][3] = {{2.4, 10, -64.231}, {2.4, 50, -81.006}, {3, 10, -70.231}, {3, 20, -79.262}, {4, 10, -80.231}};
        for (const auto& r : rows) QTest::addRow("%g, %g m", r[0], r[1]) << r[0] << r[1] << r[2];
    }
    void logDistance() {
        QFETCH(double, exponent);
        QFETCH(double, distance);
        QFETCH(double, power);
        QVERIFY(near(-logDistanceLoss(distance, kLambda, exponent), power, 0.001));
    }
    void shadowingIsStandardNormalOverPairs() {
        constexpr int kPairs = 4000;
        double sum = 0, squares = 0;
        int beyondOne = 0;
        for (std::uint64_t pair = 0; pair < kPairs; ++pair) {
            const double x = shadowing(7, pair, {1, 2, 0}, {5, -3, 0}, 2);
            sum += x;
            squares += x * x;
            beyondOne += std::abs(x) > 1;
        }
        QVERIFY(std::abs(sum / kPairs) < 0.05);
        QVERIFY(near(squares / kPairs, 1, 0.07));
        QVERIFY(near(beyondOne / double(kPairs), 0.3173, 0.025));
    }
    void shadowingDecorrelatesWithDistance_data() {
        QTest::addColumn<double>("way");
        QTest::addColumn<double>("correlation");
        for (const auto& [way, rho] : {std::pair{1., .60653}, {2., .36788}, {5., .08208}})
            QTest::addRow("%g m", way) << way << rho;
    }
    void shadowingDecorrelatesWithDistance() {
        QFETCH(double, way);
        QFETCH(double, correlation);
        constexpr int kPairs = 6000;
        double products = 0;
        for (std::uint64_t pair = 0; pair < kPairs; ++pair)
            products += shadowing(3, pair, {0, 0, 0}, {9, 1, 0}, 2) * shadowing(3, pair, {0, way, 0}, {9, 1, 0}, 2);
        QVERIFY2(near(products / kPairs, correlation, 0.05), qPrintable(QString::number(products / kPairs)));
    }
    void shadowingIsAFunction() {
        const Vec3 a(1, 2, 3), b(4, 5, 6);
        const double x = shadowing(1, 99, a, b, 2);
        for (int i = 0; i < 3; ++i) QCOMPARE(shadowing(1, 99, a, b, 2), x);
        QVERIFY(shadowing(2, 99, a, b, 2) != x);
        QVERIFY(shadowing(1, 98, a, b, 2) != x);
        QCOMPARE(shadowing(1, 99, a, b, 0), shadowing(1, 99, b, a + b, 0)); // symmetric and constant in time
    }
};

QTEST_APPLESS_MAIN(PropagationTest)
#include "propagation_test.moc"
