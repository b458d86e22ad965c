#pragma once
#include <span>

#include <QToolBar>

class QMenu;
class QToolButton;

namespace trundle {

class Actions;
class View;
class ViewSettings;
enum class ViewKind;

/// Name of a view kind for menus and tooltips.
[[nodiscard]] QString viewKindName(ViewKind kind);

/// Menu button in the corner of each view: its viewing direction.
class ViewCorner final : public QWidget {
    Q_OBJECT
public:
    explicit ViewCorner(View& view);

private:
    void addNamedViews(QMenu& menu);
    void show();
    View& m_view;
    QToolButton* m_button;
};

/// Toolbar above the views: axes of the gizmo, snapping steps, overlays, number of views. In a narrow window the items that do
/// not fit move to an overflow menu.
class ViewBar final : public QToolBar {
    Q_OBJECT
public:
    ViewBar(ViewSettings& settings, Actions& actions, QWidget* parent = nullptr);
    /// Opens the menu for typing the move and rotation steps.
    void openSteps();

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitFont();
    QMenu* menuOf(Actions& actions, std::span<const char* const> ids);
    QMenu* makeAxesMenu();
    QMenu* makeStepsMenu(); ///< with boxes for the steps
    QAction* addMenuButton(const char* name, const QString& tip, QMenu* menu);
    void showSettings();
    ViewSettings& m_settings;
    QAction *m_axes, *m_steps;
};

} // namespace trundle
