// The smallest rotation between two directions.
#include <QtTest>

#include "model/shortest_turn.h"

using namespace trundle;

class ShortestTurnTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void turnsOneOntoTheOtherByTheAngleBetweenThem() {
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = 3 * Vec3::Random(), to = 0.2 * Vec3::Random();
            const Quat turn = shortestTurn(from, to);
            QVERIFY((turn * from.normalized() - to.normalized()).norm() < 1e-14);
            const double between = std::atan2(from.cross(to).norm(), from.dot(to));
            QVERIFY(std::abs(turn.angularDistance(Quat::Identity()) - between) < 1e-14);
        }
    }
    void nearlyEqualAndOpposite() {
        const Vec3 x = Vec3::UnitX();
        QVERIFY(shortestTurn(x, x).isApprox(Quat::Identity(), 1e-15));
        for (const double off : {0.0, 1e-14, 1e-9, 1e-6, 1e-3}) {
            const Vec3 to = Vec3(-1, off, 0).normalized();
            QVERIFY2((shortestTurn(x, to) * x - to).norm() < 1e-15, qPrintable(QString::number(off)));
            const Vec3 near = Vec3(1, off, 0).normalized();
            QVERIFY((shortestTurn(x, near) * x - near).norm() < 1e-15);
        }
    }
};

QTEST_APPLESS_MAIN(ShortestTurnTest)
#include "shortest_turn_test.moc"
