#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <QMap>
#include <QMenu>

namespace trundle {

/// Arrangements of the docks, each saved in the settings.
enum class Layout { Edit, Run };

[[nodiscard]] QString nameOf(Layout layout);

/// The docks of a window and their arrangement.
class Layouts final : public QObject {
    Q_OBJECT
public:
    explicit Layouts(QMainWindow& window);

    /// Adds a dock, hidden until setShown(). Docks are identified by their panel's object name: "scene", "properties" ...
    QDockWidget* add(QWidget* panel, const QString& title);
    [[nodiscard]] QDockWidget* dock(const QString& name) const { return m_docks.value(name); }
    void use(Layout layout);
    void resetCurrent();
    void save() const;
    void disableSettings() { m_savesSettings = false; } ///< save() does nothing from now on
    [[nodiscard]] Layout current() const { return m_layout; }
    /// Restores the docks, or hides them all, as initially and on the Welcome page.
    void setShown(bool shown);
    /// Shows a dock and raises it. On the Welcome page only the guide can be shown.
    void raise(const QString& name);
    /// The same; the answer is the name of the dock that was in front there, maybe this one. Empty: all there were hidden.
    QString raiseOver(const QString& name);
    [[nodiscard]] bool isInFront(const QString& name) const; ///< not behind another tab, not hidden
    /// Shows and hides each dock; disabled while setShown(false).
    [[nodiscard]] QMenu* menu() const { return m_menu; }
    /// "Show Console" ...: actions that raise a dock, for the command palette.
    [[nodiscard]] QList<QAction*> raising() const { return m_raising; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void arrange(Layout layout);
    void sizeDocks();
    void recordWidths();
    void widenDocks();
    [[nodiscard]] QDockWidget* widestIn(Qt::DockWidgetArea area) const;
    void restore();
    void showTitles();

    QMainWindow& m_window;
    QMenu* m_menu;
    QMap<QString, QDockWidget*> m_docks;
    QList<QAction*> m_raising;
    Layout m_layout = Layout::Edit;
    QMap<Qt::DockWidgetArea, int> m_widths; // of the docks at the sides, as they were chosen: a small window narrows them
    bool m_shown = false, m_savesSettings = true;
};

} // namespace trundle
