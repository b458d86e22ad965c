#pragma once
#include <string>
#include <vector>

#include <QObject>

class QPainter;

namespace trundle {

class View;

/// Objects whose values are read out over the 3D view while an experiment runs, in the order in which they were pinned. "" is the
/// run itself.
class PinnedValues final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<std::string>& paths() const { return m_paths; }
    [[nodiscard]] bool contains(const std::string& path) const;
    void set(const std::vector<std::string>& paths, bool pinned);
    /// Leaves out those of which this says no.
    template <class Exists> void keepIf(const Exists& exists) {
        if (std::erase_if(m_paths, [&](const std::string& path) { return !exists(path); }) > 0) Q_EMIT changed();
    }

Q_SIGNALS:
    void changed();

private:
    std::vector<std::string> m_paths;
};

/// Below the corner of the current view. What there is no room for is counted.
void paintPinnedValues(QPainter& painter, const View& view);

} // namespace trundle
