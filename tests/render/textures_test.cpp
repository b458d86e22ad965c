// Textures on geoms, as a camera sees them.
#include <QtTest>

#include "base/mesh_appearance.h"
#include "render/camera_experiment.h"
#include "render/sample_experiment.h"

using namespace trundle;

namespace {

/// Four quarters: red and green above, blue and white below.
std::shared_ptr<const Raster> quarters() {
    auto raster = std::make_shared<Raster>(Raster{64, 64, {}});
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const bool right = x >= 32, low = y >= 32;
            const std::array<std::uint8_t, 3> colour{std::uint8_t(right == low ? 255 : 0), std::uint8_t(right ? 255 : 0),
                                                     std::uint8_t(low ? 255 : 0)};
            raster->pixels.insert(raster->pixels.end(), colour.begin(), colour.end());
        }
    }
    return raster;
}

/// The quarter to which a colour belongs: R, G, B or W.
char quarterOf(const std::uint8_t* p) {
    const bool r = p[0] > 110, g = p[1] > 110, b = p[2] > 110;
    return r && g && b ? 'W' : r && !g && !b ? 'R' : g && !r && !b ? 'G' : b && !r && !g ? 'B' : '?';
}

std::shared_ptr<ExperimentSpec> pictured(GeomShape shape, Pose eye, double scale = 1) {
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->materials.resize(2);
    experiment->materials[1].texture = "quarters";
    experiment->materials[1].picture = quarters();
    experiment->materials[1].textureScale = scale;
    GeomSpec geom;
    geom.name = "thing";
    geom.shape = shape;
    geom.material = 1;
    geom.size = {1, 1, 1};
    geom.radius = 0.5;
    geom.length = 1;
    StaticSpec fixed;
    fixed.name = "one";
    fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::vector{geom});
    experiment->statics = {fixed};
    experiment->robots = {cameraRobot("robot0", eye, {{"Resolution", numbers({100, 100})}, {"FieldOfView", numbers({0.6})}})};
    return experiment;
}

/// The quarters at four pixels of an image, row by row.
std::string seen(const std::shared_ptr<ExperimentSpec>& experiment, int low = 35, int high = 65) {
    const Result<CameraImage> frame = captureAtStart(experiment, "robot0/eye");
    if (!frame) return frame.error().message;
    std::string letters;
    for (const int y : {low, high})
        for (const int x : {low, high}) letters += quarterOf(frame.value().pixels.data() + 3 * (y * 100 + x));
    return letters;
}

const Pose kFromWest{{-3, 0, 0}, Quat::Identity()}; // looks along x
const Pose kFromSouth{{0, -3, 0}, rotationFromHpr({std::numbers::pi / 2, 0, 0})};
const Pose kFromAbove{{0, 0, 3}, rotationFromHpr({std::numbers::pi / 2, std::numbers::pi / 2, 0})}; // the top of the image is +y

/// A square facing the camera in the west: its upper half shows the quarters, its lower half is red.
std::shared_ptr<ExperimentSpec> meshWithAppearance(std::uint32_t material) {
    auto look = std::make_shared<MeshAppearance>();
    look->materials.resize(2);
    look->materials[0].picture = quarters();
    look->materials[1].colour = {1, 0, 0};
    look->material = {0, 0, 1, 1};
    look->onPicture = {{{{0, 1}, {1, 1}, {1, 0}}}, {{{0, 1}, {1, 0}, {0, 0}}}, {}, {}};
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, 0.5, 0}, {0, -0.5, 0}, {0, -0.5, 0.5}, {0, 0.5, 0.5}, {0, 0.5, -0.5}, {0, -0.5, -0.5}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}};
    mesh->look = look;
    auto experiment = pictured(GeomShape::Mesh, kFromWest);
    auto geoms = *experiment->statics[0].geoms;
    geoms[0].mesh = mesh;
    geoms[0].material = material;
    experiment->materials[1].picture = nullptr;
    experiment->materials[1].colour = {0, 0, 1};
    experiment->statics[0].geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
    return experiment;
}

} // namespace

class TexturesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBoxShowsThePictureOnItsSides() {
        for (const Pose& eye : {kFromWest, kFromSouth, kFromAbove})
            QCOMPARE(seen(pictured(GeomShape::Box, eye)), std::string("RGBW"));
    }
    void aScaleRepeatsIt() {
        // Two repetitions along each side: the texture centres are a quarter of the side from the middle, their corners a little off them.
        QCOMPARE(seen(pictured(GeomShape::Box, kFromWest, 2), 45, 55), std::string("WBGR"));
    }
    void aCapOfACylinderShowsIt() { QCOMPARE(seen(pictured(GeomShape::Cylinder, kFromAbove), 40, 60), std::string("RGBW")); }
    void aFloorShowsItOnEveryMetre() {
        const Pose above{{0.5, 0.5, 3}, kFromAbove.rotation};
        QCOMPARE(seen(pictured(GeomShape::Plane, above), 45, 55), std::string("RGBW"));
    }
    // The square is 54 pixels wide and high about the middle.
    void usesAppearanceOfMeshFile() {
        const CameraImage frame = captureAtStart(meshWithAppearance(0), "robot0/eye").value();
        const auto at = [&](int x, int y) { return quarterOf(frame.pixels.data() + 3 * (y * 100 + x)); };
        QCOMPARE((std::string{at(35, 32), at(65, 32), at(35, 44), at(65, 44), at(35, 60), at(65, 60)}), std::string("RGBWRR"));
    }
    void prefersMaterialOfText() {
        const CameraImage frame = captureAtStart(meshWithAppearance(1), "robot0/eye").value();
        for (const auto& [x, y] : {std::pair{35, 32}, {65, 44}, {35, 60}})
            QCOMPARE(quarterOf(frame.pixels.data() + 3 * (y * 100 + x)), 'B');
    }
    void aPictureIsLitAsAColourIs() {
        auto experiment = pictured(GeomShape::Box, kFromWest);
        auto plain = std::make_shared<Raster>(Raster{1, 1, {128, 64, 200}});
        experiment->materials[1].picture = plain;
        const CameraImage withPicture = captureAtStart(experiment, "robot0/eye").value();
        experiment->materials[1].picture = nullptr;
        experiment->materials[1].colour = {128 / 255.0, 64 / 255.0, 200 / 255.0};
        const CameraImage withColour = captureAtStart(experiment, "robot0/eye").value();
        for (std::size_t i = 3 * (50 * 100 + 50), k = 0; k < 3; ++k)
            QVERIFY(std::abs(int(withPicture.pixels[i + k]) - int(withColour.pixels[i + k])) <= 1);
    }
};

QTEST_APPLESS_MAIN(TexturesTest)
#include "textures_test.moc"
