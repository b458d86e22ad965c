#include "editor/properties/origin_mark.h"

#include <QPainter>
#include <QPainterPath>

#include "editor/widgets/theme.h"

namespace trundle {

OriginMark::OriginMark(QWidget* parent) : QToolButton(parent) {
    setFixedSize(sizeHint());
    setFocusPolicy(Qt::NoFocus); // the field's context menu key opens the same menu
}

void OriginMark::display(ValueOrigin origin, bool formula, bool waits) {
    m_waits = waits;
    m_origin = origin;
    m_formula = formula;
    update();
}

void OriginMark::paintSign(QPainter& painter) const {
    const QPointF c = QRectF(rect()).center();
    const QColor colour = m_origin == ValueOrigin::Override ? ink(Ink::Accent) : ink(Ink::Faint);
    if (m_waits) {
        const QRectF circle(c.x() - 4.5, c.y() - 4.5, 9, 9);
        painter.setPen(QPen(ink(Ink::Warning), 1.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(circle, 60 * 16, 290 * 16);
        const QPointF tip = circle.center() + QPointF(2.2, -3.9);
        painter.drawLine(tip, tip + QPointF(-0.4, -3.2));
        return painter.drawLine(tip, tip + QPointF(-3.2, 0.6));
    }
    painter.setPen(QPen(colour, 1.3));
    if (m_formula) {
        QFont font = this->font();
        font.setItalic(true);
        if (m_origin == ValueOrigin::Override) font.setWeight(QFont::DemiBold);
        painter.setFont(font);
        return painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("ƒ"));
    }
    switch (m_origin) {
    case ValueOrigin::Default: return painter.drawEllipse(c, 2.5, 2.5);
    case ValueOrigin::Own: painter.setBrush(colour); return painter.drawEllipse(c, 2.5, 2.5);
    case ValueOrigin::Override: {
        painter.setBrush(colour);
        const QPointF corners[] = {c + QPointF(0, -4.5), c + QPointF(4.5, 0), c + QPointF(0, 4.5), c + QPointF(-4.5, 0)};
        return painter.drawPolygon(corners, 4);
    }
    case ValueOrigin::Config:
        painter.drawLine(c + QPointF(-3.5, 3.5), c + QPointF(3.5, -3.5));
        painter.drawLine(c + QPointF(-1, -3.5), c + QPointF(3.5, -3.5));
        return painter.drawLine(c + QPointF(3.5, 1), c + QPointF(3.5, -3.5));
    case ValueOrigin::CommandLine: return painter.drawText(rect(), Qt::AlignCenter, QStringLiteral(">"));
    }
}

void OriginMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || isDown()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink(Ink::Line));
        painter.drawRoundedRect(rect(), 4, 4);
    }
    paintSign(painter);
}

} // namespace trundle
