#include "editor/shell/commands/design_commands.h"

#include <utility>

#include "editor/document/document.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/trust.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/dialogs/new_arena_dialog.h"
#include "editor/shell/dialogs/new_robot_dialog.h"
#include "editor/shell/recent_files.h"
#include "editor/widgets/strings.h"

namespace trundle {

DesignCommands::DesignCommands(QWidget& window, Actions& actions, Document& document, FileCommands& files,
                               ControllersPanel& controllers, Locations locations)
    : QObject(&window), m_window(window), m_document(document), m_files(files), m_controllers(controllers),
      m_locations(std::move(locations)) {
    connect(&actions.at("file.newFromDimensions"), &QAction::triggered, this, &DesignCommands::askForRobot);
    connect(&actions.at("file.newFromPlan"), &QAction::triggered, this, &DesignCommands::askForArena);
}

/// Beside the experiment that is open, so that it can import what is made.
QString DesignCommands::proposedFolder() const {
    const bool isOwn = m_document.isOpen() && !m_document.isNew() && !m_document.texts().isSample(m_document.path());
    return isOwn ? toQString(m_document.loaded()->projectFolder) : documentsFolder();
}

void DesignCommands::askForRobot() {
    auto* dialog = new NewRobotDialog(proposedFolder(), &m_window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { open(*dialog); });
    dialog->open();
}

void DesignCommands::askForArena() {
    auto* dialog = new NewArenaDialog(m_locations, proposedFolder(), &m_window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { m_files.open(toQString(dialog->made().experiment)); });
    dialog->open();
}

/// Its controller is in Python, which needs no build.
void DesignCommands::open(const NewRobotDialog& dialog) {
    TrustedFolders::add(toQString(dialog.made().folder)); // the dialog says so
    m_controllers.commands().applyTrust();
    m_files.open(toQString(dialog.made().experiment)); // asks about unsaved changes of the experiment that is open
}

} // namespace trundle
