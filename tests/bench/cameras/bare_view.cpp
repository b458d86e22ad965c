#include "bench/cameras/bare_view.h"

#include <algorithm>
#include <map>

#include <osg/GLExtensions>
#include <osg/MatrixTransform>
#include <osgUtil/SceneView>

#include "render/graphics_context.h"
#include "render/platform/egl_context.h"
#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/osg_types.h"
#include "scene/nodes/surroundings.h"
#include "scene/queries/camera_model.h"

namespace trundle {
namespace {

constexpr double kReach = 400, kReachInRadii = 60; // m, of the floor

osg::ref_ptr<osg::Group> shapesOf(const std::vector<GeomSpec>& geoms, const ExperimentSpec& experiment, const SceneShading& look,
                                  Pictures& pictures) {
    static std::map<const void*, osg::ref_ptr<osg::Group>> known;
    osg::ref_ptr<osg::Group>& node = known[&geoms];
    if (!node) node = makeGeomNode(geoms, experiment.materials, {}, look, pictures);
    return node;
}

} // namespace

struct BareView::Parts {
    Parts(const ExperimentSpec& experiment, const SignalLayout& layout) : reader(experiment, layout) {}

    CameraModel camera;
    PoseReader reader;
    BodyPoses poses;
    std::unique_ptr<EglContext> egl;
    osg::ref_ptr<GraphicsContext> context;
    SceneShading look;
    Pictures pictures;
    osg::ref_ptr<osg::Group> root = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> bodies;
    osg::ref_ptr<osgUtil::SceneView> view = new osgUtil::SceneView;
    GLuint frame = 0, colour = 0, depth = 0;
    std::vector<std::uint8_t> rows, pixels;

    [[nodiscard]] osg::GLExtensions& gl() const { return *context->getState()->get<osg::GLExtensions>(); }

    void build(const ExperimentSpec& experiment) {
        const BodyPoses start = startPoses(experiment);
        osg::ref_ptr<osg::Group> solid = new osg::Group;
        const auto add = [&](osg::Group& to, const std::vector<GeomSpec>& geoms, const Pose& pose) {
            osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(pose));
            node->addChild(shapesOf(geoms, experiment, look, pictures));
            to.addChild(node);
            return node;
        };
        for (const RobotSpec& robot : experiment.robots) {
            osg::ref_ptr<osg::Group> whole = new osg::Group;
            for (const BodySpec& body : robot.config->bodies) bodies.push_back(add(*whole, body.geoms, start[bodies.size()]));
            solid->addChild(whole);
        }
        for (const StaticSpec& fixed : experiment.statics) add(*solid, *fixed.geoms, fixed.pose);
        root->addChild(solid);
        Bounds about;
        for (unsigned i = 0; i < solid->getNumChildren(); ++i) {
            const osg::BoundingSphere ball = solid->getChild(i)->getBound();
            Bounds one;
            one.add(Vec3(ball.center().x(), ball.center().y(), ball.center().z()));
            one.grow(ball.radius());
            about.add(one);
        }
        surround(experiment, *solid, about);
    }

    void surround(const ExperimentSpec& experiment, osg::Group& solid, const Bounds& about) {
        const SceneUniforms uniforms;
        osg::StateSet& state = *root->getOrCreateStateSet();
        SceneShading::applyTo(state, uniforms);
        const Lighting lighting = lightingOf(experiment);
        lighting.applyTo(state);
        const double reach = std::max(kReach, kReachInRadii * about.radius());
        uniforms.haze->set(static_cast<float>(reach / 5));
        const std::vector<FloorPlane> floors = floorPlanes(experiment);
        for (unsigned i = 0; i < floors.size(); ++i) {
            uniforms.ground->set(static_cast<float>(floors[i].pose.position.z()));
            root->addChild(makeFloorNode(floors[i], i, about, reach, look, pictures, lighting));
            root->addChild(makeSharpShadow(floors[i], i, solid, look, lighting));
        }
        root->addChild(makeSkyNode(look));
    }

    void open() {
        context = new GraphicsContext;
        view->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT | osgUtil::SceneView::CLEAR_GLOBAL_STATESET |
                          osgUtil::SceneView::APPLY_GLOBAL_DEFAULTS);
        view->setState(context->getState());
        view->setFrameStamp(new osg::FrameStamp);
        osg::Camera& lens = *view->getCamera();
        lens.setGraphicsContext(context);
        lens.setDrawBuffer(GL_COLOR_ATTACHMENT0);
        lens.setReadBuffer(GL_COLOR_ATTACHMENT0);
        lens.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        lens.setClearColor(osg::Vec4(0.5f, 0.5f, 0.5f, 1));
        lens.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        lens.setViewport(0, 0, int(camera.width), int(camera.height));
        view->init();
        view->setSceneData(root);
        const auto buffer = [&](GLuint& name, GLenum format, GLenum attachment) {
            gl().glGenRenderbuffers(1, &name);
            gl().glBindRenderbuffer(GL_RENDERBUFFER_EXT, name);
            gl().glRenderbufferStorage(GL_RENDERBUFFER_EXT, format, GLsizei(camera.width), GLsizei(camera.height));
            gl().glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachment, GL_RENDERBUFFER_EXT, name);
        };
        gl().glGenFramebuffers(1, &frame);
        gl().glBindFramebuffer(GL_FRAMEBUFFER_EXT, frame);
        buffer(colour, GL_RGBA8, GL_COLOR_ATTACHMENT0);
        buffer(depth, GL_DEPTH24_STENCIL8_EXT, GL_DEPTH_STENCIL_ATTACHMENT);
        context->setDefaultFboId(frame);
        rows.resize(std::size_t(camera.width) * camera.height * 3);
        pixels.resize(rows.size());
    }

    void aim() {
        const CameraView from = viewOf(camera, poses[camera.body]);
        const double half = from.nearPlane * std::tan(0.5 * from.fieldOfView), aspect = double(camera.height) / camera.width;
        osg::Camera& lens = *view->getCamera();
        lens.setProjectionMatrixAsFrustum(-half, half, -half * aspect, half * aspect, from.nearPlane, from.farPlane);
        const Mat3 axes = cameraAxes(from);
        osg::Matrixd world;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) world(column, row) = axes(row, column);
        world.setTrans(toOsg(from.eye));
        lens.setViewMatrix(osg::Matrixd::inverse(world));
    }
};

BareView::BareView(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {}

BareView::~BareView() {
    Parts& p = *m_parts;
    p.root->releaseGLObjects(p.context->getState());
    p.view = nullptr;
    p.context->release();
}

std::unique_ptr<BareView> BareView::create(const ExperimentSpec& experiment, const SignalLayout& layout,
                                           const std::string& camera) {
    auto parts = std::make_unique<Parts>(experiment, layout);
    const std::vector<CameraModel> all = camerasOf(experiment);
    const auto wanted = std::find_if(all.begin(), all.end(), [&](const CameraModel& c) { return c.path == camera; });
    Result<std::unique_ptr<EglContext>> egl = EglContext::create();
    if (wanted == all.end() || !egl) return nullptr;
    parts->camera = *wanted;
    parts->egl = std::move(egl).value();
    parts->build(experiment);
    parts->open();
    return std::unique_ptr<BareView>(new BareView(std::move(parts)));
}

const std::vector<std::uint8_t>& BareView::draw(const SignalBlock& block) {
    Parts& p = *m_parts;
    p.reader.read(block, p.poses);
    for (std::size_t i = 0; i < p.bodies.size(); ++i) p.bodies[i]->setMatrix(toOsg(p.poses[i]));
    p.aim();
    p.gl().glBindFramebuffer(GL_FRAMEBUFFER_EXT, p.frame);
    p.view->cull();
    p.view->draw();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, GLsizei(p.camera.width), GLsizei(p.camera.height), GL_RGB, GL_UNSIGNED_BYTE, p.rows.data());
    const std::size_t row = std::size_t(p.camera.width) * 3;
    for (std::size_t y = 0; y < p.camera.height; ++y)
        std::copy_n(p.rows.end() - std::ptrdiff_t((y + 1) * row), row, p.pixels.begin() + std::ptrdiff_t(y * row));
    return p.pixels;
}

} // namespace trundle
