#include "editor/viewport/pinned_values.h"

#include <algorithm>

#include <QPainter>

#include "editor/running/session.h"
#include "editor/viewport/view.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr double kPinLeft = 8, kPinTop = 44, kPinBottom = 70, kPinRim = 8, kPinGap = 6, kPinNumbers = 3;
constexpr int kPinDigits = 8; // "-123.456"
const QColor kPinPaper(24, 27, 31, 205), kPinWords(245, 246, 248), kPinQuiet(178, 184, 192);

/// One object's values on a plate. Its columns have the widths of what stands in them at most, not of what does now.
class PinnedPlate {
public:
    PinnedPlate(const QPainter& painter, const std::string& path, const std::vector<LiveValue>& values)
        : m_title(path.empty() ? PinnedValues::tr("Run") : QString::fromStdString(path)), m_values(values),
          m_words(painter.font()), m_bold(painter.font()), m_figures(monospaceFont()) {
        m_bold.setWeight(QFont::DemiBold);
        m_figures.setPixelSize(12);
        const QFontMetricsF words(m_words), figures(m_figures);
        m_line = std::max(words.height(), figures.height()) + 1;
        std::size_t numbers = 1;
        for (const LiveValue& value : values) {
            m_nameWidth = std::max(m_nameWidth, words.horizontalAdvance(QString::fromStdString(value.name)));
            numbers = std::max(numbers, value.numbers.size());
        }
        m_nameWidth += 12;
        m_numberWidth = figures.horizontalAdvance(QString(kPinDigits, u'0'));
        m_numbersWidth = double(std::min(double(numbers), kPinNumbers)) * m_numberWidth;
        m_unitWidth = words.horizontalAdvance(QStringLiteral("mN m")) + 8;
        if (values.empty()) m_nameWidth = words.horizontalAdvance(none()), m_numbersWidth = m_unitWidth = 0;
        m_width = std::max(m_nameWidth + m_numbersWidth + m_unitWidth, QFontMetricsF(m_bold).horizontalAdvance(m_title));
    }
    [[nodiscard]] double height() const { return 2 * kPinRim + m_line * double(1 + std::max<std::size_t>(1, m_values.size())); }

    void paint(QPainter& painter, const QPointF& corner) const {
        painter.setPen(Qt::NoPen);
        painter.setBrush(kPinPaper);
        painter.drawRoundedRect(QRectF(corner, QSizeF(m_width + 2 * kPinRim, height())), 4, 4);
        const double left = corner.x() + kPinRim;
        double y = corner.y() + kPinRim;
        const auto write = [&](const QFont& font, const QColor& colour, double x, double width, int align, const QString& text) {
            painter.setFont(font);
            painter.setPen(colour);
            painter.drawText(QRectF(x, y, width, m_line), align | Qt::AlignVCenter | Qt::TextDontClip, text);
        };
        write(m_bold, kPinWords, left, m_width, Qt::AlignLeft, m_title);
        y += m_line;
        if (m_values.empty()) write(m_words, kPinQuiet, left, m_width, Qt::AlignLeft, none());
        for (const LiveValue& value : m_values) {
            write(m_words, kPinQuiet, left, m_nameWidth, Qt::AlignLeft, QString::fromStdString(value.name));
            const double end = left + m_nameWidth + m_numbersWidth;
            const std::size_t count = std::min(value.numbers.size(), std::size_t(kPinNumbers));
            for (std::size_t i = 0; i < count; ++i)
                write(m_figures, kPinWords, end - double(count - i) * m_numberWidth, m_numberWidth, Qt::AlignRight,
                      QString::fromStdString(value.numbers[i]));
            write(m_words, kPinQuiet, end + 6, m_unitWidth, Qt::AlignLeft, QString::fromStdString(value.unit));
            y += m_line;
        }
    }

private:
    static QString none() { return PinnedValues::tr("no values before it runs"); }

    QString m_title;
    const std::vector<LiveValue>& m_values;
    QFont m_words, m_bold, m_figures;
    double m_line = 0, m_nameWidth = 0, m_numberWidth = 0, m_numbersWidth = 0, m_unitWidth = 0, m_width = 0;
};

} // namespace

bool PinnedValues::contains(const std::string& path) const { return std::ranges::find(m_paths, path) != m_paths.end(); }

void PinnedValues::set(const std::vector<std::string>& paths, bool pinned) {
    std::erase_if(m_paths, [&](const std::string& path) { return std::ranges::find(paths, path) != paths.end(); });
    if (pinned) m_paths.insert(m_paths.end(), paths.begin(), paths.end());
    Q_EMIT changed();
}

void paintPinnedValues(QPainter& painter, const View& view) {
    const PinnedValues* pinned = view.parts().pinned;
    if (!pinned || pinned->paths().empty() || !view.isCurrent()) return;
    painter.save();
    double y = kPinTop;
    std::size_t left = pinned->paths().size();
    for (const std::string& path : pinned->paths()) {
        const PinnedPlate plate(painter, path, view.parts().session.liveValues(path));
        if (y > kPinTop && y + plate.height() > view.height() - kPinBottom) break;
        plate.paint(painter, {kPinLeft, y});
        y += plate.height() + kPinGap;
        --left;
    }
    painter.restore();
    if (left == 0) return;
    const QString more = PinnedValues::tr("%1 more have no room here").arg(left);
    const QRectF at(kPinLeft, y, QFontMetricsF(painter.font()).horizontalAdvance(more) + 2 * kPinRim,
                    QFontMetricsF(painter.font()).height() + 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPinPaper);
    painter.drawRoundedRect(at, 4, 4);
    painter.setPen(kPinQuiet);
    painter.drawText(at, Qt::AlignCenter, more);
}

} // namespace trundle
