#include "render/target.h"

#include <cstring>

#include <osg/GLExtensions>

namespace trundle {
namespace {

constexpr double kLeastNear = 0.01, kMaxNear = 2.0, kFar = 8000; // m
constexpr GLenum kDataFormat = 0x8814, kDeepFormat = 0x881A;     // four floats per pixel, of 32 and of 16 bits

const osg::Vec4 kClearColour{0.5f, 0.5f, 0.5f, 1};
constexpr float kDataDetail = 16;  // the flat faces of a coarse sphere would falsify its depth
constexpr std::size_t kValues = 4; // values read per pixel

/// Reverses the rows, since OpenGL counts them from the bottom.
template <class Value> std::vector<Value> rowsFromTop(const Value* read, const TargetShape& shape) {
    const std::size_t row = kValues * shape.width;
    std::vector<Value> values(row * shape.height);
    for (std::size_t y = 0; y < shape.height; ++y)
        std::copy_n(read + row * (shape.height - 1 - y), row, values.begin() + std::ptrdiff_t(row * y));
    return values;
}

/// True if a driver stores the colours of each draw in the eight bits of the framebuffer. Softpipe keeps more until they are read, so
/// what is drawn over a kept background would be rounded differently.
bool roundsEachDraw() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name && std::string_view(name).starts_with("llvmpipe");
}

osg::GLExtensions& gl(GraphicsContext& context) { return *context.getState()->get<osg::GLExtensions>(); }

} // namespace

Target::Target(GraphicsContext& context, TargetShape shape)
    : m_context(context), m_shape(shape), m_view(context, shape.width, shape.height,
                                                 shape.data   ? kDataDetail
                                                 : shape.rich ? kRichDetail
                                                              : 1) {}

Result<std::unique_ptr<Target>> Target::create(GraphicsContext& context, TargetShape shape) {
    std::unique_ptr<Target> target(new Target(context, shape));
    if (const Status made = target->makeBuffers(); !made) return made.error();
    if (!shape.rich && !shape.data && !shape.deep && shape.samples == 1 && roundsEachDraw())
        target->m_backgrounds = std::make_unique<Backgrounds>(context, shape.width, shape.height);
    if (!shape.rich) return target;
    Result<std::unique_ptr<SkyMap>> sky = SkyMap::create(context, shape.width, shape.height);
    if (!sky) return sky.error();
    target->m_sky = std::move(sky).value();
    return target;
}

Status Target::makeBuffers() {
    osg::GLExtensions& ext = gl(m_context);
    while (glGetError() != GL_NO_ERROR) {}
    const auto width = GLsizei(m_shape.width), height = GLsizei(m_shape.height);
    const auto buffer = [&](GLuint& name, GLenum format, GLenum attachment, int samples) {
        ext.glGenRenderbuffers(1, &name);
        ext.glBindRenderbuffer(GL_RENDERBUFFER_EXT, name);
        if (samples > 1) ext.glRenderbufferStorageMultisample(GL_RENDERBUFFER_EXT, samples, format, width, height);
        else ext.glRenderbufferStorage(GL_RENDERBUFFER_EXT, format, width, height);
        ext.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachment, GL_RENDERBUFFER_EXT, name);
    };
    const GLenum colours = m_shape.data ? kDataFormat : m_shape.deep ? kDeepFormat : GL_RGBA8;
    ext.glGenFramebuffers(1, &m_frame);
    ext.glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_frame);
    buffer(m_colour, colours, GL_COLOR_ATTACHMENT0, m_shape.samples);
    buffer(m_depth, GL_DEPTH24_STENCIL8_EXT, GL_DEPTH_STENCIL_ATTACHMENT, m_shape.samples);
    bool whole = ext.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
    if (m_shape.samples > 1) {
        ext.glGenFramebuffers(1, &m_resolvedFrame);
        ext.glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_resolvedFrame);
        buffer(m_resolvedColour, colours, GL_COLOR_ATTACHMENT0, 1);
        whole = whole && ext.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
    }
    if (!whole || glGetError() != GL_NO_ERROR) {
        return Error{Code::PictureFailed,
                     "no room to draw a picture of " + std::to_string(m_shape.width) + " x " + std::to_string(m_shape.height)};
    }
    return {};
}

Target::~Target() {
    osg::GLExtensions& ext = gl(m_context);
    for (const GLuint* frame : {&m_frame, &m_resolvedFrame})
        if (*frame) ext.glDeleteFramebuffers(1, frame);
    for (const GLuint* buffer : {&m_colour, &m_depth, &m_resolvedColour})
        if (*buffer) ext.glDeleteRenderbuffers(1, buffer);
}

void Target::aim(const Scene& scene, const CameraView& view) {
    // Depth resolution improves with the distance of the near plane; it is set to half the distance of the nearest object.
    const auto chosenNear = [&] {
        double nearest = scene.bounds().distanceTo(view.eye);
        if (const auto floor = scene.floorHeight()) nearest = std::min(nearest, std::abs(view.eye.z() - *floor));
        return std::clamp(0.5 * nearest, kLeastNear, kMaxNear);
    };
    const double nearPlane = view.nearPlane > 0 ? view.nearPlane : chosenNear();
    const double farPlane = std::max(view.farPlane > 0 ? view.farPlane : kFar, 1.001 * nearPlane);
    const double aspect = double(m_shape.height) / m_shape.width;
    osg::Camera* camera = &m_view.camera();
    if (view.orthographicWidth > 0) {
        const double half = 0.5 * view.orthographicWidth;
        camera->setProjectionMatrixAsOrtho(-half, half, -half * aspect, half * aspect, nearPlane, farPlane);
    } else {
        const double half = nearPlane * std::tan(0.5 * view.fieldOfView);
        camera->setProjectionMatrixAsFrustum(-half, half, -half * aspect, half * aspect, nearPlane, farPlane);
    }
    const Mat3 axes = cameraAxes(view);
    osg::Matrixd world; // X_WC, row-vector convention of OSG
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) world(column, row) = axes(row, column);
    world.setTrans(view.eye.x(), view.eye.y(), view.eye.z());
    camera->setViewMatrix(osg::Matrixd::inverse(world));
}

/// Draws the maps of the rich look. Returns the mask of what remains to be drawn.
std::uint32_t Target::light(Scene& scene, const DrawRequest& drawRequest) {
    const std::uint32_t shadows = kMaskShadows | kMaskSoftShadows;
    m_lit->removeDefine("SUN_MAP");
    m_lit->removeDefine("SKY_MAP");
    if (!drawRequest.lines) m_sky->draw(scene, m_view.camera(), drawRequest.mask, drawRequest.number, *m_lit);
    if (!drawRequest.sun || !(drawRequest.mask & shadows)) return drawRequest.mask;
    drawRequest.sun->draw(scene, drawRequest.view, m_shape.width, m_shape.height, drawRequest.mask, drawRequest.number, *m_lit);
    return (drawRequest.mask & ~shadows) | kMaskLampShadows;
}

/// What does not move, then the rest. The bytes do not depend on whether the first was drawn or kept.
void Target::drawInTwo(Scene& scene, const DrawRequest& drawRequest) {
    constexpr std::uint32_t kStill = kMaskStatics | kMaskFloor | kMaskSky, kShadows = kMaskShadows | kMaskSoftShadows;
    const std::uint32_t still = drawRequest.mask & (kStill | kShadows);
    const Backgrounds::Key key{
        drawRequest.scene, m_view.camera().getViewMatrix(), m_view.camera().getProjectionMatrix(), still, drawRequest.floorLines,
        drawRequest.hidden};
    const bool isStill = scene.isBackgroundStill();
    if (!isStill || !m_backgrounds->restore(key, m_frame)) {
        m_view.draw({m_frame, scene.root(), still, kClearColour, nullptr, drawRequest.number});
        if (m_context.endedEarly()) return;
        if (isStill) m_backgrounds->keep(key, m_frame);
    }
    DrawingView::Pass rest{m_frame, scene.root(), drawRequest.mask & ~kStill, kClearColour, nullptr, drawRequest.number};
    rest.clears = false;
    m_view.draw(rest);
}

Result<Image> Target::draw(Scene& scene, const DrawRequest& drawRequest) {
    aim(scene, drawRequest.view);
    if (m_backgrounds && !drawRequest.lines && scene.hasBackground()) {
        drawInTwo(scene, drawRequest);
    } else {
        const std::uint32_t mask = m_sky ? light(scene, drawRequest) : drawRequest.mask;
        m_view.draw({m_frame, scene.root(), mask, kClearColour, m_sky ? m_lit.get() : nullptr, drawRequest.number});
    }
    if (m_context.endedEarly()) return Error{Code::PictureFailed, {}};
    Image image = m_shape.deep ? readExposed(drawRequest.exposure) : readImage();
    if (scene.marks().getBound().valid()) {
        m_view.draw({m_frame, scene.marks(), ~0u, {0, 0, 0, 0}, nullptr, drawRequest.number});
        if (m_context.endedEarly()) return Error{Code::PictureFailed, {}}; // otherwise the image would lack the selection
        drawOutlines(image, rowsFromTop(readBack<std::uint8_t>(GL_UNSIGNED_BYTE).get(), m_shape), drawRequest.outline);
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return Error{Code::PictureFailed, "OpenGL reports error " + std::to_string(error)};
    return image;
}

Result<DataImage> Target::measure(Scene& scene, const CameraView& view, unsigned frame) {
    aim(scene, view);
    m_view.draw({m_frame, scene.root(), kMaskData, {0, 0, 0, 0}, nullptr, frame});
    const std::unique_ptr<float[]> read = readBack<float>(GL_FLOAT);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return Error{Code::PictureFailed, "OpenGL reports error " + std::to_string(error)};
    const std::vector<float> values = rowsFromTop(read.get(), m_shape);
    DataImage measured{m_shape.width, m_shape.height, {}, {}};
    const std::size_t count = values.size() / kValues;
    measured.depth.resize(count);
    measured.objects.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        measured.objects[i] = static_cast<std::uint32_t>(std::lround(values[kValues * i + 1]));
        measured.depth[i] = measured.objects[i] ? values[kValues * i] : std::numeric_limits<float>::infinity();
    }
    return measured;
}

template <class Value> std::unique_ptr<Value[]> Target::readBack(GLenum type) {
    osg::GLExtensions& ext = gl(m_context);
    const auto width = GLsizei(m_shape.width), height = GLsizei(m_shape.height);
    if (m_resolvedFrame) {
        ext.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, m_frame);
        ext.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, m_resolvedFrame);
        ext.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        ext.glBindFramebuffer(GL_FRAMEBUFFER_EXT, m_resolvedFrame);
    }
    auto values = std::make_unique_for_overwrite<Value[]>(kValues * m_shape.width * m_shape.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, type, values.get());
    return values;
}

Image Target::readImage() {
    const std::unique_ptr<std::uint8_t[]> read = readBack<std::uint8_t>(GL_UNSIGNED_BYTE);
    const std::size_t width = m_shape.width, height = m_shape.height;
    Image image{m_shape.width, m_shape.height, std::vector<std::uint8_t>(3 * width * height)};
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* from = read.get() + kValues * width * (height - 1 - y);
        std::uint8_t* to = image.pixels.data() + 3 * width * y;
        // Copying four bytes is faster than three; the next pixel overwrites the fourth.
        for (std::size_t x = 0; x + 1 < width; ++x, from += kValues, to += 3) std::memcpy(to, from, 4);
        std::memcpy(to, from, 3);
    }
    return image;
}

/// Exposure acts on linear light; display values are its square root.
Image Target::readExposed(double exposure) {
    const std::vector<float> values = rowsFromTop(readBack<float>(GL_FLOAT).get(), m_shape);
    const auto gain = static_cast<float>(255 * std::sqrt(exposure));
    Image image{m_shape.width, m_shape.height, {}};
    image.pixels.reserve(values.size() / kValues * 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % kValues != 3) image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(gain * values[i], 0.f, 255.f) + 0.5f));
    return image;
}

} // namespace trundle
