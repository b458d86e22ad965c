#pragma once
// How everything is lit: the sun, the sky's light, and the small programs that draw bodies, floor, sky and shadows. One for
// all scenes of a context, so that a program is compiled once; what differs between scenes is in their own uniforms.

#include <string>
#include <vector>

#include <osg/StateSet>
#include <osg/Uniform>
#include <osg/Vec3>

#include "scene/checked_program.h"

namespace trundle {

/// Where vertex data beyond position, normal and colour stands.
inline constexpr unsigned kPictureUnit = 0; ///< texture coordinates, and the picture
inline constexpr unsigned kGlowUnit = 1;    ///< texture coordinates: emitted light (rgb), shininess
inline constexpr unsigned kLayerUnit = 2;   ///< texture coordinates: number of the geom, which orders coplanar faces

/// Order of drawing. Floors come after bodies so that hidden floor costs nothing, the sky after both.
enum DrawOrder : int {
    kDrawBodies = 0,
    kDrawFloor = 1,
    kDrawShadows = 2,
    kDrawSky = 3,
    kDrawFloorTint = 5,
    kDrawClear = 10,
    kDrawOver = 12
};

/// Towards the sun of an experiment that names none, unit.
[[nodiscard]] osg::Vec3 sunDirection();

/// What a scene tells the programs.
struct SceneUniforms {
    /// Height of the ground below the bodies, for the darkening near it.
    osg::ref_ptr<osg::Uniform> ground = new osg::Uniform("groundHeight", -1e6f);
    /// Distance (m) over which a floor fades into the horizon.
    osg::ref_ptr<osg::Uniform> haze = new osg::Uniform("hazeDistance", 100.f);
    /// 1: floors without a picture have lines and a checker pattern; 0: their colour alone.
    osg::ref_ptr<osg::Uniform> floorLines = new osg::Uniform("floorLines", 1.f);
};

class Look {
public:
    Look();

    /// For the whole scene: depth test, back faces culled, no fixed-function light.
    static void applyTo(osg::StateSet& root, const SceneUniforms& uniforms);
    /// Why what was drawn since the last call is wrong: a program that the driver does not take. Empty: it is not.
    [[nodiscard]] std::string takeFailure() const;

private:
    std::vector<osg::ref_ptr<CheckedProgram>> m_programs; // all; made before those below
    [[nodiscard]] osg::ref_ptr<osg::Program> program(const char* name, const char* vertex, const std::string& fragment);

public:
    osg::ref_ptr<osg::StateSet> bodies;      ///< closed opaque shapes
    osg::ref_ptr<osg::StateSet> surfaces;    ///< meshes and height maps: both sides are drawn
    osg::ref_ptr<osg::StateSet> clear;       ///< shapes that one can see through
    osg::ref_ptr<osg::StateSet> openCasters; ///< of a shadow, where shapes are no closed ones: both sides cast it
    osg::ref_ptr<osg::StateSet> sky;
    osg::ref_ptr<osg::StateSet> ghosts;           ///< grey and translucent, whatever lies below says
    osg::ref_ptr<osg::StateSet> collision;        ///< lines in one colour
    osg::ref_ptr<osg::StateSet> guide;            ///< lines of a floor, and nothing between them
    osg::ref_ptr<osg::StateSet> tinted;           ///< shapes of an overlay, translucent
    osg::ref_ptr<osg::StateSet> floorTint;        ///< a translucent picture on the floor; it says where in `pictureArea`
    osg::ref_ptr<osg::StateSet> sunCasters;       ///< the passes of the rich look: distances from the sun,
    osg::ref_ptr<osg::StateSet> faces;            ///< what is seen of each thing,
    osg::ref_ptr<osg::StateSet> opened, smoothed; ///< and how open to the sky that is
    osg::ref_ptr<osg::Program> floor, shadow, lampShadow, flat, data;
    osg::ref_ptr<osg::Program> pictured, picturedFloor; ///< with a picture in place of a colour
};

} // namespace trundle
