#include "editor/shell/commands/edit_commands.h"

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/outline_panel.h"
#include "editor/shell/dialogs/group_dialog.h"
#include "editor/shell/layouts.h"
#include "editor/shell/work_area.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/plain_text.h"
#include "model/dotted_path.h"
#include "project/edits/plans.h"

namespace trundle {

EditCommands::EditCommands(QWidget& window, Actions& actions, const Targets& targets, const std::string& configs)
    : QObject(&window), m_actions(actions), m_targets(targets) {
    const auto on = [this](const char* id, auto what) { connect(&m_actions.at(id), &QAction::triggered, this, what); };
    on("edit.undo", [this] { m_targets.text.flush(), m_targets.document.edits().undo(); });
    on("edit.redo", [this] { m_targets.text.flush(), m_targets.document.edits().redo(); });
    for (const char* id :
         {"edit.cut", "edit.copy", "edit.paste", "edit.delete", "edit.duplicate", "edit.rename", "edit.selectAll", "edit.find"})
        on(id, [this, id] { apply(id); });
    on("edit.group",
       [this, &window, configs] { askForGroup(&window, m_targets.document, m_targets.selection.paths(), configs); });
    on("edit.singles", [this] { (void)m_targets.objects.replaceBySingles(m_targets.selection.current()); });
    on("edit.filter", [this] {
        m_targets.layouts.raise(QStringLiteral("scene"));
        m_targets.outline.focusFilter();
    });
    connect(&m_targets.document.edits(), &DocumentEdits::historyChanged, this, &EditCommands::showUndo);
    showUndo();
    connect(&m_targets.selection, &Selection::changed, this, &EditCommands::showSingles);
    connect(&m_targets.document, &Document::changed, this, &EditCommands::showSingles);
}

void EditCommands::apply(const char* id) {
    TextPanel& text = m_targets.text;
    ObjectEdits& objects = m_targets.objects;
    if (text.hasKeyboard() && text.apply(id)) return;
    const std::string_view what = id;
    if (what == "edit.cut") objects.cutSelected();
    else if (what == "edit.copy") objects.copySelected();
    else if (what == "edit.paste") objects.pasteAtSelected();
    else if (what == "edit.delete") objects.removeSelected();
    else if (what == "edit.duplicate") objects.duplicateSelected();
    else if (what == "edit.selectAll") selectAll();
    else if (what == "edit.rename") {
        m_targets.layouts.raise(QStringLiteral("scene"));
        m_targets.outline.renameSelected();
    } else if (what == "edit.find") {
        m_targets.work.showText(true);
        text.apply(id);
    }
}

void EditCommands::selectAll() {
    const EditedModel& model = m_targets.document.editedModel();
    std::vector<std::string> all;
    if (model.isOpen()) {
        if (!model.config()) return;
        for (const Part& part : model.config()->parts)
            if (part.usable) all.push_back(pathInside(model.path(), part.name));
        return m_targets.selection.set(all);
    }
    const ExperimentSpec& experiment = *m_targets.document.loaded()->experiment;
    for (const RobotSpec& robot : experiment.robots) all.push_back(robot.name);
    for (const StaticSpec& still : experiment.statics) all.push_back(still.name);
    m_targets.selection.set(all);
}

void EditCommands::showSingles() {
    const Document& document = m_targets.document;
    m_actions.at("edit.singles")
        .setEnabled(document.isOpen() && canReplaceBySingles(*document.loaded(), m_targets.selection.current()));
}

void EditCommands::showUndo() {
    const History& history = m_targets.document.edits().history();
    QAction &undo = m_actions.at("edit.undo"), &redo = m_actions.at("edit.redo");
    undo.setEnabled(history.canUndo());
    redo.setEnabled(history.canRedo());
    undo.setText(history.canUndo() ? tr("&Undo %1").arg(withoutMnemonics(history.entries()[history.position() - 1].name))
                                   : tr("&Undo"));
    redo.setText(history.canRedo() ? tr("&Redo %1").arg(withoutMnemonics(history.entries()[history.position()].name))
                                   : tr("&Redo"));
}

} // namespace trundle
