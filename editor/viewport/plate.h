#pragma once
class QPainter;
class QPointF;
class QString;

namespace trundle {

/// Words on a small dark plate about a point: readable over any picture, in both themes.
void paintPlate(QPainter& painter, const QPointF& middle, const QString& text);

} // namespace trundle
