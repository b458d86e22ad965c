#pragma once
// One file of the document in the text editor: what is typed goes to the document, what changes there comes here.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "base/diagnostic.h"
#include "editor/text/typing.h"

class QLabel;

namespace trundle {

class CodeEdit;
class Document;
struct Loaded;
class LargeTextNotice;

/// What the model check found, and in which texts.
struct ModelProblems {
    std::shared_ptr<const Loaded> texts;
    std::vector<Diagnostic> found;
};

class FilePage final : public QWidget {
    Q_OBJECT
public:
    FilePage(Document& document, std::string file, QWidget* parent = nullptr);
    ~FilePage() override;

    [[nodiscard]] CodeEdit& edit() const { return *m_edit; }
    [[nodiscard]] const std::string& file() const { return m_file; }
    void setFile(const std::string& file); ///< it was saved under another name
    [[nodiscard]] FileId id() const;       ///< in the document's load of now; kNoFile where nothing imports it any more
    /// False while a notice stands in its place: see large_text.h.
    [[nodiscard]] bool isTextShown() const { return m_shown; }
    /// Selects a range and scrolls to it; of a text that is not shown yet, once it is.
    void select(TextRange range);
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }

    [[nodiscard]] bool pending() const { return m_typing.pending(); }
    /// Gives what was typed to the document. False where it was refused: then the text is the document's again.
    bool flush();
    void abandon(); ///< its file is gone: what is pending is dropped, nothing more is said
    /// The document changed: takes over its text, without losing what is typed and not given yet.
    void follow();
    void showProblems();
    void setModelProblems(std::shared_ptr<const ModelProblems> problems); ///< shown while the document has these texts
    /// What is typed next is an entry of its own, under this name where one is given.
    void endWord(const QString& name = {});

Q_SIGNALS:
    void typed();                    ///< something waits to be given to the document
    void flushed();                  ///< it has it
    void brought(std::uint32_t end); ///< somebody else changed the text; the last change ends there

private:
    void start();
    void showText();
    [[nodiscard]] bool isTooLarge() const;
    void readWays();
    [[nodiscard]] QString nameOf(const Typing::Entry& entry, const std::string& before);

    Document& m_document;
    std::string m_file;
    CodeEdit* m_edit;
    LargeTextNotice* m_notice = nullptr; ///< made when the text is first too large
    Typing m_typing;
    std::shared_ptr<const std::string> m_base; ///< the document's text that the widget's is made from
    std::string m_wordKey, m_wordBase; ///< of the entry that goes on: the text before it
    std::vector<Diagnostic> m_problems;
    std::shared_ptr<const ModelProblems> m_modelProblems;
    QTimer m_timer;
    int m_cost = 0; ///< ms that the last flush took
    QElapsedTimer m_sinceFlush;
    bool m_flushing = false;
    bool m_shown = true;    ///< the editor holds the text
    bool m_asText = false;  ///< the user asked for it, large as it is
    TextRange m_selectLater; ///< when it is shown
};

} // namespace trundle
