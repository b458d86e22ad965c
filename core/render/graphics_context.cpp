#include "render/graphics_context.h"

#include <osg/GLObjects>
#include <osg/State>

namespace trundle {

GraphicsContext::GraphicsContext() {
    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(osg::GraphicsContext::createNewContextID());
    getState()->initializeExtensionProcs();
}

void GraphicsContext::release() {
    if (!getState()) return;
    const unsigned id = getState()->getContextID();
    osg::flushAllDeletedGLObjects(id);
    osg::deleteAllGLObjects(id);
    osg::discardAllGLObjects(id);
    setState(nullptr);
    osg::GraphicsContext::decrementContextIDUsageCount(id);
}

} // namespace trundle
