#pragma once
// OSG's representation of the render thread's EGL context: already created, always current, without a window.

#include <atomic>

#include <osg/GraphicsContext>

namespace trundle {

/// Must be created and closed while the EGL context is current.
class GraphicsContext final : public osg::GraphicsContext {
public:
    GraphicsContext();
    /// Deletes the GL objects that OSG still holds in the context.
    void release();
    /// Drawing stops as soon as `enough` is set, from any thread. `enough` must outlive this object.
    void endEarlyOn(bool& enough) { getState()->setAbortRenderingPtr(m_enough = &enough); }
    [[nodiscard]] bool endedEarly() const { return m_enough && std::atomic_ref(*m_enough).load(); }

    bool valid() const override { return true; }
    bool realizeImplementation() override { return true; }
    bool isRealizedImplementation() const override { return true; }
    void closeImplementation() override {}
    bool makeCurrentImplementation() override { return true; }
    bool makeContextCurrentImplementation(osg::GraphicsContext*) override { return true; }
    bool releaseContextImplementation() override { return true; }
    void bindPBufferToTextureImplementation(GLenum) override {}
    void swapBuffersImplementation() override {}

private:
    bool* m_enough = nullptr; ///< also read by OSG, therefore not a std::atomic
};

} // namespace trundle
