#pragma once
// Fixture: a document, its run and the panel with the 3D views, connected as in the main window.

#include <memory>

#include <QByteArray>
#include <QTemporaryDir>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/actions.h"
#include "render/service.h"

namespace trundle {

/// One robot on the floor of a walled room, seen from above and in front. 900 x 700 pixels.
struct ViewWindow {
    /// The tests of one program share the render service.
    explicit ViewWindow(RenderService* render);
    ~ViewWindow();

    /// Opens a text in a file beside the configs, or one of the samples.
    bool open(const QByteArray& text);
    bool openSample(const char* name);
    [[nodiscard]] QByteArray text() const; ///< of the opened file

    [[nodiscard]] View& view() { return panel->views().current(); }
    /// Puts the camera at `eye`, looking at `target` (both in W).
    void look(const Vec3& eye, const Vec3& target);
    [[nodiscard]] QPoint at(const Vec3& point); ///< the pixel of a point in W
    void trigger(const char* action) { actions.at(action).trigger(); }

    void move(const QPointF& to, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButtons buttons = Qt::NoButton);
    void press(const QPointF& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {});
    void release(const QPointF& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {});
    void click(const QPointF& at, Qt::KeyboardModifiers modifiers = {});
    void drag(const QPointF& from, const QPointF& to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {});
    void key(int key, Qt::KeyboardModifiers modifiers = {});
    void type(const QString& text);

    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    RunSession session{document, *application};
    Actions actions;
    std::unique_ptr<ViewportPanel> panel;
    std::vector<QString> refusals;
};

inline const QByteArray kRoom = R"(Tick = 0.01
#import robots/simple_robot.sim
#import arenas/medium_arena.sim
Static arena { Config=MediumArena Pos=0,0,0 }
Robot robot0 { Config=SimpleRobot Pos=-0.5,0,0 HPR=0,0,0 } // the first
Robot robot1 { Config=SimpleRobot Pos=0.5,0.3,0 HPR=0,0,0 }
)";

} // namespace trundle
