#include "editor/problems/problem_icons.h"

#include <QCoreApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

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

/// Drawn when it is shown, so that it follows a change of theme and is sharp at any scale.
class SignIcon final : public QIconEngine {
public:
    explicit SignIcon(Severity severity) : m_severity(severity) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode, QIcon::State) override {
        paintSign(*painter, QRectF(rect), m_severity);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new SignIcon(m_severity); }

private:
    Severity m_severity;
};

} // namespace

QIcon severityIcon(Severity severity) { return QIcon(new SignIcon(severity)); }

QString severityWord(Severity severity) {
    switch (severity) {
    case Severity::Error: return QCoreApplication::translate("Problems", "Error");
    case Severity::Warning: return QCoreApplication::translate("Problems", "Warning");
    case Severity::Hint: return QCoreApplication::translate("Problems", "Hint");
    }
    return {};
}

} // namespace trundle
