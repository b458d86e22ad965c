#pragma once
// One to four 3D views, side by side. Keys and menus apply to the current one.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <QSplitter>

#include "editor/viewport/view/auto_framing.h"
#include "editor/viewport/view/view.h"

namespace trundle {

/// Saved state of a view.
struct ViewState {
    ViewKind kind = ViewKind::Perspective;
    CameraView camera;
    std::string named; ///< the View block that it shows; empty: none
};

class ViewGrid final : public QSplitter {
    Q_OBJECT
public:
    explicit ViewGrid(const ViewContext& context); ///< must outlive this widget

    /// Number of visible views, 1 to 4.
    void setViewCount(int count);
    [[nodiscard]] int viewCount() const { return m_shown; }
    /// One of the four views, visible or not; current() is the one that keys and menus apply to.
    [[nodiscard]] View& view(int index) { return *m_views[std::size_t(index)]; }
    [[nodiscard]] View& current() { return *m_current; }
    /// Where a new object is expected: what is in the middle of the current view (W). Nothing while no view is visible.
    [[nodiscard]] std::optional<Vec3> insertionPoint() const;
    /// Sets the current view: "perspective", "top", "chase" ..., or the name of a View block. False if the name is unknown.
    bool showView(const QString& name);
    /// Of all four views, visible or not.
    [[nodiscard]] std::vector<ViewState> viewStates() const;
    /// `shown`: number of visible views. Prevents the automatic framing of a newly opened document.
    void setViewStates(const std::vector<ViewState>& viewStates, int shown);
    /// True if every visible view shows the current state.
    [[nodiscard]] bool isUpToDate() const;
    /// True if, in addition, no refinement is pending.
    [[nodiscard]] bool isSettled() const;
    /// Lets the current view look through the first camera that the path refers to.
    void lookThrough(const std::string& path);

    void frameSelection();
    void frameAll();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeViews();
    void connectFraming();
    void showModel();
    void startAgain();
    void frameNew();
    void showAll(bool atOnce);
    void leaveFollowedRobot();
    void followDrivenRobot();
    void setCurrent(View& view);

    const ViewContext& m_context;
    QSplitter *m_left, *m_right;
    AutoFraming m_autoFraming;
    std::vector<View*> m_views;
    View* m_current = nullptr;
    int m_shown = 1;
    std::array<bool, 4> m_awaitsFraming{}; // newly shown
    bool m_awaitsFiles = false;            // framed before its meshes were read
    bool m_isNew = false;                  // the document was opened, its scene is not there yet
    bool m_toBeFramed = true, m_frameWhenShown = false;
    std::vector<ViewState> m_experimentViews; // while the edited model is shown: the views of the experiment
};

} // namespace trundle
