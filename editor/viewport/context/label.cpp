#include "editor/viewport/context/label.h"

#include <algorithm>

#include <QPainter>

namespace trundle {
namespace {

constexpr QSizeF kMargins(14, 6);                            // of both sides together
constexpr int kInLines = Qt::AlignCenter | Qt::TextWordWrap; // where an area is narrower than the text

QSizeF sizeOf(const QString& text, const QFontMetricsF& metrics, double mostWidth) {
    const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
    return size.width() <= mostWidth ? size : metrics.boundingRect({0, 0, mostWidth, 0}, kInLines, text).size();
}

QRectF rectOf(const QPointF& middle, const QString& text, const QFontMetricsF& metrics, const QRectF& area) {
    const QSizeF size = sizeOf(text, metrics, area.width() - kMargins.width()) + kMargins;
    QRectF at(middle.x() - 0.5 * size.width(), middle.y() - 0.5 * size.height(), size.width(), size.height());
    if (area.contains(middle)) {
        at.moveLeft(std::max(area.left(), std::min(at.left(), area.right() - at.width())));
        at.moveTop(std::max(area.top(), std::min(at.top(), area.bottom() - at.height())));
    }
    return at;
}

} // namespace

void paintLabel(QPainter& painter, const QPointF& middle, const QString& text) {
    const QRectF at = rectOf(middle, text, QFontMetricsF(painter.font()), painter.window());
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 27, 31, 205));
    painter.drawRoundedRect(at, 4, 4);
    painter.setPen(QColor(245, 246, 248));
    const bool isOneLine = QFontMetricsF(painter.font()).horizontalAdvance(text) + kMargins.width() <= at.width();
    painter.drawText(at, isOneLine ? int(Qt::AlignCenter) : kInLines, text);
}

std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests, const QFontMetricsF& metrics, const QRectF& area) {
    std::vector<PlacedLabel> placed;
    for (const bool required : {true, false})
        for (const LabelRequest& request : requests) {
            if (request.isRequired != required) continue;
            const auto rectAt = [&](const QPointF& place) { return rectOf(place, request.text, metrics, area); };
            const auto isFree = [&](const QPointF& place) {
                const QRectF rect = rectAt(place);
                return std::ranges::none_of(placed, [&](const PlacedLabel& other) { return other.rect.intersects(rect); });
            };
            auto place = std::ranges::find_if(request.places, isFree);
            if (place == request.places.end() && required) place = request.places.begin();
            if (place != request.places.end()) placed.push_back({request.text, *place, rectAt(*place)});
        }
    return placed;
}

} // namespace trundle
