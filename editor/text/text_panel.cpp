#include "editor/text/text_panel.h"

#include <algorithm>
#include <filesystem>

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/text/code_edit.h"
#include "editor/text/completion_session.h"
#include "editor/text/file_page.h"
#include "editor/text/find_bar.h"
#include "editor/text/find_session.h"
#include "editor/text/results_list.h"
#include "editor/text/text_commands.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

constexpr int kCaretWait = 60; ///< ms that the caret rests before its block is selected

QString nameOf(const std::string& file) { return QString::fromStdString(std::filesystem::path(file).filename().string()); }

} // namespace

TextPanel::TextPanel(Document& document, Selection& selection, Actions& actions, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_actions(actions), m_tabs(new QTabWidget(this)),
      m_nothing(new QLabel(tr("No experiment is open."), this)), m_files(new QToolButton(this)),
      m_commands(new TextCommands(actions, this)), m_uses(new ResultsList(QStringLiteral("uses"), this)),
      m_found(new ResultsList(QStringLiteral("found"), this)), m_completing(new CompletionSession(
                                                                   document, [this] { return m_folders; }, this)) {
    setObjectName(QStringLiteral("textPanel"));
    m_tabs->setObjectName(QStringLiteral("textTabs"));
    m_tabs->setMovable(true);
    m_tabs->setElideMode(Qt::ElideNone); // where there is little room, arrows scroll the tabs
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    m_files->setObjectName(QStringLiteral("textFiles"));
    m_files->setText(tr("Files"));
    m_files->setToolTip(tr("Show another file of this experiment"));
    m_files->setPopupMode(QToolButton::InstantPopup);
    m_files->setAutoRaise(true);
    m_files->setMenu(new QMenu(m_files));
    m_tabs->setCornerWidget(m_files);
    m_bar = new FindBar(this);
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setObjectName(QStringLiteral("textSplit"));
    split->setChildrenCollapsible(false);
    split->addWidget(m_tabs);
    split->addWidget(m_uses);
    split->addWidget(m_found);
    split->setStretchFactor(0, 1); // lists keep their preferred height
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(split, 1);
    layout->addWidget(m_nothing, 1);
    layout->addWidget(m_bar);

    m_caretTimer.setParent(this);
    m_caretTimer.setObjectName(QStringLiteral("caretTimer"));
    m_caretTimer.setSingleShot(true);
    m_caretTimer.setInterval(kCaretWait);
    connect(&m_caretTimer, &QTimer::timeout, this, &TextPanel::selectAtCaret);
    connect(m_files->menu(), &QMenu::aboutToShow, this, &TextPanel::fillFileMenu);
    connect(m_tabs, &QTabWidget::currentChanged, this, [this] {
        markSelected(false);
        showWrap();
    });
    connect(m_uses, &ResultsList::chosen, this, &TextPanel::reveal);
    connect(&m_document, &Document::opened, this, &TextPanel::onOpened);
    connect(&m_document, &Document::changed, this, &TextPanel::onChanged);
    m_finding = new FindSession(m_document, *this, *m_bar, *m_found); // connected after the pages: it marks their new texts
    connect(&m_document, &Document::modifiedChanged, this, &TextPanel::showModified);
    connect(&m_selection, &Selection::changed, this, &TextPanel::onSelectionChanged);
    addCommands();
    onOpened();
}

TextPanel::~TextPanel() {
    if (m_watching) qApp->removeEventFilter(this);
    m_tabs->blockSignals(true);
    for (FilePage* page : pages()) page->abandon();
}

FilePage* TextPanel::page() const { return qobject_cast<FilePage*>(m_tabs->currentWidget()); }

std::vector<FilePage*> TextPanel::pages() const {
    std::vector<FilePage*> pages;
    for (int i = 0; i < m_tabs->count(); ++i)
        if (auto* page = qobject_cast<FilePage*>(m_tabs->widget(i))) pages.push_back(page);
    return pages;
}

FilePage* TextPanel::pageOf(const std::string& file) const {
    for (FilePage* page : pages())
        if (page->file() == file) return page;
    return nullptr;
}

bool TextPanel::hasKeyboard() const { return page() && page()->edit().hasFocus(); }

bool TextPanel::apply(const std::string& id) { return page() && m_commands->apply(id); }

QSize TextPanel::minimumSizeHint() const {
    for (const QWidget* part : m_bar->findChildren<QWidget*>()) part->ensurePolished(); // it changes their size
    return QWidget::minimumSizeHint().expandedTo({m_bar->minimumSizeHint().width(), 0});
}

// --- typed text ---

void TextPanel::flush() {
    for (FilePage* page : pages()) page->flush();
}

/// While typed text is pending, an event filter flushes it before any other user action is handled.
void TextPanel::watchForOthers() {
    if (m_watching) return;
    m_watching = true;
    qApp->installEventFilter(this);
}

bool TextPanel::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::Shortcut:
    case QEvent::Drop:
    case QEvent::Close:
    case QEvent::WindowDeactivate: {
        const auto* widget = qobject_cast<QWidget*>(watched);
        const bool own =
            event->type() == QEvent::KeyPress && widget && page() && (widget == &page()->edit() || page()->isAncestorOf(widget));
        if (m_watching && !own && !watched->inherits("QWidgetWindow")) flush();
        break;
    }
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

// --- the document ---

void TextPanel::onOpened() {
    m_caretTimer.stop();
    for (FilePage* page : pages()) removePage(*page);
    m_opened.clear();
    const bool open = m_document.isOpen();
    m_tabs->parentWidget()->setVisible(open);
    m_uses->hide();
    if (!open) m_finding->close();
    m_nothing->setVisible(!open);
    if (!open) return;
    m_opened = m_document.files().front();
    m_historyAt = m_document.history().position();
    addPage(m_opened);
    m_tabs->setCurrentIndex(0);
    showTitles();
}

void TextPanel::onChanged() {
    if (!m_document.isOpen() || m_opened.empty()) return;
    const std::string opened = m_document.files().front();
    if (opened != m_opened) { // saved under another name
        if (FilePage* page = pageOf(m_opened)) page->setFile(opened);
        m_opened = opened;
    }
    const History& history = m_document.history();
    m_stepping =
        history.position() != m_historyAt && (history.position() < m_historyAt || history.entries().size() == m_historySize);
    m_historyAt = history.position();
    m_historySize = history.entries().size();
    for (FilePage* page : pages()) {
        if (!m_document.text(page->file())) {
            removePage(*page);
            continue;
        }
        page->follow();
        page->showProblems();
    }
    m_stepping = false;
    showTitles();
    markSelected(false);
}

FilePage* TextPanel::addPage(const std::string& file) {
    auto* page = new FilePage(m_document, file, m_tabs);
    page->setObjectName(QStringLiteral("page:") + nameOf(file));
    page->setModelProblems(m_modelProblems);
    connectPage(*page);
    m_tabs->addTab(page, withoutMnemonics(nameOf(file)));
    const auto side = static_cast<QTabBar::ButtonPosition>(
        m_tabs->style()->styleHint(QStyle::SH_TabBar_CloseButtonPosition, nullptr, m_tabs->tabBar()));
    QToolButton* shut = nullptr; // none for the opened file; those of setTabsClosable() are never deleted
    if (file != m_opened) {
        shut = new QToolButton(m_tabs);
        shut->setObjectName(QStringLiteral("closeTab"));
        shut->setIcon(themedIcon(QStringLiteral("close")));
        shut->setIconSize({12, 12});
        shut->setToolTip(tr("Close this text; the file stays part of the experiment"));
        shut->setAutoRaise(true);
        shut->setFocusPolicy(Qt::NoFocus);
        shut->setFixedSize(20, 20);
        shut->setStyleSheet(QStringLiteral("QToolButton { border: none; padding: 0; }"));
        connect(shut, &QToolButton::clicked, this, [this, page] { closePage(m_tabs->indexOf(page)); });
    }
    m_tabs->tabBar()->setTabButton(m_tabs->indexOf(page), side, shut);
    showTitles();
    return page;
}

void TextPanel::connectPage(FilePage& page) {
    CodeEdit& edit = page.edit();
    edit.setWrapLines(m_wrap);
    connect(&edit, &CodeEdit::wrapsLinesChanged, this, &TextPanel::showWrap);
    m_commands->watch(edit);
    m_completing->watch(page); // installed last: an open list gets the keys first
    connect(&edit, &CodeEdit::hoverRequested, this,
            [this, &page](std::uint32_t at, const QPoint& pos) { showHover(page, at, pos); });
    connect(&edit, &CodeEdit::linkRequested, this, [this, &page](std::uint32_t at) { showLink(page, at); });
    connect(&edit, &CodeEdit::linkFollowed, this, &TextPanel::goToDefinition);
    connect(&edit, &CodeEdit::menuRequested, this, [this, &page](const QPoint& pos) { showMenu(page, pos); });
    connect(&page, &FilePage::typed, this, &TextPanel::watchForOthers);
    connect(&page, &FilePage::flushed, this, [this] {
        m_caretTimer.stop(); // the caret moved because of typing: select with this update
        selectAtCaret();
        const auto all = pages();
        if (!m_watching || std::any_of(all.begin(), all.end(), [](FilePage* p) { return p->pending(); })) return;
        m_watching = false;
        qApp->removeEventFilter(this);
    });
    connect(&page, &FilePage::textReplaced, this, [this, &edit](std::uint32_t end) {
        if (m_stepping && edit.hasFocus()) edit.select({end, end}); // undo moves the caret to what it changed
    });
    connect(&edit, &CodeEdit::caretMovedByHand, this, [this] { m_caretTimer.start(); });
}

FilePage* TextPanel::openFile(const std::string& file) {
    FilePage* page = pageOf(file);
    if (!page) { // also for a text that is not imported
        if (const Status added = m_document.addText(file); !added) showMessage(QString::fromStdString(added.error().message));
        if (m_document.text(file)) page = addPage(file);
    }
    if (page) m_tabs->setCurrentWidget(page);
    return page;
}

void TextPanel::closePage(int index) {
    auto* page = qobject_cast<FilePage*>(m_tabs->widget(index));
    if (!page || page->file() == m_opened) return;
    page->flush();
    removePage(*page);
}

void TextPanel::removePage(FilePage& page) {
    page.abandon();
    m_tabs->removeTab(m_tabs->indexOf(&page));
    page.deleteLater(); // a signal of the page may have called this
}

/// Opens a tab for every modified file, and closes those of files that no longer exist; one that the user closes stays closed until the next edit.
void TextPanel::showModified() {
    const std::vector<std::string> modified = m_document.modifiedFiles();
    for (const std::string& file : modified)
        if (!m_opened.empty() && !std::ranges::count(m_modified, file) && !pageOf(file)) addPage(file);
    m_modified = modified;
    for (FilePage* page : pages()) // an edit that created a file may be undone; not while its text is being typed
        if (m_document.isRemoved(page->file()) && page->file() != m_opened && !page->edit().hasFocus()) removePage(*page);
    showTitles();
}

void TextPanel::showTitles() {
    for (FilePage* page : pages()) {
        const int tab = m_tabs->indexOf(page);
        const bool modified = m_document.isModified(page->file());
        QString title = page->file() == m_opened ? nameOf(m_document.path()) : nameOf(page->file());
        m_tabs->setTabText(tab, withoutMnemonics(modified ? title + QLatin1Char('*') : title));
        QString tip = QString::fromStdString(m_document.shown(page->file()));
        if (modified) tip += QLatin1Char('\n') + tr("Unsaved changes");
        m_tabs->setTabToolTip(tab, tip);
    }
}

void TextPanel::fillFileMenu() {
    QMenu* menu = m_files->menu();
    menu->clear();
    for (const std::string& file : m_document.files()) {
        menu->addAction(withoutMnemonics(QString::fromStdString(m_document.shown(file))), this, [this, file] {
            if (FilePage* page = openFile(file)) page->setFocus();
        });
    }
}

// --- the selection ---

void TextPanel::selectAtCaret() {
    FilePage* page = this->page();
    if (!page || !page->edit().hasFocus()) return;
    if (page->pending()) return m_caretTimer.start(); // load first, in a separate event: shorter delays
    const FileId file = page->id();
    if (file == kNoFile) return;
    const std::string path = objectAt(*m_document.loaded(), file, page->edit().caret());
    if (m_selection.paths() == std::vector<std::string>{path}) return;
    // An object selected through an instance has the same block as the object in the config.
    if (blockOf(*m_document.loaded(), m_selection.current()) == blockOf(*m_document.loaded(), path) && !m_selection.empty())
        return;
    const QScopedValueRollback<bool> own(m_selecting, true);
    m_selection.select(path);
    markSelected(false);
}

void TextPanel::onSelectionChanged() {
    if (!m_selecting) markSelected(true);
}

void TextPanel::markSelected(bool scroll) {
    if (!m_document.isOpen()) return;
    const LoadedProject& loaded = *m_document.loaded();
    SourceRange block;
    const std::string path = m_selection.current();
    if (!m_selection.empty() && !path.empty()) {
        block = blockOf(loaded, path);
        const auto place = placeOf(loaded, path);
        const bool hidden = block.known() && block.file < loaded.paths.size() && !pageOf(loaded.paths[block.file]);
        if (hidden && place && place->instance) block = place->instance->range; // its config is in a file that is not shown
    }
    for (FilePage* page : pages()) {
        const bool here = block.known() && page->id() == block.file;
        if (!page->pending()) page->edit().showBlock(here ? block.range : TextRange{});
        if (!here || !scroll) continue;
        m_tabs->setCurrentWidget(page);
        page->edit().scrollTo(block.range);
    }
}

void TextPanel::reveal(const std::string& file, TextRange range, bool focus) {
    flush();
    FilePage* page = openFile(file);
    if (!page) return;
    page->endWord();
    page->select(range);
    if (focus) page->setFocus();
}

void TextPanel::revealBlock(const std::string& file, TextRange block) {
    reveal(file, {block.begin, block.begin}, true);
    if (FilePage* page = pageOf(file)) page->edit().scrollTo(block);
}

void TextPanel::setModelProblems(const std::shared_ptr<const LoadedProject>& texts, const std::vector<Diagnostic>& found) {
    m_modelProblems = std::make_shared<const ModelProblems>(ModelProblems{texts, found});
    for (FilePage* page : pages()) page->setModelProblems(m_modelProblems);
}

void TextPanel::setWrapLines(WrapLines wrap) {
    m_wrap = wrap;
    for (FilePage* page : pages()) page->edit().setWrapLines(wrap);
    showWrap();
}

/// The action's check mark shows the state of the current text; toggling it applies to panes of every width.
void TextPanel::showWrap() { m_actions.at("text.wrap").setChecked(page() && page()->edit().wrapsLines()); }

void TextPanel::revealFile(const SourceRange& place, bool focus) {
    if (!m_document.isOpen() || place.file >= m_document.loaded()->paths.size()) return;
    reveal(m_document.loaded()->paths[place.file], place.range, focus);
}

} // namespace trundle
