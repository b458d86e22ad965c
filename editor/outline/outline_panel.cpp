#include "editor/outline/outline_panel.h"

#include <algorithm>
#include <unordered_set>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QItemSelection>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/insert_menu.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_view.h"
#include "editor/running/session.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxRevealed = 20; ///< rows made visible for a large selection; the others are only highlighted

QToolButton* button(QWidget* parent, const char* name, const QString& icon, const QString& tip) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(themedIcon(icon));
    button->setIconSize({16, 16});
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    return button;
}

} // namespace

OutlinePanel::OutlinePanel(Document& document, Selection& selection, ObjectMarks& marks, ObjectEdits& edits, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_marks(marks), m_edits(edits),
      m_insert(new InsertMenu(document, selection, edits, this)), m_model(new OutlineModel(edits, marks, this)),
      m_tree(new OutlineView(*m_model, this)) {
    setObjectName(QStringLiteral("outlinePanel"));
    build();
    connectAll();
    showDocument(ChangeSet(nullptr, m_document.loaded()));
}

OutlinePanel::~OutlinePanel() {
    m_selection.disconnect(this);
    delete m_tree; // before its model: an open name editor refers to it
}

void OutlinePanel::build() {
    m_filter = new QLineEdit(this);
    m_filter->setObjectName(QStringLiteral("outlineFilter"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setToolTip(tr("Filters by words of names or kinds; shows rows that match all words, with their parents"));
    m_filter->setClearButtonEnabled(true);
    m_filter->addAction(themedIcon(QStringLiteral("find")), QLineEdit::LeadingPosition);
    m_byOwner = button(this, "outlineByOwner", QStringLiteral("tree-owner"), tr("By owner: robots, scenery, logs, configs"));
    m_byFile = button(this, "outlineByFile", QStringLiteral("kind-file"), tr("By file: each file with its blocks"));
    auto* modes = new QButtonGroup(this);
    for (QToolButton* mode : {m_byOwner, m_byFile}) {
        mode->setCheckable(true);
        modes->addButton(mode);
    }
    m_byOwner->setChecked(true);
    m_add = button(this, "outlineInsert", QStringLiteral("insert"), tr("Insert an object"));
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setMenu(new QMenu(m_add));
    m_insert->attach(*m_add->menu());

    auto* top = new QHBoxLayout;
    top->setContentsMargins(6, 6, 6, 4);
    top->setSpacing(4);
    top->addWidget(m_filter, 1);
    for (QToolButton* tool : {m_byOwner, m_byFile, m_add}) top->addWidget(tool);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addLayout(top);
    all->addWidget(m_tree, 1);
    setTabOrder(m_filter, m_tree);
    m_filter->installEventFilter(this);
}

void OutlinePanel::connectAll() {
    connect(&m_document, &Document::opened, this, [this] {
        const QScopedValueRollback guard(m_showing, true);
        m_tree->forgetFolds();
        m_marks.clear();
        m_filter->clear();
        m_model->follow({});
    });
    connect(&m_document, &Document::changed, this, &OutlinePanel::showDocument);
    connect(&m_document.editedModel(), &EditedModel::changed, this, &OutlinePanel::showModel);
    connect(&m_selection, &Selection::changed, this, &OutlinePanel::showSelection);
    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this, &OutlinePanel::takeSelection);
    connect(m_filter, &QLineEdit::textChanged, this, &OutlinePanel::setFilter);
    connect(m_byFile, &QToolButton::toggled, this, &OutlinePanel::setByFile);
    connect(m_tree, &QTreeView::activated, this, &OutlinePanel::jumpFrom);
    connect(m_tree, &OutlineView::markClicked, this, &OutlinePanel::toggleMark);
    connect(m_tree, &OutlineView::deleteRequested, &m_edits, &ObjectEdits::removeSelected);
    connect(m_tree, &OutlineView::renameRequested, this, &OutlinePanel::renameSelected);
    connect(m_tree, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        QMenu* menu = contextMenu();
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->popup(m_tree->viewport()->mapToGlobal(at));
    });
    connect(m_model, &OutlineModel::renamed, &m_marks, [this](const std::string& from, const std::string& to) {
        if (!from.empty()) m_marks.rename(from, to);
    });
}

void OutlinePanel::showValuesOf(const RunSession& session) {
    m_tree->setMoreTip([&session](const std::string& path) { return session.values().tip(path); });
    connect(&session.values(), &RunValues::changed, m_tree, &OutlineView::renewTip);
    m_model->showEnded(session.robots().ended());
}

void OutlinePanel::showDocument(const ChangeSet& changes) {
    if (changes.after() != m_document.loaded()) return; // a later edit was reported first
    {
        const QScopedValueRollback guard(m_showing, true);
        const bool anew = m_model->rowCount() == 0;
        m_model->follow(changes);
        if (anew) m_tree->unfold();
    }
    showSelection();
    say();
}

void OutlinePanel::say() {
    if (!m_document.isOpen()) m_tree->setEmptyText(tr("Nothing is open"));
    else m_tree->setEmptyText(tr("No object matches “%1”").arg(m_filter->text().trimmed()));
}

void OutlinePanel::showSelection() {
    if (m_showing) return;
    const QScopedValueRollback guard(m_showing, true);
    QItemSelection ranges;
    std::size_t revealed = 0;
    QModelIndex current;
    for (const std::string& path : m_selection.paths()) {
        const QModelIndex index = m_model->indexOf(path);
        if (!index.isValid()) continue;
        if (revealed++ < kMaxRevealed) m_tree->reveal(index);
        current = index;
        const QModelIndex end = index.siblingAtColumn(OutlineModel::ColumnCount - 1);
        if (!ranges.isEmpty() && ranges.last().parent() == index.parent() && ranges.last().bottom() + 1 == index.row())
            ranges.last() = QItemSelectionRange(ranges.last().topLeft(), end);
        else ranges.append(QItemSelectionRange(index, end));
    }
    m_tree->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
    if (!current.isValid()) return;
    m_tree->selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
    m_tree->reveal(current);
}

void OutlinePanel::takeSelection() {
    if (m_showing) return;
    const QScopedValueRollback guard(m_showing, true);
    std::vector<std::string> chosen, paths;
    std::unordered_set<std::string> left;
    for (const QModelIndex& index : m_tree->selectionModel()->selectedRows())
        if (const OutlineRow* row = m_model->rowAt(index); row && row->selectable && left.insert(row->path).second)
            chosen.push_back(row->path);
    const OutlineRow* current = m_model->rowAt(m_tree->currentIndex());
    const bool last = current && current->selectable && left.erase(current->path) > 0;
    for (const auto& from : {m_selection.paths(), chosen}) // in the order of selection
        for (const std::string& path : from)
            if (left.erase(path) > 0) paths.push_back(path);
    if (last) paths.push_back(current->path);
    m_selection.set(std::move(paths));
}

void OutlinePanel::setFilter(const QString& text) {
    {
        const QScopedValueRollback guard(m_showing, true);
        m_model->setFilter(text.trimmed().toStdString());
        m_tree->unfold();
    }
    showSelection();
    say();
}

bool OutlinePanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_filter && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter) return goToFirstMatch(), true;
    }
    return QWidget::eventFilter(watched, event);
}

void OutlinePanel::goToFirstMatch() {
    m_tree->setFocus();
    if (m_filter->text().trimmed().isEmpty()) return;
    for (QModelIndex at = m_model->index(0, 0); at.isValid(); at = m_tree->indexBelow(at))
        if (const OutlineRow* row = m_model->rowAt(at); row && row->selectable && row->matches)
            return m_tree->setCurrentIndex(at);
}

/// The edited model alone, with its parts; or everything again.
void OutlinePanel::showModel() {
    {
        const QScopedValueRollback guard(m_showing, true);
        m_model->setModel(m_document.editedModel().path());
        m_tree->unfold();
        if (m_document.editedModel().isOpen()) m_tree->expand(m_model->index(0, 0));
    }
    for (QWidget* mode : {m_byOwner, m_byFile}) mode->setEnabled(!m_document.editedModel().isOpen());
    showSelection();
    say();
}

void OutlinePanel::setByFile(bool byFile) {
    {
        const QScopedValueRollback guard(m_showing, true);
        m_model->setMode(byFile ? OutlineMode::ByFile : OutlineMode::ByOwner);
        m_tree->unfold();
    }
    showSelection();
}

void OutlinePanel::focusFilter() {
    m_filter->setFocus(Qt::ShortcutFocusReason);
    m_filter->selectAll();
}

void OutlinePanel::renameSelected() {
    const std::string path = m_selection.current();
    if (!m_edits.canRename(path)) return;
    const QModelIndex index = m_model->indexOf(path);
    if (!index.isValid()) return;
    m_tree->setFocus();
    m_tree->reveal(index);
    m_tree->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    m_tree->edit(index);
}

void OutlinePanel::jumpFrom(const QModelIndex& index) {
    const OutlineRow* row = m_model->rowAt(index);
    if (!row || !m_document.isOpen() || row->range.file >= m_document.loaded()->paths.size()) return;
    Q_EMIT jumpTo(m_document.loaded()->paths[row->range.file], row->range.range);
}

void OutlinePanel::toggleMark(const QModelIndex& index) {
    const OutlineRow* row = m_model->rowAt(index);
    if (!row || !row->markable) return;
    const bool on = index.data(OutlineModel::MarkRole).toInt() == OutlineModel::Unmarked;
    std::vector<std::string> paths = markable();
    if (std::find(paths.begin(), paths.end(), row->path) == paths.end()) paths = {row->path};
    if (index.column() == OutlineModel::VisibleColumn) m_marks.setHidden(paths, on);
    else m_marks.setLocked(paths, on);
}

std::vector<std::string> OutlinePanel::markable() const {
    std::vector<std::string> paths;
    for (const std::string& path : m_selection.paths()) {
        const OutlineRow* row = m_model->rowAt(m_model->indexOf(path));
        if (row && row->markable) paths.push_back(row->path);
    }
    return paths;
}

} // namespace trundle
