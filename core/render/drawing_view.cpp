#include "render/drawing_view.h"

#include <osg/GLExtensions>

namespace trundle {
namespace {

constexpr GLbitfield kAllBuffers = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;

} // namespace

DrawingView::DrawingView(GraphicsContext& context, std::uint32_t width, std::uint32_t height, float detail)
    : m_context(context), m_view(new osgUtil::SceneView) {
    m_view->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT | osgUtil::SceneView::CLEAR_GLOBAL_STATESET |
                        osgUtil::SceneView::APPLY_GLOBAL_DEFAULTS);
    m_view->setState(context.getState());
    m_view->setFrameStamp(new osg::FrameStamp);
    osg::Camera* camera = m_view->getCamera();
    camera->setGraphicsContext(&context);
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
    camera->setClearColor(osg::Vec4(0.5f, 0.5f, 0.5f, 1));
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    m_view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR); // not taken over from its camera
    camera->setViewport(0, 0, int(width), int(height));
    m_view->setLODScale(1 / detail);
    m_view->init();
}

DrawingView::~DrawingView() {
    m_view->releaseGLObjects(m_context.getState());
    m_view->getCamera()->setGraphicsContext(nullptr);
}

void DrawingView::draw(const Pass& pass) {
    const_cast<osg::FrameStamp*>(m_view->getFrameStamp())->setFrameNumber(pass.number);
    m_view->setSceneData(&pass.root);
    m_view->setSecondaryStateSet(pass.state);
    m_view->setCullMask(pass.mask);
    camera().setClearColor(pass.background);
    camera().setClearMask(pass.clears ? kAllBuffers : 0);
    m_context.setDefaultFboId(pass.frame);
    m_context.getState()->get<osg::GLExtensions>()->glBindFramebuffer(GL_FRAMEBUFFER_EXT, pass.frame);
    m_view->cull();
    m_view->draw();
    // OSG knows the arrays drawn last by their addresses alone. Another may be made at the address of one that is gone, and would be
    // drawn with a buffer that is gone too.
    m_context.getState()->lazyDisablingOfVertexAttributes();
    m_context.getState()->applyDisablingOfVertexAttributes();
    m_view->setSceneData(nullptr);
    m_view->setSecondaryStateSet(nullptr);
}

} // namespace trundle
