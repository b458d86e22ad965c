#pragma once
// One place to draw into: a framebuffer of its own size and an OSG view on a scene.

#include <memory>

#include "render/drawing_view.h"
#include "render/image.h"
#include "render/measured.h"
#include "render/outline.h"
#include "render/rich_maps.h"
#include "scene/scene.h"

namespace trundle {

/// How a target is made; one of each is kept and used again.
struct TargetShape {
    std::uint32_t width = 0, height = 0;
    int samples = 1;   ///< per pixel
    bool data = false; ///< numbers in place of colours
    bool rich = false; ///< the look
    auto operator<=>(const TargetShape&) const = default;
};

/// Lives and is used while the context is current.
class Target {
public:
    [[nodiscard]] static Result<std::unique_ptr<Target>> create(GraphicsContext& context, TargetShape shape);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    /// What a picture shows of a scene.
    struct Shot {
        CameraView view;
        std::uint32_t mask = 0;
        OutlineStyle outline;
        SunMap* sun = nullptr; ///< of a rich target
        bool lines = false;    ///< in place of faces, which leave no sky open
        unsigned number = 0;
    };
    /// Marked objects get an outline, in front of whatever hides them.
    [[nodiscard]] Result<Image> draw(Scene& scene, const Shot& shot);
    /// Of a target for data, and of a scene with it.
    [[nodiscard]] Result<Measured> measure(Scene& scene, const CameraView& view, unsigned frame);

private:
    Target(GraphicsContext& context, TargetShape shape);
    [[nodiscard]] Status makeBuffers();
    void aim(const Scene& scene, const CameraView& view);
    [[nodiscard]] std::uint32_t light(Scene& scene, const Shot& shot);
    /// As it lies in the frame, which is the fastest: four values for each pixel, rows from the bottom.
    template <class Value> [[nodiscard]] std::unique_ptr<Value[]> readBack(GLenum type);
    [[nodiscard]] Image readImage();

    GraphicsContext& m_context;
    TargetShape m_shape;
    DrawingView m_view;
    std::unique_ptr<SkyMap> m_sky; // of a rich one
    osg::ref_ptr<osg::StateSet> m_lit = new osg::StateSet;
    // Drawn into; then, where it has several samples for each pixel, resolved into the second.
    GLuint m_frame = 0, m_colour = 0, m_depth = 0, m_resolvedFrame = 0, m_resolvedColour = 0;
};

} // namespace trundle
