// Images of every shipped experiment show its robots and the rotation of their wheels.
#include <QtTest>

#include <QDir>

#include <numbers>
#include <set>

#include "render/config_experiment.h"
#include "render/started_service.h"
#include "scene/queries/framing.h"

using namespace trundle;

namespace {

struct Wheel {
    std::size_t pose; ///< index into BodyPoses
    Vec3 axis;        ///< in its body B
    std::string path;
    double radius = 0; ///< m
};

/// The child bodies of all hinges of the first robot of each config, if their materials have no texture.
std::vector<Wheel> wheelsOf(const ExperimentSpec& experiment) {
    std::vector<Wheel> wheels;
    std::set<const RobotConfigSpec*> seen;
    std::size_t first = 0;
    for (const RobotSpec& robot : experiment.robots) {
        const auto& bodies = robot.config->bodies;
        const bool isNew = seen.insert(robot.config.get()).second;
        for (const JointSpec& joint : robot.config->joints) {
            if (!isNew || joint.type != JointType::Hinge) continue;
            const int index = static_cast<int>(&joint - robot.config->joints.data());
            if (std::ranges::count(robot.config->gears, index, &GearSpec::other) > 0) continue; // a gear wheel, inside the robot
            const BodySpec& body = bodies[std::size_t(joint.child)];
            const auto isPictured = [&](const GeomSpec& geom) { return !experiment.materials[geom.material].texture.empty(); };
            if (std::any_of(body.geoms.begin(), body.geoms.end(), isPictured)) continue; // textures are not loaded here
            double radius = 0;
            for (const GeomSpec& geom : body.geoms) radius = std::max(radius, geom.radius);
            if (radius == 0) continue; // nothing round: it is seen to turn
            wheels.push_back({first + std::size_t(joint.child), body.pose.rotation.conjugate() * joint.axis,
                              robot.name + "/" + body.name, radius});
        }
        first += bodies.size();
    }
    return wheels;
}

int changedPixels(const Image& a, const Image& b) {
    int changed = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3)
        for (std::size_t k = i; k < i + 3; ++k)
            if (std::abs(int(a.pixels[k]) - int(b.pixels[k])) > 12) {
                ++changed;
                break;
            }
    return changed;
}

} // namespace

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

    void turningWheelsAreSeen_data() { robotsAreSeen_data(); }
    void turningWheelsAreSeen() {
        QFETCH(QString, file);
        const auto experiment = readExperiment(file.toStdString());
        QVERIFY(experiment);
        const SceneId scene = m_service->addScene(experiment);
        const BodyPoses start = startPoses(*experiment);
        for (const Wheel& wheel : wheelsOf(*experiment)) {
            PictureRequest request;
            request.scene = scene;
            request.width = request.height = 160;
            request.mask = kMaskRobots;
            request.samples = 1;
            const Pose& X_WB = start[wheel.pose];
            // From the side and a little above, so that the outer face and the tread are visible; from either end of the axis.
            int seen = 0;
            for (const double side : {-1.0, 1.0}) {
                CameraView view;
                view.target = X_WB.position;
                view.eye = X_WB.position + side * 0.5 * (X_WB.rotation * wheel.axis) + Vec3(0.1, 0, 0.15);
                view.fieldOfView = 8 * wheel.radius; // a wheel of 5 cm, or any other, fills a quarter of the width
                request.view = view;
                request.poses = nullptr;
                const Image still = m_service->draw(request).get().value();
                int least = 1 << 30;
                for (const double degrees : {36.0, 72.0, 180.0}) { // half a spoke spacing, one spacing, half a rotation
                    BodyPoses turned = start;
                    turned[wheel.pose].rotation =
                        X_WB.rotation * Quat(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, wheel.axis));
                    request.poses = std::make_shared<BodyPoses>(turned);
                    least = std::min(least, changedPixels(still, m_service->draw(request).get().value()));
                }
                seen = std::max(seen, least);
            }
            QVERIFY2(
                seen > 60,
                qPrintable(QString("%1: only %2 pixels show that it turns").arg(QString::fromStdString(wheel.path)).arg(seen)));
        }
        m_service->removeScene(scene);
    }

private:
    std::unique_ptr<RenderService> m_service;
};

QTEST_APPLESS_MAIN(ConfigsTest)
#include "configs_test.moc"
