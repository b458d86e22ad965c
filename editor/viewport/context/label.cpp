#include "editor/viewport/context/label.h"

#include <algorithm>

#include <QPainter>

namespace trundle {

void paintLabel(QPainter& painter, const QPointF& middle, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 14, metrics.height() + 6);
    QRectF at(middle.x() - 0.5 * size.width(), middle.y() - 0.5 * size.height(), size.width(), size.height());
    if (const QRectF shown = painter.window(); shown.contains(middle)) {
        at.moveLeft(std::max(shown.left(), std::min(at.left(), shown.right() - at.width())));
        at.moveTop(std::max(shown.top(), std::min(at.top(), shown.bottom() - at.height())));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 27, 31, 205));
    painter.drawRoundedRect(at, 4, 4);
    painter.setPen(QColor(245, 246, 248));
    painter.drawText(at, Qt::AlignCenter, text);
}

} // namespace trundle
