#include "editor/radios/level_diagram.h"

#include <algorithm>

#include <QPainter>

#include "editor/radios/packet_text.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

struct Stair {
    QString name;
    double change = 0; ///< dB
};

} // namespace

LevelDiagram::LevelDiagram(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("budgetLevels"));
    setAccessibleName(tr("Level diagram"));
    setToolTip(tr("Power along the way, over the receiver's MinReceivePower and the noise"));
}

void LevelDiagram::setLevels(const std::optional<Levels>& levels) {
    m_levels = levels;
    update();
}

void LevelDiagram::paintEvent(QPaintEvent*) {
    if (!m_levels) return;
    const LinkReport& r = m_levels->report;
    std::vector<Stair> stairs{{tr("send"), r.link.sendGain}, {tr("path"), -r.link.pathLoss}};
    if (r.link.shadow != 0) stairs.push_back({tr("shadow"), -r.link.shadow});
    if (r.link.wallLoss != 0) stairs.push_back({tr("walls"), -r.link.wallLoss});
    stairs.push_back({tr("receive"), r.link.receiveGain});
    double low = std::min({m_levels->noiseFloor, m_levels->sensitivity, r.outputPower}), high = r.outputPower,
           level = r.outputPower;
    for (const Stair& stair : stairs) {
        level += stair.change;
        low = std::min(low, level);
        high = std::max(high, level);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = fontMetrics();
    const int line = metrics.height(), left = metrics.horizontalAdvance(tr("sensitivity")) + 12;
    const QRectF plot(left, line, std::max(40, width() - left - 10), std::max(20, height() - 2 * line - 4));
    const double span = std::max(high - low, 1.0) * 1.06;
    const auto y = [&](double dbm) { return plot.bottom() - (dbm - low + 0.03 * span) / span * plot.height(); };

    // labels of the reference levels must not overlap
    double taken = 1e9;
    for (const auto& [name, dbm, colour] : {std::tuple(tr("noise"), m_levels->noiseFloor, ink(Ink::Faint)),
                                            std::tuple(tr("sensitivity"), m_levels->sensitivity, ink(Ink::Warning))}) {
        painter.setPen(QPen(colour, 1, Qt::DashLine));
        painter.drawLine(QPointF(plot.left(), y(dbm)), QPointF(plot.right(), y(dbm)));
        const double at = std::min(y(dbm), taken - line);
        taken = at;
        painter.drawText(QRectF(0, at - 0.5 * line, left - 8, line), Qt::AlignRight | Qt::AlignVCenter, name);
    }
    const double step = plot.width() / double(stairs.size() + 1);
    const QColor result = inkForMargin(r.margin);
    level = r.outputPower;
    double x = plot.left();
    painter.setPen(ink(Ink::Faint));
    painter.drawText(QRectF(x, y(level) - line - 2, 2 * step, line), Qt::AlignLeft, decibelText(level));
    for (std::size_t i = 0; i <= stairs.size(); ++i) {
        const bool last = i == stairs.size();
        painter.setPen(QPen(last ? result : ink(Ink::Accent), 2));
        painter.drawLine(QPointF(x, y(level)), QPointF(x + step, y(level)));
        x += step;
        if (last) break;
        painter.drawLine(QPointF(x, y(level)), QPointF(x, y(level + stairs[i].change)));
        level += stairs[i].change;
        painter.setPen(ink(Ink::Faint));
        const QRectF words(x - 0.5 * step - 4, plot.bottom() + 4, step + 8, line);
        painter.drawText(words, Qt::AlignCenter, metrics.elidedText(stairs[i].name, Qt::ElideRight, int(words.width())));
    }
    painter.setPen(result);
    const bool above = y(level) - line - 2 > 0;
    painter.drawText(QRectF(plot.right() - 2 * step, above ? y(level) - line - 2 : y(level) + 2, 2 * step, line), Qt::AlignRight,
                     decibelText(level));
}

} // namespace trundle
