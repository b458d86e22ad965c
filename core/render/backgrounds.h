#pragma once
// What does not move in the pictures of a target (floors, statics, sky, and the shadows of statics): drawn first, and kept with
// its depths while camera and sun stay. A picture has the same bytes whether its background was drawn or kept.

#include <cstdint>
#include <string>
#include <vector>

#include <osg/Matrixd>

#include "render/graphics_context.h"
#include "render/requests.h"

namespace trundle {

/// Must be created, used and destroyed while the context is current.
class Backgrounds {
public:
    /// For framebuffers of this size, without multisampling.
    Backgrounds(GraphicsContext& context, std::uint32_t width, std::uint32_t height);
    ~Backgrounds();
    Backgrounds(const Backgrounds&) = delete;
    Backgrounds& operator=(const Backgrounds&) = delete;

    /// All that a background depends on.
    struct Key {
        SceneId scene = SceneId::None;
        osg::Matrixd view, projection;
        std::uint32_t mask = 0;
        bool floorLines = true;
        std::vector<std::string> hidden;
        bool operator==(const Key&) const = default;
    };
    /// Copies colours, depths and stencil into `frame`; false if this background is not kept.
    [[nodiscard]] bool restore(const Key& key, GLuint frame);
    /// `frame` holds the background. It is kept if it is not the first one with this key (a moving camera repeats no view) and
    /// there is room: 48 MiB, less what was in use of late.
    void keep(const Key& key, GLuint frame);
    [[nodiscard]] std::size_t kept() const { return m_kept.size(); }

private:
    struct Kept {
        Key key;
        GLuint frame = 0, colour = 0, depth = 0;
        std::uint64_t lastUse = 0;
    };
    void copy(GLuint from, GLuint to);
    void drop(const Kept& kept);

    GraphicsContext& m_context;
    GLsizei m_width, m_height;
    std::vector<Kept> m_kept;
    std::vector<Key> m_seen; // the last keys of backgrounds that are not kept
    std::uint64_t m_uses = 0;
};

} // namespace trundle
