// The rich look: its additional effects, and what it must not change.
#include <QtTest>

#include "render/camera_experiment.h"
#include "render/render_thread_state.h"
#include "render/sample_experiment.h"
#include "render/started_service.h"

using namespace trundle;

namespace {

constexpr std::uint32_t kWidth = 320, kHeight = 240;

GeomSpec box(const std::string& name, const Vec3& size, const Vec3& middle, double turn = 0) {
    GeomSpec geom;
    geom.name = name;
    geom.size = size;
    geom.pose = {middle, rotationFromHpr({turn, 0, 0})};
    return geom;
}

ComponentSpec sun(double intensity, double shadows = 1) {
    ComponentSpec spec;
    spec.kind = spec.name = "Light";
    spec.values["Direction"] = {numbers({1, 0, -1}), {}, Origin::Config};
    spec.values["Intensity"] = {numbers({intensity}), {}, Origin::Config};
    spec.values["Shadows"] = {numbers({shadows}), {}, Origin::Config};
    return spec;
}

/// Boxes on a floor. The sun shines towards +x at 45 degrees.
std::shared_ptr<ExperimentSpec> yard(std::vector<GeomSpec> geoms, const ComponentSpec& light) {
    auto experiment = sampleExperiment({0, 1, false, 4});
    GeomSpec floor;
    floor.name = "floor";
    floor.shape = GeomShape::Plane;
    floor.material = 6;
    geoms.push_back(floor);
    StaticSpec fixed;
    fixed.name = "yard";
    fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(geoms));
    experiment->statics = {fixed};
    experiment->looks = {light};
    return experiment;
}

/// A post, and a table in its shadow.
std::vector<GeomSpec> postAndTable() {
    return {box("post", {0.2, 0.2, 1}, {0, 0, 0.5}), box("table", {0.6, 0.6, 0.2}, {0.6, 0, 0.1})};
}

PictureRequest from(const Vec3& eye, const Vec3& target) {
    PictureRequest request;
    request.view.emplace();
    request.view->eye = eye;
    request.view->target = target;
    request.width = kWidth;
    request.height = kHeight;
    request.mask = kMaskSensor;
    request.samples = 4;
    return request;
}

const std::uint8_t* pixelAt(const Image& image, const PictureRequest& request, const Vec3& place) {
    const auto at = project(*request.view, kWidth, kHeight, place);
    return image.at(std::uint32_t(at->x), std::uint32_t(at->y));
}

} // namespace

class RichTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { startService(m_service); }
    void cleanup() {
        m_service->setLook(LookChoice::Automatic);
        QCOMPARE(m_service->takeWarning(), std::string());
    }

    void castsShadowsOntoObjects() {
        const PictureRequest request = from({0.6, -2, 2}, {0.5, 0, 0.2});
        const auto [fast, rich] = both(yard(postAndTable(), sun(1)), request);
        const Vec3 shaded(0.6, 0, 0.2), open(0.6, 0.25, 0.2);
        QVERIFY(pixelAt(rich, request, shaded)[1] < 0.8 * pixelAt(rich, request, open)[1]);
        QVERIFY(pixelAt(fast, request, shaded)[1] > 0.97 * pixelAt(fast, request, open)[1]);
    }

    void itFallsOnTheFloorAndOnItselfToo() {
        // An arch: the floor below it, and its own leg that is in the shadow of the other.
        const PictureRequest request = from({3, -3, 2}, {0.4, 0, 0.3});
        const auto [fast, rich] =
            both(yard({box("left", {0.1, 0.6, 1}, {0, 0, 0.5}), box("right", {0.1, 0.2, 0.4}, {0.5, 0, 0.2})}, sun(1)), request);
        const Vec3 shaded(0.9, 0.2, 0), open(1.6, 0.2, 0);
        for (const Image& image : {fast, rich})
            QVERIFY(pixelAt(image, request, shaded)[1] < 0.85 * pixelAt(image, request, open)[1]);
        const Vec3 top(0.5, 0, 0.4);
        QVERIFY(pixelAt(rich, request, top)[1] < 0.8 * pixelAt(fast, request, top)[1]);
    }

    void sunlitSurfacesAreUnshaded() {
        // Rotated by all angles; every lit face looks as with a sun that casts no shadows.
        for (int i = 0; i < 12; ++i) {
            const std::vector<GeomSpec> one{box("crate", {0.5, 0.5, 0.5}, {0, 0, 0.25}, 0.13 * i)};
            const PictureRequest request = from({-1.5, -1.2, 1.2}, {0, 0, 0.25});
            const Image cast = rich(yard(one, sun(1)), request), lit = rich(yard(one, sun(1, 0)), request);
            int surface = 0, darker = 0;
            for (std::uint32_t y = 0; y < kHeight; y += 4) {
                for (std::uint32_t x = 0; x < kWidth; x += 4) {
                    const auto hit = m_service->pick({m_scene, *request.view, kWidth, kHeight, x + 0.5, y + 0.5}).get();
                    if (!hit || hit.value().path != "yard/crate") continue;
                    ++surface;
                    darker += cast.at(x, y)[1] + 2 < lit.at(x, y)[1];
                }
            }
            QVERIFY(surface > 300);
            QVERIFY2(darker <= surface / 50, qPrintable(QStringLiteral("%1 of %2, turn %3").arg(darker).arg(surface).arg(i)));
        }
    }

    void translucentObjectsCastLighterShadow() {
        const PictureRequest request = from({1, -3, 2}, {0.5, 0, 0.3});
        std::vector<GeomSpec> walls{box("left", {0.1, 0.6, 0.6}, {0, -0.5, 0.3}), box("right", {0.1, 0.6, 0.6}, {0, 0.5, 0.3})};
        walls[1].material = 8; // glass
        const Image image = rich(yard(walls, sun(1)), request);
        const int dark = pixelAt(image, request, {0.35, -0.55, 0})[1], light = pixelAt(image, request, {0.35, 0.55, 0})[1],
                  open = pixelAt(image, request, {1.25, 0.55, 0})[1];
        QVERIFY2(dark + 10 < light && light + 5 < open, qPrintable(QStringLiteral("%1 %2 %3").arg(dark).arg(light).arg(open)));
    }

    void aCornerIsDarker() {
        // No sun at all: the sky alone.
        const std::vector<GeomSpec> corner{box("back", {2, 0.1, 1}, {0, 0.5, 0.5}), box("side", {0.1, 1, 1}, {-0.5, 0, 0.5})};
        const PictureRequest request = from({1.5, -2, 1.5}, {-0.2, 0.2, 0.3});
        const auto [fast, rich] = both(yard(corner, sun(0)), request);
        const Vec3 inside(-0.43, 0.43, 0), outside(0.4, -0.4, 0);
        QVERIFY(pixelAt(rich, request, inside)[1] < 0.9 * pixelAt(rich, request, outside)[1]);
        QVERIFY(pixelAt(fast, request, inside)[1] > 0.97 * pixelAt(fast, request, outside)[1]);
        QVERIFY(std::abs(pixelAt(rich, request, outside)[1] - pixelAt(fast, request, outside)[1]) <= 1);
    }

    void edgesAreSmooth() {
        auto experiment = lampExperiment({{0, 0, 0}}, 0.5);
        experiment->materials[0].emission = {1, 0, 0};
        const Image image = rich(experiment, from({0, -3, 1}, Vec3::Zero()));
        // Between the red of the ball and the sky.
        int mixed = 0;
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const std::uint8_t green = image.at(x, kHeight / 2)[1];
            mixed += image.at(x, kHeight / 2)[0] > 200 && green > 20 && green < 180;
        }
        QVERIFY(mixed > 0);
    }

    void aViewThatMovesIsQuick() {
        PictureRequest request = from({0.6, -2, 2}, {0.5, 0, 0.2});
        request.samples = 1;
        const auto [fast, rich] = both(yard(postAndTable(), sun(1)), request);
        QVERIFY(fast == rich);
    }

    void equalRequestsGiveEqualBytes() {
        const auto experiment = sampleExperiment({9});
        auto other = RenderService::start();
        QVERIFY(other.ok());
        PictureRequest first = from({2, -3, 2}, Vec3::Zero()), second = from({-3, 1, 0.5}, Vec3::Zero());
        const Image a = rich(experiment, first), b = rich(experiment, second);
        QVERIFY(!(a == b));
        QVERIFY(rich(experiment, first) == a);
        other.value()->setLook(LookChoice::Rich);
        for (PictureRequest* request : {&second, &first}) request->scene = other.value()->addScene(experiment);
        QVERIFY(other.value()->draw(second).get().value() == b);
        QVERIFY(other.value()->draw(first).get().value() == a);
    }

    void inSoftwareAutomaticIsFast() {
        if (!m_service->isSoftware()) return;
        const auto experiment = sampleExperiment({4});
        PictureRequest request = from({2, -3, 2}, Vec3::Zero());
        request.scene = m_service->addScene(experiment);
        const Image automatic = m_service->draw(request).get().value();
        const auto [fast, rich] = both(experiment, request);
        QVERIFY(automatic == fast);
        QVERIFY(!(automatic == rich));
    }

    void sensorImagesIgnoreRenderStyle() {
        const auto experiment = sampleExperiment({4});
        PictureRequest request = from({2, -3, 2}, Vec3::Zero());
        request.capture = true;
        const auto [fast, rich] = both(experiment, request);
        QVERIFY(fast == rich);
        request.scene = m_service->addScene(experiment);
        const DataImage before = m_service->measure(request).get().value();
        m_service->setLook(LookChoice::Fast);
        const DataImage after = m_service->measure(request).get().value();
        QVERIFY(before.depth == after.depth && before.objects == after.objects);
    }

    void drawsLinesWithoutShadows() {
        PictureRequest request = from({0.6, -2, 2}, {0.5, 0, 0.2});
        request.wireframe = true;
        request.mask = kMaskWorld;
        const auto [fast, rich] = both(yard(postAndTable(), sun(1)), request);
        QVERIFY(fast == rich);
    }

    void aBrokenProgramIsNoticed() {
        auto opened = RenderThreadState::open();
        QVERIFY(opened.ok());
        RenderThreadState& state = *opened.value();
        state.add(SceneId(1), yard(postAndTable(), sun(1)), nullptr);
        PictureRequest request = from({0.6, -2, 2}, {0.5, 0, 0.2});
        request.scene = SceneId(1);
        const Image fast = state.draw(request, LookChoice::Fast).value();
        auto* opening = dynamic_cast<osg::Program*>(state.look().opened->getAttribute(osg::StateAttribute::PROGRAM));
        QVERIFY(opening);
        opening->getShader(1)->setShaderSource("#version 130\nvoid main() { nonsense; }\n");
        // A shader that only the rich look needs: the fast look is used instead, and the warning is given once.
        QVERIFY(state.draw(request, LookChoice::Rich).value() == fast);
        const std::string notice = state.takeWarning();
        QVERIFY2(notice.starts_with("the rich look is not available, so pictures have the fast one: the program \"opened\" does "
                                    "not suit this OpenGL: ") &&
                     notice.find("nonsense") != std::string::npos,
                 notice.c_str());
        QVERIFY(state.draw(request, LookChoice::Rich).value() == fast);
        QCOMPARE(state.takeWarning(), std::string());
        // A shader that both looks need.
        state.look().floor->getShader(1)->setShaderSource("#version 130\nvoid main() { nonsense; }\n");
        const Result<Image> broken = state.draw(request, LookChoice::Fast);
        QVERIFY(!broken);
        QVERIFY2(broken.error().message.starts_with("the program \"floor\" does not suit this OpenGL: "),
                 broken.error().message.c_str());
    }

private:
    Image rich(const std::shared_ptr<ExperimentSpec>& experiment, PictureRequest request) {
        m_service->setLook(LookChoice::Rich);
        request.scene = m_scene = m_service->addScene(experiment);
        const auto image = m_service->draw(request).get();
        if (!image) qFatal("%s", image.error().message.c_str());
        return image.value();
    }
    std::pair<Image, Image> both(const std::shared_ptr<ExperimentSpec>& experiment, PictureRequest request) {
        m_service->setLook(LookChoice::Fast);
        request.scene = m_service->addScene(experiment);
        const auto image = m_service->draw(request).get();
        if (!image) qFatal("%s", image.error().message.c_str());
        return {image.value(), rich(experiment, request)};
    }

    std::unique_ptr<RenderService> m_service;
    SceneId m_scene = SceneId::None; // of the last rich picture
};

QTEST_APPLESS_MAIN(RichTest)
#include "rich_test.moc"
