// Backgrounds that are kept: the same bytes as if everything had been drawn anew.
#include <QtTest>

#include <osg/GLExtensions>

#include "render/backgrounds.h"
#include "render/camera_experiment.h"
#include "render/platform/egl_context.h"
#include "render/sample_experiment.h"
#include "render/started_service.h"

using namespace trundle;

namespace {

/// A context of its own.
struct Gl {
    std::unique_ptr<EglContext> egl;
    osg::ref_ptr<GraphicsContext> context;
    Gl() {
        Result<std::unique_ptr<EglContext>> made = EglContext::create();
        if (!made) qFatal("no OpenGL");
        egl = std::move(made).value();
        context = new GraphicsContext;
    }
    ~Gl() { context->release(); }
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;
    [[nodiscard]] osg::GLExtensions& ext() const { return *context->getState()->get<osg::GLExtensions>(); }
};

/// A framebuffer like those of targets.
class Frame {
public:
    Frame(osg::GLExtensions& gl, int width, int height) : m_gl(gl) {
        gl.glGenFramebuffers(1, &id);
        gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, id);
        gl.glGenRenderbuffers(2, m_buffers);
        const std::pair<GLenum, GLenum> kinds[] = {{GL_RGBA8, GL_COLOR_ATTACHMENT0},
                                                   {GL_DEPTH24_STENCIL8_EXT, GL_DEPTH_STENCIL_ATTACHMENT}};
        for (int i = 0; i < 2; ++i) {
            gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, m_buffers[i]);
            gl.glRenderbufferStorage(GL_RENDERBUFFER_EXT, kinds[i].first, width, height);
            gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, kinds[i].second, GL_RENDERBUFFER_EXT, m_buffers[i]);
        }
    }
    ~Frame() {
        m_gl.glDeleteFramebuffers(1, &id);
        m_gl.glDeleteRenderbuffers(2, m_buffers);
    }
    void fill(float red, float depth, int stencil) const {
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, id);
        glClearColor(red, 0, 0, 1);
        glClearDepth(depth);
        glClearStencil(stencil);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    /// Red, depth in per cent, and stencil of a pixel.
    [[nodiscard]] std::array<int, 3> at(int x, int y) const {
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, id);
        std::uint8_t colour[4], stencil = 0;
        float depth = 0;
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, colour);
        glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        glReadPixels(x, y, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
        return {colour[0], int(std::lround(100 * depth)), stencil};
    }
    GLuint id = 0;

private:
    osg::GLExtensions& m_gl;
    GLuint m_buffers[2]{};
};

Backgrounds::Key keyOf(int number) {
    Backgrounds::Key key;
    key.scene = SceneId(1);
    key.view.makeTranslate(number, 0, 0);
    return key;
}

/// Robots in an arena, and a Led above the floor.
std::shared_ptr<ExperimentSpec> yard(double side = 4) {
    auto experiment = sampleExperiment({4, 0.7, true, side});
    RobotSpec lamp = cameraRobot("lamp", {{0, 0.3, 0.4}, Quat::Identity()}, {});
    auto config = std::make_shared<RobotConfigSpec>(*lamp.config);
    ComponentSpec led;
    led.kind = led.name = "Led";
    led.values["Body"] = {{PropertyType::Reference, {}, {"mount"}}, {}, Origin::Config};
    led.values["Intensity"] = {numbers({200}), {}, Origin::Config};
    config->devices = {led};
    lamp.config = config;
    experiment->robots.push_back(lamp);
    return experiment;
}

PictureRequest requestOf(const ExperimentSpec& experiment, int step) {
    PictureRequest request;
    CameraView view;
    view.eye = {3, -2, 2};
    view.target = {0, 0, 0};
    request.view = view;
    request.width = 160;
    request.height = 120;
    request.mask = kMaskSensor;
    request.samples = 1;
    request.capture = true;
    auto poses = std::make_shared<BodyPoses>(startPoses(experiment));
    for (std::size_t i = 0; i < poses->size(); ++i) (*poses)[i].position.x() += 0.03 * step;
    poses->leds = {LedColour{}};
    request.poses = poses;
    return request;
}

} // namespace

class BackgroundsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void keepsColourDepthAndStencil() {
        Gl gl;
        const Frame frame(gl.ext(), 20, 10);
        Backgrounds backgrounds(*gl.context, 20, 10);
        frame.fill(1, 0.25f, 5);
        QVERIFY(!backgrounds.restore(keyOf(1), frame.id));
        backgrounds.keep(keyOf(1), frame.id);
        QCOMPARE(backgrounds.kept(), 0u); // seen once: it may be a camera that moves
        QVERIFY(!backgrounds.restore(keyOf(1), frame.id));
        backgrounds.keep(keyOf(1), frame.id);
        QCOMPARE(backgrounds.kept(), 1u);
        frame.fill(0, 0.75f, 9);
        QVERIFY(!backgrounds.restore(keyOf(2), frame.id));
        QCOMPARE(frame.at(19, 9), (std::array{0, 75, 9}));
        QVERIFY(backgrounds.restore(keyOf(1), frame.id));
        for (const auto& [x, y] : {std::pair{0, 0}, {19, 0}, {0, 9}, {19, 9}}) QCOMPARE(frame.at(x, y), (std::array{255, 25, 5}));
    }

    void anythingElseInTheKeyIsAnotherBackground() {
        Gl gl;
        const Frame frame(gl.ext(), 20, 10);
        Backgrounds backgrounds(*gl.context, 20, 10);
        for (int i = 0; i < 2; ++i) backgrounds.keep(keyOf(1), frame.id);
        std::vector<Backgrounds::Key> others(6, keyOf(1));
        others[0].scene = SceneId(2);
        others[1].view(3, 1) = 1e-12;
        others[2].projection(0, 0) = 2;
        others[3].mask = 1;
        others[4].floorLines = false;
        others[5].hidden = {"arena"};
        for (const Backgrounds::Key& other : others) QVERIFY(!backgrounds.restore(other, frame.id));
        QVERIFY(backgrounds.restore(keyOf(1), frame.id));
    }

    /// 48 MiB of 8 bytes a pixel: six images of 1024 x 1024. What is in use keeps its room, what is not for long goes.
    void memoryIsBounded() {
        Gl gl;
        const Frame frame(gl.ext(), 1024, 1024);
        Backgrounds backgrounds(*gl.context, 1024, 1024);
        const auto draw = [&](int number) {
            const bool isKept = backgrounds.restore(keyOf(number), frame.id);
            if (!isKept) backgrounds.keep(keyOf(number), frame.id);
            return isKept;
        };
        for (int round = 0; round < 3; ++round)
            for (int number = 0; number < 8; ++number) QCOMPARE(draw(number), round == 2 && number < 6);
        QCOMPARE(backgrounds.kept(), 6u);
        for (int number = 100; number < 400; ++number) QVERIFY(!draw(number)); // a camera that moves
        QCOMPARE(backgrounds.kept(), 6u);
        QVERIFY(draw(3));
        QVERIFY(!draw(7) && !draw(7) && draw(7)); // in the room of number 0
        QCOMPARE(backgrounds.kept(), 6u);
        QVERIFY(draw(3) && !draw(0));
    }

    /// One scene draws a sequence of pictures, a new one each of them alone.
    void bytesDoNotDependOnWhatWasDrawnBefore_data() {
        QTest::addColumn<int>("what");
        for (const auto& [name, what] : {std::pair{"nothing changes but poses", 0},
                                         {"the camera moves", 1},
                                         {"floor lines", 2},
                                         {"hidden walls", 3},
                                         {"hidden floor", 4},
                                         {"wireframe", 5},
                                         {"a smaller mask", 6},
                                         {"another size", 7},
                                         {"lines of pens", 8},
                                         {"another scene", 9},
                                         {"hidden robot", 10},
                                         {"a Led shines", 11}})
            QTest::newRow(name) << what;
    }
    void bytesDoNotDependOnWhatWasDrawnBefore() {
        QFETCH(int, what);
        const auto experiment = yard();
        const auto other = yard(3);
        std::unique_ptr<RenderService> service, alone;
        startService(service);
        startService(alone);
        const SceneId scene = service->addScene(experiment), second = service->addScene(other);
        const auto change = [&](PictureRequest& request) {
            if (what == 1) request.view->eye.x() += 0.01;
            if (what == 2) request.floorLines = false;
            if (what == 3) request.hidden = {"arena/north"};
            if (what == 4) request.hidden = {"arena/floor"};
            if (what == 5) request.wireframe = true;
            if (what == 6) request.mask &= ~kMaskShadows;
            if (what == 7) request.width = 200;
            if (what == 10) request.hidden = {"robot1"};
            if (what != 8 && what != 11) return;
            auto poses = std::make_shared<BodyPoses>(*request.poses);
            if (what == 11) poses->leds = {LedColour{1, 1, 0.5f}};
            request.poses = poses;
            if (what != 8) return;
            PenLine line;
            line.points = {{{-1, 0, 0}, true}, {{1, 0.5, 0}, false}};
            line.width = 0.1;
            poses->lines = std::make_shared<const std::vector<PenLine>>(std::vector{line});
        };
        QByteArray last;
        for (int step = 0; step < 9; ++step) {
            PictureRequest request = requestOf(*experiment, step);
            const bool isChanged = step == 3 || step == 4 || step == 5 || step == 7;
            if (isChanged) change(request);
            request.scene = isChanged && what == 9 ? second : scene;
            const Result<Image> image = service->draw(request).get();
            QVERIFY(image.ok());
            request.scene = alone->addScene(isChanged && what == 9 ? other : experiment);
            const Result<Image> expected = alone->draw(request).get();
            QVERIFY(expected.ok());
            QVERIFY2(image.value().pixels == expected.value().pixels, qPrintable(QStringLiteral("picture %1").arg(step)));
            const QByteArray bytes(reinterpret_cast<const char*>(image.value().pixels.data()),
                                   qsizetype(image.value().pixels.size()));
            QVERIFY(bytes != last); // the robots have moved
            last = bytes;
        }
    }
};

QTEST_APPLESS_MAIN(BackgroundsTest)
#include "backgrounds_test.moc"
