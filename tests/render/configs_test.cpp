// Every shipped experiment gives a picture in which its robots are to be seen.
#include <QtTest>

#include <QDir>

#include "render/config_experiment.h"
#include "render/started_service.h"
#include "scene/framing.h"

using namespace trundle;

class ConfigsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { startService(m_service); }

    void robotsAreSeen_data() {
        QTest::addColumn<QString>("file");
        const QDir folder(TRUNDLE_SOURCE_DIR "/configs/experiments");
        for (const QString& name : folder.entryList({"*.sim", "thesis_*.txt"}, QDir::Files))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
    void robotsAreSeen() {
        QFETCH(QString, file);
        const auto experiment = readExperiment(file.toStdString());
        QVERIFY(experiment);
        QVERIFY(!experiment->robots.empty());
        const SceneId scene = m_service->addScene(experiment);
        PictureRequest request;
        request.scene = scene;
        request.width = 640;
        request.height = 360;
        request.mask = kMaskSensor;
        request.samples = 1;
        const auto with = m_service->draw(request).get();
        QVERIFY2(with.ok(), with.ok() ? "" : with.error().message.c_str());
        request.mask = kMaskSensor & ~kMaskRobots;
        const auto without = m_service->draw(request).get();
        QVERIFY(without.ok());
        int changed = 0;
        for (std::size_t i = 0; i < with.value().pixels.size(); i += 3)
            changed += !std::equal(&with.value().pixels[i], &with.value().pixels[i] + 3, &without.value().pixels[i]);
        QVERIFY2(changed > 100, qPrintable(QString("only %1 pixels show robots").arg(changed)));
        m_service->removeScene(scene);
    }

private:
    std::unique_ptr<RenderService> m_service;
};

QTEST_APPLESS_MAIN(ConfigsTest)
#include "configs_test.moc"
