#include "editor/text/pages/file_page.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/code/code_language.h"
#include "editor/text/code/splice.h"
#include "editor/text/pages/edit_name.h"
#include "editor/text/pages/large_text.h"
#include "lang/edit_style.h"

namespace trundle {
namespace {

/// One level of indentation of a program: that of its first indented line, 4 spaces if no line is indented.
std::string indentStep(std::string_view text) {
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
        if (at + 1 < text.size() && text[at + 1] == '\t') return "\t";
        const std::size_t first = text.find_first_not_of(' ', at + 1);
        if (first != std::string_view::npos && first > at + 2 && text[first] != '\n' && text[first] != '*')
            return std::string(std::min<std::size_t>(first - at - 1, 8), ' ');
    }
    return "    ";
}

constexpr int kWait = 10, kLongestWait = 400; ///< ms from a key press to the update of the document

} // namespace

FilePage::FilePage(Document& document, std::string file, QWidget* parent)
    : QWidget(parent), m_document(document), m_file(std::move(file)), m_edit(new CodeEdit(this)), m_typing(m_file) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_edit);
    setFocusProxy(m_edit);
    m_edit->setObjectName(QStringLiteral("textEdit"));
    m_edit->setFrameStyle(QFrame::NoFrame);
    m_edit->setAccessibleName(QString::fromStdString(m_document.texts().shown(m_file)));
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this] { flush(); });
    connect(m_edit, &CodeEdit::actionBegins, this, [this] { m_typing.beginAction(); });
    connect(m_edit, &CodeEdit::edited, this, [this](std::size_t at, std::string_view removed, std::string_view inserted) {
        if (m_typing.startsEntry(at, removed.size(), inserted)) {
            if (m_edit->styling().isPlain()) {
                m_endsWord = true; // one entry until the next flush: a large text for each would take too much memory
            } else {
                std::string before = m_edit->bytes();
                before.replace(at, inserted.size(), removed);
                m_typing.close(std::move(before));
            }
        }
        m_typing.changed(at, inserted);
        // The timer is not restarted by later keys, so that the rest of the window follows continuous typing. If loading is
        // slow, the pause is as long as the last flush, so that half of the time is left for typing.
        const int since = m_sinceFlush.isValid() ? int(std::min<qint64>(m_sinceFlush.elapsed(), kLongestWait)) : kLongestWait;
        if (!m_timer.isActive()) m_timer.start(std::clamp(m_cost - since, kWait, kLongestWait));
        Q_EMIT typed();
    });
    connect(m_edit, &CodeEdit::left, this, [this] { flush(); });
    start();
}

FilePage::~FilePage() { m_edit->blockSignals(true); } // no focus signal during destruction

void FilePage::abandon() {
    m_timer.stop();
    m_typing.drop();
    m_edit->blockSignals(true);
}

void FilePage::start() {
    m_base = m_document.texts().text(m_file);
    showText();
    readWays();
    showProblems();
}

bool FilePage::isTooLarge() const {
    const TextSize size = sizeOf(m_base ? *m_base : std::string_view());
    return !size.isShowable() || (size.isLarge() && !m_asText);
}

/// Shows the document's text, or a notice with the reason if it cannot be shown.
void FilePage::showText() {
    const std::string_view text = m_base ? std::string_view(*m_base) : std::string_view();
    const TextSize size = sizeOf(text);
    m_shown = size.isShowable() && (!size.isLarge() || m_asText);
    if (!m_shown && !m_notice) {
        m_notice = new LargeTextNotice(this);
        layout()->addWidget(m_notice);
        connect(m_notice, &LargeTextNotice::openRequested, this, [this] {
            m_asText = true;
            showText();
            readWays();
            showProblems();
            select(m_selectLater);
            setFocus();
        });
    }
    if (m_notice) m_notice->setSize(QString::fromStdString(m_document.texts().shown(m_file)), size);
    const CodeLanguage language = id() != kNoFile ? CodeLanguage::Trundle : languageOf(m_file);
    m_edit->setLanguage(language, size.isLarge() || language == CodeLanguage::None);
    m_edit->load(m_shown ? text : std::string_view());
    m_edit->setReadOnly(!m_shown);
    m_edit->setVisible(m_shown);
    if (m_notice) m_notice->setVisible(!m_shown);
    setFocusProxy(m_shown ? static_cast<QWidget*>(m_edit) : m_notice);
}

void FilePage::select(TextRange range) {
    if (m_shown) m_edit->select(range);
    else m_selectLater = range;
}

FileId FilePage::id() const {
    if (!m_document.isOpen()) return kNoFile;
    const std::vector<std::string>& paths = m_document.loaded()->paths;
    const auto at = std::find(paths.begin(), paths.end(), m_file);
    return at == paths.end() ? kNoFile : static_cast<FileId>(at - paths.begin());
}

void FilePage::setFile(const std::string& file) {
    m_file = file;
    m_typing = TypingMerger(file);
}

void FilePage::readWays() {
    const FileId file = id();
    if (file == kNoFile) {
        const std::string_view text = m_base ? std::string_view(*m_base) : std::string_view();
        return m_edit->setWays(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n", indentStep(text));
    }
    const EditStyle style = editStyle(*m_document.loaded()->trees[file]);
    m_edit->setWays(style.lineEnd, style.step);
}

bool FilePage::flush() {
    if (m_flushing || !m_typing.pending()) return true;
    m_timer.stop();
    if (m_document.opening().isOpening() || m_edit->isComposing()) { // edits are refused, or the text is not final
        m_timer.start(kWait);
        return false;
    }
    QElapsedTimer clock;
    clock.start();
    bool taken = true;
    {
        const QScopedValueRollback<bool> flushing(m_flushing, true);
        std::shared_ptr<const std::string> before = m_base;
        for (TypingMerger::Entry& entry : m_typing.take(m_edit->bytes())) {
            const QString name = nameOf(entry, before ? std::string_view(*before) : std::string_view());
            taken = taken && m_document.edits().replaceText(name, m_file, std::move(entry.bytes), entry.mergeKey).ok();
            before = m_document.texts().text(m_file);
        }
    }
    if (std::exchange(m_endsWord, false)) m_typing.endWord();
    m_cost = static_cast<int>(clock.elapsed());
    m_sinceFlush.start();
    if (!taken) {
        m_typing.drop();
        m_base = nullptr; // no longer the base of the editor's text: follow() now restores the document's text in any case
    }
    follow();
    showProblems();
    Q_EMIT flushed();
    return taken;
}

QString FilePage::nameOf(const TypingMerger::Entry& entry, std::string_view before) {
    const TextSplice change = spliceBetween(before, entry.bytes);
    m_word = entry.mergeKey == m_wordKey ? joined(m_word, change, before) : change;
    m_wordKey = entry.mergeKey;
    return entry.named ? entry.name : typedName(m_word, entry.bytes, std::filesystem::path(m_file).filename().string());
}

void FilePage::follow() {
    if (m_flushing) return;
    const std::shared_ptr<const std::string> now = m_document.texts().text(m_file);
    if (!now || now == m_base) return;
    if (m_typing.pending()) { // typing and an external change at the same time: merge
        m_typing.joinAll();
        (void)m_edit->bring(merged(*m_base, m_shown ? m_edit->bytes() : std::string(), *now));
        m_base = now;
        return;
    }
    m_base = now;
    if (m_shown && m_edit->shows(*now)) return;
    m_typing.endWord();
    if (!m_shown || isTooLarge()) {
        showText();
        return readWays();
    }
    const std::uint32_t end = m_edit->bring(*now);
    readWays();
    Q_EMIT textReplaced(end);
}

void FilePage::showProblems() {
    const FileId file = id();
    if (file == kNoFile) return; // its marks are those of a build, and move with the text
    m_problems.clear();
    if (file != kNoFile && !m_typing.pending()) {
        for (const Diagnostic& d : m_document.loaded()->diagnostics.all())
            if (d.range.file == file) m_problems.push_back(d);
        if (m_modelProblems && m_modelProblems->texts == m_document.loaded())
            for (const Diagnostic& d : m_modelProblems->found)
                if (d.range.file == file) m_problems.push_back(d);
    } else if (m_typing.pending()) return; // old ranges: the marks move with the text until it is loaded
    if (m_shown) m_edit->marks().showProblems(m_problems);
}

void FilePage::setModelProblems(std::shared_ptr<const ModelProblems> problems) {
    m_modelProblems = std::move(problems);
    showProblems();
}

void FilePage::setBuildProblems(std::vector<Diagnostic> problems) {
    if (id() != kNoFile) return;
    m_problems = std::move(problems);
    if (m_shown) m_edit->marks().showProblems(m_problems);
}

void FilePage::endWord(const QString& name) {
    m_typing.endWord();
    if (!name.isEmpty()) m_typing.nameNext(name);
}

} // namespace trundle
