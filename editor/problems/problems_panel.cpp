#include "editor/problems/problems_panel.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/problems/model_checker.h"
#include "editor/problems/problem_icons.h"
#include "editor/problems/problems_model.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/middle_elided.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"
#include "project/edits/edit_target.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

QToolButton* makeFilter(QWidget* parent, const char* name, const QIcon& icon, const QString& tip) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setCheckable(true);
    button->setChecked(true);
    button->setIcon(icon);
    showTextBesideIcon(*button, 15);
    button->setToolTip(tip);
    return button;
}

constexpr int kColumnGap = 8;   ///< pixels
constexpr int kLeastPlace = 14; ///< characters of "controller.sim:12:34"; a longer place is elided if the messages need the room

} // namespace

ProblemsPanel::ProblemsPanel(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_model(new ProblemsModel(this)),
      m_checker(new ModelChecker(this)), m_view(new QTreeView(this)), m_none(new QLabel(tr("No problems"), m_view)),
      m_errors(makeFilter(this, "showErrors", severityIcon(Severity::Error), tr("Show errors"))),
      m_warnings(makeFilter(this, "showWarnings", severityIcon(Severity::Warning), tr("Show warnings and hints"))),
      m_fix(new QToolButton(this)), m_order(new QCheckBox(this)), m_words(new QLineEdit(this)) {
    setObjectName(QStringLiteral("problemsPanel"));
    makeBar();
    m_view->setObjectName(QStringLiteral("problems"));
    m_view->setModel(m_model);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(true);
    m_view->setTextElideMode(Qt::ElideRight);
    m_view->setItemDelegateForColumn(ProblemsModel::Place, new MiddleElided(this));
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->header()->setSectionResizeMode(QHeaderView::Interactive);
    m_view->header()->setStretchLastSection(true);
    connect(m_view->header(), &QHeaderView::sectionResized, this, [this](int column) {
        m_ownColumns |= !m_fitting && column != ProblemsModel::Place; // the last column follows the view
    });
    m_view->setAccessibleName(tr("Problems"));
    m_none->setObjectName(QStringLiteral("noProblems"));
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setForegroundRole(QPalette::PlaceholderText);
    m_none->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    connect(m_view, &QTreeView::clicked, this, &ProblemsPanel::activate);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &ProblemsPanel::openMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &ProblemsPanel::showFix);
    connect(m_model, &ProblemsModel::countsChanged, this, &ProblemsPanel::countsChanged);
    connect(&document, &Document::changed, this, &ProblemsPanel::follow);
    connect(&document, &Document::opened, this, &ProblemsPanel::clearRunProblems);
    connect(&document, &Document::opened, this, [this] { setBuildProblems({}, nullptr); });
    connect(m_checker, &ModelChecker::checked, this,
            [this](const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found) {
                m_model->setModelProblems(found, loaded);
                showCounts();
                Q_EMIT modelChecked(loaded, found);
            });
    follow(ChangeSet(nullptr, document.loaded()));
}

void ProblemsPanel::makeBar() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(6, 3, 6, 3);
    bar->setSpacing(4);
    bar->addWidget(m_errors);
    bar->addWidget(m_warnings);
    bar->addWidget(m_words, 1);
    bar->addWidget(m_order);
    bar->addWidget(m_fix);
    layout->addLayout(bar);
    layout->addWidget(m_view, 1);
    m_words->setObjectName(QStringLiteral("problemFilter"));
    m_words->setPlaceholderText(tr("Filter"));
    m_words->setClearButtonEnabled(true);
    m_words->setMaximumWidth(260);
    bar->insertStretch(3, 1);
    m_order->setObjectName(QStringLiteral("problemOrder"));
    m_order->setText(tr("Errors first"));
    m_order->setToolTip(tr("Sorts by severity; else by file and line"));
    m_fix->setObjectName(QStringLiteral("applyFix"));
    m_fix->setText(tr("Fix"));
    m_fix->setIcon(themedIcon(QStringLiteral("fix")));
    showTextBesideIcon(*m_fix);
    connect(m_errors, &QToolButton::toggled, this, &ProblemsPanel::applyFilter);
    connect(m_warnings, &QToolButton::toggled, this, &ProblemsPanel::applyFilter);
    connect(m_words, &QLineEdit::textChanged, this, &ProblemsPanel::applyFilter);
    connect(m_fix, &QToolButton::clicked, this, &ProblemsPanel::fixCurrent);
    connect(m_order, &QCheckBox::toggled, this, [this](bool severity) {
        m_model->setOrder(severity ? ProblemOrder::Severity : ProblemOrder::Place);
        showCounts();
    });
}

int ProblemsPanel::errors() const { return m_model->errors(); }
int ProblemsPanel::warnings() const { return m_model->warnings(); }

void ProblemsPanel::follow(const ChangeSet& changes) {
    if (changes.after() != m_document.loaded()) return; // a later edit was reported first
    const int row =
        m_view->currentIndex().parent().isValid() ? m_view->currentIndex().parent().row() : m_view->currentIndex().row();
    const bool isSame = changes.before() == m_shown && !changes.changesProblems() && !changes.changesObjects();
    m_model->setLoaded(m_document.loaded(), isSame);
    m_shown = m_document.loaded();
    m_checker->request(m_document.loaded(), robotsCheck());
    showCounts();
    if (row >= 0 && !m_view->currentIndex().isValid() && m_model->rowCount() > 0) // select the row that follows the fixed one
        m_view->setCurrentIndex(m_model->index(std::min(row, m_model->rowCount() - 1), 0));
}

void ProblemsPanel::checkRobotsWith(std::string program, double seconds) {
    m_robots.program = std::move(program);
    m_robots.seconds = seconds;
    m_checker->request(m_document.loaded(), robotsCheck());
}

RobotsCheck ProblemsPanel::robotsCheck() const {
    RobotsCheck check = m_robots;
    check.options = m_document.options();
    return check;
}

void ProblemsPanel::applyFilter() {
    m_model->setFilter(m_errors->isChecked(), m_warnings->isChecked(), m_words->text());
    showCounts();
}

void ProblemsPanel::showCounts() {
    m_errors->setText(QString::number(errors()));
    m_warnings->setText(QString::number(warnings()));
    const bool hidden = m_model->rowCount() == 0 && errors() + warnings() > 0;
    m_none->setText(hidden                ? tr("No problems match the filter")
                    : m_document.isOpen() ? tr("No problems")
                                          : tr("Nothing is open"));
    m_none->setVisible(m_model->rowCount() == 0);
    m_view->header()->setVisible(m_model->rowCount() > 0);
    fitColumns();
    showFix();
}

/// The messages get the room that they need; the place gets what is left, within its own width.
void ProblemsPanel::fitColumns() {
    if (m_ownColumns) return;
    const QScopedValueRollback<bool> fitting(m_fitting, true);
    const QFontMetrics metrics = m_view->fontMetrics();
    const auto wanted = [this](int column) {
        const QAbstractItemView& list = *m_view; // public there
        return std::max(list.sizeHintForColumn(column), m_view->header()->sectionSizeHint(column)) + kColumnGap;
    };
    const int code = wanted(ProblemsModel::CodeColumn), room = std::max(m_view->viewport()->width() - code, 0);
    const int least = metrics.averageCharWidth() * kLeastPlace + kColumnGap,
              whole = std::max(least, wanted(ProblemsModel::Place));
    const int message = wanted(ProblemsModel::Message) + m_view->indentation();
    const int place = std::clamp(room - message, least, whole);
    m_view->setColumnWidth(ProblemsModel::CodeColumn, code);
    m_view->setColumnWidth(ProblemsModel::Message, std::max(metrics.averageCharWidth() * kLeastPlace, room - place));
}

void ProblemsPanel::showFix() {
    const Fix* fix = m_model->fixAt(m_view->currentIndex());
    m_fix->setEnabled(fix != nullptr);
    m_fix->setToolTip(fix ? tr("%1  Alt+Enter").arg(QString::fromStdString(fix->title)) : tr("No automatic fix available"));
}

void ProblemsPanel::go(const QModelIndex& index) {
    const SourceRange place = m_model->placeAt(index);
    const std::shared_ptr<const LoadedProject> texts = m_model->textsAt(index);
    if (!texts || !place.known() || place.file >= texts->paths.size() || texts->paths[place.file].empty()) return;
    const std::string file = texts->paths[place.file];
    if (texts == m_document.loaded()) {
        const std::string object = objectAt(*texts, place.file, place.range.begin);
        if (!object.empty()) m_selection.select(object);
    }
    Q_EMIT jumpTo(file, place);
}

void ProblemsPanel::activate(const QModelIndex& index) {
    if (index.parent().isValid() && m_model->fixAt(index)) applyFix(index);
    else go(index);
}

void ProblemsPanel::goTo(int step) {
    const int count = m_model->rowCount();
    if (count == 0) return;
    const QModelIndex at = m_view->currentIndex();
    const int row = at.parent().isValid() ? at.parent().row() : at.row();
    const int next = row < 0 ? (step > 0 ? 0 : count - 1) : (row + step + count) % count;
    m_view->setCurrentIndex(m_model->index(next, 0));
    go(m_view->currentIndex());
}

void ProblemsPanel::fixCurrent() { applyFix(m_view->currentIndex()); }

void ProblemsPanel::applyFix(const QModelIndex& index) {
    const Fix* fix = m_model->fixAt(index);
    if (!fix) return;
    if (fix->edits.empty()) return Q_EMIT trustRequested(m_model->diagnosticAt(index)->range);
    (void)m_document.structure().applyFix(Fix(*fix)); // rebuilds the model; the document reports a failure
}

void ProblemsPanel::openMenu(const QPoint& place) {
    const QModelIndex index = m_view->indexAt(place);
    const Diagnostic* d = m_model->diagnosticAt(index);
    if (!d) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("problemMenu"));
    const QPersistentModelIndex kept(index);
    if (m_model->placeAt(index).known())
        connect(menu->addAction(tr("Go there")), &QAction::triggered, this, [this, kept] { go(kept); });
    if (const Fix* fix = m_model->fixAt(index))
        connect(menu->addAction(tr("Fix: %1").arg(withoutMnemonics(QString::fromStdString(fix->title)))), &QAction::triggered,
                this, [this, kept] { applyFix(kept); });
    const QString line = QStringLiteral("%1 %2 %3")
                             .arg(m_model->index(index.row(), ProblemsModel::Place, index.parent()).data().toString(),
                                  QString::fromStdString(codeName(d->code)), QString::fromStdString(d->message));
    connect(menu->addAction(tr("Copy")), &QAction::triggered, this, [line] { QGuiApplication::clipboard()->setText(line); });
    menu->popup(m_view->viewport()->mapToGlobal(place));
}

void ProblemsPanel::setRunProblems(const std::vector<Diagnostic>& problems, const std::shared_ptr<const LoadedProject>& texts) {
    std::vector<Diagnostic> own = problems;
    m_run = own;
    m_runTexts = texts;
    m_model->setRun(std::move(own), texts);
    showCounts();
}

void ProblemsPanel::setBuildProblems(const std::vector<Diagnostic>& problems, const std::shared_ptr<const LoadedProject>& sources) {
    m_model->setBuild(problems, sources);
    showCounts();
}

void ProblemsPanel::clearRunProblems() {
    if (!m_run.empty()) setRunProblems({}, nullptr);
}

bool ProblemsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view && event->type() == QEvent::Resize) m_none->setGeometry(m_view->rect());
    if (watched == m_view->viewport() && event->type() == QEvent::Resize) fitColumns();
    if (watched == m_view && event->type() == QEvent::FontChange) fitColumns();
    if (watched == m_view && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (enter && key->modifiers() & Qt::AltModifier) return fixCurrent(), true;
        if (enter) {
            activate(m_view->currentIndex());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace trundle
