#pragma once
#include <functional>
#include <string>
#include <vector>

#include <QObject>
#include <QPointF>

namespace trundle {

class Actions;
class View;
class ViewBar;
class ViewGrid;
struct ViewContext;

/// Connects the window's actions to the views, and shows the menu of a view.
class ViewportActions final : public QObject {
    Q_OBJECT
public:
    /// Owned by `views`. All arguments must outlive it.
    ViewportActions(const ViewContext& context, Actions& actions, ViewGrid& views, ViewBar& bar);

private:
    void on(const char* id, const std::function<void()>& work);
    void connectViews();
    void connectTools();
    void connectOverlays();
    void connectPinned();
    void showSettings();
    void showMenu(View& view, const QPointF& at);
    void lookThroughSelectedCamera();
    void askAlign();
    void askDistribute();
    void askArray();
    [[nodiscard]] std::vector<std::string> pathsToPin() const;

    const ViewContext& m_context;
    Actions& m_actions;
    ViewGrid& m_views;
    ViewBar& m_bar;
};

} // namespace trundle
