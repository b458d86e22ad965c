#pragma once
#include <map>
#include <memory>

#include <osg/StateSet>
#include <osg/Texture2D>

#include "base/raster.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

/// Texture cache: each texture is uploaded to the graphics context once. Used only on the thread that owns the scenes.
class Pictures {
public:
    /// Draw state for closed and open shapes alike. `clear`: the material is transparent.
    [[nodiscard]] osg::ref_ptr<osg::StateSet> stateFor(const std::shared_ptr<const Raster>& picture, bool clear,
                                                       const SceneShading& look);
    [[nodiscard]] osg::ref_ptr<osg::Texture2D> textureOf(const std::shared_ptr<const Raster>& picture);
    /// Drops textures that no scene uses any more.
    void forgetUnused();

private:
    struct CachedPicture {
        std::shared_ptr<const Raster> picture; // owned, so that the address used as key stays unique
        osg::ref_ptr<osg::Texture2D> texture;
        osg::ref_ptr<osg::StateSet> solid, clear;
    };
    std::map<const Raster*, CachedPicture> m_kept;
};

} // namespace trundle
