#pragma once
// A view that draws a part of a scene into a framebuffer; all passes of a picture are made with these.

#include <osgUtil/SceneView>

#include "base/result.h"
#include "render/graphics_context.h"

namespace trundle {

/// Lives and is used while the context is current.
class DrawingView {
public:
    /// `detail` above 1: round things are cut so much more finely.
    DrawingView(GraphicsContext& context, std::uint32_t width, std::uint32_t height, float detail = 1);
    ~DrawingView();
    DrawingView(const DrawingView&) = delete;
    DrawingView& operator=(const DrawingView&) = delete;

    struct Pass {
        GLuint frame = 0;
        osg::Group& root;
        std::uint32_t mask = ~0u;
        osg::Vec4 background;
        osg::StateSet* state = nullptr; ///< over the root's own; may be null
        unsigned number = 0;
    };
    void draw(const Pass& pass);
    [[nodiscard]] osg::Camera& camera() { return *m_view->getCamera(); }
    [[nodiscard]] GraphicsContext& context() const { return m_context; }

private:
    GraphicsContext& m_context;
    osg::ref_ptr<osgUtil::SceneView> m_view;
};

} // namespace trundle
