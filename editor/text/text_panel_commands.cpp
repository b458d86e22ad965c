// The text panel's implementation of the actions.

#include "editor/document/document.h"
#include "editor/text/code_edit.h"
#include "editor/text/completion_session.h"
#include "editor/text/file_page.h"
#include "editor/text/find_session.h"
#include "editor/text/text_commands.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/actions.h"

namespace trundle {

void TextPanel::addCommands() {
    const auto withEdit = [this](auto run) {
        return [this, run] {
            if (FilePage* page = this->page()) run(page->edit());
        };
    };
    m_commands->inText("edit.undo", [this] {
        flush();
        m_document.undo();
    });
    m_commands->inText("edit.redo", [this] {
        flush();
        m_document.redo();
    });
    m_commands->inText("edit.cut", withEdit([](CodeEdit& edit) { edit.cut(); }));
    m_commands->inText("edit.copy", withEdit([](CodeEdit& edit) { edit.copy(); }));
    m_commands->inText("edit.paste", withEdit([](CodeEdit& edit) { edit.paste(); }));
    m_commands->inText("edit.delete", withEdit([](CodeEdit& edit) { edit.removeForward(); }));
    m_commands->inText("edit.selectAll", withEdit([](CodeEdit& edit) { edit.selectAll(); }));
    m_commands->inText("edit.duplicate", withEdit([](CodeEdit& edit) { edit.duplicateLines(); }));
    m_commands->inText("edit.rename", withEdit([this](CodeEdit& edit) { renameAt(edit.caret()); }));
    m_commands->inText("edit.find", [this] { m_finding->open(false); });
    m_commands->own("edit.findInFiles", [this] { m_finding->openInFiles(); });
    m_commands->own("edit.replace", [this] { m_finding->open(true); });
    m_commands->own("text.complete", [this] {
        if (FilePage* page = this->page()) m_completing->ask(*page);
    });
    m_commands->own("text.fix", [this] { showFixes(); });
    m_commands->own("text.definition", [this] {
        if (FilePage* page = this->page()) goToDefinition(page->edit().caret());
    });
    m_commands->own("text.uses", [this] {
        if (FilePage* page = this->page()) showUses(page->edit().caret());
    });
    m_commands->own("text.format", [this] { formatText(); });
    m_commands->own("text.comment", withEdit([](CodeEdit& edit) { edit.toggleComment(); }));
    m_commands->own("text.lineUp", withEdit([](CodeEdit& edit) { edit.moveLines(-1); }));
    m_commands->own("text.lineDown", withEdit([](CodeEdit& edit) { edit.moveLines(+1); }));
    connect(&m_actions.at("text.wrap"), &QAction::triggered, this, [this](bool wraps) {
        Preferences preferences = loadPreferences();
        preferences.wrapLines = wraps ? WrapLines::Always : WrapLines::Never;
        savePreferences(preferences);
        setWrapLines(preferences.wrapLines);
    });
    m_commands->own("text.fold", withEdit([](CodeEdit& edit) { edit.foldEverything(true); }));
    m_commands->own("text.unfold", withEdit([](CodeEdit& edit) { edit.foldEverything(false); }));
}

} // namespace trundle
