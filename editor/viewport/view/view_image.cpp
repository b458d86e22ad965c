#include "editor/viewport/view/view_image.h"

#include <mutex>

#include <QPainter>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/picture_request.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kFrameMs = 16;   // limits the rate to about 60 images per second
constexpr int kSettleMs = 350; // ms without a change, longer than between two key presses, before the image is refined
constexpr int kLongMs = 500;   // ms after which the first image shows "Drawing…"

} // namespace

/// Receives images from the render thread. Shared with pending requests; images for a destroyed view are dropped.
struct ViewImage::Inbox {
    std::mutex mutex;
    ViewImage* image = nullptr;
};

ViewImage::ViewImage(ToolView& view) : m_view(view), m_inbox(std::make_shared<Inbox>()) {
    m_inbox->image = this;
    m_pumpTimer.setSingleShot(true);
    m_settle.setSingleShot(true);
    connect(&m_pumpTimer, &QTimer::timeout, this, [this] {
        if (mayAsk()) ask(false);
    });
    connect(&m_settle, &QTimer::timeout, this, [this] {
        if (!m_wanted && !m_inFlight && isVisible() && !m_view.isMouseBusy()) ask(true);
    });
    connect(&m_view.context().session, &RunSession::stateChanged, this, &ViewImage::settle);
}

ViewImage::~ViewImage() {
    const std::lock_guard lock(m_inbox->mutex);
    m_inbox->image = nullptr;
}

bool ViewImage::isVisible() const { return m_view.widget().isVisible(); }

bool ViewImage::isSettled() const { return isUpToDate() && !m_settle.isActive() && !m_view.camera().isMoving(); }

void ViewImage::redraw() {
    m_wanted = true;
    m_settle.stop();
    pump();
}

void ViewImage::pump() {
    if (!mayAsk() || m_pumpTimer.isActive()) return;
    // Changes made in one event-loop pass are combined into one request.
    const qint64 since = m_sinceAsked.isValid() ? m_sinceAsked.elapsed() : kFrameMs;
    m_pumpTimer.start(int(std::max<qint64>(0, kFrameMs - since)));
}

void ViewImage::ask(bool fine) {
    const ViewContext& context = m_view.context();
    if (!context.render) {
        m_wanted = false;
        m_failure = tr("3D pictures need OpenGL, which is not available.");
        return m_view.widget().update();
    }
    m_wanted = false;
    m_inFlight = true;
    m_fine = fine;
    m_sinceAsked.start();
    ++(fine ? m_refinements : m_redraws);
    if (m_image.image.isNull()) // large meshes take long
        QTimer::singleShot(kLongMs, &m_view.widget(), qOverload<>(&QWidget::update));
    PictureRequest newRequest = pictureRequest(m_view, fine, m_software);
    RenderedImage frame{{}, *newRequest.view, context.world.objects(), context.world.poses()};
    context.render->draw(std::move(newRequest), [inbox = m_inbox, frame = std::move(frame), number = m_redraws + m_refinements,
                                                 render = context.render](Result<Image> result) {
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
        if (!inbox->image) return;
        QMetaObject::invokeMethod(
            inbox->image,
            [self = inbox->image, number, image, failure, frame, software, notice] {
                if (!notice.isEmpty()) Q_EMIT self->m_view.context().document.notice(notice);
                self->take(number, image, failure, frame, software);
            },
            Qt::QueuedConnection);
    });
}

void ViewImage::take(int number, const QImage& image, const QString& failure, RenderedImage frame, bool software) {
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
    m_view.widget().update();
    Q_EMIT shown();
    // Requests the next image while this one is painted.
    if (m_wanted && isVisible() && m_sinceAsked.elapsed() >= kFrameMs) ask(false);
    else if (m_wanted) pump();
    else settle();
}

void ViewImage::settle() {
    const bool moves = m_view.context().session.state() == RunState::Running;
    if (m_software && m_failure.isEmpty() && isUpToDate() && !moves && !m_fine && !m_view.isMouseBusy())
        m_settle.start(kSettleMs);
}

bool ViewImage::paint(QPainter& painter) const {
    const QWidget& widget = m_view.widget();
    if (!m_image.image.isNull()) {
        painter.drawImage(widget.rect(), m_image.image);
        return true;
    }
    painter.fillRect(widget.rect(), widget.palette().window());
    if (!m_failure.isEmpty()) paintMessage(painter, m_failure);
    else if (m_inFlight && m_sinceAsked.elapsed() >= kLongMs) paintMessage(painter, tr("Drawing…"));
    return false;
}

void ViewImage::paintFailure(QPainter& painter) const {
    if (!m_failure.isEmpty()) paintMessage(painter, m_failure);
}

void ViewImage::paintMessage(QPainter& painter, const QString& text) const {
    const QRect room = m_view.widget().rect().adjusted(24, 0, -24, 0);
    const QRect box = painter.fontMetrics().boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_view.widget().palette().color(QPalette::Base));
    painter.drawRoundedRect(box.adjusted(-12, -8, 12, 8), 6, 6);
    painter.setPen(ink(Ink::Text));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
}

} // namespace trundle
