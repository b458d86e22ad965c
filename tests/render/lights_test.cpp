// Sun, lamps and sky of an experiment's text.
#include <QtTest>

#include <numbers>

#include "render/camera_experiment.h"
#include "render/sample_experiment.h"
#include "scene/shaders/scene_shading.h"

using namespace trundle;

namespace {

ComponentSpec look(const std::string& kind, CameraValues values) {
    ComponentSpec spec;
    spec.kind = kind;
    spec.name = kind;
    for (auto& [key, value] : values) spec.values[key] = {value, {}, Origin::Config};
    return spec;
}

ComponentSpec lampAt(double x, double y, double z, CameraValues values = {}) {
    values["Mode"] = word("lamp");
    values["Pos"] = numbers({x, y, z});
    return look("Light", std::move(values));
}

/// A post on a floor, seen from above; the image covers -2.1 m to 2.1 m.
std::shared_ptr<ExperimentSpec> post(std::vector<ComponentSpec> looks, const Vec3& place = {0, 0, 0.5}) {
    auto experiment = boxOnFloor({0.2, 0.2, 1}, place);
    experiment->looks = std::move(looks);
    const Pose above{{0, 0, 5}, rotationFromHpr({std::numbers::pi / 2, std::numbers::pi / 2, 0})};
    experiment->robots = {cameraRobot("robot0", above, {{"Resolution", numbers({200, 200})}, {"FieldOfView", numbers({0.8})}})};
    return experiment;
}

/// Mean brightness of the floor at a position, over a few pixels.
double floorAt(const std::shared_ptr<ExperimentSpec>& experiment, double x, double y) {
    const Result<CameraImage> frame = captureAtStart(experiment, "robot0/eye");
    if (!frame) qFatal("%s", frame.error().message.c_str());
    const CameraModel camera = camerasOf(*experiment).at(0);
    const auto at = project(viewOf(camera, experiment->robots[0].pose), 200, 200, {x, y, 0});
    double sum = 0;
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            for (int k = 0; k < 3; ++k)
                sum += frame.value().pixels[std::size_t(3 * ((int(at->y) + dy) * 200 + int(at->x) + dx) + k)];
    return sum / 75;
}

} // namespace

class LightsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void castsShadowAwayFromSun() {
        for (const double side : {1.0, -1.0}) { // shining towards +x, then towards -x
            const auto experiment = post({look("Light", {{"Mode", word("sun")}, {"Direction", numbers({side, 0, -1})}})});
            const double shadow = floorAt(experiment, 0.5 * side, 0), lit = floorAt(experiment, -0.5 * side, 0);
            QVERIFY2(shadow < 0.8 * lit, qPrintable(QStringLiteral("%1 and %2").arg(shadow).arg(lit)));
        }
    }
    void aSunMayCastNoShadows() {
        const auto experiment = post({look("Light", {{"Direction", numbers({1, 0, -1})}, {"Shadows", numbers({0})}})});
        QVERIFY(floorAt(experiment, 0.5, 0) > 0.95 * floorAt(experiment, -0.5, 0));
    }
    void transparentObjectsCastNoShadow() {
        for (const auto& [opacity, casts] : {std::pair{0.0, false}, {0.3, false}, {0.8, true}}) {
            const auto experiment = post({look("Light", {{"Direction", numbers({1, 0, -1})}})});
            experiment->materials[0].opacity = opacity;
            QCOMPARE(floorAt(experiment, 0.5, 0) < 0.8 * floorAt(experiment, -0.5, 0), casts);
        }
    }
    void theShadowOfTheSunLeavesTheLightOfLamps() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        const ComponentSpec sun = look("Light", {{"Direction", numbers({1, 0, -1})}});
        const ComponentSpec lamp = lampAt(0.6, 0, 0.6, {{"Shadows", numbers({0})}, {"Intensity", numbers({0.1})}});
        const double alone = floorAt(post({night, lamp}), 0.5, 0), shadow = floorAt(post({sun, lamp}), 0.5, 0);
        QVERIFY2(std::abs(shadow - alone) < 6, qPrintable(QStringLiteral("%1 and %2").arg(shadow).arg(alone)));
        QVERIFY(floorAt(post({sun}), 0.5, 0) < shadow - 10); // brightness without the lamp
    }
    void aLampIsBrightNearIt() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        const ComponentSpec lamp =
            look("Light", {{"Mode", word("lamp")}, {"Pos", numbers({1, 1, 0.5})}, {"Intensity", numbers({0.3})}});
        const double dark = floorAt(post({night}), 1, 1), bright = floorAt(post({night, lamp}), 1, 1);
        QVERIFY2(bright > 1.5 * dark, qPrintable(QStringLiteral("%1 and %2").arg(bright).arg(dark)));
        QVERIFY(floorAt(post({night, lamp}), -1, -1) < 0.7 * bright);
    }
    void castsShadowsAwayFromLamp() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        for (const double side : {1.0, -1.0}) {
            const auto lit = post({night, lampAt(side, 0, 1.5, {{"Shadows", numbers({0})}})});
            const auto cast = post({night, lampAt(side, 0, 1.5)});
            // The post is 1 m high: its shadow is 3 m long.
            for (const double x : {-0.5, -1.5}) {
                const double dark = floorAt(cast, x * side, 0), bright = floorAt(lit, x * side, 0);
                QVERIFY2(dark < 0.95 * bright, qPrintable(QStringLiteral("at %1: %2 and %3").arg(x).arg(dark).arg(bright)));
                // As dark as without a lamp.
                QVERIFY(std::abs(dark - floorAt(post({night}), x * side, 0)) < 2);
            }
            for (const Vec3& open : {Vec3(0.5 * side, 0, 0), Vec3(-0.5 * side, 0.6, 0), Vec3(0, -1, 0)})
                QCOMPARE(floorAt(cast, open.x(), open.y()), floorAt(lit, open.x(), open.y()));
        }
    }
    void aShadowOfALampReachesIntoThePicture() {
        // Neither lamp nor post is visible.
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        const Vec3 outside(2.6, 0, 0.5);
        const double dark = floorAt(post({night, lampAt(3.6, 0, 1.5)}, outside), 1.8, 0);
        const double bright = floorAt(post({night, lampAt(3.6, 0, 1.5, {{"Shadows", numbers({0})}})}, outside), 1.8, 0);
        QVERIFY2(dark < 0.9 * bright, qPrintable(QStringLiteral("%1 and %2").arg(dark).arg(bright)));
    }
    void objectsAboveLampCastNoShadow() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        const auto cast = [&](double height) { return floorAt(post({night, lampAt(0, 0, height)}, {0, 0, 1.5}), 0.6, 0.3); };
        const auto lit = [&](double height) {
            return floorAt(post({night, lampAt(0, 0, height, {{"Shadows", numbers({0})}})}, {0, 0, 1.5}), 0.6, 0.3);
        };
        QCOMPARE(cast(0.9), lit(0.9)); // the post hangs from 1 m up
        auto ball = post({night, lampAt(1, 1, 1)});
        GeomSpec bulb;
        bulb.name = "bulb";
        bulb.shape = GeomShape::Sphere;
        bulb.radius = 0.08;
        bulb.pose.position = {1, 1, 1};
        std::vector<GeomSpec> geoms = *ball->statics[0].geoms;
        geoms.push_back(bulb);
        ball->statics[0].geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
        QCOMPARE(floorAt(ball, 0.5, 1), floorAt(post({night, lampAt(1, 1, 1)}), 0.5, 1));
    }
    /// It casts none onto the floor, and takes none of the places of three lamps above it.
    void aLampBelowTheFloorCastsNoShadow() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}}), below = lampAt(0.6, 0, -0.8),
                            dark = lampAt(0.6, 0, -0.8, {{"Shadows", numbers({0})}});
        for (const double x : {-1.2, -0.6, 0.4, 0.8, 1.2})
            QCOMPARE(floorAt(post({night, below}), x, 0), floorAt(post({night, dark}), x, 0));
        std::vector<ComponentSpec> above{night, lampAt(1, 0, 1.5), lampAt(0, 1, 1.5), lampAt(-1, 0, 1.5)}, more = above;
        more.insert(more.begin() + 1, below);
        above.insert(above.begin() + 1, dark);
        QCOMPARE(floorAt(post(more), 0.6, 0), floorAt(post(above), 0.6, 0)); // in the shadow of the third lamp above
    }
    void threeLampsCastShadowsAndTheFourthDoesNot() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        std::vector<ComponentSpec> looks{night};
        for (int i = 0; i < 4; ++i) {
            const double turn = i * std::numbers::pi / 2;
            looks.push_back(lampAt(std::cos(turn), std::sin(turn), 1.5));
        }
        const auto cast = post(looks);
        for (ComponentSpec& each : looks) each.values["Shadows"] = {numbers({0}), {}, Origin::Config};
        const auto lit = post(looks);
        for (int i = 0; i < 4; ++i) {
            const double turn = i * std::numbers::pi / 2, x = -0.6 * std::cos(turn), y = -0.6 * std::sin(turn);
            const double dark = floorAt(cast, x, y), bright = floorAt(lit, x, y);
            QVERIFY2((dark < 0.99 * bright) == (i < 3),
                     qPrintable(QStringLiteral("lamp %1: %2 and %3").arg(i).arg(dark).arg(bright)));
        }
    }
    void ambientLightIsAFactor() {
        const ComponentSpec night = look("Light", {{"Intensity", numbers({0})}});
        const double one = floorAt(post({night}), 0.7, 0.7);
        const double four = floorAt(post({night, look("Sky", {{"Ambient", numbers({4})}})}), 0.7, 0.7);
        QVERIFY2(std::abs(four / one - 2) < 0.05, qPrintable(QString::number(four / one))); // displayed: the square root
    }
    void theSkyHasItsColours() {
        auto experiment = post({look("Sky", {{"Zenith", numbers({0, 1, 0})}, {"Horizon", numbers({0, 1, 0})}})});
        experiment->robots[0].pose = {{0, 0, 5}, rotationFromHpr({2, -0.6, 0})}; // up, away from the sun
        const Result<CameraImage> frame = captureAtStart(experiment, "robot0/eye");
        QVERIFY(frame.ok());
        const std::uint8_t* p = frame.value().pixels.data() + 3 * (100 * 200 + 100);
        QVERIFY(p[0] < 10 && p[1] > 245 && p[2] < 10);
    }
    void anUnlitWorldIsBlackAllAround() {
        auto experiment =
            post({look("Sky", {{"Zenith", numbers({0, 0, 0})}, {"Horizon", numbers({0, 0, 0})}, {"Ambient", numbers({0})}}),
                  look("Light", {{"Intensity", numbers({0})}})});
        experiment->statics.clear();
        const osg::Vec3 sun = sunDirection();
        for (const Vec3& towards : {Vec3(sun.x(), sun.y(), sun.z()), Vec3(1, 0, -1), Vec3(0, 0.1, 1)}) {
            const double heading = std::atan2(towards.y(), towards.x()),
                         pitch = -std::atan2(towards.z(), towards.head<2>().norm());
            experiment->robots[0].pose = {{0, 0, 5}, rotationFromHpr({heading, pitch, 0})};
            const Result<CameraImage> frame = captureAtStart(experiment, "robot0/eye");
            QVERIFY(frame.ok());
            QCOMPARE(int(*std::ranges::max_element(frame.value().pixels)), 0);
        }
    }
};

QTEST_APPLESS_MAIN(LightsTest)
#include "lights_test.moc"
