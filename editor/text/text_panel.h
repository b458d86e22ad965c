#pragma once
// The document's files as texts, in tabs: the opened file first, the others when they are wanted.

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
class Completing;
class Document;
class FilePage;
struct Loaded;
struct ModelProblems;
class FindBar;
class Finding;
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

    /// Where texts, pictures and modules are looked for beside the project's own folders; for completion.
    void setFolders(FileFolders folders) { m_folders = std::move(folders); }
    void setWrapLines(WrapLines wrap);
    /// Gives all that is typed to the document. To be called before anything that reads or saves its texts; the panel does it by
    /// itself whenever the keyboard or the mouse goes elsewhere, and 40 ms after the first key.
    void flush();
    [[nodiscard]] FilePage* page() const; ///< the one in front; nullptr where nothing is open
    [[nodiscard]] FilePage* pageOf(const std::string& file) const;
    [[nodiscard]] std::vector<FilePage*> pages() const;

    /// Whether the keyboard is in a text: then the edit actions of the window mean the text.
    [[nodiscard]] bool hasKeyboard() const;
    /// Does what an action of the table means in a text ("edit.cut"); false where it means nothing here.
    bool carryOut(const std::string& id);
    /// As wide as the bar to find with needs, also while that is away: nothing moves when it comes.
    [[nodiscard]] QSize minimumSizeHint() const override;

    /// The kind of block whose word the caret is at, else that of the block round it; nullptr where there is none.
    [[nodiscard]] const Kind* kindAtCaret();
    /// "#import", "#loadModule" or "Param" where the caret is in one; else empty.
    [[nodiscard]] QString constructAtCaret();

    void goToDefinition(std::uint32_t offset);
    void showUses(std::uint32_t offset);
    /// Opens a line over the name at an offset, in which another name for it is typed.
    void renameAt(std::uint32_t offset);
    /// The ways to mend what is wrong at the caret, else on its line, as a menu under the caret; nullptr where there is none.
    QMenu* showFixes();
    void formatText();

public Q_SLOTS:
    /// Shows a place: opens the file's tab, selects the range there. Takes the keyboard only where asked to.
    void reveal(const std::string& file, TextRange range, bool focus = false);
    /// Shows a block: the caret goes before it with the keyboard, and nothing is selected, so that what is typed replaces nothing.
    void revealBlock(const std::string& file, TextRange block);
    void revealRange(const SourceRange& place) { revealFile(place, false); }
    /// Marks what the model check found as other problems are marked, as long as the document has these texts.
    void setModelProblems(const std::shared_ptr<const trundle::Loaded>& texts, const std::vector<trundle::Diagnostic>& found);
    FilePage* openFile(const std::string& file);

Q_SIGNALS:
    void said(const QString& text); ///< why nothing happened; for the status bar

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
    void tell(const QString& text); ///< beside the caret, for a moment

    Document& m_document;
    Selection& m_selection;
    Actions& m_actions;
    QTabWidget* m_tabs;
    QLabel* m_nothing;
    QToolButton* m_files;
    TextCommands* m_commands;
    ResultsList *m_uses, *m_found;
    Completing* m_completing;
    FindBar* m_bar;
    Finding* m_finding;
    FileFolders m_folders;
    std::shared_ptr<const ModelProblems> m_modelProblems;
    WrapLines m_wrap = WrapLines::InNarrowPanes;
    QPointer<RenameField> m_rename;
    QTimer m_caretTimer;
    std::string m_opened;                ///< path of the opened file, as last seen
    std::vector<std::string> m_modified; ///< files that were not saved, as last seen
    std::size_t m_historyAt = 0, m_historySize = 0;
    bool m_stepping = false;  ///< the document goes back or forth in its history
    bool m_selecting = false; ///< the selection changes because of this panel
    bool m_watching = false;
};

} // namespace trundle
