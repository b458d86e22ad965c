#include "editor/viewport/overlays/pinned_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/widgets/theme.h"
#include "model/dotted_path.h"
#include "project/edits/path_after_edit.h"

namespace trundle {
namespace {

constexpr double kPinEdge = 2, kPinLeft = 8, kPinTop = 44, kPinBottom = 70, kPinRim = 8, kPinGap = 6, kPinCross = 8,
                 kPinNameGap = 12;
constexpr std::size_t kPinNumbers = 3;
constexpr int kPinDigits = 8;                         // "-123.456"
constexpr int kPinMostName = 200, kPinLeastName = 70; // pixels at the default font; longer names are elided in the middle
const QColor kPinPaper(24, 27, 31, 205), kPinWords(245, 246, 248), kPinQuiet(178, 184, 192);

QString noValues() { return PinnedValues::tr("no values before it runs"); }

/// Text of one label. Column widths are those of the longest possible text, so that they do not change with the values. In a narrow
/// view the names are elided, or shown above their numbers; the numbers then share as many lines as they need.
class LabelText {
public:
    LabelText(const QFont& font, const std::string& path, std::vector<LiveValue> values, double room)
        : m_title(path.empty() ? PinnedValues::tr("Run") : QString::fromStdString(path)), m_values(std::move(values)),
          m_words(font), m_bold(font), m_figures(figuresFont(12)) {
        m_bold.setWeight(QFont::DemiBold);
        const QFontMetricsF words(m_words), figures(m_figures), bold(m_bold);
        const double inside = room - 2 * kPinRim;
        m_line = std::max(words.height(), figures.height()) + 1;
        for (const LiveValue& value : m_values) {
            m_nameWidth = std::max(m_nameWidth, words.horizontalAdvance(QString::fromStdString(value.name)));
            m_inLine = std::max(m_inLine, std::min(value.numbers.size(), kPinNumbers));
        }
        m_nameWidth = std::min(m_nameWidth, double(scaledToFont(kPinMostName))) + kPinNameGap;
        m_numberWidth = figures.horizontalAdvance(QString(kPinDigits, u'0'));
        m_unitWidth = words.horizontalAdvance(QStringLiteral("mN m")) + 8;
        const double besideNumbers = inside - double(m_inLine) * m_numberWidth - m_unitWidth;
        m_stacked = besideNumbers < std::min(m_nameWidth, double(scaledToFont(kPinLeastName)));
        m_nameWidth = std::min(m_nameWidth, m_stacked ? inside : besideNumbers);
        if (m_stacked) m_inLine = std::size_t(std::clamp((inside - m_unitWidth) / m_numberWidth, 1.0, double(m_inLine)));
        for (const LiveValue& value : m_values)
            m_names.push_back(words.elidedText(QString::fromStdString(value.name), Qt::ElideMiddle,
                                               m_nameWidth - (m_stacked ? 0 : kPinNameGap)));
        const double numbersWidth = double(m_inLine) * m_numberWidth + m_unitWidth;
        m_width = m_stacked ? std::max(m_nameWidth, numbersWidth) : m_nameWidth + numbersWidth;
        if (m_values.empty()) m_width = std::min(inside, words.horizontalAdvance(noValues()));
        const double cross = kPinCross + kPinRim;
        m_title = bold.elidedText(m_title, Qt::ElideMiddle, std::min(inside - cross, 2.0 * scaledToFont(kPinMostName)));
        m_width = std::min(inside, std::max(m_width, bold.horizontalAdvance(m_title) + cross));
    }
    [[nodiscard]] QSizeF size() const {
        std::size_t lines = m_values.empty() ? 2 : 1;
        for (const LiveValue& value : m_values) lines += linesOf(value);
        return {m_width + 2 * kPinRim, 2 * kPinRim + m_line * double(lines)};
    }

    void paint(QPainter& painter, const PinnedLabel& label) const {
        painter.setPen(Qt::NoPen);
        painter.setBrush(kPinPaper);
        painter.drawRoundedRect(label.rect, 4, 4);
        paintCross(painter, label.close);
        const double left = label.rect.left() + kPinRim;
        double y = label.rect.top() + kPinRim;
        const auto write = [&](const QFont& font, const QColor& colour, double x, double width, int align, const QString& text) {
            painter.setFont(font);
            painter.setPen(colour);
            painter.drawText(QRectF(x, y, width, m_line), align | Qt::AlignVCenter | Qt::TextDontClip, text);
        };
        write(m_bold, kPinWords, left, m_width, Qt::AlignLeft, m_title);
        y += m_line;
        if (m_values.empty())
            write(m_words, kPinQuiet, left, m_width, Qt::AlignLeft,
                  QFontMetricsF(m_words).elidedText(noValues(), Qt::ElideRight, m_width));
        for (std::size_t v = 0; v < m_values.size(); ++v) {
            const LiveValue& value = m_values[v];
            write(m_words, kPinQuiet, left, m_nameWidth, Qt::AlignLeft, m_names[v]);
            if (m_stacked) y += m_line;
            const double end = left + (m_stacked ? m_width - m_unitWidth : m_nameWidth + double(m_inLine) * m_numberWidth);
            write(m_words, kPinQuiet, end + 6, m_unitWidth, Qt::AlignLeft, QString::fromStdString(value.unit));
            const std::size_t count = std::min(value.numbers.size(), kPinNumbers);
            for (std::size_t i = 0; i < count; ++i) {
                if (i > 0 && i % m_inLine == 0) y += m_line;
                const std::size_t inLine = std::min(m_inLine, count - i / m_inLine * m_inLine); // of this line
                write(m_figures, kPinWords, end - double(inLine - i % m_inLine) * m_numberWidth, m_numberWidth, Qt::AlignRight,
                      QString::fromStdString(value.numbers[i]));
            }
            y += m_line;
        }
    }

private:
    [[nodiscard]] std::size_t linesOf(const LiveValue& value) const {
        const std::size_t count = std::max<std::size_t>(1, std::min(value.numbers.size(), kPinNumbers));
        return (m_stacked ? 1 : 0) + (count + m_inLine - 1) / m_inLine;
    }
    static void paintCross(QPainter& painter, const QRectF& at) {
        painter.setPen(QPen(kPinQuiet, 1.4));
        const QRectF cross = at.adjusted(4, 4, -4, -4);
        painter.drawLine(cross.topLeft(), cross.bottomRight());
        painter.drawLine(cross.topRight(), cross.bottomLeft());
    }

    QString m_title;
    std::vector<LiveValue> m_values;
    std::vector<QString> m_names;
    QFont m_words, m_bold, m_figures;
    double m_line = 0, m_nameWidth = 0, m_numberWidth = 0, m_unitWidth = 0, m_width = 0;
    std::size_t m_inLine = 1; // numbers in a line
    bool m_stacked = false;   // names are above their numbers
};

struct LaidLabel {
    PinnedLabel label;
    LabelText text;
};

QRectF within(const QRectF& rect, const QRectF& room) {
    QRectF moved = rect;
    moved.moveLeft(std::max(room.left(), std::min(moved.left(), room.right() - moved.width())));
    moved.moveTop(std::max(room.top(), std::min(moved.top(), room.bottom() - moved.height())));
    return moved;
}

/// The labels that fit into the view; `hidden`: number of labels that do not fit; `y`: lower end of the column.
std::vector<LaidLabel> layOut(const ToolView& view, std::size_t& hidden, double& y) {
    std::vector<LaidLabel> laid;
    hidden = 0;
    y = kPinTop;
    const PinnedValues* pinned = view.context().pinned;
    if (!pinned || !view.isCurrent()) return laid;
    bool full = false;
    for (const Pin& pin : pinned->pins()) {
        const QWidget& widget = view.widget();
        LabelText text(widget.font(), pin.path, view.context().session.values().of(pin.path), widget.width() - 2 * kPinEdge);
        QRectF rect(QPointF(kPinLeft, y), text.size());
        if (pin.position) {
            rect.moveCenter({pin.position->x() * widget.width(), pin.position->y() * widget.height()});
            rect = within(rect, QRectF(widget.rect()).adjusted(kPinEdge, kPinEdge, -kPinEdge, -kPinEdge));
        } else if (full || (y > kPinTop && rect.bottom() > widget.height() - kPinBottom)) {
            full = true;
            ++hidden;
            continue;
        } else {
            y += rect.height() + kPinGap;
            rect.moveLeft(std::clamp(widget.width() - kPinEdge - rect.width(), kPinEdge, kPinLeft));
        }
        const QRectF close(rect.right() - kPinCross - 12, rect.top() + 4, kPinCross + 8, kPinCross + 8);
        laid.push_back({{pin.path, rect, close}, std::move(text)});
    }
    return laid;
}

/// Screen position of an object; for a device, of its robot. nullopt for the run and for objects outside the view.
std::optional<QPointF> spotOf(const ToolView& view, const std::string& path) {
    const ViewportScene& world = view.context().world;
    if (path.empty()) return std::nullopt;
    std::vector<ObjectRef> objects = world.objectsOf(path);
    for (std::string owner = path; objects.empty() && !owner.empty();) objects = world.objectsOf(owner = std::string(withoutLastWord(owner)));
    if (objects.size() != 1 || world.isHidden(objects.front())) return std::nullopt;
    const Bounds bounds = world.objects()->boundsOf(objects.front(), view.shownPoses());
    const Vec3 point = bounds.empty() ? world.objects()->poseOf(objects.front(), view.shownPoses()).position : bounds.centre();
    const auto at = view.shownPixelOf(point);
    return at && QRectF(view.widget().rect()).contains(*at) ? at : std::nullopt;
}

/// Line from the nearest point of the label's edge to the object.
void paintLeader(QPainter& painter, const ToolView& view, const PinnedLabel& label) {
    const auto spot = spotOf(view, label.path);
    if (!spot || label.rect.contains(*spot)) return;
    const QPointF edge(std::clamp(spot->x(), label.rect.left(), label.rect.right()),
                       std::clamp(spot->y(), label.rect.top(), label.rect.bottom()));
    painter.setPen(QPen(kPinPaper, 3.2));
    painter.drawLine(edge, *spot);
    painter.setPen(QPen(kPinWords, 1.2));
    painter.drawLine(edge, *spot);
    painter.setBrush(kPinWords);
    painter.drawEllipse(*spot, 2.5, 2.5);
}

void paintMore(QPainter& painter, std::size_t hidden, double y) {
    const QString more = PinnedValues::tr("%1 more: no room here").arg(hidden);
    const QRectF at(kPinLeft, y, QFontMetricsF(painter.font()).horizontalAdvance(more) + 2 * kPinRim,
                    QFontMetricsF(painter.font()).height() + 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPinPaper);
    painter.drawRoundedRect(at, 4, 4);
    painter.setPen(kPinQuiet);
    painter.drawText(at, Qt::AlignCenter, more);
}

} // namespace

PinnedValues::PinnedValues(Document& document) : m_document(document) {
    // Delayed: another slot of opened() may still save the pins of the previous experiment.
    connect(&document, &Document::opened, this, [this] { m_isOtherProject = true; });
    connect(&document, &Document::changed, this, &PinnedValues::follow);
}

/// Objects may have been renamed or removed.
void PinnedValues::follow(const ChangeSet& changes) {
    if (std::exchange(m_isOtherProject, false)) setPins({}), m_valid = nullptr;
    const auto now = m_document.isOpen() && !m_document.loaded()->diagnostics.hasErrors() ? m_document.loaded() : nullptr;
    if (!now) return; // a block whose text is being typed may be back soon
    const auto before = std::exchange(m_valid, now);
    if (before && before == changes.before() && now == changes.after() && !changes.changesObjects()) return;
    std::vector<Pin> pins;
    for (const Pin& pin : m_pins)
        if (const auto path = pathAfterEdit(before ? *before : *now, *now, pin.path)) pins.push_back({*path, pin.position});
    setPins(std::move(pins));
}

std::vector<std::string> PinnedValues::paths() const {
    std::vector<std::string> paths;
    for (const Pin& pin : m_pins) paths.push_back(pin.path);
    return paths;
}

bool PinnedValues::contains(const std::string& path) const { return std::ranges::find(m_pins, path, &Pin::path) != m_pins.end(); }

void PinnedValues::set(const std::vector<std::string>& paths, bool pinned) {
    if (pinned) {
        for (const std::string& path : paths)
            if (!contains(path)) m_pins.push_back({path, std::nullopt});
    } else {
        std::erase_if(m_pins, [&](const Pin& pin) { return std::ranges::find(paths, pin.path) != paths.end(); });
    }
    Q_EMIT changed();
}

void PinnedValues::setPins(std::vector<Pin> pins) {
    if (pins == m_pins) return;
    m_pins = std::move(pins);
    Q_EMIT changed();
}

void PinnedValues::move(const std::string& path, const std::optional<QPointF>& position) {
    const auto pin = std::ranges::find(m_pins, path, &Pin::path);
    if (pin == m_pins.end() || pin->position == position) return;
    pin->position = position;
    Q_EMIT changed();
}

std::vector<PinnedLabel> pinnedLabels(const ToolView& view) {
    std::size_t hidden = 0;
    double y = 0;
    std::vector<PinnedLabel> labels;
    for (LaidLabel& laid : layOut(view, hidden, y)) labels.push_back(std::move(laid.label));
    return labels;
}

void paintPinnedValues(QPainter& painter, const ToolView& view) {
    std::size_t hidden = 0;
    double y = 0;
    const std::vector<LaidLabel> labels = layOut(view, hidden, y);
    painter.save();
    for (const LaidLabel& laid : labels) paintLeader(painter, view, laid.label);
    for (const LaidLabel& laid : labels) laid.text.paint(painter, laid.label);
    painter.restore();
    if (hidden > 0) paintMore(painter, hidden, y);
}

} // namespace trundle
