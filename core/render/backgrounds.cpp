#include "render/backgrounds.h"

#include <algorithm>

#include <osg/GLExtensions>

namespace trundle {
namespace {

constexpr std::size_t kMostBytes = std::size_t(48) << 20, kBytesOfPixel = 8, kMostSeen = 64;
constexpr std::uint64_t kLongUnused = 256; // pictures

} // namespace

Backgrounds::Backgrounds(GraphicsContext& context, std::uint32_t width, std::uint32_t height)
    : m_context(context), m_width(GLsizei(width)), m_height(GLsizei(height)) {}

Backgrounds::~Backgrounds() {
    for (const Kept& kept : m_kept) drop(kept);
}

void Backgrounds::drop(const Kept& kept) {
    osg::GLExtensions& gl = *m_context.getState()->get<osg::GLExtensions>();
    gl.glDeleteFramebuffers(1, &kept.frame);
    for (const GLuint* buffer : {&kept.colour, &kept.depth}) gl.glDeleteRenderbuffers(1, buffer);
}

void Backgrounds::copy(GLuint from, GLuint to) {
    osg::GLExtensions& gl = *m_context.getState()->get<osg::GLExtensions>();
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, from);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, to);
    gl.glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height,
                         GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
}

bool Backgrounds::restore(const Key& key, GLuint frame) {
    ++m_uses;
    const auto kept = std::ranges::find(m_kept, key, &Kept::key);
    if (kept == m_kept.end()) return false;
    kept->lastUse = m_uses;
    copy(kept->frame, frame);
    return true;
}

void Backgrounds::keep(const Key& key, GLuint frame) {
    const auto seen = std::ranges::find(m_seen, key);
    if (seen == m_seen.end()) {
        if (m_seen.size() == kMostSeen) m_seen.erase(m_seen.begin());
        m_seen.push_back(key);
        return;
    }
    m_seen.erase(seen);
    const std::size_t most = kMostBytes / (kBytesOfPixel * std::size_t(m_width) * std::size_t(m_height));
    if (most == 0) return;
    if (m_kept.size() >= most) {
        // If there are more cameras than room, those that have it keep it.
        const auto oldest = std::ranges::min_element(m_kept, {}, &Kept::lastUse);
        if (m_uses - oldest->lastUse < kLongUnused) return;
        drop(*oldest);
        m_kept.erase(oldest);
    }
    osg::GLExtensions& gl = *m_context.getState()->get<osg::GLExtensions>();
    Kept kept{key, 0, 0, 0, m_uses};
    gl.glGenFramebuffers(1, &kept.frame);
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, kept.frame);
    const auto buffer = [&](GLuint& name, GLenum format, GLenum attachment) {
        gl.glGenRenderbuffers(1, &name);
        gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, name);
        gl.glRenderbufferStorage(GL_RENDERBUFFER_EXT, format, m_width, m_height);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT, attachment, GL_RENDERBUFFER_EXT, name);
    };
    buffer(kept.colour, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    buffer(kept.depth, GL_DEPTH24_STENCIL8_EXT, GL_DEPTH_STENCIL_ATTACHMENT);
    if (gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) != GL_FRAMEBUFFER_COMPLETE_EXT) return drop(kept);
    copy(frame, kept.frame);
    m_kept.push_back(std::move(kept));
}

} // namespace trundle
