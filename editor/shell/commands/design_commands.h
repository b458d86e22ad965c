#pragma once
#include <QObject>
#include <QWidget>

#include "app/locations.h"
#include "editor/widgets/actions.h"

namespace trundle {

class ControllersPanel;
class Document;
class FileCommands;
class NewArenaDialog;
class NewRobotDialog;

/// Makes a robot from dimensions or an arena from a floor plan, as files, and opens the experiment among them.
class DesignCommands final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    DesignCommands(QWidget& window, Actions& actions, Document& document, FileCommands& files, ControllersPanel& controllers,
                   Locations locations);

private:
    [[nodiscard]] QString proposedFolder() const;
    void askForRobot();
    void askForArena();
    void open(const NewRobotDialog& dialog);

    QWidget& m_window;
    Document& m_document;
    FileCommands& m_files;
    ControllersPanel& m_controllers;
    Locations m_locations;
};

} // namespace trundle
