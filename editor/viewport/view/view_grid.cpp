#include "editor/viewport/view/view_grid.h"

#include <algorithm>
#include <utility>

#include <QTimer>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/regions.h"
#include "editor/viewport/view/view_header.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

bool awaitsFile(const GeomSpec& geom) {
    const bool isMesh = geom.shape == GeomShape::Mesh || geom.shape == GeomShape::Convex;
    return (isMesh && !geom.mesh) || (geom.shape == GeomShape::Heightfield && !geom.heightMap);
}

bool awaitsFiles(const ExperimentSpec& experiment) {
    const auto inScenery = [](const StaticSpec& s) { return s.geoms && std::ranges::any_of(*s.geoms, awaitsFile); };
    const auto inRobot = [](const RobotSpec& r) {
        return r.config && std::ranges::any_of(r.config->bodies,
                                               [](const BodySpec& body) { return std::ranges::any_of(body.geoms, awaitsFile); });
    };
    return std::ranges::any_of(experiment.statics, inScenery) || std::ranges::any_of(experiment.robots, inRobot);
}

constexpr ViewKind kKinds[] = {ViewKind::Perspective, ViewKind::Top, ViewKind::Front, ViewKind::Side};
constexpr double kLeastFramed = 0.1; // m

} // namespace

ViewGrid::ViewGrid(const ViewContext& context)
    : QSplitter(Qt::Horizontal), m_context(context), m_left(new QSplitter(Qt::Vertical)), m_right(new QSplitter(Qt::Vertical)),
      m_autoFraming(context) {
    addWidget(m_left);
    addWidget(m_right);
    makeViews();
    setViewCount(1);
    connectFraming();
    connect(&m_context.world, &ViewportScene::posed, this, [this] {
        followDrivenRobot();
        for (View* view : m_views) m_autoFraming.update(*view);
    });
}

/// A new document is framed once, as soon as it has objects.
void ViewGrid::connectFraming() {
    connect(&m_context.document.editedModel(), &EditedModel::changed, this, &ViewGrid::showModel);
    connect(&m_context.document, &Document::opened, this, [this] {
        m_isNew = m_toBeFramed = true;
        m_awaitsFiles = false;
        leaveFollowedRobot();
    });
    connect(&m_context.document, &Document::changed, this, [this] { // emitted after opened(), before which the scene is outdated
        if (std::exchange(m_isNew, false)) startAgain();
        if (!m_toBeFramed || m_context.world.objects()->instances().empty()) return;
        // Meshes and height maps of a text are read after it; then it is framed once more.
        m_toBeFramed = !std::exchange(m_awaitsFiles, false) && awaitsFiles(m_context.world.objects()->experiment());
        m_awaitsFiles = m_toBeFramed;
        m_frameWhenShown = !isVisible();
        frameNew();
    });
    if (!m_context.world.objects()->instances().empty()) m_toBeFramed = false, m_frameWhenShown = true;
}

/// A new document has the views of a new window, whatever the one before was looked at with.
void ViewGrid::startAgain() {
    for (std::size_t i = 0; i < m_views.size(); ++i) m_views[i]->camera().setKind(kKinds[i]);
}

/// A new document is shown as its first View block says, and otherwise whole.
void ViewGrid::frameNew() {
    showAll(true);
    const std::vector<ComponentSpec>& looks = m_context.world.objects()->experiment().looks;
    const auto view = std::ranges::find(looks, "View", &ComponentSpec::kind);
    if (view != looks.end() && !showsModel(m_context.world)) m_current->camera().showNamed(view->name);
    for (View* each : m_views) m_autoFraming.watch(*each);
}

/// The followed robot is not shown any more.
void ViewGrid::leaveFollowedRobot() {
    for (View* view : m_views)
        if (view->camera().free().kind() == ViewKind::Follow || view->camera().free().kind() == ViewKind::Chase)
            view->camera().setKind(ViewKind::Perspective);
}

/// Frames the edited model; afterwards the experiment is shown as before.
void ViewGrid::showModel() {
    const bool isShown = showsModel(m_context.world), wasShown = !m_experimentViews.empty();
    if (isShown == wasShown) return; // renamed
    if (!isShown) return setViewStates(std::exchange(m_experimentViews, {}), m_shown);
    m_experimentViews = viewStates();
    leaveFollowedRobot();
    frameAll();
}

void ViewGrid::makeViews() {
    for (int i = 0; i < 4; ++i) {
        auto* view = new View(m_context, kKinds[i]);
        view->setObjectName(QStringLiteral("view%1").arg(i));
        new ViewCorner(*view);
        (i % 2 == 0 ? m_left : m_right)->addWidget(view);
        connect(view, &View::activated, this, [this, view] { setCurrent(*view); });
        m_views.push_back(view);
    }
    m_current = m_views.front();
}

void ViewGrid::setViewCount(int count) {
    m_shown = std::clamp(count, 1, 4);
    for (int i = 0; i < 4; ++i) {
        View* view = m_views[std::size_t(i)];
        const bool wasThere = view->isVisibleTo(this), isThere = m_shown == 3 ? i != 2 : i < m_shown; // 3: one left, two right
        view->setVisible(isThere);
        // A newly shown view is framed after it got its size, unless it gets a camera before.
        m_awaitsFraming[std::size_t(i)] = isThere && (!wasThere || m_awaitsFraming[std::size_t(i)]);
        if (isThere && !wasThere)
            QTimer::singleShot(0, view, [this, view, i] {
                if (std::exchange(m_awaitsFraming[std::size_t(i)], false)) view->frame(m_context.world.bounds(), false);
            });
    }
    m_right->setVisible(m_shown > 1);
    if (m_shown > 1) setSizes({1000, 1000});
    for (QSplitter* side : {m_left, m_right}) side->setSizes({1000, 1000});
    setCurrent(m_current->isVisibleTo(this) ? *m_current : *m_views.front());
}

void ViewGrid::setCurrent(View& view) {
    m_current = &view;
    for (View* each : m_views) each->setCurrent(each == m_current, m_shown > 1 && each == m_current);
}

/// While a robot is driven by keyboard, the view moves when the robot would leave it.
void ViewGrid::followDrivenRobot() {
    const std::string robot = m_context.session.robots().driven();
    const std::optional<Pose> pose = robot.empty() ? std::nullopt : m_context.session.robots().pose(robot);
    if (!pose || !m_current->isVisible() || m_current->camera().free().kind() != ViewKind::Perspective ||
        m_current->camera().through())
        return;
    const std::optional<QPointF> at = m_current->camera().pixelOf(pose->position);
    const int dx = m_current->width() / 5, dy = m_current->height() / 5; // all of the robot stays in view
    if (!at || !m_current->rect().adjusted(dx, dy, -dx, -dy).contains(at->toPoint()))
        m_current->camera().setKind(ViewKind::Follow);
}

bool ViewGrid::showView(const QString& name) {
    for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic, ViewKind::Top, ViewKind::Front, ViewKind::Side,
                                ViewKind::Follow, ViewKind::Chase}) {
        if (viewKindName(kind).compare(name, Qt::CaseInsensitive) != 0) continue;
        m_current->camera().setKind(kind);
        if (kind == ViewKind::Top || kind == ViewKind::Front || kind == ViewKind::Side)
            m_current->frame(m_context.world.bounds(), false);
        return true;
    }
    const std::string view = name.toStdString();
    for (const ComponentSpec& look : m_context.world.objects()->experiment().looks) {
        if (look.kind != "View" || look.name != view) continue;
        m_current->camera().showNamed(view);
        return true;
    }
    return false;
}

std::optional<Vec3> ViewGrid::insertionPoint() const {
    if (!m_current->isVisible()) return std::nullopt;
    const Vec3 point = m_current->camera().pointUnder(QRectF(m_current->rect()).center());
    const ViewCamera& camera = m_current->camera().free();
    constexpr double kFarthest = 3; // of the distance of the camera: towards the horizon the floor is too far away to be meant
    return (point - camera.view().eye).norm() <= kFarthest * camera.distance() ? point : camera.middle();
}

std::vector<ViewState> ViewGrid::viewStates() const {
    std::vector<ViewState> viewStates;
    for (const View* view : m_views) {
        const CameraControl& camera = view->camera();
        viewStates.push_back({camera.free().kind(), camera.free().view(), camera.named()});
    }
    return viewStates;
}

void ViewGrid::setViewStates(const std::vector<ViewState>& viewStates, int shown) {
    m_toBeFramed = m_frameWhenShown = false;
    setViewCount(shown);
    for (std::size_t i = 0; i < m_views.size() && i < viewStates.size(); ++i) {
        m_awaitsFraming[i] = false;
        const ViewState& state = viewStates[i];
        CameraControl& camera = m_views[i]->camera();
        camera.setView(state.camera);
        if (camera.free().kind() != state.kind) camera.setKind(state.kind);
        if (!state.named.empty()) camera.showNamed(state.named);
    }
}

void ViewGrid::lookThrough(const std::string& path) {
    const auto cameras = m_context.world.camerasOf(path);
    if (!cameras.empty()) m_current->camera().lookThrough(cameras.front()->path);
}

bool ViewGrid::isUpToDate() const {
    return std::all_of(m_views.begin(), m_views.end(),
                       [](const View* view) { return !view->isVisible() || view->image().isUpToDate(); });
}

bool ViewGrid::isSettled() const {
    return std::all_of(m_views.begin(), m_views.end(),
                       [](const View* view) { return !view->isVisible() || view->image().isSettled(); });
}

void ViewGrid::frameSelection() {
    Bounds box;
    for (const std::string& path : m_context.selection.paths()) {
        for (const ObjectRef& object : m_context.world.objectsOf(path)) box.add(m_context.world.boundsOf(object));
        box.add(boundsOfRegions(m_context.world.objects()->experiment(), path));
    }
    if (box.empty()) return frameAll();
    if (box.radius() < kLeastFramed) box.grow(kLeastFramed);
    box.grow(0.35 * box.radius());
    m_current->frame(box);
}

void ViewGrid::frameAll() { showAll(!m_current->isVisible() || m_current->image().picture().isNull()); }

/// `atOnce`: as at first; otherwise the current view keeps its direction and moves there.
void ViewGrid::showAll(bool atOnce) {
    for (View* view : m_views) {
        if (view->camera().free().kind() == ViewKind::Perspective && m_context.world.objects()) {
            const auto width = std::uint32_t(std::max(16, view->width())), height = std::uint32_t(std::max(16, view->height()));
            const CameraView whole =
                defaultView(m_context.world.objects()->experiment(), *m_context.world.poses(), width, height);
            if (atOnce || view != m_current) {
                view->camera().setView(whole);
                continue;
            }
        }
        view->frame(m_context.world.bounds(), !atOnce && view == m_current);
    }
}

void ViewGrid::showEvent(QShowEvent* event) {
    QSplitter::showEvent(event);
    // It was framed before it had a size.
    if (m_frameWhenShown) QTimer::singleShot(0, this, &ViewGrid::frameNew);
    m_frameWhenShown = false;
}

} // namespace trundle
