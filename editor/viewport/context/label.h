#pragma once
#include <span>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QString>

class QFontMetricsF;
class QPainter;

namespace trundle {

/// A text label on a dark rounded rectangle around a point; legible over any image and in both themes. Beside the point where it would
/// leave the painted area, in several lines where that is narrower.
void paintLabel(QPainter& painter, const QPointF& middle, const QString& text);

struct LabelRequest {
    QString text;
    std::vector<QPointF> places; ///< for its middle, the best first; not empty
    bool isRequired = false;
};
struct PlacedLabel {
    QString text;
    QPointF middle;
    QRectF rect; ///< pixels
};
/// Puts each label, the required ones first, at its first place where it covers none that has one. Without such a place a required
/// label is at its first one, any other is left out.
[[nodiscard]] std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests, const QFontMetricsF& metrics,
                                                   const QRectF& area);

} // namespace trundle
