// A missing mesh: the placeholder drawn in its place, and the warning for the user.
#include <QtTest>

#include <QTemporaryDir>

#include "base/platform/atomic_file.h"
#include "model/object_numbers.h"
#include "project/loading/project.h"
#include "render/config_experiment.h"
#include "render/started_service.h"
#include "scene/scene.h"

using namespace trundle;

namespace {

constexpr const char* kText = R"(Material grey { ColorRGB=0.5,0.5,0.5 }
Surface rubber { Friction=1 }
RobotConfig Rover {
  Body chassis {
    Box hull   { Size=0.3,0.2,0.1  Pos=0,0,0.05  Mass=1  Material=grey Surface=rubber }
    Mesh shell { File=meshes/gone.obj  Pos=0,0.4,0.05  Mass=1  Material=grey Surface=rubber }
  }
}
Robot rover { Config=Rover }
)";

} // namespace

class PlaceholderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        const std::string path = m_folder.filePath(QStringLiteral("gone.sim")).toStdString();
        QVERIFY(writeFileAtomically(path, kText).ok());
        m_loaded = readProject(path);
        QVERIFY(m_loaded);
        startService(m_service);
        m_view.eye = {-0.8, 0.2, 1.2};
        m_view.target = {0, 0.2, 0};
    }

    void reportsWhere() {
        int reported = 0;
        for (const Diagnostic& problem : m_loaded->diagnostics.all()) {
            if (problem.code != Code::MeshUnreadable) continue;
            ++reported;
            QCOMPARE(problem.severity, Severity::Error);
            QVERIFY2(problem.message.starts_with("meshes/gone.obj is not found"), problem.message.c_str());
            QCOMPARE(std::string(kText).substr(problem.range.range.begin, problem.range.range.size()),
                     std::string("meshes/gone.obj"));
        }
        QCOMPARE(reported, 1);
    }

    void showsMarkerForMissingMesh() {
        PictureRequest request;
        request.scene = m_service->addScene(m_loaded->experiment);
        request.view = m_view;
        request.width = 320;
        request.height = 240;
        request.mask = kMaskSensor;
        request.samples = 1;
        const auto brightOnes = [&](std::vector<std::string> hidden) {
            request.hidden = std::move(hidden);
            const Result<Image> image = m_service->draw(request).get();
            int count = 0;
            for (std::size_t i = 0; image && i < image.value().pixels.size(); i += 3) {
                const std::uint8_t* p = image.value().pixels.data() + i;
                count += p[0] > 150 && p[1] < 60 && p[2] > 150;
            }
            return count;
        };
        const int shown = brightOnes({});
        QVERIFY2(shown > 300, qPrintable(QString::number(shown)));
        QCOMPARE(brightOnes({"rover/chassis/shell"}), 0);

        // The placeholder has the mesh's path for picking and for segmentation images.
        const auto at = project(m_view, 320, 240, {0, 0.4, 0.05});
        QVERIFY(at);
        request.hidden.clear();
        const Result<DataImage> measured = m_service->measure(request).get();
        QVERIFY(measured.ok());
        const std::uint32_t object = measured.value().objects[std::size_t(at->y) * 320 + std::size_t(at->x)];
        QCOMPARE(objectNames(*m_loaded->experiment).at(object), std::string("rover/chassis/shell"));
        const Result<PickResult> picked = m_service->pick({request.scene, m_view, 320, 240, at->x, at->y}).get();
        QVERIFY(picked.ok());
        QCOMPARE(picked.value().path, std::string("rover/chassis/shell"));
    }

private:
    QTemporaryDir m_folder;
    std::shared_ptr<const LoadedProject> m_loaded;
    std::unique_ptr<RenderService> m_service;
    CameraView m_view;
};

QTEST_APPLESS_MAIN(PlaceholderTest)
#include "placeholder_test.moc"
