#include "editor/text/completion/completion_session.h"

#include <algorithm>

#include <QKeyEvent>
#include <QToolTip>

#include "editor/document/document.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/completion/completion_popup.h"
#include "editor/widgets/plain_text.h"
#include "lang/characters.h"

namespace trundle {
namespace {

/// Whether typing this text opens the list: a letter, or a character after which there is often a choice.
bool callsForList(std::string_view inserted) {
    return inserted.size() == 1 && (isIdentStart(inserted[0]) || inserted == "=" || inserted == "." || inserted == "$" ||
                                    inserted == "#" || inserted == "/");
}

/// After a new block is inserted with its name selected: the text from the name to the end of "Config = ", or to its first line.
std::string afterName(const Completion& chosen) {
    if (chosen.select >= chosen.caret) return {};
    const std::string rest = chosen.insert.substr(chosen.caret);
    std::size_t end = rest.find('=');
    for (const char sign : {'\n', '{'})
        if (end == std::string::npos) end = rest.find(sign);
    if (end == std::string::npos) return {};
    for (++end; end < rest.size() && isBlank(rest[end]);) ++end;
    return rest.substr(0, end);
}

} // namespace

CompletionSession::CompletionSession(Document& document, std::function<FileFolders()> folders, QWidget* owner)
    : QObject(owner), m_document(document), m_folders(std::move(folders)), m_popup(new CompletionPopup(owner)) {
    connect(m_popup, &CompletionPopup::clicked, this, &CompletionSession::accept);
    connect(m_popup, &CompletionPopup::left, this, &CompletionSession::close);
    connect(m_popup, &QObject::destroyed, this, [this] { m_popup = nullptr; });
}

CompletionSession::~CompletionSession() {
    if (m_popup) m_popup->disconnect(this);
    delete m_popup; // the popup may have been reparented to the window
}

void CompletionSession::watch(FilePage& page) {
    page.edit().installEventFilter(this);
    connect(&page.edit(), &CodeEdit::edited, this,
            [this, &page](std::size_t, std::string_view, std::string_view inserted) { onEdited(page, inserted); });
    connect(&page.edit(), &CodeEdit::caretMovedByHand, this, [this, &page] {
        m_insertedSuffix.clear();
        narrow(page);
    });
    connect(&page.edit(), &CodeEdit::left, this, &CompletionSession::close);
    connect(&page, &FilePage::textReplaced, this, &CompletionSession::close); // the list is obsolete
    connect(&page, &FilePage::flushed, this, [this, &page] {
        if (std::exchange(m_wanted, false) && page.edit().hasFocus()) list(page, m_asked && isShown(), false);
    });
}

bool CompletionSession::isShown() const { return m_popup && m_popup->isVisible(); }

void CompletionSession::close() {
    m_wanted = m_asked = false;
    if (m_popup) m_popup->hide();
    m_page = nullptr;
}

void CompletionSession::onEdited(FilePage&, std::string_view inserted) {
    if (m_accepting) return;
    QToolTip::hideText(); // "No completions here"
    m_insertedSuffix.clear();
    if (callsForList(inserted)) m_wanted = true;
    else if (!(inserted.size() == 1 && isIdent(inserted[0])) && !(isShown() && inserted.empty())) close();
}

std::string CompletionSession::typed(FilePage& page) const {
    const std::string text = page.edit().bytes();
    const std::uint32_t caret = page.edit().caret();
    if (caret < m_found.word.begin || caret > text.size()) return "\n";
    return text.substr(m_found.word.begin, caret - m_found.word.begin);
}

void CompletionSession::list(FilePage& page, bool asked, bool fresh) {
    if (!page.flush() || page.id() == kNoFile) return;
    m_wanted = false;
    const std::uint32_t caret = page.edit().caret();
    m_found = completionsAt(*m_document.loaded(), page.id(), caret, m_folders());
    if (fresh) m_behind = m_found.word.end > caret ? m_found.word.end - caret : 0;
    else if (!isShown()) m_behind = 0; // when typing opened the list, the text after the caret is kept
    m_page = &page;
    m_asked = asked;
    show(page);
    if (asked && isShown()) QToolTip::hideText();
    if (asked && !isShown())
        showToolTip(page.edit().viewport()->mapToGlobal(page.edit().geometry().placeOf(caret)), tr("No completions here"),
                    &page.edit());
}

/// Filters the found completions by the letters typed so far.
void CompletionSession::narrow(FilePage& page) {
    if (isShown() && m_page == &page) show(page);
}

void CompletionSession::show(FilePage& page) {
    const std::string word = typed(page);
    const bool isWord = std::all_of(word.begin(), word.end(), [](char c) { return isWordChar(c) || c == '$' || c == '#'; });
    m_shown = isWord ? fitting(m_found.items, word) : std::vector<const Completion*>();
    // If the word is complete, or follows a number that may end there, the list would only intercept Enter.
    const bool done = !m_asked && std::any_of(m_shown.begin(), m_shown.end(), [&](const Completion* c) {
        return c->label == word || (word.empty() && c->sort == CompletionSort::Unit);
    });
    if (m_shown.empty() || done) {
        if (m_popup) m_popup->hide();
        return;
    }
    if (m_popup)
        m_popup->showItems(m_shown, page.edit().viewport()->mapToGlobal(page.edit().geometry().placeOf(m_found.word.begin)),
                           page.edit().geometry().lineHeight());
}

void CompletionSession::accept() {
    if (!m_page || !m_popup) return;
    const int at = m_popup->current();
    if (at < 0 || at >= static_cast<int>(m_shown.size())) return close();
    const Completion chosen = *m_shown[static_cast<std::size_t>(at)];
    FilePage& page = *m_page;
    const TextRange word{m_found.word.begin, page.edit().caret() + m_behind};
    close();
    m_accepting = true;
    page.endWord(tr("Complete %1").arg(QString::fromStdString(chosen.label)));
    page.edit().type(word, chosen.insert, word.begin + static_cast<std::uint32_t>(chosen.caret));
    if (chosen.select < chosen.caret)
        page.edit().select(
            {word.begin + static_cast<std::uint32_t>(chosen.select), word.begin + static_cast<std::uint32_t>(chosen.caret)});
    m_accepting = false;
    const std::string_view whole = std::string_view(chosen.insert).substr(0, chosen.caret);
    m_insertedSuffix =
        chosen.select < chosen.caret ? QString() : QString::fromUtf8(whole.substr(whole.find_last_not_of(" =.") + 1));
    m_afterName = afterName(chosen);
    m_namedIn = &page;
    page.edit().setFocus();
    m_wanted = chosen.hasMore; // requests the next list when the document has the text
    page.endWord();
}

bool CompletionSession::canHandleKey(const QKeyEvent& event) {
    if (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) return false;
    switch (event.key()) {
    case Qt::Key_Down: m_popup->step(1); return true;
    case Qt::Key_Up: m_popup->step(-1); return true;
    case Qt::Key_PageDown: m_popup->step(m_popup->rows()); return true;
    case Qt::Key_PageUp: m_popup->step(-m_popup->rows()); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Tab: accept(); return true;
    case Qt::Key_Escape: close(); return true;
    default: return false;
    }
}

/// Tab or Enter after the name of a new block moves to the next value to fill in.
bool CompletionSession::continueBlock(const QKeyEvent& event) {
    const bool key = event.key() == Qt::Key_Tab || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (!key || event.modifiers() & ~Qt::KeypadModifier || m_afterName.empty() || !m_namedIn) return false;
    FilePage& page = *m_namedIn;
    const std::string passed = std::exchange(m_afterName, {});
    const std::uint32_t caret = page.edit().selection().end;
    if (!page.edit().hasFocus() || page.edit().bytes().compare(caret, passed.size(), passed) != 0) return false;
    const auto place = static_cast<std::uint32_t>(caret + passed.size());
    page.edit().select({place, place});
    list(page, false, true);
    return true;
}

/// Ignores a "." or "=" that the user types although the completion has already inserted it.
bool CompletionSession::isThereAlready(const QString& typed) {
    const qsizetype at = typed.size() == 1 ? m_insertedSuffix.indexOf(typed) : -1;
    if (at < 0) return false;
    m_insertedSuffix.remove(0, at + 1);
    return true;
}

bool CompletionSession::eventFilter(QObject* watched, QEvent* event) {
    if (isShown() && event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    if (isShown() && event->type() == QEvent::KeyPress && canHandleKey(*static_cast<QKeyEvent*>(event))) return true;
    if (event->type() == QEvent::KeyPress && continueBlock(*static_cast<QKeyEvent*>(event))) return true;
    if (event->type() == QEvent::KeyPress && isThereAlready(static_cast<QKeyEvent*>(event)->text())) return true;
    return QObject::eventFilter(watched, event);
}

} // namespace trundle
