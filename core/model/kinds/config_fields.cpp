#include "model/kinds/config_fields.h"

#include "model/kinds/quantities.h"

namespace trundle {

namespace {

constexpr double kLargest = 1e4; ///< m

/// A dimension of a shape.
constexpr Quantity extent() { return metres().above(0).atMost(kLargest).required(); }

template <class T> void describeGeom(Describe<T>& d) {
    d.field("Pos", &GeomFields::pos, position(), "Position of its centre in the body or config.");
    d.field("HPR", &GeomFields::hpr, angles(), "Heading, pitch and roll in the body or config.");
    d.field("Material", &GeomFields::material, reference("Material"), "How it looks.");
    d.field("Surface", &GeomFields::surface, reference("Surface"), "How it touches.");
    d.field("Collide", &GeomFields::collide, flag(), "Touches others; when false it is only drawn.");
    d.field("Visible", &GeomFields::visible, flag(), "Is drawn.");
}

template <class T> void describeSolid(Describe<T>& d) {
    describeGeom(d);
    d.field("Mass", &SolidFields::mass, kilograms().above(0).atMost(1e9),
            "Its mass; not with Density, nor with Mass of the body.");
    d.field("Density", &SolidFields::density, unitOf("kg/m^3").above(0).atMost(1e6), "Its mass per volume.");
}

template <class T> void describeEnds(Describe<T>& d) {
    d.field("Parent", &JointFields::parent, reference("Body|world").required(), "Body that carries the joint, or world.");
    d.field("Child", &JointFields::child, reference("Body").required(), "Body that moves.");
}

template <class T> void describeAnchor(Describe<T>& d) {
    d.field("Anchor", &JointFields::anchor, position(),
            "Point of the joint in the config frame; the child's origin where absent.");
}

template <class T> void describeSpring(Describe<T>& d, const char* stiffness, const char* damping) {
    d.field("Stiffness", &JointFields::stiffness, unitOf(stiffness).within(0, 1e12),
            "Of the spring towards the start position; at most 1.8 rad per tick.");
    d.field("Damping", &JointFields::damping, unitOf(damping).within(0, 1e12), "Resistance per speed.");
}

template <class T> void describeSwivel(Describe<T>& d, const char* about) {
    d.field("Stiffness", &JointFields::stiffness, unitOf("Nm/rad").within(0, 1e12), about);
    d.field("Damping", &JointFields::damping, unitOf("Nms/rad").within(0, 1e12), "Resistance per speed.");
}

} // namespace

void BodyFields::describe(Describe<BodyFields>& d) {
    d.help("One rigid body of a robot: its geoms and its mass.");
    d.field("Pos", &BodyFields::pos, position(), "Position of its frame in the config frame.");
    d.field("HPR", &BodyFields::hpr, angles(), "Heading, pitch and roll in the config frame.");
    d.field("In", &BodyFields::in, reference("Body"), "The body in whose frame Pos and HPR are, in place of the config's.");
    d.field("Mass", &BodyFields::mass, kilograms().above(0).atMost(1e9),
            "Spread evenly over its geoms, which then have no mass of their own.");
    d.field("CenterOfMass", &BodyFields::centreOfMass, position(), "In the body's frame; from the geoms where absent.");
    d.field("Inertia", &BodyFields::inertia, unitOf("kgm^2").counted(3, 6),
            "Ixx, Iyy, Izz[, Ixy, Ixz, Iyz] about the centre of mass; from the geoms where absent.");
}

void BoxFields::describe(Describe<BoxFields>& d) {
    d.help("A box.");
    d.field("Size", &BoxFields::size, extent(), "Full lengths along x, y and z.");
    describeSolid(d);
}

void SphereFields::describe(Describe<SphereFields>& d) {
    d.help("A sphere.");
    d.field("Radius", &SphereFields::radius, extent(), "Its radius.");
    describeSolid(d);
}

void CylinderFields::describe(Describe<CylinderFields>& d) {
    d.help("A cylinder along its z axis.");
    d.field("Radius", &CylinderFields::radius, extent(), "Its radius.");
    d.field("Length", &CylinderFields::length, extent(), "Its length along z.");
    describeSolid(d);
}

void CapsuleFields::describe(Describe<CapsuleFields>& d) {
    d.help("A cylinder along its z axis with half a sphere on each end.");
    d.field("Radius", &CapsuleFields::radius, extent(), "Its radius.");
    d.field("Length", &CapsuleFields::length, extent(), "Length of the cylinder between the half spheres.");
    describeSolid(d);
}

void ConvexFields::describe(Describe<ConvexFields>& d) {
    d.help("The convex hull of a mesh.");
    d.field("File", &ConvexFields::file, trundle::file("obj|stl|dae|gltf|glb").required(), "The mesh.");
    d.field("Scale", &ConvexFields::scale, number().above(0).atMost(1e6).counted(1, 3),
            "Factor on its lengths, or one for each axis.");
    describeSolid(d);
}

void MeshFields::describe(Describe<MeshFields>& d) {
    d.help("A triangle mesh.");
    d.field("File", &MeshFields::file, trundle::file("obj|stl|dae|gltf|glb").required(), "The mesh.");
    d.field("Scale", &MeshFields::scale, number().above(0).atMost(1e6).counted(1, 3),
            "Factor on its lengths, or one for each axis.");
    d.field("Shape", &MeshFields::shape, oneOf("mesh|hull|none"),
            "What collides; the mesh of scenery and the hull on bodies where absent.");
    describeSolid(d);
}

void PlaneFields::describe(Describe<PlaneFields>& d) {
    d.help("An endless plane through Pos; its own z points out of the ground. Scenery only.");
    describeGeom(d);
}

void HeightfieldFields::describe(Describe<HeightfieldFields>& d) {
    d.help("Ground from a grey picture, black at Pos.z, its top row at +y. Scenery only.");
    d.field("File", &HeightfieldFields::file, trundle::file("png|jpg|jpeg|bmp|pgm|ppm").required(), "The picture.");
    d.field("Size", &HeightfieldFields::size, extent(), "Length along x, along y, height of white.");
    describeGeom(d);
}

void HingeFields::describe(Describe<HingeFields>& d) {
    d.help("Lets the child turn about an axis.");
    describeEnds(d);
    describeAnchor(d);
    d.field("Axis", &JointFields::axis, direction(), "Axis in the config frame; the child turns right-handed about it.");
    d.field("LowStop", &JointFields::lowStop, degrees().within(-180, 180), "Smallest angle.");
    d.field("HighStop", &JointFields::highStop, degrees().within(-180, 180), "Largest angle.");
    describeSpring(d, "Nm/rad", "Nms/rad");
    d.field("RestAngle", &JointFields::rest, degrees().within(-36000, 36000), "Where the spring has no torque; 0 is the start.");
    d.field("Friction", &JointFields::friction, newtonMetres().within(0, 1e9), "Torque that holds it until overcome.");
}

void SliderFields::describe(Describe<SliderFields>& d) {
    d.help("Lets the child slide along an axis.");
    describeEnds(d);
    d.field("Axis", &JointFields::axis, direction(), "Axis in the config frame; the child moves along it.");
    d.field("LowStop", &JointFields::lowStop, position(), "Lowest position along the axis; 0 is the start.");
    d.field("HighStop", &JointFields::highStop, position(), "Highest position along the axis.");
    describeSpring(d, "N/m", "Ns/m");
    d.field("RestPosition", &JointFields::rest, position(), "Where the spring has no force; 0 is the start.");
    d.field("Friction", &JointFields::friction, newtons().within(0, 1e9), "Force that holds it until overcome.");
}

void BallFields::describe(Describe<BallFields>& d) {
    d.help("Lets the child turn about a point.");
    describeEnds(d);
    describeAnchor(d);
    d.field("Axis", &JointFields::axis, direction(), "Middle of the cone of SwingStop, in the config frame.");
    d.field("SwingStop", &JointFields::swingStop, degrees().above(0).atMost(180),
            "Largest angle between Axis on the child and on the parent; twist about it stays free.");
    describeSwivel(d, "Of the spring towards the start orientation, about all axes.");
}

void UniversalFields::describe(Describe<UniversalFields>& d) {
    d.help("Lets the child turn about two axes at a right angle.");
    describeEnds(d);
    describeAnchor(d);
    d.field("Axis", &JointFields::axis, direction(), "First axis, fixed to the parent.");
    d.field("Axis2", &JointFields::axis2, direction(), "Second axis, fixed to the child.");
    d.field("LowStop", &JointFields::lowStop, degrees().within(-180, 180), "Smallest angle about Axis.");
    d.field("HighStop", &JointFields::highStop, degrees().within(-180, 180), "Largest angle about Axis.");
    d.field("LowStop2", &JointFields::lowStop2, degrees().within(-180, 180), "Smallest angle about Axis2.");
    d.field("HighStop2", &JointFields::highStop2, degrees().within(-180, 180), "Largest angle about Axis2.");
    describeSwivel(d, "Of the spring about Axis towards the start position.");
    d.field("Stiffness2", &JointFields::stiffness2, unitOf("Nm/rad").within(0, 1e12), "About Axis2; as about Axis where absent.");
    d.field("Damping2", &JointFields::damping2, unitOf("Nms/rad").within(0, 1e12), "About Axis2; as about Axis where absent.");
}

void FixedFields::describe(Describe<FixedFields>& d) {
    d.help("Holds the child to the parent.");
    describeEnds(d);
}

void SuspensionFields::describe(Describe<SuspensionFields>& d) {
    d.help("A wheel's hinge about Axis2 whose anchor slides along Axis on a spring.");
    describeEnds(d);
    describeAnchor(d);
    d.field("Axis", &JointFields::axis, direction(), "Direction of the spring.");
    d.field("Axis2", &JointFields::axis2, direction(), "The wheel's axle.");
    describeSpring(d, "N/m", "Ns/m");
    d.field("Travel", &JointFields::travel, metres().within(0, kLargest), "How far it gives to each side; 0 = no stop.");
}

void SpringFields::describe(Describe<SpringFields>& d) {
    d.help("A spring with damper along the line between a point of one body and a point of another.");
    d.field("Parent", &SpringFields::parent, reference("Body|world").required(), "Body at one end, or world.");
    d.field("Child", &SpringFields::child, reference("Body").required(), "Body at the other end.");
    d.field("Anchor", &SpringFields::anchor, position(),
            "Point of Parent in the config frame; its origin where absent, for the world that of the config.");
    d.field("Anchor2", &SpringFields::anchor2, position(), "Point of Child in the config frame; its origin where absent.");
    d.field("Length", &SpringFields::length, metres().within(0, kLargest), "Without force; that of the start where absent.");
    d.field("Stiffness", &SpringFields::stiffness, unitOf("N/m").within(0, 1e12),
            "Force per extension; at most 1.8 rad per tick.");
    d.field("Damping", &SpringFields::damping, unitOf("Ns/m").within(0, 1e12), "Force per rate of its length.");
}

void GearFields::describe(Describe<GearFields>& d) {
    d.help("Couples two joints that have a body or the world in common: the rate of Joint is Ratio times that of Other.");
    d.field("Joint", &GearFields::joint, reference("Hinge|Slider").required(), "The joint that is turned or moved.");
    d.field("Other", &GearFields::other, reference("Hinge|Slider").required(), "The joint that turns or moves it.");
    d.field("Ratio", &GearFields::ratio, number().within(-1e6, 1e6).required(),
            "Rate of Joint per rate of Other, negative for two meshing wheels; m per rad for a Slider on a Hinge.");
}

} // namespace trundle
