#include "editor/text/completing.h"

#include <algorithm>

#include <QKeyEvent>

#include "editor/document/document.h"
#include "editor/text/code_edit.h"
#include "editor/text/completion_popup.h"
#include "editor/widgets/plain_text.h"
#include "lang/characters.h"

namespace trundle {
namespace {

/// Letters begin a word; after these signs there is often a choice.
bool callsForList(std::string_view inserted) {
    return inserted.size() == 1 && (isIdentStart(inserted[0]) || inserted == "=" || inserted == "." || inserted == "$" ||
                                    inserted == "#" || inserted == "/");
}

/// Of a block with its name chosen, to be typed: from there to behind "Config = ", or to where its first line goes.
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

Completing::Completing(Document& document, std::function<FileFolders()> folders, QWidget* owner)
    : QObject(owner), m_document(document), m_folders(std::move(folders)), m_popup(new CompletionPopup(owner)) {
    connect(m_popup, &CompletionPopup::clicked, this, &Completing::accept);
    connect(m_popup, &CompletionPopup::left, this, &Completing::close);
    connect(m_popup, &QObject::destroyed, this, [this] { m_popup = nullptr; });
}

Completing::~Completing() {
    if (m_popup) m_popup->disconnect(this);
    delete m_popup; // it may have become the window's
}

void Completing::watch(FilePage& page) {
    page.edit().installEventFilter(this);
    connect(&page.edit(), &CodeEdit::edited, this,
            [this, &page](std::size_t, std::string_view, std::string_view inserted) { onEdited(page, inserted); });
    connect(&page.edit(), &CodeEdit::caretMovedByHand, this, [this, &page] {
        m_brought.clear();
        narrow(page);
    });
    connect(&page.edit(), &CodeEdit::left, this, &Completing::close);
    connect(&page, &FilePage::brought, this, &Completing::close); // undone: it was for another text
    connect(&page, &FilePage::flushed, this, [this, &page] {
        if (std::exchange(m_wanted, false) && page.edit().hasFocus()) list(page, m_asked && isShown(), false);
    });
}

bool Completing::isShown() const { return m_popup && m_popup->isVisible(); }

void Completing::close() {
    m_wanted = m_asked = false;
    if (m_popup) m_popup->hide();
    m_page = nullptr;
}

void Completing::onEdited(FilePage&, std::string_view inserted) {
    if (m_accepting) return;
    m_brought.clear();
    if (callsForList(inserted)) m_wanted = true;
    else if (!(inserted.size() == 1 && isIdent(inserted[0])) && !(isShown() && inserted.empty())) close();
}

std::string Completing::typed(FilePage& page) const {
    const std::string text = page.edit().bytes();
    const std::uint32_t caret = page.edit().caret();
    if (caret < m_found.word.begin || caret > text.size()) return "\n";
    return text.substr(m_found.word.begin, caret - m_found.word.begin);
}

void Completing::list(FilePage& page, bool asked, bool fresh) {
    if (!page.flush() || page.id() == kNoFile) return;
    m_wanted = false;
    const std::uint32_t caret = page.edit().caret();
    m_found = completionsAt(*m_document.loaded(), page.id(), caret, m_folders());
    if (fresh) m_behind = m_found.word.end > caret ? m_found.word.end - caret : 0;
    else if (!isShown()) m_behind = 0; // while typing, what stands behind the caret was there before and stays
    m_page = &page;
    m_asked = asked;
    show(page);
    if (asked && !isShown())
        showToolTip(page.edit().viewport()->mapToGlobal(page.edit().placeOf(caret)), tr("Nothing to complete here"),
                    &page.edit());
}

/// The letters typed since, or taken back, choose among what was found.
void Completing::narrow(FilePage& page) {
    if (isShown() && m_page == &page) show(page);
}

void Completing::show(FilePage& page) {
    const std::string word = typed(page);
    const bool isWord = std::all_of(word.begin(), word.end(), [](char c) { return isWordChar(c) || c == '$' || c == '#'; });
    m_shown = isWord ? fitting(m_found.items, word) : std::vector<const Completion*>();
    // Typed out in full, or behind a number that may end there, the list would only be in the way of Enter.
    const bool done = !m_asked && std::any_of(m_shown.begin(), m_shown.end(), [&](const Completion* c) {
        return c->label == word || (word.empty() && c->sort == CompletionSort::Unit);
    });
    if (m_shown.empty() || done) {
        if (m_popup) m_popup->hide();
        return;
    }
    if (m_popup)
        m_popup->showItems(m_shown, page.edit().viewport()->mapToGlobal(page.edit().placeOf(m_found.word.begin)),
                           page.edit().lineHeight());
}

void Completing::accept() {
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
    m_brought = chosen.select < chosen.caret ? QString() : QString::fromUtf8(whole.substr(whole.find_last_not_of(" =.") + 1));
    m_afterName = afterName(chosen);
    m_namedIn = &page;
    page.edit().setFocus();
    m_wanted = chosen.goesOn; // once the document has it
    page.endWord();
}

bool Completing::takesKey(const QKeyEvent& event) {
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

/// Tab or Enter behind the name of a new block: on to what it still needs.
bool Completing::goesOn(const QKeyEvent& event) {
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

/// Whoever is used to typing the "." or " = " behind a name types it although the choice brought it: it is not wanted twice.
bool Completing::isThereAlready(const QString& typed) {
    const qsizetype at = typed.size() == 1 ? m_brought.indexOf(typed) : -1;
    if (at < 0) return false;
    m_brought.remove(0, at + 1);
    return true;
}

bool Completing::eventFilter(QObject* watched, QEvent* event) {
    if (isShown() && event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
        event->accept();
    if (isShown() && event->type() == QEvent::KeyPress && takesKey(*static_cast<QKeyEvent*>(event))) return true;
    if (event->type() == QEvent::KeyPress && goesOn(*static_cast<QKeyEvent*>(event))) return true;
    if (event->type() == QEvent::KeyPress && isThereAlready(static_cast<QKeyEvent*>(event)->text())) return true;
    return QObject::eventFilter(watched, event);
}

} // namespace trundle
