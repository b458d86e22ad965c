#pragma once
#include <QWidget>

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
    void show();
    View& m_view;
    QToolButton* m_button;
};

/// The bar over the views: axes of the handles, snapping and its steps, overlays, how many views.
class ViewBar final : public QWidget {
    Q_OBJECT
public:
    ViewBar(ViewSettings& settings, Actions& actions, QWidget* parent = nullptr);
    /// The steps of moves and turns, to be typed.
    void openSteps();

private:
    void showSettings();
    ViewSettings& m_settings;
    QToolButton *m_axes, *m_steps;
};

} // namespace trundle
