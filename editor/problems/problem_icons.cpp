#include "editor/problems/problem_icons.h"

#include <QCoreApplication>
#include <QPainterPath>

#include "editor/widgets/painted_icon.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

void paintSign(QPainter& painter, const QRectF& box, Severity severity) {
    const double s = std::min(box.width(), box.height()) / 16;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(box.center());
    painter.scale(s, s);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink(severity == Severity::Error ? Ink::Error : severity == Severity::Warning ? Ink::Warning : Ink::Hint));
    if (severity == Severity::Warning) {
        QPainterPath triangle;
        triangle.moveTo(0, -6.5);
        triangle.lineTo(7, 6);
        triangle.lineTo(-7, 6);
        triangle.closeSubpath();
        painter.drawPath(triangle);
    } else painter.drawEllipse(QPointF(0, 0), 6.5, 6.5);
    QPen pen(currentTheme() == ThemeKind::Dark ? QColor(0x1a, 0x1d, 0x23) : QColor(Qt::white), 1.7, Qt::SolidLine, Qt::RoundCap);
    painter.setPen(pen);
    if (severity == Severity::Error) {
        painter.drawLine(QPointF(-2.4, -2.4), QPointF(2.4, 2.4));
        painter.drawLine(QPointF(-2.4, 2.4), QPointF(2.4, -2.4));
    } else {
        const double low = severity == Severity::Warning ? 1 : 0;
        painter.drawLine(QPointF(0, -2.8 + low), QPointF(0, 0.8 + low));
        painter.drawPoint(QPointF(0, 3.2 + low));
    }
    painter.restore();
}

} // namespace

QIcon severityIcon(Severity severity) {
    return paintedIcon([severity](QPainter& painter, const QRectF& box, QIcon::Mode) { paintSign(painter, box, severity); });
}

QString severityWord(Severity severity) {
    switch (severity) {
    case Severity::Error: return QCoreApplication::translate("Problems", "Error");
    case Severity::Warning: return QCoreApplication::translate("Problems", "Warning");
    case Severity::Hint: return QCoreApplication::translate("Problems", "Hint");
    }
    return {};
}

} // namespace trundle
