#include "editor/running/panels/console_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include "editor/running/panels/console_model.h"
#include "editor/running/session.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

QToolButton* tool(const char* name, const char* icon, const QString& tip, QWidget* parent) {
    auto* made = new QToolButton(parent);
    made->setObjectName(QLatin1String(name));
    made->setIcon(themedIcon(QLatin1String(icon)));
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setAutoRaise(true);
    return made;
}

} // namespace

ConsolePanel::ConsolePanel(RunSession& session, QWidget* parent) : QWidget(parent), m_model(new ConsoleModel(this)) {
    setObjectName(QStringLiteral("ConsolePanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    makeView();
    column->addWidget(makeTools());
    column->addWidget(m_view);
    connect(&session.messages(), &RunMessages::consoleLines, m_model, &ConsoleModel::append);
    connect(m_model, &ConsoleModel::robotsChanged, this, &ConsolePanel::showRobots);
    showRobots();
    showCounts();
}

QWidget* ConsolePanel::makeTools() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(6, 4, 6, 4);
    row->setSpacing(4);
    m_robot = new QComboBox(bar);
    m_robot->setObjectName(QStringLiteral("consoleRobot"));
    m_robot->setToolTip(tr("Whose lines are shown"));
    m_robot->setAccessibleName(tr("Robot"));
    m_robot->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_robot->setMinimumContentsLength(14);
    m_robot->setMaxVisibleItems(24);
    m_search = new QLineEdit(bar);
    m_search->setObjectName(QStringLiteral("consoleSearch"));
    m_search->setPlaceholderText(tr("Show lines with…"));
    m_search->setAccessibleName(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_counts = new QLabel(bar);
    m_counts->setObjectName(QStringLiteral("consoleCounts"));
    m_counts->setForegroundRole(QPalette::PlaceholderText);
    QToolButton* copy = tool("consoleCopy", "copy", tr("Copy the selected lines, or all that are shown"), bar);
    QToolButton* clear = tool("consoleClear", "delete", tr("Clear the console"), bar);
    row->addWidget(m_robot);
    row->addWidget(m_search, 1);
    row->addWidget(m_counts);
    row->addWidget(copy);
    row->addWidget(clear);
    connect(m_robot, &QComboBox::currentIndexChanged, this, &ConsolePanel::applyFilter);
    connect(m_search, &QLineEdit::textChanged, this, &ConsolePanel::applyFilter);
    connect(copy, &QToolButton::clicked, this, &ConsolePanel::copySelected);
    connect(clear, &QToolButton::clicked, this, &ConsolePanel::clear);
    return bar;
}

void ConsolePanel::makeView() {
    m_view = makeLineTable("consoleLines", m_model, LineFont::Monospace, this);
    m_view->setColumnWidth(ConsoleModel::Time, 86);
    m_view->setColumnWidth(ConsoleModel::Who, 150);
    m_view->installEventFilter(this);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        QMenu menu(this);
        menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy"), this, &ConsolePanel::copySelected);
        menu.addAction(tr("Select All"), m_view, &QTableView::selectAll);
        menu.addSeparator();
        menu.addAction(themedIcon(QStringLiteral("delete")), tr("Clear"), this, &ConsolePanel::clear);
        menu.exec(m_view->viewport()->mapToGlobal(at));
    });

    // If the end is visible it stays visible, also when the panel's height changes.
    QScrollBar* const bar = m_view->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) { m_follows = value >= bar->maximum(); });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar] {
        if (m_follows) bar->setValue(bar->maximum());
    });
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &ConsolePanel::follow);
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, [this, bar](const QModelIndex&, int first, int last) {
        if (!m_follows) bar->setValue(bar->value() - (last - first + 1)); // the visible lines stay in place
    });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_follows = true;
        follow();
    });
}

void ConsolePanel::follow() {
    if (m_follows) m_view->scrollToBottom();
    showCounts();
}

void ConsolePanel::showRobots() {
    const QString chosen = m_robot->currentData().toString();
    const QSignalBlocker quiet(m_robot);
    m_robot->clear();
    m_robot->addItem(tr("All robots"), QString());
    m_robot->addItem(tr("Run messages"), ConsoleModel::kRunItself);
    QStringList robots = m_model->robots();
    if (!chosen.isEmpty() && chosen != ConsoleModel::kRunItself && !robots.contains(chosen)) robots.append(chosen);
    for (const QString& robot : robots) m_robot->addItem(robot, robot);
    m_robot->setCurrentIndex(std::max(0, m_robot->findData(chosen)));
}

void ConsolePanel::applyFilter() { m_model->setFilter(m_robot->currentData().toString(), m_search->text()); }

void ConsolePanel::showCounts() {
    const auto all = static_cast<int>(m_model->lineCount()), shown = m_model->rowCount();
    m_counts->setText(shown == all ? (all == 1 ? tr("1 line") : tr("%L1 lines").arg(all))
                                   : tr("%L1 of %L2 lines").arg(shown).arg(all));
}

void ConsolePanel::copySelected() {
    QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (rows.isEmpty())
        for (int row = 0; row < m_model->rowCount(); ++row) rows.append(m_model->index(row, 0));
    if (!rows.isEmpty()) QApplication::clipboard()->setText(m_model->copyText(rows));
}

void ConsolePanel::clear() { m_model->clear(); }

/// The window's Copy and Select All apply to objects; with the focus here they apply to lines.
bool ConsolePanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
        auto* key = static_cast<QKeyEvent*>(event);
        const bool copies = key->matches(QKeySequence::Copy), selects = key->matches(QKeySequence::SelectAll);
        if (copies || selects) {
            event->accept();
            if (event->type() == QEvent::ShortcutOverride) return true;
            if (copies) copySelected();
            else m_view->selectAll();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ConsolePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    for (auto [name, icon] : {std::pair("consoleCopy", "copy"), {"consoleClear", "delete"}})
        if (auto* button = findChild<QToolButton*>(QLatin1String(name))) button->setIcon(themedIcon(QLatin1String(icon)));
}

} // namespace trundle
