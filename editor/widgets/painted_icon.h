#pragma once
#include <functional>

#include <QIcon>
#include <QPainter>

namespace trundle {

/// Paints the icon into a box of logical pixels.
using IconPainting = std::function<void(QPainter& painter, const QRectF& box, QIcon::Mode mode)>;

/// An icon that is painted whenever it is shown, so that it follows a change of theme and is sharp at any scale.
[[nodiscard]] QIcon paintedIcon(IconPainting paint);

} // namespace trundle
