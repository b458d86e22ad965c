#include "editor/text/text_panel.h"

#include <QLabel>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/code/code_language.h"
#include "editor/text/completion/completion_session.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/pages/text_pages.h"
#include "editor/text/search/find_bar.h"
#include "editor/text/search/find_session.h"
#include "editor/text/search/results_list.h"
#include "editor/text/text_assistance.h"
#include "editor/text/text_commands.h"
#include "editor/widgets/actions.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

constexpr int kCaretWait = 60; ///< ms that the caret rests before its block is selected

} // namespace

TextPanel::TextPanel(Document& document, Selection& selection, Actions& actions, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_actions(actions), m_pages(new TextPages(document, this)),
      m_nothing(new QLabel(tr("No experiment is open."), this)), m_files(new QToolButton(this)),
      m_commands(new TextCommands(actions, this)), m_uses(new ResultsList(QStringLiteral("uses"), this)),
      m_found(new ResultsList(QStringLiteral("found"), this)),
      m_assistance(new TextAssistance(document, *m_pages, *m_uses, *m_commands, actions, this)),
      m_completing(new CompletionSession(
          document, [this] { return m_folders; }, this)),
      m_bar(new FindBar(this)) {
    setObjectName(QStringLiteral("textPanel"));
    makeLayout();
    m_caretTimer.setParent(this);
    m_caretTimer.setObjectName(QStringLiteral("caretTimer"));
    m_caretTimer.setSingleShot(true);
    m_caretTimer.setInterval(kCaretWait);
    connect(&m_caretTimer, &QTimer::timeout, this, &TextPanel::selectAtCaret);
    connect(m_files->menu(), &QMenu::aboutToShow, this, [this] { m_pages->fillFileMenu(*m_files->menu()); });
    connect(m_pages, &QTabWidget::currentChanged, this, [this] {
        markSelected(false);
        showWrap();
    });
    connect(m_pages, &TextPages::pageAdded, this, [this](FilePage* page) { connectPage(*page); });
    connect(m_pages, &TextPages::refused, m_assistance, &TextAssistance::showMessage);
    connect(m_assistance, &TextAssistance::messageRequested, this, &TextPanel::messageRequested);
    connect(m_uses, &ResultsList::chosen, this, &TextPanel::reveal);
    connect(&m_document, &Document::opened, this, &TextPanel::onOpened);
    connect(&m_document, &Document::changed, this, &TextPanel::onChanged);
    m_finding =
        new FindSession(m_document, *m_pages, *m_bar, *m_found, this); // connected after the pages: it marks their new texts
    connect(&m_document.texts(), &DocumentTexts::modifiedChanged, m_pages, &TextPages::showModified);
    connect(&m_selection, &Selection::changed, this, &TextPanel::onSelectionChanged);
    addCommands();
    onOpened();
}

TextPanel::~TextPanel() { m_pages->abandon(); } // closing a window loses its focus, which passes typed text on

void TextPanel::makeLayout() {
    m_nothing->setAlignment(Qt::AlignCenter);
    m_nothing->setForegroundRole(QPalette::PlaceholderText);
    m_files->setObjectName(QStringLiteral("textFiles"));
    m_files->setText(tr("Files"));
    m_files->setToolTip(tr("Show another file of this experiment"));
    m_files->setPopupMode(QToolButton::InstantPopup);
    m_files->setAutoRaise(true);
    m_files->setMenu(new QMenu(m_files));
    m_pages->setCornerWidget(m_files);
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setObjectName(QStringLiteral("textSplit"));
    split->setChildrenCollapsible(false);
    split->addWidget(m_pages);
    split->addWidget(m_uses);
    split->addWidget(m_found);
    split->setStretchFactor(0, 1); // lists keep their preferred height
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(split, 1);
    layout->addWidget(m_nothing, 1);
    layout->addWidget(m_bar);
}

FilePage* TextPanel::page() const { return m_pages->page(); }

std::vector<FilePage*> TextPanel::pages() const { return m_pages->pages(); }

FilePage* TextPanel::pageOf(const std::string& file) const { return m_pages->pageOf(file); }

void TextPanel::flush() { m_pages->flush(); }

FilePage* TextPanel::openFile(const std::string& file) { return m_pages->openFile(file); }

const Kind* TextPanel::kindAtCaret() { return m_assistance->kindAtCaret(); }

QString TextPanel::constructAtCaret() { return m_assistance->constructAtCaret(); }

bool TextPanel::hasKeyboard() const { return page() && page()->edit().hasFocus(); }

bool TextPanel::apply(const std::string& id) { return page() && m_commands->apply(id); }

QSize TextPanel::minimumSizeHint() const {
    for (const QWidget* part : m_bar->findChildren<QWidget*>()) part->ensurePolished(); // it changes their size
    return QWidget::minimumSizeHint().expandedTo({m_bar->minimumSizeHint().width(), 0});
}

// --- the document ---

void TextPanel::onOpened() {
    m_caretTimer.stop();
    m_pages->closeAll();
    const bool open = m_document.isOpen();
    m_pages->parentWidget()->setVisible(open);
    m_uses->hide();
    if (!open) m_finding->close();
    m_nothing->setVisible(!open);
    if (open) m_pages->showOpened();
}

void TextPanel::onChanged() {
    m_pages->follow();
    markSelected(false);
}

void TextPanel::connectPage(FilePage& page) {
    CodeEdit& edit = page.edit();
    edit.wrapping().setMode(m_wrap);
    connect(&edit.wrapping(), &CodeWrapping::changed, this, &TextPanel::showWrap);
    m_commands->watch(edit);
    m_completing->watch(page); // installed last: an open list gets the keys first
    m_assistance->watch(page);
    connect(&page, &FilePage::flushed, this, [this] {
        m_caretTimer.stop(); // the caret moved because of typing: select with this update
        selectAtCaret();
    });
    connect(&edit, &CodeEdit::caretMovedByHand, this, [this] { m_caretTimer.start(); });
}

void TextPanel::setModelProblems(const std::shared_ptr<const LoadedProject>& texts, const std::vector<Diagnostic>& found) {
    m_pages->setModelProblems(std::make_shared<const ModelProblems>(ModelProblems{texts, found}));
}

void TextPanel::setBuildProblems(const std::vector<Diagnostic>& found, const std::shared_ptr<const LoadedProject>& sources) {
    m_pages->setBuildProblems(found, sources);
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
        if (!page->pending()) page->edit().marks().showBlock(here ? block.range : TextRange{});
        if (!here || !scroll) continue;
        m_pages->setCurrentWidget(page);
        page->edit().geometry().scrollTo(block.range);
    }
}

void TextPanel::reveal(const std::string& file, TextRange range, bool focus) { m_pages->reveal(file, range, focus); }

void TextPanel::revealBlock(const std::string& file, TextRange block) {
    reveal(file, {block.begin, block.begin}, true);
    if (FilePage* page = pageOf(file)) page->edit().geometry().scrollTo(block);
}

// --- commands ---

void TextPanel::setWrapLines(WrapLines wrap) {
    m_wrap = wrap;
    for (FilePage* page : pages()) page->edit().wrapping().setMode(wrap);
    showWrap();
}

/// The action's check mark shows the state of the current text; toggling it applies to panes of every width.
void TextPanel::showWrap() { m_actions.at("text.wrap").setChecked(page() && page()->edit().wrapping().wraps()); }

void TextPanel::addCommands() {
    const auto withEdit = [this](auto run) {
        return [this, run] {
            if (FilePage* page = this->page()) run(page->edit());
        };
    };
    m_commands->inText("edit.undo", [this] {
        flush();
        m_document.edits().undo();
    });
    m_commands->inText("edit.redo", [this] {
        flush();
        m_document.edits().redo();
    });
    m_commands->inText("edit.cut", withEdit([](CodeEdit& edit) { edit.cut(); }));
    m_commands->inText("edit.copy", withEdit([](CodeEdit& edit) { edit.copy(); }));
    m_commands->inText("edit.paste", withEdit([](CodeEdit& edit) { edit.paste(); }));
    m_commands->inText("edit.delete", withEdit([](CodeEdit& edit) { edit.removeForward(); }));
    m_commands->inText("edit.selectAll", withEdit([](CodeEdit& edit) { edit.selectAll(); }));
    m_commands->inText("edit.rename", withEdit([this](CodeEdit& edit) { m_assistance->renameAt(edit.caret()); }));
    m_commands->inText("edit.find", [this] { m_finding->open(false); });
    m_commands->own("edit.findInFiles", [this] { m_finding->openInFiles(); });
    m_commands->own("edit.replace", [this] { m_finding->open(true); });
    m_commands->own("text.complete", [this] {
        if (FilePage* page = this->page()) m_completing->ask(*page);
    });
    m_commands->own("text.fix", [this] { m_assistance->showFixes(); });
    m_commands->own("text.definition", [this] {
        if (FilePage* page = this->page()) m_assistance->goToDefinition(page->edit().caret());
    });
    m_commands->own("text.uses", [this] {
        if (FilePage* page = this->page()) m_assistance->showUses(page->edit().caret());
    });
    m_commands->own("text.format", [this] { m_assistance->formatText(); });
    addLineCommands();
    connect(&m_actions.at("text.wrap"), &QAction::triggered, this, [this](bool wraps) {
        Preferences preferences = loadPreferences();
        preferences.wrapLines = wraps ? WrapLines::Always : WrapLines::Never;
        savePreferences(preferences);
        setWrapLines(preferences.wrapLines);
    });
}

void TextPanel::addLineCommands() {
    const auto changeLines = [this](auto command) {
        return [this, command] {
            if (FilePage* page = this->page()) page->edit().changeLines(command);
        };
    };
    const auto fold = [this](bool folded) {
        return [this, folded] {
            if (FilePage* page = this->page()) page->edit().styling().foldEverything(folded);
        };
    };
    m_commands->inText("edit.duplicate", changeLines([this](auto text, auto anchor, auto caret) {
                           return duplicateLines(text, anchor, caret, page()->edit().lineEnd());
                       }));
    m_commands->own("text.comment", changeLines([this](auto text, auto anchor, auto caret) {
                        return toggleComment(text, anchor, caret, lineComment(page()->edit().styling().language()));
                    }));
    m_commands->own("text.lineUp",
                    changeLines([](auto text, auto anchor, auto caret) { return moveLines(text, anchor, caret, -1); }));
    m_commands->own("text.lineDown",
                    changeLines([](auto text, auto anchor, auto caret) { return moveLines(text, anchor, caret, +1); }));
    m_commands->own("text.fold", fold(true));
    m_commands->own("text.unfold", fold(false));
}

} // namespace trundle
