#pragma once
// Mouse and keyboard of a user of the whole window: menus, buttons, rows of the tree, points of the 3D view, drags.

#include <string>

#include <QStringList>

#include <trundle/geometry.h>

class QAbstractItemView;
class QModelIndex;

namespace trundle {

class MainWindow;

class WindowHand {
public:
    explicit WindowHand(MainWindow& window) : m_window(window) {}

    /// Clicks through the menu bar: {"File", "New", "Empty File"}. False if an entry is missing or disabled.
    [[nodiscard]] bool choose(const QStringList& entries) const;
    /// Clicks a visible button of that object name.
    [[nodiscard]] bool press(const char* button) const;
    /// Clicks the row of an object in the Scene tree.
    [[nodiscard]] bool clickRow(const std::string& path) const;
    void key(int key, Qt::KeyboardModifiers modifiers = {}) const; ///< in the widget that has the focus
    void keyDown(int key) const;
    void keyUp(int key) const;

    /// Puts the camera of the current view at `eye`, looking at `target` (W, m): a test of placing starts from a known view.
    void look(const Vec3& eye, const Vec3& target) const;
    void clickPoint(const Vec3& point) const; ///< of W, in the current view
    /// Drags an item of the Library, found by its title, to a point of W in the current view.
    [[nodiscard]] bool dragToPoint(const QString& item, const Vec3& point) const;

private:
    MainWindow& m_window;
};

} // namespace trundle
