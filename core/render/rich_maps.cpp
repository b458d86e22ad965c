#include "render/rich_maps.h"

#include <osg/GLExtensions>
#include <osg/Geometry>

#include "scene/nodes/surroundings.h"
#include "scene/queries/sun_fit.h"

namespace trundle {
namespace {

constexpr GLint kOneFloat = 0x822E, kTwoHalves = 0x822F, kFourFloats = 0x8814; // R32F, RG16F, RGBA32F
constexpr GLenum kRed = 0x1903, kRedGreen = 0x8227;
constexpr float kOpenReach = 0.3f; // m

osg::ref_ptr<osg::Texture2D> mapOf(std::uint32_t width, std::uint32_t height, GLint format, GLenum source, GLenum type) {
    osg::ref_ptr<osg::Texture2D> map = new osg::Texture2D;
    map->setTextureSize(int(width), int(height));
    map->setInternalFormat(format);
    map->setSourceFormat(source);
    map->setSourceType(type);
    map->setResizeNonPowerOfTwoHint(false);
    for (const auto which : {osg::Texture::MIN_FILTER, osg::Texture::MAG_FILTER}) map->setFilter(which, osg::Texture::NEAREST);
    for (const auto which : {osg::Texture::WRAP_S, osg::Texture::WRAP_T}) map->setWrap(which, osg::Texture::CLAMP_TO_EDGE);
    return map;
}

/// Creates all attachments; an Error if the framebuffer is not complete.
Status complete(GraphicsContext& context, osg::FrameBufferObject& frame, const osg::Texture2D& map) {
    osg::State& state = *context.getState();
    state.setActiveTextureUnit(kMapUnit);
    frame.apply(state);
    state.haveAppliedTextureAttribute(kMapUnit, &map); // attaching it has bound it
    const bool whole =
        state.get<osg::GLExtensions>()->glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
    if (glGetError() == GL_NO_ERROR && whole) return {};
    return Error{Code::PictureFailed, "no map of " + std::to_string(map.getTextureWidth()) + " x " +
                                          std::to_string(map.getTextureHeight()) + " for shadows can be drawn into"};
}

GLuint idOf(const osg::FrameBufferObject& frame, const DrawingView& view) {
    return frame.getHandle(view.context().getState()->getContextID());
}

} // namespace

SunMap::SunMap(GraphicsContext& context, std::uint32_t pixels)
    : m_view(context, pixels, pixels, kRichDetail), m_pixels(pixels),
      m_tests(mapOf(pixels, pixels, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT)),
      m_depths(mapOf(pixels, pixels, kOneFloat, kRed, GL_FLOAT)) {
    // Outside the map nothing occludes the sun.
    for (osg::Texture2D* map : {m_tests.get(), m_depths.get()}) {
        for (const auto which : {osg::Texture::WRAP_S, osg::Texture::WRAP_T}) map->setWrap(which, osg::Texture::CLAMP_TO_BORDER);
        map->setBorderColor(osg::Vec4d(1, 1, 1, 1));
    }
    for (const auto which : {osg::Texture::MIN_FILTER, osg::Texture::MAG_FILTER}) m_tests->setFilter(which, osg::Texture::LINEAR);
    m_tests->setShadowComparison(true);
    m_tests->setShadowCompareFunc(osg::Texture::LEQUAL);
    m_frame->setAttachment(osg::Camera::COLOR_BUFFER, osg::FrameBufferAttachment(m_depths.get()));
    m_frame->setAttachment(osg::Camera::DEPTH_BUFFER, osg::FrameBufferAttachment(m_tests.get()));
}

Result<std::unique_ptr<SunMap>> SunMap::create(GraphicsContext& context, std::uint32_t pixels) {
    std::unique_ptr<SunMap> map(new SunMap(context, pixels));
    if (const Status made = complete(context, *map->m_frame, *map->m_depths); !made) return made.error();
    return map;
}

SunMap::~SunMap() {
    osg::State* state = m_view.context().getState();
    m_frame->releaseGLObjects(state);
    for (osg::Texture2D* map : {m_tests.get(), m_depths.get()}) map->releaseGLObjects(state);
}

void SunMap::draw(Scene& scene, const CameraView& view, std::uint32_t width, std::uint32_t height, std::uint32_t mask,
                  unsigned number, osg::StateSet& lit) {
    lit.removeDefine("SUN_MAP");
    const std::optional<SunFit> fit = fitSun(scene.sun(), scene.sunCasters(), view, width, height, m_pixels);
    if (!fit) return;
    osg::Matrixd place; // row-vector convention of OSG
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) place(column, row) = fit->axes(row, column);
    const Vec3 top = fit->axes.col(2) * fit->origin.z();
    place.setTrans(top.x(), top.y(), top.z());
    const osg::Matrixd towards = osg::Matrixd::inverse(place);
    const osg::Matrixd flat = osg::Matrixd::ortho(fit->origin.x(), fit->origin.x() + fit->width, fit->origin.y(),
                                                  fit->origin.y() + fit->height, 0, fit->depth);
    m_view.camera().setViewMatrix(towards);
    m_view.camera().setProjectionMatrix(flat);
    m_view.draw({idOf(*m_frame, m_view),
                 scene.root(),
                 mask & (kMaskRobots | kMaskStatics),
                 {1, 1, 1, 1},
                 scene.store().look.sunCasters.get(),
                 number});

    lit.setDefine("SUN_MAP");
    lit.setTextureAttribute(kSunTestUnit, m_tests);
    lit.setTextureAttribute(kSunDepthUnit, m_depths);
    lit.getOrCreateUniform("sunTests", osg::Uniform::SAMPLER_2D_SHADOW)->set(int(kSunTestUnit));
    lit.getOrCreateUniform("sunDepths", osg::Uniform::SAMPLER_2D)->set(int(kSunDepthUnit));
    const osg::Matrixd unit = osg::Matrixd::translate(1, 1, 1) * osg::Matrixd::scale(0.5, 0.5, 0.5);
    lit.getOrCreateUniform("sunMap", osg::Uniform::FLOAT_MAT4)->set(osg::Matrixf(towards * flat * unit));
    lit.getOrCreateUniform("sunSize", osg::Uniform::FLOAT_VEC4)
        ->set(osg::Vec4(fit->width, fit->height, fit->depth, fit->texel(m_pixels)));
}

SkyMap::SkyMap(GraphicsContext& context, std::uint32_t width, std::uint32_t height)
    : m_view(context, width, height, kRichDetail), m_faces(mapOf(width, height, kFourFloats, GL_RGBA, GL_FLOAT)),
      m_opened(mapOf(width, height, kTwoHalves, kRedGreen, GL_FLOAT)),
      m_sky(mapOf(width, height, kTwoHalves, kRedGreen, GL_FLOAT)), m_whole(new osg::Group) {
    m_facesFrame->setAttachment(osg::Camera::COLOR_BUFFER, osg::FrameBufferAttachment(m_faces.get()));
    m_facesFrame->setAttachment(osg::Camera::DEPTH_BUFFER,
                                osg::FrameBufferAttachment(new osg::RenderBuffer(int(width), int(height), GL_DEPTH_COMPONENT24)));
    m_openedFrame->setAttachment(osg::Camera::COLOR_BUFFER, osg::FrameBufferAttachment(m_opened.get()));
    m_skyFrame->setAttachment(osg::Camera::COLOR_BUFFER, osg::FrameBufferAttachment(m_sky.get()));
    m_whole->addChild(makeWholeNode());
}

Result<std::unique_ptr<SkyMap>> SkyMap::create(GraphicsContext& context, std::uint32_t width, std::uint32_t height) {
    std::unique_ptr<SkyMap> map(new SkyMap(context, width, height));
    for (const auto& [frame, texture] :
         {std::pair{map->m_facesFrame, map->m_faces}, {map->m_openedFrame, map->m_opened}, {map->m_skyFrame, map->m_sky}})
        if (const Status made = complete(context, *frame, *texture); !made) return made.error();
    return map;
}

SkyMap::~SkyMap() {
    osg::State* state = m_view.context().getState();
    for (osg::FrameBufferObject* frame : {m_facesFrame.get(), m_openedFrame.get(), m_skyFrame.get()})
        frame->releaseGLObjects(state);
    for (osg::Texture2D* map : {m_faces.get(), m_opened.get(), m_sky.get()}) map->releaseGLObjects(state);
    m_whole->releaseGLObjects(state);
}

void SkyMap::draw(Scene& scene, const osg::Camera& camera, std::uint32_t mask, unsigned number, osg::StateSet& lit) {
    const SceneShading& look = scene.store().look;
    m_view.camera().setViewMatrix(camera.getViewMatrix());
    m_view.camera().setProjectionMatrix(camera.getProjectionMatrix());
    const osg::Vec4 nothing(0, 0, 0, 0);
    m_view.draw({idOf(*m_facesFrame, m_view), scene.root(), kMaskSolid | (mask & kMaskFloor), nothing, look.faces.get(), number});

    osg::StateSet* state = m_whole->getOrCreateStateSet();
    state->setTextureAttribute(kMapUnit, m_faces);
    state->getOrCreateUniform("faces", osg::Uniform::SAMPLER_2D)->set(int(kMapUnit));
    state->getOrCreateUniform("openReach", osg::Uniform::FLOAT)->set(kOpenReach);
    m_view.draw({idOf(*m_openedFrame, m_view), *m_whole, ~0u, nothing, look.opened.get(), number});
    state->setTextureAttribute(kMapUnit, m_opened);
    state->getOrCreateUniform("opened", osg::Uniform::SAMPLER_2D)->set(int(kMapUnit));
    m_view.draw({idOf(*m_skyFrame, m_view), *m_whole, ~0u, nothing, look.smoothed.get(), number});

    lit.setDefine("SKY_MAP");
    lit.setTextureAttribute(kSkyUnit, m_sky);
    lit.getOrCreateUniform("skyMap", osg::Uniform::SAMPLER_2D)->set(int(kSkyUnit));
}

} // namespace trundle
