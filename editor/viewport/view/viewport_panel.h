#pragma once
// The viewport panel: one to four 3D views and their shared state.

#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/overlays/trails.h"
#include "editor/viewport/view/view.h"

class QLabel;
class QSplitter;
class QPushButton;

namespace trundle {

struct LoadedProject;
class Actions;
class PinnedValues;
class RadioOverlays;

/// Saved state of a view.
struct ViewState {
    ViewKind kind = ViewKind::Perspective;
    CameraView camera;
};

class ViewportPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null without OpenGL. All arguments must outlive this object.
    ViewportPanel(Document& document, Selection& selection, RunSession& session, RenderService* render, Actions& actions,
                  QWidget* parent = nullptr);
    ~ViewportPanel() override;

    /// Number of visible views, 1 to 4.
    void setViewCount(int count);
    [[nodiscard]] int viewCount() const { return m_shown; }
    /// One of the four views, visible or not; current() is the one that keys and menus apply to.
    [[nodiscard]] View& view(int index) { return *m_views[std::size_t(index)]; }
    [[nodiscard]] View& current() { return *m_current; }
    [[nodiscard]] ViewSettings& settings() { return m_settings; }
    [[nodiscard]] ViewportScene& world() { return *m_world; }
    [[nodiscard]] RadioOverlays& radios() { return *m_radios; }
    [[nodiscard]] PinnedValues& pinned() { return *m_pinned; }
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
    /// True if, in addition, no refinement is pending; used for screenshots of the window.
    [[nodiscard]] bool isSettled() const;
    /// Lets the current view look through the first camera that the path refers to.
    void lookThrough(const std::string& path);

public Q_SLOTS:
    void frameSelection();
    void frameAll();
    /// Objects that are not drawn, or that cannot be selected with the mouse.
    void setHidden(const std::vector<std::string>& paths);
    void setLocked(const std::vector<std::string>& paths);

protected:
    void resizeEvent(QResizeEvent*) override;
    void showEvent(QShowEvent*) override;

private:
    void placeBanner();
    void makeViews(RenderService* render);
    void makeBanner();
    void connectBanner();
    void connectFraming();
    void connectActions();
    void connectOverlays();
    void connectPinned();
    void showBanner();
    void showMenu(View& view, const QPointF& at);
    void lookThroughSelectedCamera();
    void askAlign();
    void askDistribute();
    void askArray();
    void followDrivenRobot();
    void setCurrent(View& view);
    void setKind(ViewKind kind);
    void showTools();

    Document& m_document;
    Selection& m_selection;
    RunSession& m_session;
    Actions& m_actions;
    ViewSettings m_settings;
    std::unique_ptr<Measurement> m_measurement;
    std::unique_ptr<ViewportScene> m_world;
    std::unique_ptr<Trails> m_trails;
    std::unique_ptr<RadioOverlays> m_radios;
    std::unique_ptr<PinnedValues> m_pinned;
    std::unique_ptr<ViewContext> m_context;
    std::vector<View*> m_views;
    View* m_current = nullptr;
    QSplitter *m_columns = nullptr, *m_left = nullptr, *m_right = nullptr;
    QWidget* m_banner = nullptr;
    QLabel* m_bannerText = nullptr;
    QPushButton* m_bannerButton = nullptr;
    std::string m_blockingLayout;
    int m_shown = 1;
    bool m_toBeFramed = true, m_frameWhenShown = false;
    std::shared_ptr<const LoadedProject> m_pinsIn; // texts without errors in which the pins' paths were last valid
    bool m_pinsOfOther = false;                    // another experiment was opened, but is not displayed yet
};

} // namespace trundle
