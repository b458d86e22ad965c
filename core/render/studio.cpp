#include "render/studio.h"

#include <osg/GLObjects>
#include <osg/Notify>

#include "scene/framing.h"

namespace trundle {
namespace {

constexpr std::size_t kMostTargets = 8;

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
    m_stages.clear();
    m_shapes.reset();
    m_context->release();
    m_context = nullptr;
}

void Studio::endEarlyOn(bool& enough) { m_context->getState()->setAbortRenderingPtr(&enough); }

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
    }
    Result<std::unique_ptr<Target>> made = Target::create(*m_context, shape);
    if (!made) return made.error();
    Kept& kept = m_targets[shape];
    kept = {std::move(made).value(), ++m_uses};
    return kept.target.get();
}

Result<Studio::Set> Studio::prepare(const PictureRequest& request, bool data) {
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
    const int samples = data ? 1 : std::clamp(request.samples, 1, m_mostSamples);
    const Result<Target*> target = this->target({request.width, request.height, samples, data});
    if (!target) return target.error();
    stage.value()->scene->setHidden(request.hidden);
    return Set{stage.value(), target.value(), view};
}

Result<Measured> Studio::measure(const PictureRequest& request) {
    const Result<Set> set = prepare(request, true);
    if (!set) return set.error();
    Scene& scene = *set.value().stage->scene;
    scene.makeData(*set.value().stage->experiment);
    scene.followData();
    return set.value().target->measure(scene, set.value().view, static_cast<unsigned>(++m_uses));
}

Result<Image> Studio::draw(const PictureRequest& request) {
    const Result<Set> set = prepare(request, false);
    if (!set) return set.error();
    Scene& scene = *set.value().stage->scene;
    scene.setMarks(request.marks);
    scene.setWireframe(request.wireframe);
    scene.setOverlay(request.overlay);
    if (request.mask & kMaskCollision) scene.makeCollision(*set.value().stage->experiment);
    return set.value().target->draw(scene, set.value().view, request.mask, static_cast<unsigned>(++m_uses), request.outline);
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
