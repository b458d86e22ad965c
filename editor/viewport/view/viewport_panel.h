#pragma once
// The viewport panel: the 3D views, the bar above them, and what all views share.

#include <memory>

#include <QWidget>

#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/overlays/trails.h"
#include "editor/viewport/view/view_grid.h"

namespace trundle {

class Actions;
class FloorDrawing;
class PinnedValues;
class RadioOverlays;
class ViewBanner;

class ViewportPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null without OpenGL. All arguments must outlive this object.
    ViewportPanel(Document& document, Selection& selection, RunSession& session, RenderService* render, Actions& actions,
                  QWidget* parent = nullptr);
    ~ViewportPanel() override;

    [[nodiscard]] ViewGrid& views() { return *m_views; }
    [[nodiscard]] ViewSettings& settings() { return m_settings; }
    [[nodiscard]] ViewportScene& world() { return *m_world; }
    [[nodiscard]] RadioOverlays& radios() { return *m_radios; }
    [[nodiscard]] PinnedValues& pinned() { return *m_pinned; }
    /// True if everything visible is up to date and refined; used for screenshots of the window.
    [[nodiscard]] bool isSettled() const;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void updateBanner();
    void placeBanner();

    ViewSettings m_settings;
    std::unique_ptr<Measurement> m_measurement;
    std::unique_ptr<ViewportScene> m_world;
    std::unique_ptr<Trails> m_trails;
    std::unique_ptr<RadioOverlays> m_radios;
    std::unique_ptr<PinnedValues> m_pinned;
    std::unique_ptr<FloorDrawing> m_drawing;
    std::unique_ptr<ViewContext> m_context;
    ViewGrid* m_views = nullptr;
    ViewBanner* m_banner = nullptr;
};

} // namespace trundle
