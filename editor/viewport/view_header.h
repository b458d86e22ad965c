#pragma once
#include <QToolBar>

class QMenu;
class QToolButton;

namespace trundle {

class Actions;
class View;
class ViewSettings;
enum class ViewKind;

/// Words that menus and tooltips use.
[[nodiscard]] QString viewKindName(ViewKind kind);

/// In a corner of each view: which way it looks, as a menu.
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

/// The bar over the views: axes of the handles, steps of moves, overlays, how many views. Where it is narrow, what has
/// no room goes into the menu at its end.
class ViewBar final : public QToolBar {
    Q_OBJECT
public:
    ViewBar(ViewSettings& settings, Actions& actions, QWidget* parent = nullptr);
    /// The steps of moves and turns, to be typed.
    void openSteps();

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitFont();
    QAction* addMenuButton(const char* name, const QString& tip, QMenu* menu);
    void showSettings();
    ViewSettings& m_settings;
    QAction *m_axes, *m_steps;
};

} // namespace trundle
