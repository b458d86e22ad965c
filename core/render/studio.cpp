#include "render/studio.h"

#include <bit>

#include <osg/GLObjects>
#include <osg/Notify>

#include "scene/framing.h"

namespace trundle {
namespace {

constexpr std::size_t kMostTargets = 8;
constexpr int kRichSamples = 4;
constexpr std::uint32_t kLeastSunPixels = 512, kMostSunPixels = 4096, kMostSunPixelsInSoftware = 2048; // along each side

/// OSG talks to standard error of its own accord; nobody below the program prints.
struct Silence : osg::NotifyHandler {
    void notify(osg::NotifySeverity, const char*) override {}
};

Error refused(std::string why) { return {Code::PictureFailed, std::move(why)}; }

} // namespace

Studio::Studio(std::unique_ptr<EglContext> egl)
    : m_egl(std::move(egl)), m_context(new GraphicsContext), m_shapes(std::make_shared<ShapeStore>()) {
    glGetIntegerv(GL_MAX_SAMPLES_EXT, &m_mostSamples);
    m_mostSamples = std::max(1, m_mostSamples);
}

Result<std::unique_ptr<Studio>> Studio::open() {
    // Once for all threads that open a studio: OSG swaps handlers without a lock.
    [[maybe_unused]] static const bool silent = (osg::setNotifyHandler(new Silence), true);
    Result<std::unique_ptr<EglContext>> egl = EglContext::create();
    if (!egl) return egl.error();
    return std::unique_ptr<Studio>(new Studio(std::move(egl).value()));
}

Studio::~Studio() {
    for (auto& [id, stage] : m_stages) stage.scene->root().releaseGLObjects(m_context->getState());
    m_shapes->releaseGlObjects(m_context->getState());
    m_targets.clear();
    m_suns.clear();
    m_stages.clear();
    m_shapes.reset();
    m_context->release();
    m_context = nullptr;
}

void Studio::endEarlyOn(bool& enough) { m_context->endEarlyOn(enough); }

void Studio::add(SceneId id, std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts) {
    Stage stage;
    stage.scene = std::make_unique<Scene>(*experiment, m_shapes, ghosts.get());
    stage.start = startPoses(*experiment);
    stage.experiment = std::move(experiment);
    m_stages.emplace(id, std::move(stage));
}

void Studio::remove(SceneId id) {
    const auto it = m_stages.find(id);
    if (it == m_stages.end()) return;
    // What other scenes share stays; the rest is deleted with its last owner.
    m_stages.erase(it);
    m_shapes->forgetUnused();
    osg::flushAllDeletedGLObjects(m_context->getState()->getContextID());
}

Result<Studio::Stage*> Studio::stage(SceneId id, const std::shared_ptr<const BodyPoses>& poses) {
    const auto it = m_stages.find(id);
    if (it == m_stages.end()) return refused("there is no such scene");
    Stage& stage = it->second;
    if (poses && poses->size() != stage.start.size()) {
        return refused("poses of " + std::to_string(poses->size()) + " bodies for a scene of " +
                       std::to_string(stage.start.size()));
    }
    stage.scene->setPoses(poses ? *poses : stage.start);
    return &stage;
}

Result<Target*> Studio::target(TargetShape shape) {
    if (const auto it = m_targets.find(shape); it != m_targets.end()) {
        it->second.lastUse = ++m_uses;
        return it->second.target.get();
    }
    if (m_targets.size() >= kMostTargets) {
        m_targets.erase(std::min_element(m_targets.begin(), m_targets.end(),
                                         [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; }));
        osg::flushAllDeletedGLObjects(m_context->getState()->getContextID()); // its maps
    }
    Result<std::unique_ptr<Target>> made = Target::create(*m_context, shape);
    if (!made) return made.error();
    Kept& kept = m_targets[shape];
    kept = {std::move(made).value(), ++m_uses};
    return kept.target.get();
}

Result<Studio::Set> Studio::prepare(const PictureRequest& request, bool data, bool rich) {
    if (request.width < 1 || request.height < 1 || request.width > kMostPixels || request.height > kMostPixels) {
        return refused("a picture has 1 to " + std::to_string(kMostPixels) + " pixels along each side, not " +
                       std::to_string(request.width) + " x " + std::to_string(request.height));
    }
    const Result<Stage*> stage = this->stage(request.scene, request.poses);
    if (!stage) return stage.error();
    const CameraView view = request.view
                                ? *request.view
                                : defaultView(*stage.value()->experiment, request.poses ? *request.poses : stage.value()->start,
                                              request.width, request.height);
    if (!isUsable(view)) return refused("no picture can be taken from this view");
    const int wanted = rich && request.capture ? std::max(request.samples, kRichSamples) : request.samples;
    const int samples = data ? 1 : std::clamp(wanted, 1, m_mostSamples);
    const Result<Target*> target = this->target({request.width, request.height, samples, data, rich});
    if (!target) return target.error();
    stage.value()->scene->setHidden(request.hidden);
    return Set{stage.value(), target.value(), view};
}

Result<Measured> Studio::measure(const PictureRequest& request) {
    const Result<Set> set = prepare(request, true, false);
    if (!set) return set.error();
    Scene& scene = *set.value().stage->scene;
    scene.makeData(*set.value().stage->experiment);
    scene.followData();
    Result<Measured> measured = set.value().target->measure(scene, set.value().view, static_cast<unsigned>(++m_uses));
    if (const Status whole = programs(); !whole) return whole.error();
    return measured;
}

Status Studio::programs() const {
    const std::string failure = m_shapes->look.takeFailure();
    return failure.empty() ? Status() : refused(failure);
}

Result<Image> Studio::draw(const PictureRequest& request, LookChoice look) {
    const bool quick = request.samples <= 1 && !request.capture; // a view that moves where the processor draws it
    if (quick || m_isRichBroken || !isRich(look, m_egl->renderer())) return drawOnce(request, false);
    Result<Image> rich = drawOnce(request, true);
    if (rich || rich.error().message.empty()) return rich; // none: it gave way
    Result<Image> fast = drawOnce(request, false);
    if (fast && !std::exchange(m_isNoticed, true))
        m_notice = "the rich look is not to be had here, so pictures have the fast one: " + rich.error().message;
    return fast;
}

Result<SunMap*> Studio::sunMap(std::uint32_t width, std::uint32_t height) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::uint32_t allowed = std::min<std::uint32_t>(
        isSoftwareRenderer(m_egl->renderer()) ? kMostSunPixelsInSoftware : kMostSunPixels, static_cast<std::uint32_t>(most));
    const std::uint32_t pixels = std::min(allowed, std::max(kLeastSunPixels, std::bit_ceil(2 * std::max(width, height))));
    std::unique_ptr<SunMap>& sun = m_suns[pixels];
    if (!sun) {
        Result<std::unique_ptr<SunMap>> made = SunMap::create(*m_context, pixels);
        if (!made) return made.error();
        sun = std::move(made).value();
    }
    return sun.get();
}

Result<Image> Studio::drawOnce(const PictureRequest& request, bool rich) {
    if (rich && m_mostSamples < kRichSamples)
        return refused("OpenGL has no " + std::to_string(kRichSamples) + " samples for a pixel");
    const Result<Set> set = prepare(request, false, rich);
    if (!set) return set.error();
    Scene& scene = *set.value().stage->scene;
    scene.setMarks(request.marks);
    scene.setWireframe(request.wireframe);
    scene.setFloorLines(request.floorLines);
    scene.setOverlay(request.overlay);
    if (request.mask & kMaskCollision) scene.makeCollision(*set.value().stage->experiment);
    const Result<SunMap*> sun = rich ? sunMap(request.width, request.height) : Result<SunMap*>(nullptr);
    if (!sun) return sun.error();
    Target::Shot shot;
    shot.view = set.value().view;
    shot.mask = request.mask;
    shot.outline = request.outline;
    shot.sun = sun.value();
    shot.lines = request.wireframe;
    shot.number = static_cast<unsigned>(++m_uses);
    Result<Image> image = set.value().target->draw(scene, shot);
    if (const Status whole = programs(); !whole) {
        m_isRichBroken = m_isRichBroken || rich;
        return whole.error();
    }
    return image;
}

Result<std::vector<Picked>> Studio::pick(const PickRequest& request) {
    const Result<Stage*> stage = this->stage(request.scene, request.poses);
    if (!stage) return stage.error();
    if (!isUsable(request.view) || request.width < 1 || request.height < 1) return refused("nothing can be picked in this view");
    std::vector<Picked> all;
    const ViewRay ray = rayThrough(request.view, request.width, request.height, request.x, request.y);
    for (const SceneHit& hit : stage.value()->scene->pickAll(ray, request.mask)) all.push_back({hit.path, hit.point});
    return all;
}

} // namespace trundle
