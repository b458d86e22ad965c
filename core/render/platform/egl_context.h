#pragma once
// An off-screen OpenGL compatibility context; needs no window and no display.

#include <memory>
#include <string>

#include "base/result.h"

namespace trundle {

class EglContext {
public:
    /// Creates a context and makes it current on this thread. Tries surfaceless, then a device, then the default display. Fails
    /// with E510 and the reason of each attempt if there is no OpenGL.
    [[nodiscard]] static Result<std::unique_ptr<EglContext>> create();
    /// Must run on the thread that created it.
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    [[nodiscard]] const std::string& version() const { return m_version; }   ///< GL_VERSION
    [[nodiscard]] const std::string& renderer() const { return m_renderer; } ///< GL_RENDERER

private:
    EglContext() = default;
    void *m_display = nullptr, *m_context = nullptr, *m_surface = nullptr;
    std::string m_version, m_renderer;
};

} // namespace trundle
