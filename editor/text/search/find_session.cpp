#include "editor/text/search/find_session.h"

#include <algorithm>

#include "editor/document/document.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/pages/large_text.h"
#include "editor/text/pages/text_pages.h"
#include "editor/text/search/find_bar.h"
#include "editor/text/search/results_list.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxListed = 1000;

/// The line ending of the first line.
std::string lineEndOf(std::string_view text) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) return "\n";
    return std::string(text.substr(end, text.substr(end, 2) == "\r\n" ? 2 : 1));
}

/// Whether Replace All leaves a file out: a sample that an own project uses cannot be saved.
bool isKept(const Document& document, const std::string& file) {
    const DocumentTexts& texts = document.texts();
    return texts.isSample(file) && !texts.isSample(document.path());
}

} // namespace

FindSession::FindSession(Document& document, TextPages& pages, FindBar& bar, ResultsList& list, QObject* parent)
    : QObject(parent), m_document(document), m_pages(pages), m_bar(bar), m_list(list) {
    connect(&bar, &FindBar::changed, this, &FindSession::findAsTyped);
    connect(&bar, &FindBar::step, this, &FindSession::step);
    connect(&bar, &FindBar::replaceOne, this, &FindSession::replaceOne);
    connect(&bar, &FindBar::replaceAll, this, &FindSession::replaceAll);
    connect(&bar, &FindBar::closed, this, &FindSession::close);
    connect(&bar, &FindBar::listRequested, this, [this] {
        if (m_list.isVisible()) m_list.setFocus();
    });
    connect(&list, &ResultsList::closed, this, &FindSession::close);
    connect(&list, &ResultsList::chosen, this, [this](const std::string& file, TextRange range, bool focus) {
        m_pages.reveal(file, range, focus);
        updateMatches();
    });
    const auto update = [this] {
        if (m_bar.isVisible() && m_document.isOpen()) updateMatches();
    };
    connect(&document, &Document::changed, this, update);
    connect(&pages, &QTabWidget::currentChanged, this, update); // the matches are those of the shown page
}

void FindSession::open(bool replacing) {
    FilePage* page = m_pages.page();
    if (!page) return;
    m_pages.flush();
    const TextRange selected = page->edit().selection();
    const std::string bytes = page->edit().bytes();
    QString words = QString::fromStdString(bytes.substr(std::min<std::size_t>(selected.begin, bytes.size()), selected.size()));
    if (words.contains(QLatin1Char('\n')) || words.contains(QLatin1Char('\r'))) words.clear();
    m_fromFile = page->file();
    m_from = selected.begin;
    m_bar.open(words, replacing);
}

void FindSession::openInFiles() {
    m_bar.setEverywhere(true);
    open(false);
}

void FindSession::close() {
    m_bar.hide();
    m_list.hide();
    m_found.clear();
    for (FilePage* page : m_pages.pages()) page->edit().marks().showMatches({});
    if (FilePage* page = m_pages.page()) page->setFocus();
}

void FindSession::updateMatches() {
    m_found.clear();
    m_others.clear();
    const SearchOptions searchOptions = m_bar.searchOptions();
    const TextSearch search(searchOptions);
    if (!search.valid()) {
        for (FilePage* page : m_pages.pages()) page->edit().marks().showMatches({});
        m_bar.showStatus(search.fault(), true);
        return list();
    }
    FilePage* front = m_pages.page();
    for (const std::string& file : m_document.texts().files()) {
        FilePage* page = m_pages.pageOf(file);
        std::vector<TextRange> marks;
        const auto text = m_document.texts().text(file);
        const bool shown = page ? page->isTextShown() : text && text->size() <= kLargestFullText;
        if (text && shown && (m_bar.everywhere() || page == front)) {
            for (TextMatch& match : search.in(*text)) {
                marks.push_back(match.range);
                m_found.push_back({file, std::move(match)});
            }
        }
        if (page) page->edit().marks().showMatches(marks);
    }
    searchProject(search);
    list();
    count();
}

/// Searches texts of the project's folder that the experiment does not load: their current text if open, else the file.
void FindSession::searchProject(const TextSearch& search) {
    FilePage* front = m_pages.page();
    std::vector<ProjectTexts::Text> texts;
    if (m_bar.everywhere() && !m_document.isNew()) texts = m_project.in(m_document.loaded()->projectFolder);
    else if (front) texts.push_back({front->file(), nullptr});
    const std::vector<std::string> loaded = m_document.texts().files();
    for (ProjectTexts::Text& text : texts) {
        if (std::ranges::find(loaded, text.path) != loaded.end()) continue;
        if (const auto own = m_document.texts().text(text.path)) text.bytes = own;
        if (!text.bytes) continue;
        std::vector<TextRange> marks;
        for (TextMatch& match : search.in(*text.bytes)) {
            marks.push_back(match.range);
            m_found.push_back({text.path, std::move(match)});
        }
        if (!marks.empty()) m_others.emplace(text.path, std::make_shared<const SourceText>(text.path, text.bytes));
        if (FilePage* page = m_pages.pageOf(text.path)) page->edit().marks().showMatches(marks);
    }
}

/// Fills the result list, one row per match, when all files are searched.
void FindSession::list() {
    m_list.setVisible(m_bar.everywhere() && !m_bar.searchOptions().words.isEmpty());
    if (m_list.isHidden() || !m_document.isOpen()) return;
    std::vector<ResultsList::Row> rows;
    const LoadedProject& loaded = *m_document.loaded();
    std::size_t files = 0;
    std::string last;
    for (const FileMatches& found : m_found) {
        files += found.file != last;
        last = found.file;
        const auto path = std::find(loaded.paths.begin(), loaded.paths.end(), found.file);
        const auto other = m_others.find(found.file);
        if (rows.size() == kMaxListed || (path == loaded.paths.end() && other == m_others.end())) continue;
        const SourceText& text = other != m_others.end()
                                     ? *other->second
                                     : loaded.trees[static_cast<std::size_t>(path - loaded.paths.begin())]->source();
        const std::uint32_t line = text.position(found.match.range.begin).line;
        rows.push_back(
            {found.file, m_document.texts().shown(found.file), line, found.match.range, std::string(text.line(line)), false});
    }
    QString title = m_found.empty() ? tr("Nothing found in the project")
                    : files == 1    ? tr("%1 found in one file").arg(m_found.size())
                                    : tr("%1 found in %2 files").arg(m_found.size()).arg(files);
    if (m_found.size() > kMaxListed) title += tr("; the first %1 are listed").arg(kMaxListed);
    if (m_project.left() > 0) title += tr("; %n larger file(s) not searched", nullptr, static_cast<int>(m_project.left()));
    m_list.showRows(title, std::move(rows));
}

std::ptrdiff_t FindSession::here() const {
    FilePage* page = m_pages.page();
    if (!page) return -1;
    const TextRange selected = page->edit().selection();
    const auto at = std::find_if(m_found.begin(), m_found.end(),
                                 [&](const FileMatches& f) { return f.file == page->file() && f.match.range == selected; });
    return at == m_found.end() ? -1 : at - m_found.begin();
}

void FindSession::count() {
    if (m_bar.searchOptions().words.isEmpty()) return m_bar.showStatus({});
    if (m_found.empty()) return m_bar.showStatus(tr("Not found"), true);
    const std::ptrdiff_t at = here();
    const int total = static_cast<int>(m_found.size());
    m_list.setCurrent(static_cast<int>(at));
    m_bar.showStatus(at < 0 ? tr("%n found", nullptr, total) : tr("%1 of %2").arg(at + 1).arg(total));
}

/// Incremental search: selects the first match after the caret position at which the search began.
void FindSession::findAsTyped() {
    m_pages.flush();
    updateMatches();
    FilePage* page = m_pages.page();
    if (!page || m_found.empty()) return;
    if (page->file() != m_fromFile) {
        m_fromFile = page->file();
        m_from = page->edit().selection().begin;
    }
    const auto next = std::find_if(m_found.begin(), m_found.end(),
                                   [&](const FileMatches& f) { return f.file == m_fromFile && f.match.range.begin >= m_from; });
    if (next != m_found.end()) go(*next);
    else if (const auto first =
                 std::find_if(m_found.begin(), m_found.end(), [&](const FileMatches& f) { return f.file == m_fromFile; });
             first != m_found.end())
        go(*first);
}

/// `found` is a copy, since showing another page replaces m_found.
void FindSession::go(FileMatches found) { // NOLINT(performance-unnecessary-value-param)
    m_pages.reveal(found.file, found.match.range);
    if (FilePage* page = m_pages.page(); page && page->file() == found.file) {
        m_fromFile = found.file;
        m_from = found.match.range.begin;
    }
    count();
}

void FindSession::step(int direction) {
    m_pages.flush();
    updateMatches();
    FilePage* page = m_pages.page();
    if (!page || m_found.empty()) return;
    std::ptrdiff_t next = here();
    const auto total = static_cast<std::ptrdiff_t>(m_found.size());
    if (next >= 0) {
        next = (next + direction + total) % total;
    } else { // the selection is not a match: go to the nearest one in this direction
        std::vector<std::string> files = m_document.texts().files();
        for (const FileMatches& f : m_found)
            if (std::find(files.begin(), files.end(), f.file) == files.end()) files.push_back(f.file);
        const auto order = [&](const std::string& file) { return std::find(files.begin(), files.end(), file) - files.begin(); };
        const std::pair caret(order(page->file()), page->edit().selection().begin);
        next = 0;
        while (next < total && std::pair(order(m_found[static_cast<std::size_t>(next)].file),
                                         m_found[static_cast<std::size_t>(next)].match.range.begin) < caret)
            ++next;
        if (direction < 0) --next;
        next = (next + total) % total;
    }
    const FileMatches found = m_found[static_cast<std::size_t>(next)];
    const bool opened = !m_pages.pageOf(found.file);
    go(found);
    if (opened) updateMatches(); // also marks the newly opened tab
}

void FindSession::replaceOne() {
    m_pages.flush();
    updateMatches();
    const std::ptrdiff_t at = here();
    if (at < 0) return step(+1);
    const FileMatches found = m_found[static_cast<std::size_t>(at)];
    FilePage* page = m_pages.page();
    const auto before = m_document.texts().text(found.file);
    if (!before) return;
    const std::string text = TextSearch(m_bar.searchOptions()).replacement(found.match, m_bar.replacement(), lineEndOf(*before));
    std::string after = *before;
    after.replace(found.match.range.begin, found.match.range.size(), text);
    if (!m_document.edits().replaceText(tr("Replace"), found.file, std::move(after))) return;
    const auto end = found.match.range.begin + static_cast<std::uint32_t>(text.size());
    page->edit().select({end, end});
    step(+1);
}

void FindSession::replaceAll() {
    m_pages.flush();
    updateMatches();
    const TextSearch search(m_bar.searchOptions());
    std::map<std::string, std::vector<const FileMatches*>> byFile;
    for (const FileMatches& found : m_found) byFile[found.file].push_back(&found);
    std::size_t kept = 0;
    std::erase_if(byFile, [&](const auto& entry) {
        const bool stays = isKept(m_document, entry.first);
        kept += stays ? entry.second.size() : 0;
        return stays;
    });
    FileTexts texts;
    for (const auto& [file, matches] : byFile) {
        const auto other = m_others.find(file);
        const std::string_view before =
            other != m_others.end() ? other->second->bytes() : std::string_view(*m_document.texts().text(file));
        const std::string lineEnd = lineEndOf(before);
        std::string after;
        std::size_t at = 0;
        for (const FileMatches* found : matches) {
            after += before.substr(at, found->match.range.begin - at);
            after += search.replacement(found->match, m_bar.replacement(), lineEnd);
            at = found->match.range.end;
        }
        after += before.substr(at);
        texts.emplace(file, std::make_shared<const std::string>(std::move(after)));
    }
    const std::size_t total = m_found.size();
    if (total == 0 || (!texts.empty() && !m_document.edits().replaceTexts(tr("Replace All"), texts))) return;
    const QString left = kept > 0 ? tr("; %1 in read-only files that came with Trundle stay").arg(kept) : QString();
    m_bar.showStatus(tr("%n replaced", nullptr, static_cast<int>(total - kept)) + left);
}

} // namespace trundle
