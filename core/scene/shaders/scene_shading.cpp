#include "scene/shaders/scene_shading.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>

#include "scene/shaders/shader_source.h"

namespace trundle {
SceneShading::SceneShading()
    : bodies(new osg::StateSet), surfaces(new osg::StateSet), clear(new osg::StateSet), openCasters(new osg::StateSet),
      sky(new osg::StateSet), ghosts(new osg::StateSet), collision(new osg::StateSet), guide(new osg::StateSet),
      tinted(new osg::StateSet), floorTint(new osg::StateSet), sunCasters(new osg::StateSet), faces(new osg::StateSet),
      opened(new osg::StateSet), smoothed(new osg::StateSet), floor(program("floor", "floor.vert.glsl", "floor.frag.glsl")),
      shadow(program("shadow", "shadow.vert.glsl", "shadow.frag.glsl")),
      flatShadow(program("flatShadow", "flat_shadow.vert.glsl", "shadow.frag.glsl")),
      lampShadow(program("lampShadow", "lamp_shadow.vert.glsl", "lamp_shadow.frag.glsl")),
      flat(program("flat", "flat.vert.glsl", "flat.frag.glsl")), data(program("data", "data.vert.glsl", "data.frag.glsl")),
      pictured(program("pictured", "body.vert.glsl", "pictured.frag.glsl")),
      picturedFloor(program("picturedFloor", "floor.vert.glsl", "pictured_floor.frag.glsl")) {
    const osg::ref_ptr<osg::Program> body = program("body", "body.vert.glsl", "body.frag.glsl");
    for (osg::StateSet* set : {bodies.get(), surfaces.get(), clear.get()}) set->setAttributeAndModes(body);
    surfaces->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    openCasters->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);

    clear->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    clear->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    clear->setRenderBinDetails(kDrawClear, "DepthSortedBin");

    sky->setAttributeAndModes(program("sky", "sky.vert.glsl", "sky.frag.glsl"));
    sky->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    sky->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    sky->setRenderBinDetails(kDrawSky, "RenderBin");

    guide->setAttributeAndModes(program("guide", "floor.vert.glsl", "guide.frag.glsl"));
    guide->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    guide->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    guide->setAttributeAndModes(new osg::PolygonOffset(1.f, 2.f)); // objects on the ground are drawn over it
    guide->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    guide->setRenderBinDetails(kDrawClear, "DepthSortedBin");

    tinted->setAttributeAndModes(program("tinted", "tinted.vert.glsl", "tinted.frag.glsl"));
    tinted->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    tinted->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    tinted->setRenderBinDetails(kDrawClear, "DepthSortedBin");

    floorTint->setAttributeAndModes(program("floorTint", "floor.vert.glsl", "floor_tint.frag.glsl"));
    floorTint->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    floorTint->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    floorTint->setRenderBinDetails(kDrawFloorTint, "RenderBin");

    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    ghosts->setAttributeAndModes(program("ghost", "body.vert.glsl", "ghost.frag.glsl"), force);
    ghosts->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), force);
    ghosts->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false), force);
    ghosts->setRenderBinDetails(kDrawClear, "DepthSortedBin", osg::StateSet::OVERRIDE_RENDERBIN_DETAILS);

    collision->setAttributeAndModes(flat, force);
    collision->addUniform(new osg::Uniform("flatColour", osg::Vec4(0.25f, 0.95f, 0.35f, 0.85f)));
    collision->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), force);
    collision->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE), force);
    collision->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false), force);
    collision->setMode(GL_CULL_FACE, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    collision->setRenderBinDetails(kDrawOver, "RenderBin", osg::StateSet::OVERRIDE_RENDERBIN_DETAILS);

    sunCasters->setAttributeAndModes(program("sunCasters", "sun_depth.vert.glsl", "sun_depth.frag.glsl"), force);
    sunCasters->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, true), force);
    sunCasters->setMode(GL_BLEND, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    faces->setAttributeAndModes(program("faces", "face.vert.glsl", "face.frag.glsl"), force);
    opened->setAttributeAndModes(program("opened", "whole_image.vert.glsl", "sky_open.frag.glsl"));
    smoothed->setAttributeAndModes(program("smoothed", "whole_image.vert.glsl", "sky_smooth.frag.glsl"));
    for (osg::StateSet* set : {opened.get(), smoothed.get()}) {
        set->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
        set->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    }
}

osg::ref_ptr<osg::Program> SceneShading::program(const char* name, const char* vertex, const char* fragment) {
    osg::ref_ptr<CheckedProgram> result = new CheckedProgram;
    result->setName(name);
    result->addShader(new osg::Shader(osg::Shader::VERTEX, shaderSource(vertex)));
    result->addShader(new osg::Shader(osg::Shader::FRAGMENT, shaderSource(fragment)));
    m_programs.push_back(result);
    return result;
}

std::string SceneShading::takeFailure() const {
    std::string first;
    for (const auto& each : m_programs)
        if (std::string failure = each->takeFailure(); first.empty()) first = std::move(failure);
    return first;
}

void SceneShading::applyTo(osg::StateSet& root, const SceneUniforms& uniforms) {
    root.setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, true));
    root.setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    root.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    root.addUniform(uniforms.ground);
    root.addUniform(uniforms.haze);
    root.addUniform(uniforms.floorLines);
}

} // namespace trundle
