#pragma once
// Shading shared by all scenes of a context: draw states and GLSL programs for bodies, floor, sky and shadows, so that each
// program is compiled once. Values that differ between scenes are in SceneUniforms.

#include <string>
#include <vector>

#include <osg/StateSet>
#include <osg/Uniform>
#include <osg/Vec3>

#include "scene/shaders/checked_program.h"

namespace trundle {

/// Texture units used for vertex data beyond position, normal and colour.
inline constexpr unsigned kPictureUnit = 0; ///< texture coordinates and the texture
inline constexpr unsigned kGlowUnit = 1;    ///< texture coordinates hold: emitted light (rgb), shininess
inline constexpr unsigned kLayerUnit = 2;   ///< texture coordinates hold: number of the geom, which orders coplanar faces

/// Draw order. Floors are drawn after bodies, so that hidden floor pixels are rejected early; the sky after both.
enum DrawOrder : int {
    kDrawBodies = 0,
    kDrawFloor = 1,
    kDrawShadows = 2,
    kDrawSky = 3,
    kDrawFloorTint = 5,
    kDrawClear = 10,
    kDrawOver = 12
};

/// Unit vector towards the default sun.
[[nodiscard]] osg::Vec3 sunDirection();

/// Uniforms of one scene.
struct SceneUniforms {
    /// Height (m) of the ground below the bodies, for the contact darkening near it.
    osg::ref_ptr<osg::Uniform> ground = new osg::Uniform("groundHeight", -1e6f);
    /// Distance (m) over which a floor fades into the horizon.
    osg::ref_ptr<osg::Uniform> haze = new osg::Uniform("hazeDistance", 100.f);
    /// 1: floors without a texture have lines and a checker pattern; 0: their colour alone.
    osg::ref_ptr<osg::Uniform> floorLines = new osg::Uniform("floorLines", 1.f);
};

class SceneShading {
public:
    SceneShading();

    /// For the whole scene: depth test, back faces culled, no fixed-function light.
    static void applyTo(osg::StateSet& root, const SceneUniforms& uniforms);
    /// Error of the draws since the last call: a program that the driver rejected; empty if there was none.
    [[nodiscard]] std::string takeFailure() const;

private:
    std::vector<osg::ref_ptr<CheckedProgram>> m_programs; // all programs; declared before the states that use them
    /// `vertex` and `fragment` are files of this folder.
    [[nodiscard]] osg::ref_ptr<osg::Program> program(const char* name, const char* vertex, const char* fragment);

public:
    osg::ref_ptr<osg::StateSet> bodies;      ///< closed opaque shapes
    osg::ref_ptr<osg::StateSet> surfaces;    ///< meshes and height maps: both sides are drawn
    osg::ref_ptr<osg::StateSet> clear;       ///< transparent shapes
    osg::ref_ptr<osg::StateSet> openCasters; ///< casters that are not closed: both sides cast shadows
    osg::ref_ptr<osg::StateSet> sky;
    osg::ref_ptr<osg::StateSet> ghosts;           ///< grey and translucent, overriding the states of the nodes below
    osg::ref_ptr<osg::StateSet> collision;        ///< lines in one colour
    osg::ref_ptr<osg::StateSet> guide;            ///< grid lines only
    osg::ref_ptr<osg::StateSet> tinted;           ///< translucent shapes of an overlay
    osg::ref_ptr<osg::StateSet> floorTint;        ///< translucent image on the floor, positioned by the uniform `pictureArea`
    osg::ref_ptr<osg::StateSet> sunCasters;       ///< rich look, shadow pass: distances from the sun
    osg::ref_ptr<osg::StateSet> faces;            ///< rich look, geometry pass: visible faces
    osg::ref_ptr<osg::StateSet> opened, smoothed; ///< rich look, ambient occlusion: raw, smoothed
    osg::ref_ptr<osg::Program> floor, shadow, flatShadow, lampShadow, flat, data;
    osg::ref_ptr<osg::Program> pictured, picturedFloor; ///< with a texture instead of a colour
};

} // namespace trundle
