#pragma once
// One file of the document in the text editor: passes typed text to the document and shows the document's changes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "base/diagnostic.h"
#include "editor/text/pages/typing_merger.h"
#include "lang/text_splice.h"

class QLabel;

namespace trundle {

class CodeEdit;
class Document;
struct LoadedProject;
class LargeTextNotice;

/// The diagnostics of the model check, and the texts that it checked.
struct ModelProblems {
    std::shared_ptr<const LoadedProject> texts;
    std::vector<Diagnostic> found;
};

class FilePage final : public QWidget {
    Q_OBJECT
public:
    FilePage(Document& document, std::string file, QWidget* parent = nullptr);
    ~FilePage() override;

    [[nodiscard]] CodeEdit& edit() const { return *m_edit; }
    [[nodiscard]] const std::string& file() const { return m_file; }
    /// The file was saved under another name; follow() shows what that changed in its text.
    void setFile(const std::string& file);
    [[nodiscard]] FileId id() const;       ///< in the currently loaded project; kNoFile if it is no longer imported
    /// False while a notice is shown instead: see large_text.h.
    [[nodiscard]] bool isTextShown() const { return m_shown; }
    /// Selects a range and scrolls to it; if the text is not shown yet, does so when it is.
    void select(TextRange range);
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }

    [[nodiscard]] bool pending() const { return m_typing.pending(); }
    /// Passes the typed text to the document. False if it was refused; the document's text is then restored.
    bool flush();
    void abandon(); ///< its file was removed: drops pending text and emits nothing more
    /// Shows the document's text after a change, merging pending typed text.
    void follow();
    void showProblems();
    void setModelProblems(std::shared_ptr<const ModelProblems> problems); ///< shown while the document has these texts
    /// Of a source outside the experiment: the messages of its last build, marked until the next one.
    void setBuildProblems(std::vector<Diagnostic> problems);
    /// The next typing becomes a separate entry of the history, with this name if given.
    void endWord(const QString& name = {});

Q_SIGNALS:
    void typed();                         ///< text is pending
    void flushed();                       ///< nothing is pending
    void textReplaced(std::uint32_t end); ///< the text was changed by others, for example undo; `end`: end of the last change

private:
    void start();
    void showText();
    [[nodiscard]] bool isTooLarge() const;
    void readWays();
    [[nodiscard]] QString nameOf(const TypingMerger::Entry& entry, std::string_view before);

    Document& m_document;
    std::string m_file;
    CodeEdit* m_edit;
    LargeTextNotice* m_notice = nullptr; ///< created for the first text that is too large
    TypingMerger m_typing;
    std::shared_ptr<const std::string> m_base; ///< the document's text that the editor's text is based on
    std::string m_wordKey;                     ///< merge key of the current history entry
    TextSplice m_word;                         ///< all of that entry's changes
    std::vector<Diagnostic> m_problems;
    std::shared_ptr<const ModelProblems> m_modelProblems;
    QTimer m_timer;
    int m_cost = 0; ///< ms that the last flush took
    QElapsedTimer m_sinceFlush;
    bool m_flushing = false;
    bool m_endsWord = false; ///< after the next flush, a new entry begins
    bool m_shown = true;     ///< the editor has the text
    bool m_asText = false;   ///< the user chose to show it despite its size
    TextRange m_selectLater; ///< pending select(), until the text is shown
};

} // namespace trundle
