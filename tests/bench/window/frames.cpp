// Measures images per second during a run, and the cost of an image compared with a bare OSG loop that draws the same scene.

#include <thread>

#include <osg/GLExtensions>
#include <osgUtil/SceneView>

#include "base/platform/thread_priority.h"
#include "bench/window/bench_window.h"
#include "editor/shell/work_area.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view/viewport_panel.h"
#include "render/graphics_context.h"
#include "render/platform/egl_context.h"
#include "scene/scene.h"

namespace trundle {
namespace {

/// Cull, draw, finish; no read-back, no threads, no widget.
class BareLoop {
public:
    BareLoop(const ExperimentSpec& experiment, const CameraView& view, int width, int height)
        : m_scene(experiment), m_poses(startPoses(experiment)) {
        auto egl = EglContext::create();
        if (!egl) qFatal("no OpenGL: %s", egl.error().message.c_str());
        m_egl = std::move(egl).value();
        m_context = new GraphicsContext;
        m_ext = m_context->getState()->get<osg::GLExtensions>();
        m_ext->glGenFramebuffers(1, &m_frame);
        m_ext->glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_frame);
        GLuint buffers[2] = {0, 0};
        m_ext->glGenRenderbuffers(2, buffers);
        const GLenum formats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8_EXT},
                     attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
        for (int i = 0; i < 2; ++i) {
            m_ext->glBindRenderbuffer(GL_RENDERBUFFER_EXT, buffers[i]);
            m_ext->glRenderbufferStorage(GL_RENDERBUFFER_EXT, formats[i], width, height);
            m_ext->glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachments[i], GL_RENDERBUFFER_EXT, buffers[i]);
        }
        m_view->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT | osgUtil::SceneView::CLEAR_GLOBAL_STATESET |
                            osgUtil::SceneView::APPLY_GLOBAL_DEFAULTS);
        m_view->setState(m_context->getState());
        m_view->setFrameStamp(m_stamp);
        osg::Camera* camera = m_view->getCamera();
        camera->setGraphicsContext(m_context);
        camera->setDrawBuffer(GL_COLOR_ATTACHMENT0);
        camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
        camera->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        camera->setViewport(0, 0, width, height);
        camera->setProjectionMatrixAsPerspective(2 * std::atan(std::tan(0.5 * view.fieldOfView) * height / width) * 180 / M_PI,
                                                 double(width) / height, 0.5, 8000);
        camera->setViewMatrixAsLookAt({view.eye.x(), view.eye.y(), view.eye.z()},
                                      {view.target.x(), view.target.y(), view.target.z()}, {0, 0, 1});
        m_view->init();
        m_view->setSceneData(&m_scene.root());
        m_view->setCullMask(kMaskSensor);
    }
    ~BareLoop() {
        m_view = nullptr;
        m_context->release();
    }

    void draw() {
        m_stamp->setFrameNumber(++m_number);
        m_scene.setPoses(m_poses);
        m_context->setDefaultFboId(m_frame);
        m_ext->glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_frame);
        m_view->cull();
        m_view->draw();
        glFinish();
    }

private:
    std::unique_ptr<EglContext> m_egl;
    osg::ref_ptr<GraphicsContext> m_context;
    osg::GLExtensions* m_ext = nullptr;
    Scene m_scene;
    BodyPoses m_poses;
    osg::ref_ptr<osg::FrameStamp> m_stamp = new osg::FrameStamp;
    osg::ref_ptr<osgUtil::SceneView> m_view = new osgUtil::SceneView;
    GLuint m_frame = 0;
    unsigned m_number = 0;
};

/// Wall time, and processor time of all threads.
struct Times {
    void add(const std::function<void()>& work) {
        const double start = nowMs(), computed = computedByAllMs();
        work();
        m_times.push_back(nowMs() - start);
        m_computed.push_back(computedByAllMs() - computed);
    }
    [[nodiscard]] QJsonObject json() const {
        QJsonObject all = summary(m_times);
        all.insert(QStringLiteral("computed"), summary(m_computed).value(QStringLiteral("median")));
        return all;
    }
    std::vector<double> m_times, m_computed;
};

} // namespace

QJsonObject measureFrames(const QString& file, double seconds) {
    BenchWindow w;
    w.open(file);
    w.act([&] { w.window->work().showText(false); });
    w.sizeView(1280, 720);
    View& view = w.view();
    const QSize size = view.size();

    int pictures = 0;
    const auto counted = QObject::connect(&view.image(), &ViewImage::shown, [&] { ++pictures; });
    w.trigger("sim.run");
    w.until("it runs", [&] { return w.window->session().results().time() > 0.5; });
    pictures = 0;
    const double begin = nowMs();
    w.wait(1000 * seconds);
    const double perSecond = 1000 * pictures / (nowMs() - begin);
    const double factor = w.window->session().results().realTimeFactor();
    QObject::disconnect(counted);
    w.trigger("sim.reset");
    w.wait(100);
    w.untilSettled();

    PictureRequest request;
    request.scene = w.window->viewport().world().scene();
    request.view = view.camera().view();
    request.width = std::uint32_t(size.width());
    request.height = std::uint32_t(size.height());
    request.mask = kMaskSensor;
    request.samples = 1;
    PictureRequest still = request;
    still.mask = kMaskStill;
    still.samples = 4;
    Times bare, served, finer, painted;
    std::thread([&] {
        lowerThreadPriority(); // as the render service's own thread
        BareLoop loop(*w.window->document().loaded()->experiment, *request.view, size.width(), size.height());
        for (const double start = nowMs(); nowMs() - start < 3000 * seconds;) { // alternating: equal load for all
            for (int i = 0; i < 20; ++i) {
                bare.add([&] { loop.draw(); });
                served.add([&] { (void)w.render->draw(request).get(); });
            }
            finer.add([&] { (void)w.render->draw(still).get(); });
        }
    }).join();
    for (int i = 0; i < 50; ++i) painted.add([&] { view.repaint(); });
    return {{QStringLiteral("renderer"), QString::fromStdString(w.render->renderer())},
            {QStringLiteral("width"), size.width()},
            {QStringLiteral("height"), size.height()},
            {QStringLiteral("pictures_per_second"), perSecond},
            {QStringLiteral("real_time_factor"), factor},
            {QStringLiteral("bare"), bare.json()},
            {QStringLiteral("served"), served.json()},
            {QStringLiteral("finer"), finer.json()},
            {QStringLiteral("painted"), painted.json()}};
}

} // namespace trundle
