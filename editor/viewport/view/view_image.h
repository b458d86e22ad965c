#pragma once
// The image of a 3D view: requested from the render service when something changes, refined when nothing does.

#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "editor/viewport/context/rendered_image.h"

class QPainter;

namespace trundle {

class ToolView;

class ViewImage final : public QObject {
    Q_OBJECT
public:
    explicit ViewImage(ToolView& view); ///< must outlive this object
    ~ViewImage() override;

    /// Marks the image as outdated. Calls are combined into one request; a hidden view requests none.
    void redraw();
    /// Refines the image soon, if nothing changes until then.
    void settle();
    void cancelSettle() { m_settle.stop(); }

    [[nodiscard]] const RenderedImage& rendered() const { return m_image; }
    [[nodiscard]] const QImage& picture() const { return m_image.image; }
    /// Paints the image, or the reason why it is missing; false without an image.
    bool paint(QPainter& painter) const;
    void paintFailure(QPainter& painter) const; ///< over an older image

    /// Number of images requested because of a change, and number of refinements requested when idle. For tests.
    [[nodiscard]] int redraws() const { return m_redraws; }
    [[nodiscard]] int refinements() const { return m_refinements; }
    /// A view that displays an error instead of an image also counts as up to date.
    [[nodiscard]] bool isUpToDate() const { return !m_wanted && !m_inFlight && !(m_image.image.isNull() && m_failure.isEmpty()); }
    [[nodiscard]] bool isSettled() const;

Q_SIGNALS:
    void shown();

private:
    struct Inbox;
    void pump();
    void ask(bool fine);
    void take(int number, const QImage& image, const QString& failure, RenderedImage frame, bool software);
    [[nodiscard]] bool isVisible() const;
    /// A refinement in progress is cancelled by a new request.
    [[nodiscard]] bool mayAsk() const { return m_wanted && (!m_inFlight || m_fine) && isVisible(); }
    void paintMessage(QPainter& painter, const QString& text) const;

    ToolView& m_view;
    std::shared_ptr<Inbox> m_inbox;
    RenderedImage m_image;
    QString m_failure;
    QTimer m_pumpTimer, m_settle;
    QElapsedTimer m_sinceAsked;
    bool m_wanted = true, m_inFlight = false, m_fine = false, m_software = true;
    int m_redraws = 0, m_refinements = 0; // their sum is the number of the last request
};

} // namespace trundle
