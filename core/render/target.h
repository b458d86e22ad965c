#pragma once
// A render target: a framebuffer of its own size and an OSG view of a scene.

#include <memory>

#include "render/backgrounds.h"
#include "render/data_image.h"
#include "render/drawing_view.h"
#include "render/image.h"
#include "render/rich_maps.h"
#include "render/selection_outline.h"
#include "scene/scene.h"

namespace trundle {

/// Properties of a target; one target of each shape is cached.
struct TargetShape {
    std::uint32_t width = 0, height = 0;
    int samples = 1;   ///< per pixel
    bool data = false; ///< depths and object numbers instead of colours
    bool rich = false; ///< rich look
    bool deep = false; ///< colours beyond white are kept until the picture is exposed
    auto operator<=>(const TargetShape&) const = default;
};

/// Must be created, used and destroyed while the context is current.
class Target {
public:
    [[nodiscard]] static Result<std::unique_ptr<Target>> create(GraphicsContext& context, TargetShape shape);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    /// One image request for a scene.
    struct DrawRequest {
        CameraView view;
        std::uint32_t mask = 0;
        OutlineStyle outline;
        SunMap* sun = nullptr; ///< only for a rich target
        bool lines = false;    ///< wireframe; ambient occlusion is skipped
        unsigned number = 0;
        SceneId scene = SceneId::None;
        bool floorLines = true;
        double exposure = 1; ///< other than 1 only for a deep target
        std::vector<std::string> hidden;
    };
    /// Marked objects get an outline, drawn over any occluder.
    [[nodiscard]] Result<Image> draw(Scene& scene, const DrawRequest& drawRequest);
    /// For a data target, and a scene with makeData() called.
    [[nodiscard]] Result<DataImage> measure(Scene& scene, const CameraView& view, unsigned frame);

private:
    Target(GraphicsContext& context, TargetShape shape);
    [[nodiscard]] Status makeBuffers();
    void aim(const Scene& scene, const CameraView& view);
    [[nodiscard]] std::uint32_t light(Scene& scene, const DrawRequest& drawRequest);
    void drawInTwo(Scene& scene, const DrawRequest& drawRequest);
    /// Pixels in framebuffer layout, which is the fastest: four values per pixel, rows from the bottom.
    template <class Value> [[nodiscard]] std::unique_ptr<Value[]> readBack(GLenum type);
    [[nodiscard]] Image readImage();
    [[nodiscard]] Image readExposed(double exposure);

    GraphicsContext& m_context;
    TargetShape m_shape;
    DrawingView m_view;
    std::unique_ptr<SkyMap> m_sky;              // only for a rich target
    std::unique_ptr<Backgrounds> m_backgrounds; // only for the fast look with one sample per pixel, in llvmpipe
    osg::ref_ptr<osg::StateSet> m_lit = new osg::StateSet;
    // Framebuffer to draw into, and, with several samples per pixel, a second one for the resolved image.
    GLuint m_frame = 0, m_colour = 0, m_depth = 0, m_resolvedFrame = 0, m_resolvedColour = 0;
};

} // namespace trundle
