#pragma once
class QPainter;
class QPointF;
class QString;

namespace trundle {

/// A text label on a dark rounded rectangle around a point; legible over any image and in both themes. Beside the point where it would
/// leave the painted area.
void paintLabel(QPainter& painter, const QPointF& middle, const QString& text);

} // namespace trundle
