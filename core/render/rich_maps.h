#pragma once
// Textures that the rich look renders before the image: the sun's shadow map, and ambient occlusion per pixel.

#include <memory>
#include <optional>

#include <osg/FrameBufferObject>
#include <osg/Texture2D>

#include "render/drawing_view.h"
#include "scene/scene.h"

namespace trundle {

/// Texture units of the maps.
inline constexpr unsigned kSunTestUnit = 3, kSunDepthUnit = 4, kSkyUnit = 5, kMapUnit = 6;

inline constexpr float kRichDetail = 2; ///< level-of-detail factor for rich images

/// Shadow map of the sun. One map serves all images of similar size and is redrawn for each.
class SunMap {
public:
    /// `pixels` along each side.
    [[nodiscard]] static Result<std::unique_ptr<SunMap>> create(GraphicsContext& context, std::uint32_t pixels);
    ~SunMap();

    /// Draws the casters that matter for an image of that size and sets the uniforms of `lit`; removes those of the previous
    /// image.
    void draw(Scene& scene, const CameraView& view, std::uint32_t width, std::uint32_t height, std::uint32_t mask,
              unsigned number, osg::StateSet& lit);

private:
    SunMap(GraphicsContext& context, std::uint32_t pixels);
    DrawingView m_view;
    std::uint32_t m_pixels;
    osg::ref_ptr<osg::Texture2D> m_tests, m_depths;
    osg::ref_ptr<osg::FrameBufferObject> m_frame = new osg::FrameBufferObject;
};

/// Ambient occlusion (visible fraction of the sky) for each pixel of a target.
class SkyMap {
public:
    [[nodiscard]] static Result<std::unique_ptr<SkyMap>> create(GraphicsContext& context, std::uint32_t width,
                                                                std::uint32_t height);
    ~SkyMap();

    /// Draws the map for the view of `camera`, with the floors selected by `mask`, and sets the uniforms of `lit`.
    void draw(Scene& scene, const osg::Camera& camera, std::uint32_t mask, unsigned number, osg::StateSet& lit);

private:
    SkyMap(GraphicsContext& context, std::uint32_t width, std::uint32_t height);
    DrawingView m_view;
    osg::ref_ptr<osg::Texture2D> m_faces, m_opened, m_sky;
    osg::ref_ptr<osg::FrameBufferObject> m_facesFrame = new osg::FrameBufferObject, m_openedFrame = new osg::FrameBufferObject,
                                         m_skyFrame = new osg::FrameBufferObject;
    osg::ref_ptr<osg::Group> m_whole; // one triangle over all pixels
};

} // namespace trundle
