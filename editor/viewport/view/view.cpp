#include "editor/viewport/view/view.h"

#include <mutex>

#include <QPainter>
#include <QPointer>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/overlays/overlays.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/tools/library_drop.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/tools/navigation.h"
#include "editor/viewport/tools/pin_tool.h"
#include "editor/viewport/tools/push_tool.h"
#include "editor/viewport/tools/select_tool.h"
#include "editor/widgets/theme.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16;   // limits the rate to about 60 images per second
constexpr int kSettleMs = 350; // ms without a change, longer than between two key presses, before the image is refined
constexpr int kGlideMs = 160;
constexpr int kLongMs = 500; // ms after which the first image shows "Drawing…"

std::array<std::uint8_t, 3> bytesOf(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

} // namespace

/// Receives images from the render thread. Shared with pending requests; images for a destroyed view are dropped.
struct View::Inbox {
    std::mutex mutex;
    View* view = nullptr;
};

View::View(const ViewContext& context, ViewKind kind, QWidget* parent)
    : QWidget(parent), m_context(context), m_inbox(std::make_shared<Inbox>()) {
    m_inbox->view = this;
    setObjectName(QStringLiteral("view3d"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(120, 90);
    setAccessibleName(tr("3D view"));

    makeTools();
    m_pumpTimer.setSingleShot(true);
    m_settle.setSingleShot(true);
    connect(&m_pumpTimer, &QTimer::timeout, this, [this] {
        if (mayAsk()) ask(false);
    });
    connect(&m_settle, &QTimer::timeout, this, [this] {
        if (!m_wanted && !m_inFlight && isVisible() && !isMouseBusy()) ask(true);
    });
    connect(&m_glide, &QTimer::timeout, this, &View::glide);
    connectContext();
    m_camera.setKind(kind);
}

void View::makeTools() {
    m_tools.push_back(std::make_unique<PinTool>(*this));
    auto navigation = std::make_unique<Navigation>(*this);
    m_navigation = navigation.get();
    m_tools.push_back(std::move(navigation));
    m_tools.push_back(std::make_unique<MeasureTool>(*this));
    auto gizmo = std::make_unique<GizmoTool>(*this);
    m_gizmo = gizmo.get();
    m_tools.push_back(std::move(gizmo));
    m_tools.push_back(std::make_unique<PushTool>(*this));
    m_tools.push_back(std::make_unique<SelectTool>(*this));
}

void View::connectContext() {
    connect(&m_context.session, &RunSession::stateChanged, this, &View::settle);
    connect(&m_context.world, &ViewportScene::replaced, this, [this] {
        followSelection();
        redraw();
    });
    connect(&m_context.world, &ViewportScene::posed, this, [this] {
        followSelection();
        redraw();
    });
    connect(&m_context.document, &Document::changed, this,
            [this] { // the scene of a run stays, but its Views are those of the text
                if (m_named.empty()) return;
                followNamed();
                redraw();
            });
    connect(&m_context.world, &ViewportScene::marked, this, &View::redraw);
    connect(&m_context.world, &ViewportScene::draggedMoved, this, &View::redraw);
    connect(&m_context.settings, &ViewSettings::changed, this, &View::redraw);
    connect(&m_context.settings, &ViewSettings::changed, this, qOverload<>(&View::update)); // handles need no new image
    connect(&m_context.selection, &Selection::changed, this, [this] {
        if (m_camera.kind() == ViewKind::Follow || m_camera.kind() == ViewKind::Chase) m_camera.setKind(m_camera.kind());
        followSelection();
        redraw();
    });
    if (const RadioOverlays* radios = m_context.radios) {
        connect(radios, &RadioOverlays::sceneChanged, this, &View::redraw);
        connect(radios, &RadioOverlays::linksChanged, this, qOverload<>(&QWidget::update));
    }
}

View::~View() {
    const std::lock_guard lock(m_inbox->mutex);
    m_inbox->view = nullptr;
}

void View::setKind(ViewKind kind) {
    m_glide.stop();
    leaveCamera();
    m_camera.setKind(kind);
    followSelection();
    Q_EMIT kindChanged();
    redraw();
}

void View::setCamera(const CameraView& view) {
    changeCamera([&](ViewCamera& camera) { camera.setView(view); });
}

void View::changeCamera(const std::function<void(ViewCamera&)>& change) {
    const ViewKind before = m_camera.kind();
    m_glide.stop();
    const bool left = leaveCamera();
    change(m_camera);
    if (left || m_camera.kind() != before) Q_EMIT kindChanged();
    redraw();
}

void View::frame(const Bounds& bounds, bool gently) {
    ViewCamera there = m_camera;
    there.frame(bounds, width(), height());
    if (!gently || !isVisible() || m_image.image.isNull()) return changeCamera([&](ViewCamera& camera) { camera = there; });
    if (leaveCamera()) Q_EMIT kindChanged();
    m_glideFrom = m_camera;
    m_glideTo = there;
    m_gliding.start();
    m_glide.start(kFrameMs);
}

void View::glide() {
    // Both ends have the same viewing direction, so only position and zoom are interpolated.
    const double share = std::min(1.0, double(m_gliding.elapsed()) / kGlideMs), smooth = share * share * (3 - 2 * share);
    if (share >= 1) m_glide.stop();
    ViewCamera between = m_glideTo;
    const double distance = m_glideFrom.distance() * std::pow(m_glideTo.distance() / m_glideFrom.distance(), smooth);
    const Vec3 middle = (1 - smooth) * m_glideFrom.middle() + smooth * m_glideTo.middle();
    between.pan(middle, m_glideTo.middle());
    between.zoom(distance / m_glideTo.distance(), middle);
    m_camera = share >= 1 ? m_glideTo : between;
    redraw();
}

/// nullopt unless the view follows a robot.
std::optional<ObjectRef> View::followedRobot() const {
    if (m_camera.kind() != ViewKind::Follow && m_camera.kind() != ViewKind::Chase) return std::nullopt;
    const ViewportScene& world = m_context.world;
    const std::optional<ObjectRef> selected = world.find(m_context.selection.current());
    if (selected && world.objects()->robotOf(*selected)) return ObjectRef{ObjectKind::Robot, selected->instance};
    if (world.objects()->experiment().robots.empty()) return std::nullopt;
    return ObjectRef{ObjectKind::Robot, 0};
}

void View::followSelection() {
    followCamera();
    followNamed();
    if (const auto robot = followedRobot()) m_camera.follow(m_context.world.poseOf(*robot));
}

CameraView View::cameraView() const {
    if (const CameraModel* camera = throughCamera()) return throughView(*camera, *m_context.world.poses());
    if (!m_named.empty())
        if (const auto view =
                namedView(*textOfViews(), m_named, m_context.world.objects()->experiment(), *m_context.world.poses()))
            return *view;
    if (!m_camera.isParallel()) return m_camera.view();
    const Bounds all = m_context.world.bounds();
    return m_camera.view(all.empty() ? 0 : (all.centre() - m_camera.middle()).norm() + all.radius());
}

ViewRay View::rayAt(const QPointF& at) const {
    return rayThrough(cameraView(), std::uint32_t(std::max(1, width())), std::uint32_t(std::max(1, height())), at.x(), at.y());
}

std::optional<QPointF> View::pixelOf(const Vec3& point) const {
    const auto at = project(cameraView(), std::uint32_t(std::max(1, width())), std::uint32_t(std::max(1, height())), point);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

std::optional<QPointF> View::shownPixelOf(const Vec3& point) const {
    if (m_image.image.isNull()) return pixelOf(point);
    const auto at = project(m_image.camera, std::uint32_t(std::max(1, width())), std::uint32_t(std::max(1, height())), point);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

const BodyPoses& View::shownPoses() const {
    return m_image.poses && m_image.objects == m_context.world.objects() ? *m_image.poses : *m_context.world.poses();
}

Vec3 View::pointUnder(const QPointF& at) const {
    const ViewRay ray = rayAt(at);
    const std::vector<RayHit> hits = m_context.world.hitsAlong(ray, true);
    if (!hits.empty()) return hits.front().point;
    const double down = -ray.origin.z() / ray.direction.z();
    if (std::isfinite(down) && down > 0 && down < 50 * m_camera.distance()) return ray.origin + down * ray.direction;
    return ray.origin + (m_camera.middle() - ray.origin).dot(ray.direction) * ray.direction;
}

void View::setHovered(const std::string& path, const QString& hint) {
    if (hint != m_hoverHint) {
        m_hoverHint = hint;
        update();
    }
    if (path == m_hovered) return;
    m_hovered = path;
    redraw();
}

void View::setHint(const QString& hint) {
    if (hint == m_hint) return;
    m_hint = hint;
    update();
}

void View::redraw() {
    m_wanted = true;
    m_settle.stop();
    pump();
}

void View::pump() {
    if (!mayAsk() || m_pumpTimer.isActive()) return;
    // Changes made in one event-loop pass are combined into one request.
    const qint64 since = m_sinceAsked.isValid() ? m_sinceAsked.elapsed() : kFrameMs;
    m_pumpTimer.start(int(std::max<qint64>(0, kFrameMs - since)));
}

PictureRequest View::request(bool fine) const {
    PictureRequest r;
    const ViewSettings& settings = m_context.settings;
    // The image size is limited; beyond it one image pixel covers several screen pixels.
    const double scale = std::min(devicePixelRatioF(), kMaxPixels / double(std::max({1, width(), height()})));
    r.scene = m_context.world.drawnScene();
    r.view = cameraView();
    r.width = std::uint32_t(std::clamp(int(std::lround(width() * scale)), 1, int(kMaxPixels)));
    r.height = std::uint32_t(std::clamp(int(std::lround(height() * scale)), 1, int(kMaxPixels)));
    r.poses = m_context.world.drawnPoses();
    r.samples = fine || !m_software ? 4 : 1;
    r.yields = fine;
    r.mask = kMaskRobots | kMaskStatics | kMaskFloor | kMaskSky | kMaskGhosts;
    r.floorLines = settings.shows(kOverlayGrid);
    if (r.floorLines) r.mask |= kMaskGuide;
    if (settings.shows(kOverlayCollision)) r.mask |= kMaskCollision;
    if (m_context.radios && (m_context.radios->inScene().shapes || m_context.radios->inScene().floor)) {
        r.mask |= kMaskOverlay;
        r.overlay = m_context.radios->inScene();
    }
    r.wireframe = settings.shows(kOverlayWireframe);
    if (settings.shows(kOverlayShadows) && !r.wireframe) r.mask |= fine || !m_software ? kMaskSoftShadows : kMaskShadows;
    r.hidden = m_context.world.hiddenInScene();
    if (const CameraModel* camera = throughCamera(); camera && !camera->seesSelf) r.hidden.push_back(camera->robot);
    for (const std::string& path : m_context.selection.paths())
        for (const ObjectRef& object : m_context.world.objectsOf(path))
            r.marks.selected.push_back(m_context.world.objects()->pathOf(object, '/'));
    if (!m_hovered.empty() && !m_context.selection.contains(m_hovered))
        for (const ObjectRef& object : m_context.world.objectsOf(m_hovered))
            r.marks.hovered.push_back(m_context.world.objects()->pathOf(object, '/'));
    r.outline.selected = bytesOf(outlineColour());
    r.outline.hovered = {255, 255, 255};
    r.outline.width = float(1.6 * scale);
    return r;
}

void View::ask(bool fine) {
    if (!m_context.render) {
        m_wanted = false;
        m_failure = tr("3D pictures need OpenGL, which is not available.");
        return update();
    }
    m_wanted = false;
    m_inFlight = true;
    m_fine = fine;
    m_sinceAsked.start();
    ++(fine ? m_refinements : m_redraws);
    if (m_image.image.isNull()) QTimer::singleShot(kLongMs, this, qOverload<>(&View::update)); // large meshes take long
    PictureRequest newRequest = request(fine);
    RenderedImage frame{{}, *newRequest.view, m_context.world.objects(), m_context.world.poses()};
    m_context.render->draw(std::move(newRequest), [inbox = m_inbox, frame = std::move(frame), number = m_redraws + m_refinements,
                                                   render = m_context.render](Result<Image> result) {
        QImage image;
        QString failure;
        if (result) {
            const Image& drawn = result.value();
            image = QImage(drawn.pixels.data(), int(drawn.width), int(drawn.height), int(drawn.width) * 3, QImage::Format_RGB888)
                        .convertToFormat(QImage::Format_RGB32);
        } else {
            failure = QString::fromStdString(result.error().message);
        }
        const bool software = render->isSoftware();
        const QString notice = QString::fromStdString(render->takeWarning());
        const std::lock_guard lock(inbox->mutex);
        if (!inbox->view) return;
        QMetaObject::invokeMethod(
            inbox->view,
            [view = inbox->view, number, image, failure, frame, software, notice] {
                if (!notice.isEmpty()) Q_EMIT view->m_context.document.notice(notice);
                view->take(number, image, failure, frame, software);
            },
            Qt::QueuedConnection);
    });
}

void View::take(int number, const QImage& image, const QString& failure, RenderedImage frame, bool software) {
    if (number != m_redraws + m_refinements) return; // a cancelled refinement
    m_inFlight = false;
    m_software = software;
    if (image.isNull() && failure.isEmpty()) { // cancelled by another request: retry when idle
        m_fine = false;
        return settle();
    }
    m_failure = failure;
    if (!image.isNull()) {
        m_image = std::move(frame);
        m_image.image = image;
    }
    update();
    Q_EMIT pictureShown();
    // Requests the next image while this one is painted.
    if (m_wanted && isVisible() && m_sinceAsked.elapsed() >= kFrameMs) ask(false);
    else if (m_wanted) pump();
    else settle();
}

void View::settle() {
    const bool moves = m_context.session.state() == RunState::Running;
    if (m_software && m_failure.isEmpty() && isUpToDate() && !moves && !m_fine && !isMouseBusy()) m_settle.start(kSettleMs);
}

void View::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_image.image.isNull()) {
        painter.fillRect(rect(), palette().window());
        if (!m_failure.isEmpty()) paintMessage(painter, m_failure);
        else if (m_inFlight && m_sinceAsked.elapsed() >= kLongMs) paintMessage(painter, tr("Drawing…"));
        return;
    }
    painter.drawImage(rect(), m_image.image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOverlays(painter, *this);
    paintThrough(painter);
    for (const auto& work : m_tools) work->paint(painter);
    paintHints(painter);
    if (!m_failure.isEmpty()) paintMessage(painter, m_failure);
    if (m_isFramed) {
        painter.setPen(QPen(ink(Ink::Accent), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void View::setCurrent(bool current, bool framed) {
    if (current == m_isCurrent && framed == m_isFramed) return;
    m_isCurrent = current;
    m_isFramed = framed;
    update();
}

} // namespace trundle
