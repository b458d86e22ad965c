#pragma once
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>

namespace trundle {

/// Which objects are hidden in the viewports and which are locked against mouse edits. Marks are view state: they are part
/// of neither the texts nor the history. A mark on an object applies to everything inside it.
class ObjectMarks final : public QObject {
    Q_OBJECT
public:
    using Paths = std::set<std::string, std::less<>>;
    using QObject::QObject;

    /// Whether the object or one that contains it is marked: "robot0.chassis" if "robot0" is. For a member of a Grid or Scatter
    /// only its own name is checked; check the Grid's as well.
    [[nodiscard]] bool isHidden(std::string_view path) const { return holds(m_hidden, path); }
    [[nodiscard]] bool isLocked(std::string_view path) const { return holds(m_locked, path); }
    [[nodiscard]] const Paths& hidden() const { return m_hidden; } ///< as set, without nested objects
    [[nodiscard]] const Paths& locked() const { return m_locked; }

    void setHidden(const std::vector<std::string>& paths, bool hidden);
    void setLocked(const std::vector<std::string>& paths, bool locked);
    void showAll();
    /// Moves the marks of a renamed object and of objects inside it.
    void rename(const std::string& from, const std::string& to);
    void clear();

Q_SIGNALS:
    void hiddenChanged();
    void lockedChanged();

private:
    [[nodiscard]] static bool holds(const Paths& marks, std::string_view path);
    Paths m_hidden, m_locked;
};

} // namespace trundle
