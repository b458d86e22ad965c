#include "editor/shell/commands/command_palette.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

enum : int { kMenu = Qt::UserRole, kKeys, kIndex };

/// Paints the name on the left; menu and shortcut, faint, on the right.
class CommandDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return {100, option.fontMetrics.height() + 12};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const bool selected = option.state & QStyle::State_Selected, enabled = option.state & QStyle::State_Enabled;
        if (selected) painter->fillRect(option.rect, option.palette.highlight());
        const QRect line = option.rect.adjusted(34, 0, -12, 0);
        const auto group = enabled ? QPalette::Active : QPalette::Disabled;
        const QIcon icon = index.data(Qt::DecorationRole).value<QIcon>();
        icon.paint(painter, QRect(option.rect.left() + 10, option.rect.center().y() - 7, 16, 16), Qt::AlignCenter,
                   selected  ? QIcon::Selected
                   : enabled ? QIcon::Normal
                             : QIcon::Disabled);
        painter->setPen(option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text));
        painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, index.data().toString());
        if (!selected) painter->setPen(ink(Ink::Faint));
        const QString keys = index.data(kKeys).toString(), menu = index.data(kMenu).toString();
        painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, keys.isEmpty() ? menu : menu + QStringLiteral("   ") + keys);
    }
};

} // namespace

CommandPalette::CommandPalette(const Actions& actions, std::vector<Command> more, QWidget* parent) : QDialog(parent, Qt::Popup) {
    setObjectName(QStringLiteral("commandPalette"));
    for (const ActionRow& row : actions.table()) {
        QAction& action = actions.at(row.id);
        if (std::string_view(row.id) == "edit.palette") continue;
        QString menu = QLatin1String(row.menu), name = action.text().remove(QLatin1Char('&'));
        menu.remove(QLatin1Char('|')).remove(QLatin1Char('&'));
        if (const qsizetype under = menu.indexOf(QLatin1Char('/')); under > 0) // its name qualifies "Robot…"
            name = menu.mid(under + 1) + QStringLiteral(": ") + name;
        m_commands.push_back({name, menu, &action});
    }
    m_commands.insert(m_commands.end(), more.begin(), more.end());

    m_search->setObjectName(QStringLiteral("paletteSearch"));
    m_search->setPlaceholderText(tr("Type a command"));
    m_search->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("paletteList"));
    m_list->setItemDelegate(new CommandDelegate(m_list));
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_none->setText(tr("No matching command"));
    m_none->setForegroundRole(QPalette::PlaceholderText);
    m_none->setAlignment(Qt::AlignCenter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_search);
    layout->addWidget(m_list);
    // A popup has no frame of its own.
    setStyleSheet(QStringLiteral("#commandPalette { border: 1px solid %1; }").arg(ink(Ink::Faint).name()));
    resizeToFont(*this, {560, 380});
    if (parent) move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 70)));
    connect(m_search, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::trigger);
    fill({});
    m_search->setFocus();
}

int CommandPalette::match(const QString& name, const QString& letters) {
    if (letters.isEmpty()) return 1;
    int score = 1;
    for (const QString& word : letters.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        const qsizetype at = name.indexOf(word, 0, Qt::CaseInsensitive);
        if (at == 0) score += 8;
        else if (at > 0) score += name[at - 1].isLetterOrNumber() ? 2 : 5;
        else return 0;
    }
    return score;
}

int CommandPalette::scoreOf(const Command& command, const QString& letters) {
    // Also matches the menu's name: "For Running" is an entry of View/Layout.
    int score = match(command.name, letters);
    if (score == 0) score = match(command.menu + QLatin1Char(' ') + command.name, letters);
    const QString id = command.action ? command.action->objectName() : QString();
    const bool isHistory = id == QLatin1String("edit.undo") || id == QLatin1String("edit.redo");
    if (score == 0 || !isHistory) return score;
    const QString verb = command.name.section(QLatin1Char(' '), 0, 0), first = letters.section(QLatin1Char(' '), 0, 0);
    return verb.startsWith(first, Qt::CaseInsensitive) ? score : 1;
}

void CommandPalette::fill(const QString& letters) {
    m_list->clear();
    std::vector<std::pair<int, std::size_t>> found;
    for (std::size_t i = 0; i < m_commands.size(); ++i)
        if (const int score = scoreOf(m_commands[i], letters); score > 0) found.emplace_back(-score, i);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [score, i] : found) {
        const Command& command = m_commands[i];
        if (!command.action) continue;
        auto* item = new QListWidgetItem(command.action->icon(), command.name, m_list);
        item->setData(kMenu, command.menu);
        item->setData(kKeys, command.action->shortcut().toString(QKeySequence::NativeText));
        item->setData(kIndex, qulonglong(i));
        item->setToolTip(command.action->statusTip());
        if (!command.action->isEnabled()) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    if (m_list->count()) m_list->setCurrentRow(0);
    m_none->setVisible(m_list->count() == 0);
    m_none->setGeometry(m_list->rect());
}

void CommandPalette::trigger() {
    QListWidgetItem* item = m_list->currentItem();
    if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
    const QPointer<QAction> action = m_commands[item->data(kIndex).toULongLong()].action;
    close();
    if (action) action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        trigger();
        return true;
    }
    if (key != Qt::Key_Down && key != Qt::Key_Up && key != Qt::Key_PageDown && key != Qt::Key_PageUp)
        return QDialog::eventFilter(watched, event);
    const int by = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : key == Qt::Key_PageDown ? 10 : -10;
    m_list->setCurrentRow(std::clamp(m_list->currentRow() + by, 0, std::max(0, m_list->count() - 1)));
    return true;
}

} // namespace trundle
