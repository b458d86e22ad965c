#pragma once
// An OSG view that draws a part of a scene into a framebuffer; used for every pass of an image.

#include <osgUtil/SceneView>

#include "base/result.h"
#include "render/graphics_context.h"

namespace trundle {

/// Must be created, used and destroyed while the context is current.
class DrawingView {
public:
    /// `detail` above 1 selects finer levels of detail by that factor.
    DrawingView(GraphicsContext& context, std::uint32_t width, std::uint32_t height, float detail = 1);
    ~DrawingView();
    DrawingView(const DrawingView&) = delete;
    DrawingView& operator=(const DrawingView&) = delete;

    struct Pass {
        GLuint frame = 0;
        osg::Group& root;
        std::uint32_t mask = ~0u;
        osg::Vec4 background;
        osg::StateSet* state = nullptr; ///< applied over the root's own state; may be null
        unsigned number = 0;
        bool clears = true; ///< the framebuffer first
    };
    void draw(const Pass& pass);
    [[nodiscard]] osg::Camera& camera() { return *m_view->getCamera(); }
    [[nodiscard]] GraphicsContext& context() const { return m_context; }

private:
    GraphicsContext& m_context;
    osg::ref_ptr<osgUtil::SceneView> m_view;
};

} // namespace trundle
