#include "editor/properties/live_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/properties/section.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

enum LiveColumn { kName, kNow, kUnit, kLiveColumns };
constexpr int kNumberWidth = 8;   // "-123.456", and in two neighbours seldom more
constexpr int kSingleWidth = 14;
constexpr int kFigurePixels = 11; // three such numbers leave room for a name

/// Numbers of one line end in the same columns from tick to tick.
QString inColumns(const LiveValue& value) {
    QString text;
    for (const std::string& number : value.numbers) {
        const QString shown = QString::fromStdString(number);
        text += value.numbers.size() > 1 ? shown.rightJustified(kNumberWidth) : shown;
    }
    return text;
}

QString tipOf(const LiveValue& value) {
    QStringList lines;
    if (!value.help.empty()) lines << QString::fromStdString(value.help);
    if (!value.signal.empty()) lines << LiveTable::tr("Signal %1").arg(QString::fromStdString(value.signal));
    if (value.commanded) lines << LiveTable::tr("A command: set, not measured");
    return lines.join(u'\n');
}

} // namespace

LiveTable::LiveTable(QWidget* parent)
    : QWidget(parent), m_section(new Section(tr("Now"), true, this)), m_table(new QTreeWidget(m_section->rows())),
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
    m_table->setTextElideMode(Qt::ElideRight);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->header()->setStretchLastSection(false);
    m_table->header()->setMinimumSectionSize(10);
    m_table->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
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

void LiveTable::display(const std::vector<LiveValue>& values, const QString& object, const QString& hint) {
    std::vector<std::string> names;
    m_counts.clear();
    for (const LiveValue& value : values) {
        names.push_back(value.name);
        m_counts.push_back(value.numbers.size());
    }
    m_section->setTitle(object.isEmpty() ? tr("Now") : tr("Now: %1").arg(object));
    m_hint->setText(hint);
    m_hint->setVisible(values.empty());
    m_table->setVisible(!values.empty());
    setVisible(!values.empty() || !hint.isEmpty());
    if (names != m_names) {
        m_names = std::move(names);
        m_table->clear();
        for (const LiveValue& value : values) {
            auto* row = new QTreeWidgetItem(m_table, {QString::fromStdString(value.name)});
            row->setTextAlignment(kNow, Qt::AlignRight | Qt::AlignVCenter);
        }
        style();
    }
    for (int i = 0; i < m_table->topLevelItemCount(); ++i)
        for (int column = 0; column < kLiveColumns; ++column)
            m_table->topLevelItem(i)->setToolTip(column, tipOf(values[std::size_t(i)]));
    update(values);
    fit();
}

void LiveTable::update(const std::vector<LiveValue>& values) {
    for (int i = 0; i < m_table->topLevelItemCount() && std::size_t(i) < values.size(); ++i) {
        QTreeWidgetItem* row = m_table->topLevelItem(i);
        row->setText(kNow, inColumns(values[std::size_t(i)]));
        row->setText(kUnit, QString::fromStdString(values[std::size_t(i)].unit));
    }
}

/// Of its numbers: wide enough for what may come, not for what is there.
int LiveTable::nowWidth(int digit) const {
    std::size_t most = 1;
    for (const std::size_t count : m_counts) most = std::max(most, std::min<std::size_t>(count, 3));
    return digit * (most > 1 ? kNumberWidth * int(most) : kSingleWidth) + 14;
}

void LiveTable::style() {
    QFont figures = monospaceFont();
    figures.setPixelSize(kFigurePixels);
    const int digit = QFontMetrics(figures).horizontalAdvance(u'0');
    m_table->header()->resizeSection(kNow, nowWidth(digit));
    m_table->header()->resizeSection(kUnit, fontMetrics().horizontalAdvance(QStringLiteral("mN m")) + 12);
    for (int i = 0; i < m_table->topLevelItemCount(); ++i) {
        m_table->topLevelItem(i)->setFont(kNow, figures);
        m_table->topLevelItem(i)->setForeground(kUnit, ink(Ink::Faint));
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
    m_table->setFixedHeight(std::max(line, std::min(line * m_table->topLevelItemCount() + 2, m_mostHeight)));
}

void LiveTable::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        style();
        fit();
    }
}

} // namespace trundle
