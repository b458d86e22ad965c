#pragma once
#include <deque>
#include <map>
#include <string>

#include <QObject>

#include <trundle/geometry.h>

namespace trundle {

class ShownWorld;

/// Where the robots of a run have been, as long as somebody wants to see it.
class Trails final : public QObject {
    Q_OBJECT
public:
    explicit Trails(ShownWorld& world, QObject* parent = nullptr);

    /// What was noted is forgotten when nobody wants it any more.
    void setWanted(bool wanted);
    /// Oldest first, by robot; places at least a few millimetres apart.
    [[nodiscard]] const std::map<std::string, std::deque<Vec3>>& all() const { return m_trails; }

private:
    void note();
    ShownWorld& m_world;
    std::map<std::string, std::deque<Vec3>> m_trails;
    bool m_wanted = false;
};

} // namespace trundle
