#pragma once
// The Text panel: the document's files in tabs, the opened file first, others on demand.

#include <memory>
#include <string>
#include <vector>

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "base/diagnostic.h"
#include "editor/text/project_files.h"
#include "editor/widgets/preferences.h"

class QLabel;
class QMenu;
class QTabWidget;
class QToolButton;

namespace trundle {

class Actions;
class CodeEdit;
class CompletionSession;
class Document;
class FilePage;
struct LoadedProject;
struct ModelProblems;
class FindBar;
class FindSession;
class RenameField;
class ProjectRename;
class ResultsList;
class Selection;
class TextCommands;
struct Kind;

class TextPanel final : public QWidget {
    Q_OBJECT
public:
    TextPanel(Document& document, Selection& selection, Actions& actions, QWidget* parent = nullptr);
    ~TextPanel() override;

    /// Search folders for texts, images and modules in addition to the project's; for completion.
    void setFolders(FileFolders folders) { m_folders = std::move(folders); }
    void setWrapLines(WrapLines wrap);
    /// Passes all typed text to the document. Call it before reading or saving its texts; the panel itself calls it on any other
    /// keyboard or mouse action, and 10 to 400 ms after the first key.
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

    /// The kind of the block whose keyword is at the caret, else of the enclosing block; nullptr if there is none.
    [[nodiscard]] const Kind* kindAtCaret();
    /// "#import", "#loadModule" or "Param" if the caret is in one; else empty.
    [[nodiscard]] QString constructAtCaret();

    void goToDefinition(std::uint32_t offset);
    void showUses(std::uint32_t offset);
    /// Opens the rename field for the name at an offset.
    void renameAt(std::uint32_t offset);
    /// Opens a menu below the caret with the fixes of the diagnostics at the caret, else on its line; nullptr if there are none.
    QMenu* showFixes();
    void formatText();

public Q_SLOTS:
    /// Opens the file's tab and selects the range. Takes the focus only with `focus`.
    void reveal(const std::string& file, TextRange range, bool focus = false);
    /// Moves focus and caret to the start of a block, without a selection that typing would replace.
    void revealBlock(const std::string& file, TextRange block);
    void revealRange(const SourceRange& place) { revealFile(place, false); }
    /// Shows the diagnostics of the model check while the document has these texts.
    void setModelProblems(const std::shared_ptr<const trundle::LoadedProject>& texts,
                          const std::vector<trundle::Diagnostic>& found);
    FilePage* openFile(const std::string& file);

Q_SIGNALS:
    void messageRequested(const QString& text); ///< the reason why a command did nothing; for the status bar

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void revealFile(const SourceRange& place, bool focus);
    void onOpened();
    void onChanged();
    void onSelectionChanged();
    void showModified();
    void showTitles();
    void showWrap();
    void fillFileMenu();
    void addCommands();
    void selectAtCaret();
    void markSelected(bool scroll);
    void watchForOthers();
    FilePage* addPage(const std::string& file);
    void connectPage(FilePage& page);
    void closePage(int index);
    void removePage(FilePage& page);
    void showHover(FilePage& page, std::uint32_t offset, const QPoint& globalPos);
    void showLink(FilePage& page, std::uint32_t offset);
    void showMenu(FilePage& page, const QPoint& globalPos);
    void offerOthers(const ProjectRename& renaming);
    void rename(FilePage& page, ProjectRename& renaming, const QString& from, const QString& to);
    void showMessage(const QString& text); ///< a tooltip at the caret

    Document& m_document;
    Selection& m_selection;
    Actions& m_actions;
    QTabWidget* m_tabs;
    QLabel* m_nothing;
    QToolButton* m_files;
    TextCommands* m_commands;
    ResultsList *m_uses, *m_found;
    CompletionSession* m_completing;
    FindBar* m_bar;
    FindSession* m_finding;
    FileFolders m_folders;
    std::shared_ptr<const ModelProblems> m_modelProblems;
    WrapLines m_wrap = WrapLines::InNarrowPanes;
    QPointer<RenameField> m_rename;
    QTimer m_caretTimer;
    std::string m_opened;                ///< path of the opened file at the last update
    std::vector<std::string> m_modified; ///< modified files at the last update
    std::size_t m_historyAt = 0, m_historySize = 0;
    bool m_stepping = false;  ///< undo or redo is running
    bool m_selecting = false; ///< this panel is changing the selection
    bool m_watching = false;
};

} // namespace trundle
