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

std::vector<Stair> stairsOf(const LinkReport& r) {
    std::vector<Stair> stairs{{LevelDiagram::tr("send"), r.link.sendGain}, {LevelDiagram::tr("path"), -r.link.pathLoss}};
    if (r.link.shadow != 0) stairs.push_back({LevelDiagram::tr("shadow"), -r.link.shadow});
    if (r.link.wallLoss != 0) stairs.push_back({LevelDiagram::tr("walls"), -r.link.wallLoss});
    stairs.push_back({LevelDiagram::tr("receive"), r.link.receiveGain});
    return stairs;
}

} // namespace

/// Where power stands in the widget.
struct LevelDiagram::Scale {
    QRectF plot;
    double low = 0, span = 1; ///< dBm, dB
    int line = 0;             ///< height of a line of text
    [[nodiscard]] double y(double dbm) const { return plot.bottom() - (dbm - low + 0.03 * span) / span * plot.height(); }
};

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
    double low = std::min({m_levels->noiseFloor, m_levels->sensitivity, r.outputPower}), high = r.outputPower,
           level = r.outputPower;
    for (const Stair& stair : stairsOf(r)) {
        level += stair.change;
        low = std::min(low, level);
        high = std::max(high, level);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().height(), left = fontMetrics().horizontalAdvance(tr("sensitivity")) + 12;
    const QRectF plot(left, line, std::max(40, width() - left - 10), std::max(20, height() - 2 * line - 4));
    const Scale scale{plot, low, std::max(high - low, 1.0) * 1.06, line};
    drawReferences(painter, scale);
    drawStairs(painter, scale);
}

void LevelDiagram::drawReferences(QPainter& painter, const Scale& scale) const {
    double taken = 1e9; // labels must not overlap
    for (const auto& [name, dbm, colour] : {std::tuple(tr("noise"), m_levels->noiseFloor, ink(Ink::Faint)),
                                            std::tuple(tr("sensitivity"), m_levels->sensitivity, ink(Ink::Warning))}) {
        painter.setPen(QPen(colour, 1, Qt::DashLine));
        painter.drawLine(QPointF(scale.plot.left(), scale.y(dbm)), QPointF(scale.plot.right(), scale.y(dbm)));
        taken = std::min(scale.y(dbm), taken - scale.line);
        painter.drawText(QRectF(0, taken - 0.5 * scale.line, scale.plot.left() - 8, scale.line),
                         Qt::AlignRight | Qt::AlignVCenter, name);
    }
}

void LevelDiagram::drawStairs(QPainter& painter, const Scale& scale) const {
    const LinkReport& r = m_levels->report;
    const std::vector<Stair> stairs = stairsOf(r);
    const QRectF& plot = scale.plot;
    const int line = scale.line;
    const auto y = [&](double dbm) { return scale.y(dbm); };
    const double step = plot.width() / double(stairs.size() + 1);
    const QColor result = inkForMargin(r.margin);
    double level = r.outputPower;
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
        painter.drawText(words, Qt::AlignCenter, fontMetrics().elidedText(stairs[i].name, Qt::ElideRight, int(words.width())));
    }
    painter.setPen(result);
    const bool above = y(level) - line - 2 > 0;
    painter.drawText(QRectF(plot.right() - 2 * step, above ? y(level) - line - 2 : y(level) + 2, 2 * step, line), Qt::AlignRight,
                     decibelText(level));
}

} // namespace trundle
