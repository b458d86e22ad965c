#include "editor/document/history_panel.h"

#include <QEvent>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/widgets/theme.h"

namespace trundle {

static constexpr int kIcon = 16;

HistoryPanel::HistoryPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_list(new QListWidget(this)) {
    setObjectName(u"historyPanel"_qs);
    m_list->setObjectName(u"historyList"_qs);
    m_list->setAccessibleName(tr("History of edits"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_list->setIconSize({kIcon, kIcon}); // the rows keep their height when the first one has a mark
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideRight);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, &HistoryPanel::goTo);
    connect(&m_document.edits(), &DocumentEdits::historyChanged, this, &HistoryPanel::fillRows);
    connect(&m_document.texts(), &DocumentTexts::modifiedChanged, this, &HistoryPanel::fillRows);
    connect(&m_document, &Document::opened, this, [this] {
        m_saved = -1;
        fillRows();
    });
    fillRows();
}

void HistoryPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) fillRows();
}

/// Finds the row of the saved state. There is none if edits since the last save replaced that state.
void HistoryPanel::findSaved() {
    const int now = static_cast<int>(m_document.edits().history().position());
    if (m_document.isOpen() && !m_document.texts().isModified() && !m_document.isNew()) m_saved = now;
    else if (m_saved == now || m_saved > static_cast<int>(m_document.edits().history().entries().size())) m_saved = -1;
}

void HistoryPanel::fillRows() {
    findSaved();
    const QSignalBlocker quiet(m_list);
    QPixmap nothing(kIcon, kIcon);
    nothing.fill(Qt::transparent);
    const auto& entries = m_document.edits().history().entries();
    const int rows = m_document.isOpen() ? static_cast<int>(entries.size()) + 1 : 0;
    const int now = static_cast<int>(m_document.edits().history().position());
    while (m_list->count() > rows) delete m_list->takeItem(m_list->count() - 1);
    for (int row = 0; row < rows; ++row) {
        const QString name = row == 0 ? tr("Opened") : entries[static_cast<std::size_t>(row - 1)].name;
        if (row == m_list->count()) m_list->addItem(name);
        QListWidgetItem& item = *m_list->item(row);
        if (item.text() != name) item.setText(name);
        const QString tip = row == m_saved ? name + QLatin1Char('\n') + tr("Saved: the files contain this state") : name;
        if (item.toolTip() != tip) item.setToolTip(tip);
        item.setIcon(row == m_saved ? themedIcon(QStringLiteral("save")) : QIcon(nothing));
        const QColor ink = palette().color(row > now ? QPalette::Disabled : QPalette::Active, QPalette::Text);
        if (item.foreground().color() != ink || item.foreground().style() == Qt::NoBrush) item.setForeground(ink);
    }
    m_list->setCurrentRow(rows == 0 ? -1 : now);
}

void HistoryPanel::goTo(int row) {
    if (row >= 0) m_document.edits().moveTo(static_cast<std::size_t>(row));
    fillRows(); // restores the selection if the document did not move
}

} // namespace trundle
