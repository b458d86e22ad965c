#pragma once
// What OSG is told of the context that render holds: already made, always current, no window.

#include <atomic>

#include <osg/GraphicsContext>

namespace trundle {

/// Made and closed while the real context is current.
class GraphicsContext final : public osg::GraphicsContext {
public:
    GraphicsContext();
    /// Deletes what OSG still holds in the context.
    void release();
    /// Drawing ends as soon as `enough` is set; another thread may set it. It outlives this.
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
    bool* m_enough = nullptr; ///< OSG reads it too, so it is no std::atomic
};

} // namespace trundle
