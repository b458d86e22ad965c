#include "editor/viewport/overlays/through_frame.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>
#include <QWidget>

#include "editor/viewport/context/label.h"
#include "editor/viewport/context/tool_view.h"
#include "scene/queries/camera_model.h"

namespace trundle {

void paintThroughFrame(QPainter& painter, const ToolView& view) {
    const CameraModel* camera = view.camera().through();
    if (!camera) return;
    const QRect all = view.widget().rect();
    const double aspect = double(camera->width) / std::max(1u, camera->height);
    const double high = std::min(double(all.height()), all.width() / aspect), wide = high * aspect;
    const QRectF frame(0.5 * (all.width() - wide), 0.5 * (all.height() - high), wide, high);
    QPainterPath rim;
    rim.addRect(all);
    rim.addRect(frame);
    painter.fillPath(rim, QColor(16, 18, 22, 120));
    painter.setPen(QPen(QColor(245, 246, 248, 190), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
    const bool bends = camera->k1 != 0 || camera->k2 != 0;
    const QString words =
        (bends ? QWidget::tr("Through %1, without its Distortion  •  Esc leaves") : QWidget::tr("Through %1  •  Esc leaves"))
            .arg(QString::fromStdString(camera->path));
    paintLabel(painter, {0.5 * all.width(), 8 + 0.5 * (painter.fontMetrics().height() + 6)}, words);
}

} // namespace trundle
