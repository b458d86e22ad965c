#include "editor/viewport/context/view_hints.h"

#include <algorithm>

#include <QPainter>

#include "editor/viewport/context/label.h"

namespace trundle {

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
    if (!m_hint.isEmpty()) paintHint(painter, size);
    if (m_hoverHint.isEmpty()) return;
    const QFontMetrics metrics = painter.fontMetrics();
    const double high = metrics.height() + 6;
    const double half = 0.5 * (metrics.horizontalAdvance(m_hoverHint) + 14);
    const double x = std::clamp(cursor.x() + 14 + half, half + 2, std::max(half + 2, size.width() - half - 2));
    const bool below = cursor.y() + 16 + high < size.height() - 2;
    paintLabel(painter, {x, below ? cursor.y() + 16 + 0.5 * high : cursor.y() - 8 - 0.5 * high}, m_hoverHint);
}

/// In a narrow view the hint is split into several lines. It is placed above the scale bar and its label, and above the axes
/// where it would overlap them.
void ViewHints::paintHint(QPainter& painter, const QSize& size) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const double high = metrics.height() + 6;
    const bool fits = metrics.horizontalAdvance(m_hint) + 20 < size.width();
    const QStringList lines = fits ? QStringList(m_hint) : m_hint.split(QStringLiteral(" · "));
    double wide = 0;
    for (const QString& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line) + 14.0);
    const int scale = 34 + metrics.height(), axes = 0.5 * (size.width() - wide) < 76 ? 78 : 0;
    const double bottom = size.height() - std::max(scale, axes);
    for (int i = 0; i < lines.size(); ++i)
        paintLabel(painter, {0.5 * size.width(), bottom - high * (double(lines.size() - i) - 0.5)}, lines[i]);
}

} // namespace trundle
