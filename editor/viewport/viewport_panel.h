#pragma once
// The 3D part of the window: one to four views with what belongs to them.

#include <memory>
#include <vector>

#include <QWidget>

#include "editor/viewport/trails.h"
#include "editor/viewport/view.h"
#include "editor/viewport/view_settings.h"

class QLabel;
class QSplitter;
class QPushButton;

namespace trundle {

class Actions;
class PinnedValues;
class RadioOverlays;

/// How a view stands, for the next time.
struct ViewStand {
    ViewKind kind = ViewKind::Perspective;
    CameraView camera;
};

class ViewportPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null where no OpenGL is to be had. All outlive this.
    ViewportPanel(Document& document, Selection& selection, RunSession& session, RenderService* render, Actions& actions,
                  QWidget* parent = nullptr);
    ~ViewportPanel() override;

    /// 1, 2 or 4.
    void setViewCount(int count);
    [[nodiscard]] int viewCount() const { return m_shown; }
    /// Those shown, and the one that keys and menus mean.
    [[nodiscard]] View& view(int index) { return *m_views[std::size_t(index)]; }
    [[nodiscard]] View& current() { return *m_current; }
    [[nodiscard]] ViewSettings& settings() { return m_settings; }
    [[nodiscard]] ShownWorld& world() { return *m_world; }
    [[nodiscard]] RadioOverlays& radios() { return *m_radios; }
    [[nodiscard]] PinnedValues& pinned() { return *m_pinned; }
    /// "perspective", "top", "chase" ..., or the name of a View of the experiment: the current view. False where there is none of that name.
    bool showView(const QString& name);
    /// Of all four, whether they are shown or not.
    [[nodiscard]] std::vector<ViewStand> stands() const;
    /// So many are shown. What was just opened is not framed then.
    void setStands(const std::vector<ViewStand>& stands, int shown);
    /// Every visible view shows what is now.
    [[nodiscard]] bool isUpToDate() const;
    /// And as fine as it will be while all stands still: the time for a picture of the window.
    [[nodiscard]] bool isSettled() const;
    /// The current view looks through the first camera that a path of the selection means.
    void lookThrough(const std::string& path);

public Q_SLOTS:
    void frameSelection();
    void frameAll();
    /// Objects that the views leave out, or do not let the mouse take.
    void setHidden(const std::vector<std::string>& paths);
    void setLocked(const std::vector<std::string>& paths);

protected:
    void resizeEvent(QResizeEvent*) override;
    void showEvent(QShowEvent*) override;

private:
    void placeBanner();
    void makeViews(RenderService* render);
    void connectActions();
    void connectOverlays();
    void connectPinned();
    void showBanner();
    void showMenu(View& view, const QPointF& at);
    void lookThroughSelected();
    void askAlign();
    void askDistribute();
    void askArray();
    void keepDrivenInSight();
    void setCurrent(View& view);
    void setKind(ViewKind kind);
    void showTools();

    Document& m_document;
    Selection& m_selection;
    RunSession& m_session;
    Actions& m_actions;
    ViewSettings m_settings;
    std::unique_ptr<Measurement> m_measurement;
    std::unique_ptr<ShownWorld> m_world;
    std::unique_ptr<Trails> m_trails;
    std::unique_ptr<RadioOverlays> m_radios;
    std::unique_ptr<PinnedValues> m_pinned;
    std::unique_ptr<ViewParts> m_parts;
    std::vector<View*> m_views;
    View* m_current = nullptr;
    QSplitter *m_columns = nullptr, *m_left = nullptr, *m_right = nullptr;
    QWidget* m_banner = nullptr;
    QLabel* m_bannerText = nullptr;
    QPushButton* m_bannerButton = nullptr;
    std::string m_inTheWay;
    int m_shown = 1;
    bool m_toBeFramed = true, m_frameWhenShown = false;
    bool m_pinsOfOther = false; // another experiment was opened, and its text is not shown yet
};

} // namespace trundle
