#pragma once
// One place to draw into: a framebuffer of its own size and an OSG view on a scene.

#include <memory>

#include <osgUtil/SceneView>

#include "render/graphics_context.h"
#include "render/image.h"
#include "render/measured.h"
#include "render/outline.h"
#include "scene/scene.h"

namespace trundle {

/// How a target is made; one of each is kept and used again.
struct TargetShape {
    std::uint32_t width = 0, height = 0;
    int samples = 1;   ///< per pixel
    bool data = false; ///< numbers in place of colours
    auto operator<=>(const TargetShape&) const = default;
};

/// Lives and is used while the context is current.
class Target {
public:
    [[nodiscard]] static Result<std::unique_ptr<Target>> create(GraphicsContext& context, TargetShape shape);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    /// Marked objects get an outline, in front of whatever hides them.
    [[nodiscard]] Result<Image> draw(Scene& scene, const CameraView& view, std::uint32_t mask, unsigned frame,
                                     const OutlineStyle& outline = {});
    /// Of a target for data, and of a scene with it.
    [[nodiscard]] Result<Measured> measure(Scene& scene, const CameraView& view, unsigned frame);

private:
    Target(GraphicsContext& context, TargetShape shape);
    [[nodiscard]] Status makeBuffers();
    void aim(const Scene& scene, const CameraView& view);
    void pass(osg::Group& root, std::uint32_t mask, const osg::Vec4& background);
    /// Rows from the top, each pixel of so many values.
    template <class Value> [[nodiscard]] std::vector<Value> readBack(GLenum format, GLenum type, std::size_t values);

    GraphicsContext& m_context;
    TargetShape m_shape;
    osg::ref_ptr<osgUtil::SceneView> m_view;
    // Drawn into; then, where it has several samples for each pixel, resolved into the second.
    GLuint m_frame = 0, m_colour = 0, m_depth = 0, m_resolvedFrame = 0, m_resolvedColour = 0;
};

} // namespace trundle
