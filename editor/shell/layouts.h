#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <QMap>
#include <QMenu>

namespace trundle {

/// What the window is used for: each has its own arrangement of docks, kept in the settings.
enum class Layout { Edit, Run };

[[nodiscard]] QString nameOf(Layout layout);

/// The docks of a window and where they stand.
class Layouts final : public QObject {
    Q_OBJECT
public:
    explicit Layouts(QMainWindow& window);

    /// Adds a dock, hidden until setShown(). Docks are known by the object names of their panels: "scene", "properties" ...
    QDockWidget* add(QWidget* panel, const QString& title);
    [[nodiscard]] QDockWidget* dock(const QString& name) const { return m_docks.value(name); }
    void use(Layout layout);
    void resetCurrent();
    void save() const;
    void leaveNoTrace() { m_leavesTraces = false; } ///< save() does nothing from now on
    [[nodiscard]] Layout current() const { return m_layout; }
    /// The docks as they were last, or all away, as at first and on the Welcome page.
    void setShown(bool shown);
    /// Brings a dock to the front, wherever it is. On the Welcome page there is only the guide.
    void raise(const QString& name);
    /// Shows and hides each dock; of no use while setShown() keeps them away.
    [[nodiscard]] QMenu* menu() const { return m_menu; }
    /// "Show Console" ...: each brings a dock to the front, for who looks for it by its name.
    [[nodiscard]] QList<QAction*> raising() const { return m_raising; }

private:
    void arrange(Layout layout);
    void sizeDocks();
    void restore();
    void showTitles();

    QMainWindow& m_window;
    QMenu* m_menu;
    QMap<QString, QDockWidget*> m_docks;
    QList<QAction*> m_raising;
    Layout m_layout = Layout::Edit;
    bool m_shown = false, m_leavesTraces = true;
};

} // namespace trundle
