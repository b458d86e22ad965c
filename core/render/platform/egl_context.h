#pragma once
// An OpenGL compatibility context with no window and no display.

#include <memory>
#include <string>

#include "base/result.h"

namespace trundle {

class EglContext {
public:
    /// Makes one and makes it current on this thread. Tries surfaceless, then a device, then the default display.
    /// E510 with what each way said where no OpenGL is to be had.
    [[nodiscard]] static Result<std::unique_ptr<EglContext>> create();
    /// On the thread that made it.
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
