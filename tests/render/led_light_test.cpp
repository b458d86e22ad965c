// The light of Leds on what is around them.
#include <QtTest>

#include <numbers>

#include "render/camera_experiment.h"
#include "render/sample_experiment.h"

using namespace trundle;

namespace {

using Channels = std::array<double, 3>;

ComponentSpec ledAt(const Vec3& place, double candela, CameraValues values = {}) {
    ComponentSpec spec;
    spec.kind = spec.name = "Led";
    values["Body"] = {PropertyType::Reference, {}, {"mount"}};
    values["Pos"] = numbers({place.x(), place.y(), place.z()});
    values["Intensity"] = numbers({candela});
    values["Diameter"] = numbers({0});
    for (auto& [key, value] : values) spec.values[key] = {value, {}, Origin::Config};
    return spec;
}

/// A dim floor with a post, seen from above; the image covers -2.1 m to 2.1 m. The Leds are on a robot in the world's origin.
std::shared_ptr<ExperimentSpec> darkFloor(const std::vector<ComponentSpec>& leds, const Vec3& at = Vec3::Zero()) {
    auto experiment = boxOnFloor({0.2, 0.2, 1}, {0, 0, 0.5});
    ComponentSpec night;
    night.kind = night.name = "Light";
    night.values["Intensity"] = {numbers({0}), {}, Origin::Config};
    experiment->looks = {night};
    const Pose above{{0, 0, 5}, rotationFromHpr({std::numbers::pi / 2, std::numbers::pi / 2, 0})};
    RobotSpec lamps = cameraRobot("lamps", {at, Quat::Identity()}, {});
    auto config = std::make_shared<RobotConfigSpec>(*lamps.config);
    config->devices = leds;
    lamps.config = config;
    experiment->robots = {cameraRobot("robot0", above, {{"Resolution", numbers({200, 200})}, {"FieldOfView", numbers({0.8})}}),
                          lamps};
    return experiment;
}

std::vector<std::uint8_t> pixelsOf(const std::shared_ptr<ExperimentSpec>& experiment) {
    const Result<CameraImage> frame = captureAtStart(experiment, "robot0/eye");
    if (!frame) qFatal("%s", frame.error().message.c_str());
    return frame.value().pixels;
}

/// Mean red, green and blue of the floor at a position, over a few pixels.
Channels floorAt(const std::shared_ptr<ExperimentSpec>& experiment, double x, double y) {
    const std::vector<std::uint8_t> pixels = pixelsOf(experiment);
    const CameraModel camera = camerasOf(*experiment).at(0);
    const auto at = project(viewOf(camera, experiment->robots[0].pose), 200, 200, {x, y, 0});
    Channels mean{};
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            for (std::size_t k = 0; k < 3; ++k)
                mean[k] += pixels[3 * std::size_t((int(at->y) + dy) * 200 + int(at->x) + dx) + k] / 25.0;
    return mean;
}

} // namespace

class LedLightTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDarkLedChangesNoPixel() {
        const auto without = pixelsOf(darkFloor({}));
        QVERIFY(pixelsOf(darkFloor({ledAt({1, 1, 0.3}, 100, {{"On", numbers({0})}})})) == without);
        QVERIFY(pixelsOf(darkFloor({ledAt({1, 1, 0.3}, 0)})) == without);
        QVERIFY(pixelsOf(darkFloor({ledAt({1, 1, 0.3}, 100)})) != without);
        QVERIFY(pixelsOf(darkFloor({ledAt({1, 1, 0.3}, 100)})) == pixelsOf(darkFloor({ledAt({1, 1, 0.3}, 100)})));
    }

    /// Light adds up, and falls with the square of the distance and the cosine to the floor's normal: a display value is its root.
    void itsLightFallsWithTheSquareOfTheDistance() {
        const auto lit = darkFloor({ledAt({1.25, 1.25, 0.5}, 30)}), dark = darkFloor({}); // in one tile, beside its lines
        const auto added = [&](double x, double y) {
            return std::pow(floorAt(lit, x, y)[1], 2) - std::pow(floorAt(dark, x, y)[1], 2);
        };
        const double below = added(1.25, 1.25), aside = added(1.25, 0.75); // sqrt(2) as far, 45 degrees
        QVERIFY2(below > 500, qPrintable(QString::number(below)));
        QVERIFY2(std::abs(aside / below - 1 / std::pow(2, 1.5)) < 0.03, qPrintable(QString::number(aside / below)));
    }

    void itMovesWithItsRobot() {
        const auto moved = darkFloor({ledAt({0, 0, 0.3}, 100)}, {-1, -1, 0}), there = darkFloor({ledAt({-1, -1, 0.3}, 100)});
        QVERIFY(floorAt(moved, -1, -1)[1] > floorAt(moved, 1, 1)[1] + 30);
        QVERIFY(std::abs(floorAt(moved, -1, -1)[1] - floorAt(there, -1, -1)[1]) < 1);
    }

    void itHasItsColour() {
        const Channels dark = floorAt(darkFloor({}), 1, 1),
                       red = floorAt(darkFloor({ledAt({1, 1, 0.3}, 50, {{"ColorRGB", numbers({1, 0, 0})}})}), 1, 1);
        QVERIFY(red[0] > dark[0] + 20);
        QVERIFY(std::abs(red[1] - dark[1]) < 0.5 && std::abs(red[2] - dark[2]) < 0.5);
    }

    /// It looks to +x, and shines half as bright 20 degrees off.
    void aNarrowBeamLightsWhatIsAhead() {
        const auto beam = darkFloor({ledAt({-1, 1, 0.3}, 1000, {{"HalfAngle", numbers({20 * std::numbers::pi / 180})}})});
        const auto added = [&](double x) { return floorAt(beam, x, 1)[1] - floorAt(darkFloor({}), x, 1)[1]; };
        QVERIFY(added(-0.4) > 10);
        QVERIFY(std::abs(added(-1.6)) < 0.5);
    }

    /// Of more than light a picture, those that are brightest from the eye.
    void theBrightestOfManyLight() {
        std::vector<ComponentSpec> many;
        for (int i = 0; i < 12; ++i) many.push_back(ledAt({-1.5, -1.5 + 0.02 * i, 0.05}, 0.5));
        many.push_back(ledAt({1, 1, 0.3}, 100));
        const double alone = floorAt(darkFloor({many.back()}), 1, 1)[1];
        QVERIFY(alone > floorAt(darkFloor({}), 1, 1)[1] + 30);
        QVERIFY(std::abs(floorAt(darkFloor(many), 1, 1)[1] - alone) < 1);
    }
};

QTEST_APPLESS_MAIN(LedLightTest)
#include "led_light_test.moc"
