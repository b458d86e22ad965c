// Paths of objects whose names begin like others.
#include <QtTest>

#include "render/sample_experiment.h"
#include "scene/queries/object_index.h"

using namespace trundle;

class ObjectPathsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// "chassis2" and "chassis_rear" are other bodies than "chassis", which is before them.
    void aNameThatBeginsLikeAnother_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("body"); // -1: no body
        QTest::newRow("short") << "robot0.chassis" << 0;
        QTest::newRow("longer") << "robot0.chassis2" << 1;
        QTest::newRow("longest") << "robot0.chassis_rear" << 2;
        QTest::newRow("geom of the short one") << "robot0.chassis.bumper" << 0;
        QTest::newRow("geom of the longer one") << "robot0.chassis2.tyre" << 1;
        QTest::newRow("geom of the longest one, with slashes") << "robot0/chassis_rear/tyre" << 2;
        QTest::newRow("too short") << "robot0.chass" << -1;
        QTest::newRow("none so long") << "robot0.chassis22" << -1;
        QTest::newRow("no such geom") << "robot0.chassis.tyre" << -1;
        QTest::newRow("the other's geom") << "robot0.chassis2.hull" << -1;
    }
    void aNameThatBeginsLikeAnother() {
        QFETCH(QString, path);
        QFETCH(int, body);
        const auto experiment = sampleExperiment({1});
        auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[0].config);
        QCOMPARE(config->bodies.size(), std::size_t(3));
        config->bodies[1].name = "chassis2";
        config->bodies[2].name = "chassis_rear";
        experiment->robots[0].config = config;
        const ObjectIndex objects(experiment);
        const auto found = objects.find(path.toStdString());
        QCOMPARE(found.has_value(), body >= 0);
        if (!found) return;
        QCOMPARE(int(found->body), body);
        QCOMPARE(objects.pathOf(*found, '/'), QString(path).replace(u'.', u'/').toStdString());
    }
};

QTEST_APPLESS_MAIN(ObjectPathsTest)
#include "object_paths_test.moc"
