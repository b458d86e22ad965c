#include "editor/viewport/view.h"

#include <mutex>

#include <QPainter>
#include <QPointer>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/gizmo_work.h"
#include "editor/viewport/library_drop.h"
#include "editor/viewport/measure_work.h"
#include "editor/viewport/navigation.h"
#include "editor/viewport/overlays.h"
#include "editor/viewport/pin_work.h"
#include "editor/viewport/push_work.h"
#include "editor/viewport/radio_overlays.h"
#include "editor/viewport/select_work.h"
#include "editor/viewport/shown_world.h"
#include "editor/viewport/view_settings.h"
#include "editor/widgets/theme.h"
#include "scene/framing.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16; // no more than about 60 pictures a second
constexpr int kSettleMs =
    350; // after so long without a change, longer than between two keys, the picture is drawn once more, finer
constexpr int kGlideMs = 160;
constexpr int kLongMs = 500; // a first picture that takes longer says so

std::array<std::uint8_t, 3> bytesOf(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

} // namespace

/// Where the render thread leaves pictures. It outlives the view: a picture for a view that is gone goes nowhere.
struct View::Inbox {
    std::mutex mutex;
    View* view = nullptr;
};

QColor View::outlineColour() { return {255, 150, 30}; }

View::View(const ViewParts& parts, ViewKind kind, QWidget* parent)
    : QWidget(parent), m_parts(parts), m_inbox(std::make_shared<Inbox>()) {
    m_inbox->view = this;
    setObjectName(QStringLiteral("view3d"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(120, 90);
    setAccessibleName(tr("3D view"));

    m_works.push_back(std::make_unique<PinWork>(*this));
    auto navigation = std::make_unique<Navigation>(*this);
    m_navigation = navigation.get();
    m_works.push_back(std::move(navigation));
    m_works.push_back(std::make_unique<MeasureWork>(*this));
    auto gizmo = std::make_unique<GizmoWork>(*this);
    m_gizmo = gizmo.get();
    m_works.push_back(std::move(gizmo));
    m_works.push_back(std::make_unique<PushWork>(*this));
    m_works.push_back(std::make_unique<SelectWork>(*this));

    m_pumpTimer.setSingleShot(true);
    m_settle.setSingleShot(true);
    connect(&m_pumpTimer, &QTimer::timeout, this, [this] {
        if (mayAsk()) ask(false);
    });
    connect(&m_settle, &QTimer::timeout, this, [this] {
        if (!m_wanted && !m_inFlight && isVisible() && !mouseIsBusy()) ask(true);
    });
    connect(&m_glide, &QTimer::timeout, this, &View::glide);
    connect(&m_parts.session, &RunSession::stateChanged, this, &View::settle);
    connect(&m_parts.world, &ShownWorld::replaced, this, [this] {
        followSelection();
        redraw();
    });
    connect(&m_parts.world, &ShownWorld::posed, this, [this] {
        followSelection();
        redraw();
    });
    connect(&m_parts.world, &ShownWorld::marked, this, &View::redraw);
    connect(&m_parts.world, &ShownWorld::draggedMoved, this, &View::redraw);
    connect(&m_parts.settings, &ViewSettings::changed, this, &View::redraw);
    connect(&m_parts.settings, &ViewSettings::changed, this, qOverload<>(&View::update)); // handles need no other picture
    connect(&m_parts.selection, &Selection::changed, this, [this] {
        if (m_camera.kind() == ViewKind::Follow || m_camera.kind() == ViewKind::Chase) m_camera.setKind(m_camera.kind());
        followSelection();
        redraw();
    });
    if (const RadioOverlays* radios = m_parts.radios) {
        connect(radios, &RadioOverlays::sceneChanged, this, &View::redraw);
        connect(radios, &RadioOverlays::linksChanged, this, qOverload<>(&QWidget::update));
    }
    m_camera.setKind(kind);
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
    if (!gently || !isVisible() || m_frame.image.isNull()) return changeCamera([&](ViewCamera& camera) { camera = there; });
    if (leaveCamera()) Q_EMIT kindChanged();
    m_glideFrom = m_camera;
    m_glideTo = there;
    m_gliding.start();
    m_glide.start(kFrameMs);
}

void View::glide() {
    // The direction of sight is the same at both ends, so nothing turns on the way.
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

/// Nothing where the view follows none.
std::optional<ObjectRef> View::followedRobot() const {
    if (m_camera.kind() != ViewKind::Follow && m_camera.kind() != ViewKind::Chase) return std::nullopt;
    const ShownWorld& world = m_parts.world;
    const std::optional<ObjectRef> selected = world.find(m_parts.selection.current());
    if (selected && world.objects()->robotOf(*selected)) return ObjectRef{ObjectKind::Robot, selected->instance};
    if (world.objects()->experiment().robots.empty()) return std::nullopt;
    return ObjectRef{ObjectKind::Robot, 0};
}

void View::followSelection() {
    followCamera();
    followNamed();
    if (const auto robot = followedRobot()) m_camera.follow(m_parts.world.poseOf(*robot));
}

CameraView View::cameraView() const {
    if (const CameraModel* camera = throughCamera()) return throughView(*camera, *m_parts.world.poses());
    if (!m_named.empty())
        if (const auto view = namedView(*textOfViews(), m_named, m_parts.world.objects()->experiment(), *m_parts.world.poses()))
            return *view;
    if (!m_camera.isParallel()) return m_camera.view();
    const Bounds all = m_parts.world.bounds();
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
    if (m_frame.image.isNull()) return pixelOf(point);
    const auto at = project(m_frame.camera, std::uint32_t(std::max(1, width())), std::uint32_t(std::max(1, height())), point);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

const BodyPoses& View::shownPoses() const {
    return m_frame.poses && m_frame.objects == m_parts.world.objects() ? *m_frame.poses : *m_parts.world.poses();
}

Vec3 View::pointUnder(const QPointF& at) const {
    const ViewRay ray = rayAt(at);
    const std::vector<RayHit> hits = m_parts.world.hitsAlong(ray, true);
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
    // Changes of one moment make one picture: the request goes out when the event loop comes round.
    const qint64 since = m_sinceAsked.isValid() ? m_sinceAsked.elapsed() : kFrameMs;
    m_pumpTimer.start(int(std::max<qint64>(0, kFrameMs - since)));
}

PictureRequest View::request(bool fine) const {
    PictureRequest r;
    const ViewSettings& settings = m_parts.settings;
    // Beyond what is drawn at most, a pixel of the picture is larger than one of the screen.
    const double scale = std::min(devicePixelRatioF(), kMostPixels / double(std::max({1, width(), height()})));
    r.scene = m_parts.world.drawnScene();
    r.view = cameraView();
    r.width = std::uint32_t(std::clamp(int(std::lround(width() * scale)), 1, int(kMostPixels)));
    r.height = std::uint32_t(std::clamp(int(std::lround(height() * scale)), 1, int(kMostPixels)));
    r.poses = m_parts.world.drawnPoses();
    r.samples = fine || !m_software ? 4 : 1;
    r.yields = fine;
    r.mask = kMaskRobots | kMaskStatics | kMaskFloor | kMaskSky | kMaskGhosts;
    r.floorLines = settings.shows(kOverlayGrid);
    if (r.floorLines) r.mask |= kMaskGuide;
    if (settings.shows(kOverlayCollision)) r.mask |= kMaskCollision;
    if (m_parts.radios && (m_parts.radios->inScene().shapes || m_parts.radios->inScene().floor)) {
        r.mask |= kMaskOverlay;
        r.overlay = m_parts.radios->inScene();
    }
    r.wireframe = settings.shows(kOverlayWireframe);
    if (settings.shows(kOverlayShadows) && !r.wireframe) r.mask |= fine || !m_software ? kMaskSoftShadows : kMaskShadows;
    r.hidden = m_parts.world.hiddenInScene();
    if (const CameraModel* camera = throughCamera(); camera && !camera->seesSelf) r.hidden.push_back(camera->robot);
    for (const std::string& path : m_parts.selection.paths())
        for (const ObjectRef& object : m_parts.world.objectsOf(path))
            r.marks.selected.push_back(m_parts.world.objects()->pathOf(object, '/'));
    if (!m_hovered.empty() && !m_parts.selection.contains(m_hovered))
        for (const ObjectRef& object : m_parts.world.objectsOf(m_hovered))
            r.marks.hovered.push_back(m_parts.world.objects()->pathOf(object, '/'));
    r.outline.selected = bytesOf(outlineColour());
    r.outline.hovered = {255, 255, 255};
    r.outline.width = float(1.6 * scale);
    return r;
}

void View::ask(bool fine) {
    if (!m_parts.render) {
        m_wanted = false;
        m_failure = tr("3D pictures need OpenGL, and none is to be had here.");
        return update();
    }
    m_wanted = false;
    m_inFlight = true;
    m_fine = fine;
    m_sinceAsked.start();
    ++(fine ? m_refinements : m_redraws);
    if (m_frame.image.isNull()) QTimer::singleShot(kLongMs, this, qOverload<>(&View::update)); // a large mesh takes its time
    PictureRequest wish = request(fine);
    Frame frame{{}, *wish.view, m_parts.world.objects(), m_parts.world.poses()};
    m_parts.render->draw(std::move(wish), [inbox = m_inbox, frame = std::move(frame), number = m_redraws + m_refinements,
                                           render = m_parts.render](Result<Image> result) {
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
        const QString notice = QString::fromStdString(render->takeNotice());
        const std::lock_guard lock(inbox->mutex);
        if (!inbox->view) return;
        QMetaObject::invokeMethod(
            inbox->view,
            [view = inbox->view, number, image, failure, frame, software, notice] {
                if (!notice.isEmpty()) Q_EMIT view->m_parts.document.notice(notice);
                view->take(number, image, failure, frame, software);
            },
            Qt::QueuedConnection);
    });
}

void View::take(int number, const QImage& image, const QString& failure, Frame frame, bool software) {
    if (number != m_redraws + m_refinements) return; // a finer one that gave way
    m_inFlight = false;
    m_software = software;
    if (image.isNull() && failure.isEmpty()) { // it gave way to somebody else's picture: once more when there is time
        m_fine = false;
        return settle();
    }
    m_failure = failure;
    if (!image.isNull()) {
        m_frame = std::move(frame);
        m_frame.image = image;
    }
    update();
    Q_EMIT pictureShown();
    // The next picture is drawn while this one is painted.
    if (m_wanted && isVisible() && m_sinceAsked.elapsed() >= kFrameMs) ask(false);
    else if (m_wanted) pump();
    else settle();
}

void View::settle() {
    const bool moves = m_parts.session.state() == RunState::Running;
    if (m_software && m_failure.isEmpty() && isUpToDate() && !moves && !m_fine && !mouseIsBusy()) m_settle.start(kSettleMs);
}

void View::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_frame.image.isNull()) {
        painter.fillRect(rect(), palette().window());
        if (!m_failure.isEmpty()) paintMessage(painter, m_failure);
        else if (m_inFlight && m_sinceAsked.elapsed() >= kLongMs) paintMessage(painter, tr("Drawing…"));
        return;
    }
    painter.drawImage(rect(), m_frame.image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOverlays(painter, *this);
    paintThrough(painter);
    for (const auto& work : m_works) work->paint(painter);
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
