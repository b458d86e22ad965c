#include "editor/viewport/radio/radio_legend.h"

#include <cmath>

#include <QCoreApplication>
#include <QPainter>

#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/radio_colours.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "lang/number_text.h"

namespace trundle {
namespace {

constexpr int kLeastWidth = 360, kLeastHeight = 240;    // minimum view size for a legend
constexpr int kRoomForWords = 760;                      // pixels across, minimum for text beside the colours
constexpr double kWide = 276, kNarrow = 190, kEdge = 8; // widths of the legend boxes, and the margin around them
constexpr double kRim = 10, kGap = 6, kBar = 9, kUnderBar = 4;
const QColor kPaper(24, 27, 31, 205), kWords(245, 246, 248), kQuiet(178, 184, 192);

QColor colourOf(const Rgb& c) { return {c[0], c[1], c[2]}; }

QString decibelText(double value) {
    return QString::fromStdString(steppedNumber(value, 0.1)).replace(QLatin1Char('-'), QChar(0x2212));
}

QString metresText(double metres) { return QString::fromStdString(steppedNumber(metres, 0.001)) + QStringLiteral(" m"); }

/// A row of a legend box: text, a colour bar with numbers below, or line samples.
struct LegendRow {
    QString words;
    bool isTitle = false;
    Rgb (*bar)(double share) = nullptr;
    std::vector<std::pair<double, QString>> numbers; ///< position below the bar as a fraction of its width, and the text
    std::vector<std::pair<Rgb, QString>> samples;
    bool stays = false; ///< also shown in a narrow view; without it, rows of plain text are left out there
    [[nodiscard]] bool explains() const { return !isTitle && !bar && samples.empty() && !stays; }
};
using LegendBox = std::vector<LegendRow>;

/// Contents of the legend boxes of the enabled overlays.
class Legend {
    Q_DECLARE_TR_FUNCTIONS(trundle::Legend)
public:
    explicit Legend(const ToolView& view) : m_view(view), m_radios(*view.context().radios) {}

    [[nodiscard]] std::vector<LegendBox> labels() const {
        const ViewSettings& settings = m_view.context().settings;
        std::vector<LegendBox> all;
        if (settings.shows(kOverlayLobes)) all.push_back(lobes());
        if (settings.shows(kOverlayLinks)) all.push_back(links());
        if (settings.shows(kOverlayCoverage)) all.push_back(coverage());
        return all;
    }

private:
    [[nodiscard]] LegendBox lobes() const {
        const auto colour = [](double share) { return gainColour(kLobeFloor + share * (kLobeTop - kLobeFloor)); };
        return {{tr("Antenna lobes"), true},
                {{},
                 false,
                 colour,
                 {{0, decibelText(kLobeFloor)},
                  {-kLobeFloor / (kLobeTop - kLobeFloor), decibelText(0)},
                  {1, decibelText(kLobeTop) + tr(" dBi")}}},
                {tr("Radius %1 at 0 dBi, 0 at %2 dBi").arg(metresText(m_radios.lobeUnit()), decibelText(kLobeFloor))}};
    }

    [[nodiscard]] LegendBox links() const {
        LegendBox label{{tr("Radio links"), true}, {}, {tr("over the sensitivity, at full power")}};
        label[1].samples = {{marginColour(0), tr("< %1").arg(kSlimMargin)},
                            {marginColour(kSlimMargin), tr("%1–%2").arg(kSlimMargin).arg(kSafeMargin)},
                            {marginColour(kSafeMargin), tr("> %1 dB").arg(kSafeMargin)}};
        const RadioLinks* links = m_radios.links();
        const std::size_t drawn = links ? links->links.size() : 0;
        QString count = !links                    ? tr("Computing…")
                        : drawn == 0              ? tr("No radio is in range.")
                        : drawn < links->reaching ? tr("The %1 strongest of %2").arg(drawn).arg(links->reaching)
                                                  : tr("Links: %1").arg(drawn);
        if (links && std::ranges::any_of(links->links, &RadioLink::oneWay)) count += tr("; dashed: one way only");
        label.push_back({count});
        if (links && links->nearest > 0) label.push_back({tr("Searched among the %1 nearest of each").arg(links->nearest)});
        return label;
    }

    [[nodiscard]] LegendBox coverage() const {
        const CoverageMap* map = m_radios.coverage();
        if (!map) return {{tr("Radio coverage"), true}, {tr("Computing…")}};
        const Coverage& c = map->coverage;
        const auto& [low, high] = map->scale;
        const MediumSettings& medium = m_view.context().world.objects()->experiment().medium;
        LegendBox label{{tr("Coverage of %1").arg(QString::fromStdString(c.transmitter)), true},
                        {{},
                         false,
                         heatColour,
                         {{0, decibelText(low)}, {0.5, decibelText(0.5 * (low + high))}, {1, decibelText(high) + tr(" dBm")}}},
                        {tr("%1 dBm sent; grey: less than %2 dBm").arg(decibelText(c.sent), decibelText(c.receiver.sensitivity))},
                        {tr("Received with 0 dBi, %1 over z = 0").arg(metresText(c.receiver.height))},
                        {modelText(medium)}};
        if (medium.shadowing > 0)
            label.push_back({tr("Shadowing %1 dB, as one receiver finds it").arg(decibelText(medium.shadowing))});
        label.push_back(
            {medium.wallLoss > 0 ? tr("%1 dB for each wall").arg(decibelText(medium.wallLoss)) : tr("Walls do not attenuate")});
        const auto here = underPointer(c);
        label.push_back({here ? tr("Here: %1 dBm").arg(decibelText(*here)) : tr("Here: –")});
        label.back().stays = true;
        return label;
    }

    static QString modelText(const MediumSettings& medium) {
        if (medium.model == PropagationModel::TwoRay) return tr("Direct ray and the floor's reflection");
        if (medium.model == PropagationModel::LogDistance) return tr("Log-distance, exponent %1").arg(medium.exponent);
        return tr("Free space");
    }

    [[nodiscard]] std::optional<double> underPointer(const Coverage& coverage) const {
        if (!m_view.widget().underMouse()) return std::nullopt;
        const ViewRay ray = m_view.camera().rayAt(m_view.cursorPosition());
        const double way = -ray.origin.z() / ray.direction.z();
        if (!(way > 0 && std::isfinite(way))) return std::nullopt;
        const Vec3 place = ray.origin + way * ray.direction;
        const double power = coverage.at(place.x(), place.y());
        return std::isfinite(power) ? std::optional(power) : std::nullopt;
    }

    const ToolView& m_view;
    const RadioOverlays& m_radios;
};

double labelHeight(const LegendBox& label, double line) {
    double height = 2 * kRim;
    for (const LegendRow& row : label) height += line + (row.bar ? kBar + kUnderBar : 0);
    return height;
}

void paintLegendRow(QPainter& painter, const LegendRow& row, const QRectF& at, double line) {
    painter.setPen(row.isTitle ? kWords : kQuiet);
    if (row.bar) {
        for (int x = 0; x < int(at.width()); ++x)
            painter.fillRect(QRectF(at.left() + x, at.top() + 2, 1, kBar), colourOf(row.bar((x + 0.5) / at.width())));
        for (const auto& [share, number] : row.numbers) {
            const double wide = painter.fontMetrics().horizontalAdvance(number),
                         x = std::clamp(share * at.width() - 0.5 * wide, 0.0, at.width() - wide);
            painter.drawText(QRectF(at.left() + x, at.top() + kBar + kUnderBar, wide + 1, line), Qt::AlignVCenter, number);
        }
        return;
    }
    double x = at.left();
    for (const auto& [colour, words] : row.samples) {
        painter.setPen(QPen(colourOf(colour), 3));
        painter.drawLine(QPointF(x + 1, at.center().y()), QPointF(x + 10, at.center().y()));
        painter.setPen(kQuiet);
        painter.drawText(QRectF(x + 14, at.top(), at.right() - x, line), Qt::AlignVCenter, words);
        x += 14 + painter.fontMetrics().horizontalAdvance(words) + 12;
    }
    painter.drawText(at, Qt::AlignVCenter, painter.fontMetrics().elidedText(row.words, Qt::ElideMiddle, int(at.width())));
}

void paintLegendBox(QPainter& painter, const LegendBox& label, const QRectF& at, double line) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPaper);
    painter.drawRoundedRect(at, 4, 4);
    double y = at.top() + kRim;
    for (const LegendRow& row : label) {
        painter.save();
        QFont font = painter.font();
        font.setWeight(row.isTitle ? QFont::DemiBold : QFont::Normal);
        painter.setFont(font);
        const double high = line + (row.bar ? kBar + kUnderBar : 0);
        paintLegendRow(painter, row, {at.left() + kRim, y, at.width() - 2 * kRim, high}, line);
        painter.restore();
        y += high;
    }
}

} // namespace

void paintRadioLinks(QPainter& painter, const ToolView& view) {
    const RadioOverlays* radios = view.context().radios;
    if (!radios || !radios->links()) return;
    const BodyPoses& poses = view.shownPoses();
    const std::vector<RadioNode>& nodes = radios->nodes();
    const ScenePainter pen(painter, view);
    const auto antenna = [&](std::size_t node) -> std::optional<Vec3> {
        if (node >= nodes.size() || nodes[node].body >= poses.size()) return std::nullopt;
        const auto robot = view.context().world.find(nodes[node].robot);
        if (robot && view.context().world.isHidden(*robot)) return std::nullopt;
        return poses[nodes[node].body] * nodes[node].mounting.position;
    };
    const auto& links = radios->links()->links;
    for (auto link = links.rbegin(); link != links.rend(); ++link) { // the strongest is drawn last
        const auto from = antenna(link->from), to = antenna(link->to);
        if (from && to)
            pen.line(*from, *to, colourOf(marginColour(link->margin)), 1.8, link->oneWay ? Qt::DashLine : Qt::SolidLine);
    }
}

void paintRadioLegend(QPainter& painter, const ToolView& view) {
    const RadioOverlays* radios = view.context().radios;
    if (!radios || radios->nodes().empty() || !view.isCurrent()) return;
    if (view.widget().width() < kLeastWidth || view.widget().height() < kLeastHeight) return;
    const double line = painter.fontMetrics().height() + 1;
    std::vector<LegendBox> labels = Legend(view).labels();
    bool full = view.widget().width() >= kRoomForWords;
    if (!full) {
        // Colours only; the text is added while the pointer is over the legend.
        std::vector<LegendBox> brief = labels;
        double bottom = kEdge;
        for (LegendBox& label : brief) {
            std::erase_if(label, [](const LegendRow& row) { return row.explains(); });
            bottom += labelHeight(label, line) + kGap;
        }
        const QPointF& cursor = view.cursorPosition();
        full = view.widget().underMouse() && cursor.x() > view.widget().width() - kNarrow - kEdge && cursor.y() < bottom;
        if (!full) labels = std::move(brief);
    }
    const double wide = full ? kWide : kNarrow;
    double y = kEdge;
    for (const LegendBox& label : labels) {
        const double high = labelHeight(label, line);
        paintLegendBox(painter, label, {view.widget().width() - wide - kEdge, y, wide, high}, line);
        y += high + kGap;
    }
}

} // namespace trundle
