#pragma once
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>

namespace trundle {

/// Which objects the views leave out and which they do not let the mouse take. Marks are for looking and working: they are in
/// no file and in no history. A mark on an object holds for all that is in it.
class ObjectMarks final : public QObject {
    Q_OBJECT
public:
    using Paths = std::set<std::string, std::less<>>;
    using QObject::QObject;

    /// Of itself or of something it is in: "robot0.chassis" where "robot0" is. A member of a Grid or Scatter has the marks of
    /// its own name only; ask for the Grid's as well.
    [[nodiscard]] bool isHidden(std::string_view path) const { return holds(m_hidden, path); }
    [[nodiscard]] bool isLocked(std::string_view path) const { return holds(m_locked, path); }
    [[nodiscard]] const Paths& hidden() const { return m_hidden; } ///< as set, without what is in them
    [[nodiscard]] const Paths& locked() const { return m_locked; }

    void setHidden(const std::vector<std::string>& paths, bool hidden);
    void setLocked(const std::vector<std::string>& paths, bool locked);
    void showAll();
    /// An object has another name now: its marks and those in it go along.
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
