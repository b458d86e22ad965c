#pragma once
// Mouse and keyboard of a user of the whole window: menus, buttons, rows of the tree, points of the 3D view, drags.

#include <string>

#include <QPointF>
#include <QStringList>

#include <trundle/geometry.h>

class QAbstractItemView;
class QModelIndex;
class QWidget;

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
    /// Presses at one place of the current view, moves in steps to another one, and releases there. Pixels of the view.
    void dragPixels(const QPointF& from, const QPointF& to) const;
    void dragPoints(const Vec3& from, const Vec3& to) const; ///< of W
    [[nodiscard]] QPointF pixelOf(const Vec3& point) const;  ///< of W, in the current view
    /// Drags an item of the Library, found by its title, to a point of W in the current view.
    [[nodiscard]] bool dragToPoint(const QString& item, const Vec3& point) const;

    /// The next file dialog gets this path typed into its name, and Enter. To be called before what opens it, which may wait for it.
    void answerFileDialog(const QString& path) const;
    /// Selects what is in a line edit and types over it.
    static void typeOver(QWidget* line, const QString& text);

private:
    MainWindow& m_window;
};

} // namespace trundle
