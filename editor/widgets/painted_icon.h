#pragma once
#include <functional>

#include <QIcon>
#include <QPainter>

namespace trundle {

/// Paints the icon into a rectangle in logical pixels.
using IconPainting = std::function<void(QPainter& painter, const QRectF& box, QIcon::Mode mode)>;

/// An icon that is painted each time it is shown, so that it follows the theme and is sharp at any scale.
[[nodiscard]] QIcon paintedIcon(IconPainting paint);

} // namespace trundle
