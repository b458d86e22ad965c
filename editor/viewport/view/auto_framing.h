#pragma once
#include <map>
#include <optional>

#include "editor/viewport/context/view_context.h"
#include "scene/queries/camera_view.h"
#include "scene/shapes/bounds.h"

namespace trundle {

class View;

/// Widens a view that the program framed when the last robot leaves its picture, until the user moves the view.
class AutoFraming {
public:
    explicit AutoFraming(const ViewContext& context) : m_context(context) {}

    /// The program has just framed it.
    void watch(const View& view);
    /// For the poses that are shown now.
    void update(View& view);
    void leave() { m_watched.clear(); }

private:
    struct Watched {
        CameraView camera; ///< that it was given
        Bounds robots;     ///< where they were at all framings
    };
    [[nodiscard]] Bounds robots() const;
    [[nodiscard]] bool showsRobot(const View& view) const;

    const ViewContext& m_context;
    std::map<const View*, Watched> m_watched;
};

} // namespace trundle
