#pragma once
#include <deque>
#include <map>
#include <string>

#include <QObject>

#include <trundle/geometry.h>

namespace trundle {

class ViewportScene;

/// Records the paths of the robots of a run while the trail overlay is enabled.
class Trails final : public QObject {
    Q_OBJECT
public:
    explicit Trails(ViewportScene& world, QObject* parent = nullptr);

    /// Disabling discards the recorded points.
    void setWanted(bool wanted);
    /// By robot, oldest point first; points are at least a few millimetres apart.
    [[nodiscard]] const std::map<std::string, std::deque<Vec3>>& all() const { return m_trails; }

private:
    void note();
    ViewportScene& m_world;
    std::map<std::string, std::deque<Vec3>> m_trails;
    bool m_wanted = false;
};

} // namespace trundle
