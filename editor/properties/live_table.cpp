#include "editor/properties/live_table.h"

#include <algorithm>

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QScopedValueRollback>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/properties/section.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

enum LiveColumn { kName, kNow, kUnit, kLiveColumns };
constexpr int kNumberWidth = 8; // "-123.456"; longer numbers are rare
constexpr int kSingleWidth = 14;

/// Pads the numbers of a line so that they stay in the same columns at every tick.
QString inColumns(const LiveValue& value) {
    QString text;
    for (const std::string& number : value.numbers) {
        const QString shown = QString::fromStdString(number);
        text += value.numbers.size() > 1 ? shown.rightJustified(kNumberWidth) : shown;
    }
    return text;
}

QString tipOf(const LiveValue& value) {
    QStringList lines{QString::fromStdString(value.name)};
    if (!value.help.empty()) lines << QString::fromStdString(value.help);
    if (!value.signal.empty()) lines << LiveTable::tr("Signal %1").arg(QString::fromStdString(value.signal));
    if (value.commanded) lines << LiveTable::tr("A command: set, not measured");
    return lines.join(u'\n');
}

} // namespace

/// Asks for the height of its rows but can be shown with one of them, so that it never makes the window grow.
class LiveTable::Table final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;
    [[nodiscard]] QSize sizeHint() const override { return {QTreeWidget::sizeHint().width(), m_wanted}; }
    void setHeights(int least, int wanted) {
        m_wanted = wanted;
        setMinimumHeight(least);
        setMaximumHeight(wanted);
        updateGeometry();
    }

private:
    int m_wanted = 0;
};

LiveTable::LiveTable(QWidget* parent)
    : QWidget(parent), m_section(new Section(tr("Now"), true, this)), m_table(new Table(m_section->rows())),
      m_hint(new QLabel(m_section->rows())) {
    setObjectName(QStringLiteral("liveTable"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_section);
    m_table->setObjectName(QStringLiteral("liveValues"));
    m_table->setAccessibleName(tr("Values now"));
    m_table->setColumnCount(kLiveColumns);
    m_table->setHeaderHidden(true);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setIndentation(0);
    m_table->setTextElideMode(Qt::ElideMiddle);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->header()->setStretchLastSection(false);
    m_table->header()->setMinimumSectionSize(10);
    m_table->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    m_table->viewport()->installEventFilter(this);
    m_hint->setWordWrap(true);
    m_hint->setMargin(6);
    m_hint->setObjectName(QStringLiteral("liveHint"));
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_section->add(m_table);
    m_section->add(m_hint);
    connect(m_section, &Section::folded, this, &LiveTable::fit);
    style();
    hide();
}

std::vector<LiveTable::Line> LiveTable::linesOf(const std::vector<LiveGroup>& groups) {
    std::vector<Line> lines;
    for (const LiveGroup& group : groups) {
        if (!group.object.isEmpty()) lines.push_back({group.object.toStdString(), 0, true});
        for (const LiveValue& value : group.values) lines.push_back({value.name, value.numbers.size(), false});
    }
    return lines;
}

void LiveTable::display(const std::vector<LiveGroup>& groups, const QString& hint) {
    m_hint->setText(hint);
    m_hint->setVisible(!hint.isEmpty());
    m_table->setVisible(!groups.empty());
    setVisible(!groups.empty() || !hint.isEmpty());
    m_groups = groups;
    if (std::vector<Line> lines = linesOf(groups); lines != m_lines) {
        m_lines = std::move(lines);
        rebuild();
    } else {
        fill();
    }
    fit();
}

bool LiveTable::update(const std::vector<LiveGroup>& groups) {
    if (linesOf(groups) != m_lines) return false;
    m_groups = groups;
    fill();
    return true;
}

void LiveTable::rebuild() {
    const QScopedValueRollback<bool> rebuilding(m_rebuilding, true);
    m_rows.clear();
    m_table->clear();
    style();
    m_stacked = stacking();
    const auto addRow = [this](const std::string& name) {
        return new QTreeWidgetItem(m_table, QStringList{QString::fromStdString(name)});
    };
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        QTreeWidgetItem* name = addRow(m_lines[i].name);
        name->setFirstColumnSpanned(m_lines[i].heading || m_stacked[i]);
        if (m_lines[i].heading) {
            name->setFont(kName, bold);
            name->setToolTip(kName, QString::fromStdString(m_lines[i].name));
        } else {
            m_rows.push_back({name, m_stacked[i] ? addRow({}) : name});
        }
    }
    style();
    fill();
}

void LiveTable::fill() {
    std::size_t i = 0;
    for (const LiveGroup& group : m_groups) {
        for (const LiveValue& value : group.values) {
            const Row& row = m_rows[i++];
            row.value->setText(kNow, inColumns(value));
            row.value->setText(kUnit, QString::fromStdString(value.unit));
            const QString tip = tipOf(value);
            if (row.name->toolTip(kName) == tip) continue;
            for (QTreeWidgetItem* item : {row.name, row.value})
                for (int column = 0; column < kLiveColumns; ++column) item->setToolTip(column, tip);
        }
    }
}

/// Which names do not fit next to their numbers. Uses the columns set by style().
std::vector<bool> LiveTable::stacking() const {
    const int padding = 2 * (m_table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_table) + 1); // of an item
    const int room = m_table->viewport()->width() - m_table->columnWidth(kNow) - m_table->columnWidth(kUnit) - padding;
    const QFontMetrics metrics(m_table->font());
    std::vector<bool> stacked;
    for (const Line& line : m_lines)
        stacked.push_back(!line.heading && metrics.horizontalAdvance(QString::fromStdString(line.name)) > room);
    return stacked;
}

void LiveTable::style() {
    const QFont figures = figuresFont();
    // Wide enough for all possible values, not only the current ones.
    std::size_t most = 1;
    for (const Line& line : m_lines) most = std::max(most, std::min<std::size_t>(line.numbers, 3));
    const QString widest(most > 1 ? kNumberWidth * int(most) : kSingleWidth, u'0'); // its digits may be fractions of pixels wide
    m_table->header()->resizeSection(kNow, QFontMetrics(figures).horizontalAdvance(widest) + 14);
    m_table->header()->resizeSection(kUnit, fontMetrics().horizontalAdvance(QStringLiteral("mN m")) + 12);
    for (const Row& row : m_rows) {
        row.value->setFont(kNow, figures);
        row.value->setTextAlignment(kNow, Qt::AlignRight | Qt::AlignVCenter);
        row.value->setForeground(kUnit, ink(Ink::Faint));
    }
}

void LiveTable::setMostHeight(int height) {
    if (height == m_mostHeight) return;
    m_mostHeight = height;
    fit();
}

void LiveTable::fit() {
    if (m_table->topLevelItemCount() == 0) return;
    const int line = m_table->sizeHintForRow(0);
    m_table->setHeights(line, std::max(line, std::min(line * m_table->topLevelItemCount() + 2, m_mostHeight)));
}

void LiveTable::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        style();
        fit();
    }
}

bool LiveTable::eventFilter(QObject* watched, QEvent* event) {
    // Emptying and filling the table also resizes it, since its scroll bar disappears and appears.
    if (event->type() == QEvent::Resize && !m_rebuilding && stacking() != m_stacked) {
        rebuild();
        fit();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace trundle
