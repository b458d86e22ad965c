// Not a test: how long pictures of a view take, beside a bare OSG loop that draws the same scene: frame_times ROBOTS [SECONDS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <osg/GLExtensions>
#include <osgUtil/SceneView>

#include "editor/viewport/view_window.h"
#include "render/graphics_context.h"
#include "render/platform/egl_context.h"
#include "scene/framing.h"
#include "scene/scene.h"

using namespace trundle;

namespace {

double now() { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void say(const char* what, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    std::printf("%-44s %7.2f ms (10th percentile) %7.2f ms (median) of %zu\n", what, times[times.size() / 10],
                times[times.size() / 2], times.size());
}

/// Cull, draw, finish; no reading back, no threads, no widget.
void bareLoop(const ExperimentSpec& experiment, const CameraView& view, int width, int height, double seconds) {
    const auto egl = EglContext::create();
    if (!egl) return;
    osg::ref_ptr<GraphicsContext> context = new GraphicsContext;
    osg::GLExtensions& ext = *context->getState()->get<osg::GLExtensions>();
    GLuint frame = 0, buffers[2] = {0, 0};
    ext.glGenFramebuffers(1, &frame);
    ext.glBindFramebuffer(GL_FRAMEBUFFER_EXT, frame);
    ext.glGenRenderbuffers(2, buffers);
    const GLenum formats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8_EXT},
                 attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        ext.glBindRenderbuffer(GL_RENDERBUFFER_EXT, buffers[i]);
        ext.glRenderbufferStorage(GL_RENDERBUFFER_EXT, formats[i], width, height);
        ext.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachments[i], GL_RENDERBUFFER_EXT, buffers[i]);
    }
    Scene scene(experiment);
    osg::ref_ptr<osgUtil::SceneView> sceneView = new osgUtil::SceneView;
    sceneView->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT | osgUtil::SceneView::CLEAR_GLOBAL_STATESET |
                           osgUtil::SceneView::APPLY_GLOBAL_DEFAULTS);
    sceneView->setState(context->getState());
    sceneView->setFrameStamp(new osg::FrameStamp);
    osg::Camera* camera = sceneView->getCamera();
    camera->setGraphicsContext(context);
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
    camera->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setViewport(0, 0, width, height);
    camera->setProjectionMatrixAsPerspective(2 * std::atan(std::tan(0.5 * view.fieldOfView) * height / width) * 180 / M_PI,
                                             double(width) / height, 0.5, 8000);
    camera->setViewMatrixAsLookAt({view.eye.x(), view.eye.y(), view.eye.z()}, {view.target.x(), view.target.y(), view.target.z()},
                                  {0, 0, 1});
    sceneView->init();
    sceneView->setSceneData(&scene.root());
    sceneView->setCullMask(kMaskSensor);
    const BodyPoses poses = startPoses(experiment);
    std::vector<double> times;
    const double begin = now();
    for (unsigned n = 0; now() - begin < 1000 * seconds; ++n) {
        const double t = now();
        const_cast<osg::FrameStamp*>(sceneView->getFrameStamp())->setFrameNumber(n);
        scene.setPoses(poses);
        context->setDefaultFboId(frame);
        ext.glBindFramebuffer(GL_FRAMEBUFFER_EXT, frame);
        sceneView->cull();
        sceneView->draw();
        glFinish();
        times.push_back(now() - t);
    }
    say("bare OSG loop", times);
    sceneView = nullptr;
    context->release();
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const int robots = argc > 1 ? std::atoi(argv[1]) : 30;
    const double seconds = argc > 2 ? std::atof(argv[2]) : 5;
    QByteArray text = "#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\nStatic arena { Config=MediumArena "
                      "Pos=0,0,0 side=6 }\n";
    for (int i = 0; i < robots; ++i)
        text += QStringLiteral("Robot robot%1 { Config=SimpleRobot Pos=%2,%3,0 HPR=%4,0,0 }\n")
                    .arg(i)
                    .arg(0.9 * (i % 6) - 2.2)
                    .arg(0.9 * (i / 6) - 2.0)
                    .arg(37 * i % 360)
                    .toUtf8();
    auto render = RenderService::startInBackground();
    ViewWindow window(render.get());
    if (!window.open(text)) return 1;
    window.panel->resize(1280, 720 + window.panel->height() - window.view().height());
    QElapsedTimer settled;
    settled.start();
    while (settled.elapsed() < 1500) QApplication::processEvents(QEventLoop::AllEvents, 20);
    std::printf("%s, %d robots, %d x %d\n", render->renderer().c_str(), robots, window.view().width(), window.view().height());
    const CameraView view = window.view().cameraView();
    bareLoop(*window.document.loaded()->experiment, view, window.view().width(), window.view().height(), seconds);

    // As while orbiting: every picture asks for the next one.
    std::vector<double> times;
    double last = now();
    QObject::connect(&window.view(), &View::pictureShown, &window.view(), [&] {
        times.push_back(now() - last);
        last = now();
        window.view().redraw();
    });
    window.view().redraw();
    QEventLoop loop;
    QTimer::singleShot(int(1000 * seconds), &loop, &QEventLoop::quit);
    loop.exec();
    say("view: from picture to picture, painted", times);
    QObject::disconnect(&window.view(), &View::pictureShown, nullptr, nullptr);
    while (!window.panel->isUpToDate()) QApplication::processEvents(QEventLoop::AllEvents, 20);
    std::vector<double> painted;
    for (int i = 0; i < 60; ++i) {
        const double t = now();
        window.view().repaint();
        painted.push_back(now() - t);
    }
    say("view: painting a picture that is there", painted);
    std::vector<double> drawn;
    PictureRequest request;
    request.scene = window.panel->world().scene();
    request.view = view;
    request.width = std::uint32_t(window.view().width());
    request.height = std::uint32_t(window.view().height());
    request.mask = kMaskSensor;
    request.samples = 1;
    for (int i = 0; i < 60; ++i) {
        const double t = now();
        (void)render->draw(request).get();
        drawn.push_back(now() - t);
    }
    say("service: request to pixels", drawn);
    const auto experiment = window.document.loaded()->experiment;
    std::vector<double> added;
    for (int i = 0; i < 10; ++i) {
        const double t = now();
        const SceneId scene = render->addScene(experiment);
        PickRequest pick;
        pick.scene = scene;
        (void)render->pick(pick).get();
        added.push_back(now() - t);
        render->removeScene(scene);
    }
    say("service: a scene after an edit", added);
    return 0;
}
