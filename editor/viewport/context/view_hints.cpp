#include "editor/viewport/context/view_hints.h"

#include <algorithm>

#include <QPainter>
#include <QRectF>
#include <QStringList>

#include "editor/viewport/context/label.h"

namespace trundle {

namespace {

/// Where the hint is: in a narrow view in several lines, above the scale bar and its label, and above the axes where it would
/// overlap them.
struct HintPlace {
    QStringList lines;
    QRectF rect;
};

double labelHeight(const QFontMetrics& metrics) { return metrics.height() + 6; }

HintPlace hintPlace(const QString& hint, const QFontMetrics& metrics, const QSize& size) {
    if (hint.isEmpty()) return {};
    const bool fits = metrics.horizontalAdvance(hint) + 20 < size.width();
    HintPlace place{fits ? QStringList(hint) : hint.split(QStringLiteral(" · ")), {}};
    double wide = 0;
    for (const QString& line : place.lines) wide = std::max(wide, metrics.horizontalAdvance(line) + 14.0);
    const int scale = 34 + metrics.height(), axes = 0.5 * (size.width() - wide) < 76 ? 78 : 0;
    const double high = labelHeight(metrics) * double(place.lines.size());
    place.rect = {0.5 * (size.width() - wide), size.height() - std::max(scale, axes) - high, wide, high};
    return place;
}

} // namespace

void ViewHints::setHovered(const std::string& path, const QString& hint) {
    if (hint != m_hoverHint) {
        m_hoverHint = hint;
        Q_EMIT textChanged();
    }
    if (path == m_hovered) return;
    m_hovered = path;
    Q_EMIT hoveredChanged();
}

void ViewHints::setHint(const QString& hint) {
    if (hint == m_hint) return;
    m_hint = hint;
    Q_EMIT textChanged();
}

void ViewHints::paint(QPainter& painter, const QSize& size, const QPointF& cursor) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const double high = labelHeight(metrics);
    const HintPlace hint = hintPlace(m_hint, metrics, size);
    for (int i = 0; i < hint.lines.size(); ++i)
        paintLabel(painter, {0.5 * size.width(), hint.rect.top() + high * (i + 0.5)}, hint.lines[i]);
    if (m_hoverHint.isEmpty()) return;
    const double half = 0.5 * (metrics.horizontalAdvance(m_hoverHint) + 14);
    const double x = std::clamp(cursor.x() + 14 + half, half + 2, std::max(half + 2, size.width() - half - 2));
    const bool below = cursor.y() + 16 + high < size.height() - 2;
    double y = below ? cursor.y() + 16 + 0.5 * high : cursor.y() - 8 - 0.5 * high;
    const QRectF beside(x - half, y - 0.5 * high, 2 * half, high);
    if (beside.intersects(hint.rect)) y = std::min(cursor.y() - 8, hint.rect.top() - 2) - 0.5 * high;
    paintLabel(painter, {x, y}, m_hoverHint);
}

} // namespace trundle
