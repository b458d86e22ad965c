#pragma once
// Positions of joints that the views show before a run. They pose the picture alone: neither the text nor a run changes.

#include <map>
#include <string>

#include <QObject>

#include "scene/queries/object_index.h"

namespace trundle {

class JointPositions final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] bool empty() const { return m_positions.empty(); } ///< everything is as at the start
    /// rad or m, by the coordinate of jointCoordinates().
    [[nodiscard]] double at(const RobotSpec& robot, std::size_t coordinate) const;
    /// Within its stops; joints that gears couple to it follow.
    void set(const RobotSpec& robot, std::size_t coordinate, double position);
    void reset();
    /// Moves the bodies of robots whose joints are not at the start.
    void apply(const ObjectIndex& objects, BodyPoses& poses) const;

Q_SIGNALS:
    void changed();

private:
    /// By robot, joint and part: names last longer than indices, which change with edits.
    using Key = std::tuple<std::string, std::string, int>;
    std::map<Key, double> m_positions;
};

} // namespace trundle
