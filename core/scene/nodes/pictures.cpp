#include "scene/nodes/pictures.h"

#include <cstring>

namespace trundle {
namespace {

osg::ref_ptr<osg::Texture2D> textureFrom(const Raster& picture) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(int(picture.width), int(picture.height), 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    std::memcpy(image->data(), picture.pixels.data(), picture.pixels.size());
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    return texture;
}

} // namespace

osg::ref_ptr<osg::Texture2D> Pictures::textureOf(const std::shared_ptr<const Raster>& picture) {
    CachedPicture& kept = m_kept[picture.get()];
    if (!kept.texture) {
        kept.picture = picture;
        kept.texture = textureFrom(*picture);
    }
    return kept.texture;
}

osg::ref_ptr<osg::StateSet> Pictures::stateFor(const std::shared_ptr<const Raster>& picture, bool clear,
                                               const SceneShading& look) {
    const osg::ref_ptr<osg::Texture2D> texture = textureOf(picture);
    CachedPicture& kept = m_kept[picture.get()];
    osg::ref_ptr<osg::StateSet>& state = clear ? kept.clear : kept.solid;
    if (!state) {
        state = new osg::StateSet(clear ? *look.clear : *look.surfaces, osg::CopyOp::SHALLOW_COPY);
        state->setAttributeAndModes(look.pictured);
        state->setTextureAttribute(kPictureUnit, texture);
        state->addUniform(new osg::Uniform("picture", int(kPictureUnit)));
    }
    return state;
}

void Pictures::forgetUnused() {
    std::erase_if(m_kept, [](const auto& entry) {
        const CachedPicture& kept = entry.second;
        const int own = 1 + (kept.solid ? 1 : 0) + (kept.clear ? 1 : 0); // reference count when only this cache holds it
        return kept.texture->referenceCount() == own && (!kept.solid || kept.solid->referenceCount() == 1) &&
               (!kept.clear || kept.clear->referenceCount() == 1);
    });
}

} // namespace trundle
