#include "render/render_thread_state.h"

#include <bit>

#include <osg/GLObjects>
#include <osg/Notify>

#include "scene/queries/framing.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxTargets = 8;
constexpr int kRichSamples = 4;
constexpr std::uint32_t kLeastSunPixels = 512, kMaxSunPixels = 4096, kMaxSunPixelsInSoftware = 2048; // along each side

/// Silences OSG, which otherwise writes to standard error; libraries of Trundle do not print.
struct NullNotifyHandler : osg::NotifyHandler {
    void notify(osg::NotifySeverity, const char*) override {}
};

Error refused(std::string why) { return {Code::PictureFailed, std::move(why)}; }

} // namespace

RenderThreadState::RenderThreadState(std::unique_ptr<EglContext> egl)
    : m_egl(std::move(egl)), m_context(new GraphicsContext), m_shapes(std::make_shared<ShapeStore>()) {
    glGetIntegerv(GL_MAX_SAMPLES_EXT, &m_mostSamples);
    m_mostSamples = std::max(1, m_mostSamples);
}

Result<std::unique_ptr<RenderThreadState>> RenderThreadState::open() {
    // Once for all render threads: OSG replaces its handler without a lock.
    [[maybe_unused]] static const bool silent = (osg::setNotifyHandler(new NullNotifyHandler), true);
    Result<std::unique_ptr<EglContext>> egl = EglContext::create();
    if (!egl) return egl.error();
    return std::unique_ptr<RenderThreadState>(new RenderThreadState(std::move(egl).value()));
}

RenderThreadState::~RenderThreadState() {
    for (auto& [id, sceneState] : m_sceneStates) sceneState.scene->root().releaseGLObjects(m_context->getState());
    m_shapes->releaseGlObjects(m_context->getState());
    m_targets.clear();
    m_suns.clear();
    m_sceneStates.clear();
    m_shapes.reset();
    m_context->release();
    m_context = nullptr;
}

void RenderThreadState::endEarlyOn(bool& enough) { m_context->endEarlyOn(enough); }

void RenderThreadState::add(SceneId id, std::shared_ptr<const ExperimentSpec> experiment,
                            std::shared_ptr<const ExperimentSpec> ghosts) {
    SceneState sceneState;
    sceneState.scene = std::make_unique<Scene>(*experiment, m_shapes, ghosts.get());
    sceneState.start = startPoses(*experiment);
    sceneState.experiment = std::move(experiment);
    m_sceneStates.emplace(id, std::move(sceneState));
}

void RenderThreadState::remove(SceneId id) {
    const auto it = m_sceneStates.find(id);
    if (it == m_sceneStates.end()) return;
    // Shapes shared with other scenes stay; the others are deleted with their last owner.
    m_sceneStates.erase(it);
    m_shapes->forgetUnused();
    osg::flushAllDeletedGLObjects(m_context->getState()->getContextID());
}

Result<RenderThreadState::SceneState*> RenderThreadState::sceneState(SceneId id, const std::shared_ptr<const BodyPoses>& poses) {
    const auto it = m_sceneStates.find(id);
    if (it == m_sceneStates.end()) return refused("there is no such scene");
    SceneState& sceneState = it->second;
    if (poses && poses->size() != sceneState.start.size()) {
        return refused("poses of " + std::to_string(poses->size()) + " bodies for a scene of " +
                       std::to_string(sceneState.start.size()));
    }
    sceneState.scene->setPoses(poses ? *poses : sceneState.start);
    return &sceneState;
}

Result<Target*> RenderThreadState::target(TargetShape shape) {
    if (const auto it = m_targets.find(shape); it != m_targets.end()) {
        it->second.lastUse = ++m_uses;
        return it->second.target.get();
    }
    if (m_targets.size() >= kMaxTargets) {
        m_targets.erase(std::min_element(m_targets.begin(), m_targets.end(),
                                         [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; }));
        osg::flushAllDeletedGLObjects(m_context->getState()->getContextID()); // frees its textures
    }
    Result<std::unique_ptr<Target>> made = Target::create(*m_context, shape);
    if (!made) return made.error();
    CachedTarget& kept = m_targets[shape];
    kept = {std::move(made).value(), ++m_uses};
    return kept.target.get();
}

Result<RenderThreadState::RenderSetup> RenderThreadState::prepare(const PictureRequest& request, bool data, bool rich) {
    if (request.width < 1 || request.height < 1 || request.width > kMaxPixels || request.height > kMaxPixels) {
        return refused("a picture has 1 to " + std::to_string(kMaxPixels) + " pixels along each side, not " +
                       std::to_string(request.width) + " x " + std::to_string(request.height));
    }
    const Result<SceneState*> sceneState = this->sceneState(request.scene, request.poses);
    if (!sceneState) return sceneState.error();
    const CameraView view =
        request.view ? *request.view
                     : defaultView(*sceneState.value()->experiment, request.poses ? *request.poses : sceneState.value()->start,
                                   request.width, request.height);
    if (!isUsable(view)) return refused("no picture can be taken from this view");
    const int wanted = rich && request.capture ? std::max(request.samples, kRichSamples) : request.samples;
    const int samples = data ? 1 : std::clamp(wanted, 1, m_mostSamples);
    const Result<Target*> target = this->target({request.width, request.height, samples, data, rich, request.exposure != 1});
    if (!target) return target.error();
    sceneState.value()->scene->setHidden(request.hidden);
    return RenderSetup{sceneState.value(), target.value(), view};
}

Result<DataImage> RenderThreadState::measure(const PictureRequest& request) {
    const Result<RenderSetup> set = prepare(request, true, false);
    if (!set) return set.error();
    Scene& scene = *set.value().sceneState->scene;
    scene.makeData(*set.value().sceneState->experiment);
    scene.followData();
    Result<DataImage> measured = set.value().target->measure(scene, set.value().view, static_cast<unsigned>(++m_uses));
    if (const Status whole = programs(); !whole) return whole.error();
    return measured;
}

Status RenderThreadState::programs() const {
    const std::string failure = m_shapes->look.takeFailure();
    return failure.empty() ? Status() : refused(failure);
}

Result<Image> RenderThreadState::draw(const PictureRequest& request, LookChoice look) {
    const bool quick = request.samples <= 1 && !request.capture; // a moving view, drawn in software
    if (quick || m_isRichBroken || !isRich(look, m_egl->renderer())) return drawOnce(request, false);
    Result<Image> rich = drawOnce(request, true);
    if (rich || rich.error().message.empty()) return rich; // an empty message means that it was cancelled
    Result<Image> fast = drawOnce(request, false);
    if (fast && !std::exchange(m_isNoticed, true))
        m_notice = "the rich look is not available, so pictures have the fast one: " + rich.error().message;
    return fast;
}

Result<SunMap*> RenderThreadState::sunMap(std::uint32_t width, std::uint32_t height) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::uint32_t allowed = std::min<std::uint32_t>(
        isSoftwareRenderer(m_egl->renderer()) ? kMaxSunPixelsInSoftware : kMaxSunPixels, static_cast<std::uint32_t>(most));
    const std::uint32_t pixels = std::min(allowed, std::max(kLeastSunPixels, std::bit_ceil(2 * std::max(width, height))));
    std::unique_ptr<SunMap>& sun = m_suns[pixels];
    if (!sun) {
        Result<std::unique_ptr<SunMap>> made = SunMap::create(*m_context, pixels);
        if (!made) return made.error();
        sun = std::move(made).value();
    }
    return sun.get();
}

Result<Image> RenderThreadState::drawOnce(const PictureRequest& request, bool rich) {
    if (rich && m_mostSamples < kRichSamples)
        return refused("OpenGL has no " + std::to_string(kRichSamples) + " samples for a pixel");
    const Result<RenderSetup> set = prepare(request, false, rich);
    if (!set) return set.error();
    Scene& scene = *set.value().sceneState->scene;
    scene.setMarks(request.marks);
    scene.setWireframe(request.wireframe);
    scene.setFloorLines(request.floorLines);
    scene.lightLeds(set.value().view.eye);
    scene.setOverlay(request.overlay);
    if (request.mask & kMaskCollision) scene.makeCollision(*set.value().sceneState->experiment);
    const Result<SunMap*> sun = rich ? sunMap(request.width, request.height) : Result<SunMap*>(nullptr);
    if (!sun) return sun.error();
    Target::DrawRequest drawRequest;
    drawRequest.view = set.value().view;
    drawRequest.mask = request.mask;
    drawRequest.outline = request.outline;
    drawRequest.sun = sun.value();
    drawRequest.lines = request.wireframe;
    drawRequest.number = static_cast<unsigned>(++m_uses);
    drawRequest.scene = request.scene;
    drawRequest.floorLines = request.floorLines;
    drawRequest.exposure = request.exposure;
    drawRequest.hidden = request.hidden;
    Result<Image> image = set.value().target->draw(scene, drawRequest);
    if (const Status whole = programs(); !whole) {
        m_isRichBroken = m_isRichBroken || rich;
        return whole.error();
    }
    return image;
}

Result<std::vector<PickResult>> RenderThreadState::pick(const PickRequest& request) {
    const Result<SceneState*> sceneState = this->sceneState(request.scene, request.poses);
    if (!sceneState) return sceneState.error();
    if (!isUsable(request.view) || request.width < 1 || request.height < 1) return refused("nothing can be picked in this view");
    std::vector<PickResult> all;
    const ViewRay ray = rayThrough(request.view, request.width, request.height, request.x, request.y);
    for (const SceneHit& hit : sceneState.value()->scene->pickAll(ray, request.mask)) all.push_back({hit.path, hit.point});
    return all;
}

} // namespace trundle
