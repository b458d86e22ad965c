#pragma once
#include <map>
#include <memory>

#include <osg/StateSet>
#include <osg/Texture2D>

#include "base/raster.h"
#include "scene/look.h"

namespace trundle {

/// The pictures on surfaces, each sent to the graphics context once. Used on one thread, with the scenes.
class Pictures {
public:
    /// For closed and for open shapes alike. `clear`: one can see through them.
    [[nodiscard]] osg::ref_ptr<osg::StateSet> stateFor(const std::shared_ptr<const Raster>& picture, bool clear,
                                                       const Look& look);
    [[nodiscard]] osg::ref_ptr<osg::Texture2D> textureOf(const std::shared_ptr<const Raster>& picture);
    /// Drops what nobody draws any more.
    void forgetUnused();

private:
    struct Kept {
        std::shared_ptr<const Raster> picture; // so that its address stays its own
        osg::ref_ptr<osg::Texture2D> texture;
        osg::ref_ptr<osg::StateSet> solid, clear;
    };
    std::map<const Raster*, Kept> m_kept;
};

} // namespace trundle
