#pragma once
#include <string>

#include <QObject>

#include "app/locations.h"

class QWidget;

namespace trundle {

class Actions;
class Document;
class MeshDialog;
class Selection;
class ViewportScene;

/// Connects the action "mesh.import": a mesh and its collision shape become geoms of a body, of the StaticConfig that is shown alone, or
/// scenery of the experiment. One entry of the history; refusals are reported by Document::refused().
class MeshCommands final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    MeshCommands(QWidget& window, Actions& actions, Document& document, Selection& selection, const ViewportScene& world,
                 Locations locations);

private:
    void ask();
    void insert(const MeshDialog& dialog, const std::string& body);

    QWidget& m_window;
    Document& m_document;
    Selection& m_selection;
    const ViewportScene& m_world;
    const Locations m_locations;
};

} // namespace trundle
