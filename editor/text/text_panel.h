#pragma once
// The Text panel: the document's files in tabs, with search, completion and the commands of a text editor.

#include <memory>
#include <string>
#include <vector>

#include <QTimer>
#include <QWidget>

#include "base/diagnostic.h"
#include "editor/text/symbols/project_files.h"
#include "editor/widgets/preferences.h"

class QLabel;
class QToolButton;

namespace trundle {

class Actions;
class CompletionSession;
class Document;
class FilePage;
class FindBar;
class FindSession;
class ResultsList;
class Selection;
class TextAssistance;
class TextCommands;
class TextPages;
struct Kind;
struct LoadedProject;

class TextPanel final : public QWidget {
    Q_OBJECT
public:
    TextPanel(Document& document, Selection& selection, Actions& actions, QWidget* parent = nullptr);
    ~TextPanel() override;

    /// Search folders for texts, images and modules in addition to the project's; for completion.
    void setFolders(FileFolders folders) { m_folders = std::move(folders); }
    void setWrapLines(WrapLines wrap);
    /// Passes all typed text to the document. Call it before reading or saving its texts.
    void flush();
    [[nodiscard]] FilePage* page() const; ///< the current page; nullptr if nothing is open
    [[nodiscard]] FilePage* pageOf(const std::string& file) const;
    [[nodiscard]] std::vector<FilePage*> pages() const;

    /// Whether a text has the focus: then the window's edit actions apply to the text.
    [[nodiscard]] bool hasKeyboard() const;
    /// Runs an action of the table as a text command ("edit.cut"); false if there is none.
    bool apply(const std::string& id);
    /// Includes the width of the hidden find bar, so that showing it does not resize the panel.
    [[nodiscard]] QSize minimumSizeHint() const override;

    /// The kind of the block whose keyword is at the caret, else of the enclosing block; nullptr outside of blocks.
    [[nodiscard]] const Kind* kindAtCaret();
    /// "#import", "#loadModule" or "Param" if the caret is in one; else empty.
    [[nodiscard]] QString constructAtCaret();

public Q_SLOTS:
    /// Opens the file's tab and selects the range. Takes the focus only with `focus`.
    void reveal(const std::string& file, TextRange range, bool focus = false);
    /// Moves focus and caret to the start of a block, without a selection that typing would replace.
    void revealBlock(const std::string& file, TextRange block);
    /// Shows the diagnostics of the model check while the document has these texts.
    void setModelProblems(const std::shared_ptr<const trundle::LoadedProject>& texts,
                          const std::vector<trundle::Diagnostic>& found);
    /// Marks the messages of a build in the sources that are shown; see TextPages.
    void setBuildProblems(const std::vector<trundle::Diagnostic>& found,
                          const std::shared_ptr<const trundle::LoadedProject>& sources);
    FilePage* openFile(const std::string& file);

Q_SIGNALS:
    void messageRequested(const QString& text); ///< the reason why a command did nothing; for the status bar

private:
    void makeLayout();
    void onOpened();
    void onChanged();
    void onSelectionChanged();
    void showWrap();
    void addCommands();
    void addLineCommands();
    void selectAtCaret();
    void markSelected(bool scroll);
    void connectPage(FilePage& page);

    Document& m_document;
    Selection& m_selection;
    Actions& m_actions;
    TextPages* m_pages;
    QLabel* m_nothing;
    QToolButton* m_files;
    TextCommands* m_commands;
    ResultsList *m_uses, *m_found;
    TextAssistance* m_assistance;
    CompletionSession* m_completing;
    FindBar* m_bar;
    FindSession* m_finding;
    FileFolders m_folders;
    WrapLines m_wrap = WrapLines::InNarrowPanes;
    QTimer m_caretTimer;
    bool m_selecting = false; ///< this panel is changing the selection
};

} // namespace trundle
