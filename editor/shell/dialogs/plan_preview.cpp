#include "editor/shell/dialogs/plan_preview.h"

#include <algorithm>

#include <QImage>
#include <QPainter>

#include "editor/properties/editors/amount_field.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kPlanSide = 220, kPlanMargin = 8; // pixels

} // namespace

AmountField* makeLengthField(const char* name, const QString& title, double least, double most, double value) {
    Property property;
    property.name = title.toStdString();
    property.unit = "m";
    property.minimum = least;
    property.maximum = most;
    auto* field = new AmountField(property);
    field->setObjectName(QLatin1String(name));
    field->setValue(value);
    return field;
}

PlanPreview::PlanPreview(const char* name) {
    setObjectName(QLatin1String(name));
    setFixedSize(scaledToFont(kPlanSide), scaledToFont(kPlanSide));
    setAlignment(Qt::AlignCenter);
    setFrameShape(QFrame::StyledPanel);
    setWordWrap(true);
}

void PlanPreview::showWalls(const RoomPlan& plan) {
    const double scale = (width() - 2. * kPlanMargin) / std::max(plan.length, plan.width);
    QPixmap picture(size() - QSize(kPlanMargin, kPlanMargin));
    picture.fill(themePalette().color(QPalette::Base));
    QPainter p(&picture);
    p.setRenderHint(QPainter::Antialiasing);
    p.translate(picture.width() / 2., picture.height() / 2.);
    for (const RoomWall& w : plan.walls) {
        const double along = std::max(1.0, w.along * scale), across = std::max(1.0, w.across * scale);
        p.fillRect(QRectF(w.x * scale - along / 2, -w.y * scale - across / 2, along, across), ink(Ink::Text));
    }
    p.end();
    setPixmap(picture);
}

void PlanPreview::showHeights(const HeightMap& map) {
    QImage image(int(map.columns), int(map.rows), QImage::Format_Grayscale8);
    for (std::uint32_t row = 0; row < map.rows; ++row)
        for (std::uint32_t column = 0; column < map.columns; ++column)
            image.scanLine(int(row))[column] =
                uchar(255 * std::clamp(map.heights[std::size_t(row) * map.columns + column], 0.f, 1.f));
    setPixmap(QPixmap::fromImage(image).scaled(size() - QSize(kPlanMargin, kPlanMargin), Qt::KeepAspectRatio,
                                               Qt::SmoothTransformation));
}

void PlanPreview::showObstacles(const ObstacleField& field, const std::vector<FieldObstacle>& obstacles) {
    const double scale = (width() - 2. * kPlanMargin) / std::max(field.length, field.width);
    QPixmap picture(size() - QSize(kPlanMargin, kPlanMargin));
    picture.fill(themePalette().color(QPalette::Base));
    QPainter p(&picture);
    p.setRenderHint(QPainter::Antialiasing);
    p.translate(picture.width() / 2., picture.height() / 2.);
    p.scale(scale, -scale);
    p.setPen(Qt::NoPen);
    p.setBrush(ink(Ink::Line));
    for (const auto& [left, low, right, high] : field.occupied) p.drawRect(QRectF(left, low, right - left, high - low));
    for (const auto& [x, y, radius] : field.free) p.drawEllipse(QPointF(x, y), radius, radius);
    p.setBrush(ink(Ink::Text));
    for (const FieldObstacle& o : obstacles) {
        p.save();
        p.translate(o.x, o.y);
        p.rotate(o.heading);
        const QRectF around(-o.across / 2, -o.deep / 2, o.across, o.deep);
        if (o.isRound) p.drawEllipse(around);
        else p.drawRect(around);
        p.restore();
    }
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(ink(Ink::Faint), 1 / scale, Qt::DashLine));
    p.drawRect(QRectF(-field.length / 2, -field.width / 2, field.length, field.width));
    p.end();
    setPixmap(picture);
}

} // namespace trundle
