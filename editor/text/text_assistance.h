#pragma once
// What the Text panel knows about the name at a place: tooltips, links, references, fixes, renaming and the context menu.

#include <QObject>
#include <QPointer>

#include "base/source_range.h"

class QMenu;

namespace trundle {

class Actions;
class Document;
class FilePage;
class ProjectRename;
class RenameField;
class ResultsList;
class TextCommands;
class TextPages;
struct Kind;

class TextAssistance final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object. `uses` lists references.
    TextAssistance(Document& document, TextPages& pages, ResultsList& uses, TextCommands& commands, Actions& actions,
                   QObject* parent = nullptr);

    void watch(FilePage& page); ///< for hover, links and the context menu

    /// The kind of the block whose keyword is at the caret, else of the enclosing block; nullptr outside of blocks.
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
    /// The reason why a command did nothing, as a tooltip at the caret and as messageRequested().
    void showMessage(const QString& text);

Q_SIGNALS:
    void messageRequested(const QString& text);

private:
    void showHover(FilePage& page, std::uint32_t offset, const QPoint& globalPos);
    void showLink(FilePage& page, std::uint32_t offset);
    void showMenu(FilePage& page, const QPoint& globalPos);
    void offerOthers(const ProjectRename& renaming);
    void rename(FilePage& page, ProjectRename& renaming, const QString& from, const QString& to);

    Document& m_document;
    TextPages& m_pages;
    ResultsList& m_uses;
    TextCommands& m_commands;
    Actions& m_actions;
    QPointer<RenameField> m_rename;
};

} // namespace trundle
