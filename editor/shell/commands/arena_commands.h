#pragma once
// The commands that insert scenery which is made from numbers or a picture: a room, a maze, obstacles, a height map.

#include <array>
#include <string>

#include <QObject>

#include "app/locations.h"

class QWidget;

namespace trundle {

class Actions;
class Document;
class ViewportScene;
struct RoomPlan;

/// Connects the actions "arena.*". Each is one entry of the history: boxes in the StaticConfig that is shown alone, otherwise a config
/// and its Static in the experiment. Refusals are reported by Document::refused().
class ArenaCommands final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ArenaCommands(QWidget& window, Actions& actions, Document& document, const ViewportScene& world, Locations locations);

private:
    void askRoom();
    void askMaze();
    void askObstacles();
    void askHeights();
    void insertRoom(const QString& title, const std::string& name, const RoomPlan& plan, bool hasFloor);
    void insertHeights(const QString& picture, const std::array<double, 3>& sizes);
    void insert(const QString& title, const std::string& blocks, const std::string& insideConfig);

    QWidget& m_window;
    Document& m_document;
    const ViewportScene& m_world;
    const Locations m_locations;
};

} // namespace trundle
