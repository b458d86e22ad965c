#pragma once
#include <string>
#include <vector>

#include <QObject>

namespace trundle {

/// The selection shared by outline, viewport, properties and text editor. Objects are identified by their dotted paths
/// (project/objects/object_location.h): "robot0", "robot0.chassis.hull", "RobotConfig.SimpleRobot.leftAxle", "Material.red"; "" is
/// the experiment itself.
class Selection final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<std::string>& paths() const { return m_paths; }
    [[nodiscard]] bool contains(const std::string& path) const;
    /// The object selected last, which single-object tools use; "" if nothing is selected.
    [[nodiscard]] std::string current() const { return m_paths.empty() ? std::string() : m_paths.back(); }
    [[nodiscard]] bool empty() const { return m_paths.empty(); }

    void set(std::vector<std::string> paths);
    void select(const std::string& path) { set({path}); }
    void toggle(const std::string& path);
    void clear() { set({}); }

Q_SIGNALS:
    void changed();

private:
    std::vector<std::string> m_paths; // without duplicates
};

} // namespace trundle
