#pragma once
// What the rich look knows of the light before it draws: how far the sun reaches, and how open to the sky each pixel is.

#include <memory>
#include <optional>

#include <osg/FrameBufferObject>
#include <osg/Texture2D>

#include "render/drawing_view.h"
#include "scene/scene.h"

namespace trundle {

/// Where a map stands among the textures.
inline constexpr unsigned kSunTestUnit = 3, kSunDepthUnit = 4, kSkyUnit = 5, kMapUnit = 6;

inline constexpr float kRichDetail = 2; ///< of all that is drawn for a rich picture

/// Distances from the sun. One for all pictures of about one size, drawn anew for each.
class SunMap {
public:
    /// Of so many pixels along each side.
    [[nodiscard]] static Result<std::unique_ptr<SunMap>> create(GraphicsContext& context, std::uint32_t pixels);
    ~SunMap();

    /// Draws what matters to a picture of that size, and has `lit` tell the programs; what it told of another picture is taken back.
    void draw(Scene& scene, const CameraView& view, std::uint32_t width, std::uint32_t height, std::uint32_t mask,
              unsigned number, osg::StateSet& lit);

private:
    SunMap(GraphicsContext& context, std::uint32_t pixels);
    DrawingView m_view;
    std::uint32_t m_pixels;
    osg::ref_ptr<osg::Texture2D> m_tests, m_depths;
    osg::ref_ptr<osg::FrameBufferObject> m_frame = new osg::FrameBufferObject;
};

/// What of the sky the pixels of one target see.
class SkyMap {
public:
    [[nodiscard]] static Result<std::unique_ptr<SkyMap>> create(GraphicsContext& context, std::uint32_t width,
                                                                std::uint32_t height);
    ~SkyMap();

    /// Draws it as `camera` looks, with the floors where `mask` has them, and has `lit` tell the programs.
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
