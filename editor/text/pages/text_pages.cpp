#include "editor/text/pages/text_pages.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include <QApplication>
#include <QDir>
#include <QMenu>
#include <QStyle>
#include <QTabBar>
#include <QToolButton>

#include "app/module_build.h"
#include "editor/document/document.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"
#include "project/loading/import_path.h"

namespace trundle {
namespace {

/// A Python module's own file; of a C++ module what is in the folder of its CMakeLists.txt.
std::set<std::string> sourcesOfModules(const LoadedProject& loaded) {
    std::set<std::string> found;
    for (const ModuleSpec& module : loaded.experiment->modules) {
        if (!pathBelow(module.library, std::array{loaded.projectFolder})) continue;
        if (module.library.ends_with(".py")) found.insert(module.library);
        else
            for (const std::string& source : sourcesOfModule(module.library, loaded.projectFolder)) found.insert(source);
    }
    return found;
}

QString nameOf(const std::string& file) { return QString::fromStdString(std::filesystem::path(file).filename().string()); }

} // namespace

TextPages::TextPages(Document& document, QWidget* parent) : QTabWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("textTabs"));
    setMovable(true);
    setElideMode(Qt::ElideNone); // where there is little room, arrows scroll the tabs
}

TextPages::~TextPages() { abandon(); }

void TextPages::abandon() {
    if (std::exchange(m_watching, false)) qApp->removeEventFilter(this);
    blockSignals(true);
    for (FilePage* page : pages()) page->abandon();
}

FilePage* TextPages::page() const { return qobject_cast<FilePage*>(currentWidget()); }

std::vector<FilePage*> TextPages::pages() const {
    std::vector<FilePage*> pages;
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<FilePage*>(widget(i))) pages.push_back(page);
    return pages;
}

FilePage* TextPages::pageOf(const std::string& file) const {
    for (FilePage* page : pages())
        if (page->file() == file) return page;
    return nullptr;
}

// --- typed text ---

void TextPages::flush() {
    for (FilePage* page : pages()) page->flush();
}

/// While typed text is pending, an event filter flushes it before any other user action is handled.
void TextPages::watchForOthers() {
    if (m_watching) return;
    m_watching = true;
    qApp->installEventFilter(this);
}

bool TextPages::eventFilter(QObject* watched, QEvent* event) {
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
    return QTabWidget::eventFilter(watched, event);
}

// --- the document ---

void TextPages::closeAll() {
    for (FilePage* page : pages()) removePage(*page);
    m_opened.clear();
}

void TextPages::showOpened() {
    m_opened = m_document.texts().files().front();
    m_historyAt = m_document.edits().history().position();
    addPage(m_opened);
    setCurrentIndex(0);
    showTitles();
}

void TextPages::follow() {
    if (!m_document.isOpen() || m_opened.empty()) return;
    const std::string opened = m_document.texts().files().front();
    if (opened != m_opened) { // saved under another name
        if (FilePage* page = pageOf(m_opened)) page->setFile(opened);
        m_opened = opened;
    }
    const History& history = m_document.edits().history();
    m_stepping =
        history.position() != m_historyAt && (history.position() < m_historyAt || history.entries().size() == m_historySize);
    const std::size_t before = std::exchange(m_historyAt, history.position());
    m_historySize = history.entries().size();
    for (FilePage* page : pages()) {
        if (!m_document.texts().text(page->file())) {
            removePage(*page);
            continue;
        }
        page->follow();
        page->showProblems();
    }
    if (m_stepping) showStep(history, before);
    m_stepping = false;
    showTitles();
}

/// Undo and redo from a text show what they have changed, also if that is in another text.
void TextPages::showStep(const History& history, std::size_t before) {
    if (!page() || !page()->edit().hasFocus()) return;
    const std::size_t now = history.position();
    const auto isHere = [this](const History::Step& step) { return step.splices.contains(page()->file()); };
    const auto steps = history.entries().begin();
    if (std::any_of(steps + std::ptrdiff_t(std::min(before, now)), steps + std::ptrdiff_t(std::max(before, now)), isHere)) return;
    const auto& splices = history.entries()[now < before ? now : now - 1].splices;
    if (splices.empty()) return;
    const auto& [file, splice] = *splices.begin();
    if (!m_document.texts().text(file) || m_document.texts().isRemoved(file)) return;
    const auto end = static_cast<std::uint32_t>(splice.at + (now < before ? splice.removed : splice.inserted).size());
    reveal(file, {end, end}, true);
}

FilePage* TextPages::addPage(const std::string& file) {
    auto* page = new FilePage(m_document, file, this);
    page->setObjectName(QStringLiteral("page:") + nameOf(file));
    page->setModelProblems(m_modelProblems);
    showBuild(*page);
    connectPage(*page);
    Q_EMIT pageAdded(page);
    addTab(page, withoutMnemonics(nameOf(file)));
    const auto side =
        static_cast<QTabBar::ButtonPosition>(style()->styleHint(QStyle::SH_TabBar_CloseButtonPosition, nullptr, tabBar()));
    QToolButton* shut = nullptr; // none for the opened file; those of setTabsClosable() are never deleted
    if (file != m_opened) {
        shut = new QToolButton(this);
        shut->setObjectName(QStringLiteral("closeTab"));
        shut->setIcon(themedIcon(QStringLiteral("close")));
        shut->setIconSize({12, 12});
        shut->setToolTip(tr("Close this text; the file stays part of the experiment"));
        shut->setAutoRaise(true);
        shut->setFocusPolicy(Qt::NoFocus);
        shut->setFixedSize(20, 20);
        shut->setStyleSheet(QStringLiteral("QToolButton { border: none; padding: 0; }"));
        connect(shut, &QToolButton::clicked, this, [this, page] { closePage(indexOf(page)); });
    }
    tabBar()->setTabButton(indexOf(page), side, shut);
    showTitles();
    return page;
}

void TextPages::connectPage(FilePage& page) {
    connect(&page, &FilePage::typed, this, &TextPages::watchForOthers);
    connect(&page, &FilePage::flushed, this, [this] {
        const auto all = pages();
        if (!m_watching || std::any_of(all.begin(), all.end(), [](FilePage* p) { return p->pending(); })) return;
        m_watching = false;
        qApp->removeEventFilter(this);
    });
    connect(&page, &FilePage::textReplaced, this, [this, &edit = page.edit()](std::uint32_t end) {
        if (m_stepping && edit.hasFocus()) edit.select({end, end}); // undo moves the caret to what it changed
    });
}

FilePage* TextPages::openFile(const std::string& file) {
    FilePage* page = pageOf(file);
    if (!page) { // also for a text that is not imported
        if (const Status added = m_document.edits().addText(file); !added)
            Q_EMIT refused(QString::fromStdString(added.error().message));
        if (m_document.texts().text(file)) page = addPage(file);
    }
    if (page) setCurrentWidget(page);
    return page;
}

void TextPages::closePage(int index) {
    auto* page = qobject_cast<FilePage*>(widget(index));
    if (!page || page->file() == m_opened) return;
    page->flush();
    removePage(*page);
}

void TextPages::removePage(FilePage& page) {
    page.abandon();
    removeTab(indexOf(&page));
    page.deleteLater(); // a signal of the page may have called this
}

/// Opens a tab for every modified file, and closes those of files that no longer exist; one that the user closes stays closed until the next edit.
void TextPages::showModified() {
    const std::vector<std::string> modified = m_document.texts().modifiedFiles();
    for (const std::string& file : modified)
        if (!m_opened.empty() && !std::ranges::count(m_modified, file) && !pageOf(file)) addPage(file);
    m_modified = modified;
    for (FilePage* page : pages()) // an edit that created a file may be undone; not while its text is being typed
        if (m_document.texts().isRemoved(page->file()) && page->file() != m_opened && !page->edit().hasFocus()) removePage(*page);
    showTitles();
}

void TextPages::showTitles() {
    for (FilePage* page : pages()) {
        const int tab = indexOf(page);
        const bool modified = m_document.texts().isModified(page->file());
        QString title = page->file() == m_opened ? nameOf(m_document.path()) : nameOf(page->file());
        setTabText(tab, withoutMnemonics(modified ? title + QLatin1Char('*') : title));
        QString tip = QString::fromStdString(m_document.texts().shown(page->file()));
        if (modified) tip += QLatin1Char('\n') + tr("Unsaved changes");
        setTabToolTip(tab, tip);
    }
}

/// The texts of the experiment, and below them the sources of the modules of its project.
void TextPages::fillFileMenu(QMenu& menu) {
    menu.clear();
    const std::vector<std::string> files = m_document.texts().files();
    const auto add = [&](const std::string& file) {
        menu.addAction(withoutMnemonics(QString::fromStdString(m_document.texts().shown(file))), this, [this, file] {
            if (FilePage* page = openFile(file)) page->setFocus();
        });
    };
    std::ranges::for_each(files, add);
    if (!m_document.isOpen()) return;
    std::set<std::string> sources = sourcesOfModules(*m_document.loaded());
    for (const std::string& file : files) sources.erase(file);
    if (!sources.empty()) menu.addSeparator();
    std::ranges::for_each(sources, add);
}

void TextPages::reveal(const std::string& file, TextRange range, bool focus) {
    flush();
    FilePage* page = openFile(file);
    if (!page) return;
    page->endWord();
    page->select(range);
    if (focus) page->setFocus();
}

void TextPages::reveal(const SourceRange& place, bool focus) {
    if (!m_document.isOpen() || place.file >= m_document.loaded()->paths.size()) return;
    reveal(m_document.loaded()->paths[place.file], place.range, focus);
}

void TextPages::setModelProblems(std::shared_ptr<const ModelProblems> problems) {
    m_modelProblems = std::move(problems);
    for (FilePage* page : pages()) page->setModelProblems(m_modelProblems);
}

void TextPages::setBuildProblems(const std::vector<Diagnostic>& found, const std::shared_ptr<const LoadedProject>& sources) {
    m_build = std::make_shared<const ModelProblems>(ModelProblems{sources, found});
    for (FilePage* page : pages()) showBuild(*page);
}

/// Only if the source has not changed since.
void TextPages::showBuild(FilePage& page) const {
    std::vector<Diagnostic> own;
    if (m_build && m_build->texts)
        for (const Diagnostic& d : m_build->found)
            if (d.range.known() && m_build->texts->paths[d.range.file] == page.file() &&
                m_build->texts->sources[d.range.file].text->bytes() == page.edit().bytes())
                own.push_back(d);
    page.setBuildProblems(std::move(own));
}

} // namespace trundle
