#include "model/kinds/world_fields.h"

#include "model/kinds/quantities.h"

namespace trundle {

namespace {

constexpr double kLargestWhole = 9007199254740992.0;

constexpr Quantity whole(double low, double high) {
    Quantity q = number().within(low, high);
    q.type = TRUNDLE_INTEGER;
    return q;
}

template <class T> void describePose(Describe<T>& d, const char* config, const char* pos) {
    std::string named = config;
    if (const std::size_t bar = named.find('|'); bar != std::string::npos) named.replace(bar, 1, " or ");
    d.field("Config", &PoseFields::config, reference(config).required(), "Name of the " + named + " it is created from.");
    d.field("Pos", &PoseFields::pos, position(), pos);
    d.field("HPR", &PoseFields::hpr, angles(), "Heading, pitch and roll.");
}

template <class T> void describeVariant(Describe<T>& d, const char* config) {
    d.field("Config", &VariantFields::config, reference(config),
            std::string("Another ") + config +
                " that this one is a variant of: it has all of that, with the values given here for its "
                "Params and, by path, for what is in it, and the blocks added here.");
}

} // namespace

void SettingsFields::describe(Describe<SettingsFields>& d) {
    d.help("Settings of the experiment, written at the top level without a block.");
    d.field("Tick", &SettingsFields::tick, seconds().within(1e-5, 0.1), "Length of one step of the simulation.");
    d.field("Duration", &SettingsFields::duration, seconds().within(0, 1e9), "How long to simulate; 0 = until stopped.");
    d.field("Seed", &SettingsFields::seed, whole(0, kLargestWhole), "Start of all random numbers.");
    d.field("Gravity", &SettingsFields::gravity, metresPerSecondSquared().within(-1000, 1000), "Acceleration of free fall.");
    d.field(
        "Engine", &SettingsFields::engine, oneOf("auto|general|wheeled|planar"),
        "General holds everything. Wheeled is many times faster and holds robots on wheels, boxes, cylinders and balls on level "
        "ground. Planar holds the same and is faster still: robots move over the ground and do not lean. Auto is wheeled where "
        "all of the experiment fits it.");
    d.field("Solver", &SettingsFields::solver, oneOf("auto|exact|quick"),
            "Exact, quick, or chosen by the size of the largest cluster of contacts.");
    d.field("Iterations", &SettingsFields::iterations, whole(1, 10000), "Iterations of the quick solver.");
    d.field("Threads", &SettingsFields::threads, whole(0, 64),
            "Threads that compute the motion; 0 = as many as the machine has, where there is work for them. The results do not depend on it.");
    d.field("ErrorReduction", &SettingsFields::errorReduction, number().within(0.05, 0.95),
            "Share of what a joint gapes that one tick closes (ODE's ERP). Less makes joints softer.");
    d.field("Isolation", &SettingsFields::isolation, oneOf("none|module|robot"),
            "Which controllers share a process of their own; not given: none in trundle-cli, module in the window.");
    d.field(
        "NoContact", &SettingsFields::noContact, reference("Robot|Grid|Scatter").counted(2, 1000),
        "Pairs of robots that pass through each other: a,b or a,b, c,d. The name of a Grid or Scatter means all its members.");
    d.field("Title", &SettingsFields::title, text(), "Name of the experiment.");
    d.field("Description", &SettingsFields::description, text(), "What the experiment is about.");
}

void MaterialFields::describe(Describe<MaterialFields>& d) {
    d.help("How a geom looks.");
    const Quantity share = number().within(0, 1);
    d.field("ColorRGB", &MaterialFields::colour, share, "Red, green and blue.");
    d.field("Texture", &MaterialFields::texture, file("jpg|jpeg|png"),
            "Picture on the surface, in place of ColorRGB; white where it is clear. Its ending may be left out.");
    d.field("TextureScale", &MaterialFields::textureScale, number().above(0), "How often the picture is repeated.");
    d.field("TextureMap", &MaterialFields::textureMap, oneOf("auto|planar|box|cylinder|sphere"),
            "How the picture is laid on the surface.");
    d.field("Shininess", &MaterialFields::shininess, share, "0 = matt, 1 = polished.");
    d.field("Opacity", &MaterialFields::opacity, share, "0 = invisible, 1 = opaque.");
    d.field("Emission", &MaterialFields::emission, share, "Light of its own: red, green and blue.");
}

void SurfaceFields::describe(Describe<SurfaceFields>& d) {
    d.help("How a geom touches others. Of a pair hold the smaller friction, the larger restitution and rolling friction, the sum "
           "of softness.");
    d.field("Friction", &SurfaceFields::friction, number().within(0, 1000), "Coefficient of Coulomb friction.");
    d.field(
        "Friction2", &SurfaceFields::friction2, number().within(0, 1000),
        "Coefficient across the geom's direction; Friction is then the one along it. The direction is the geom's x axis, of a "
        "wheel its rolling direction. Without it, friction is the same in all directions.");
    d.field("FrictionHeading", &SurfaceFields::frictionHeading, angles(),
            "From the geom's direction to that of Friction, about the normal towards the geom. No effect without Friction2.");
    d.field("Restitution", &SurfaceFields::restitution, number().within(0, 1), "Share of the speed that a bounce keeps.");
    d.field("RollingFriction", &SurfaceFields::rollingFriction, metres().within(0, 10),
            "Lever of the force that brakes rolling.");
    d.field("Softness", &SurfaceFields::softness, unitOf("m/N").within(0, 1),
            "How far each contact point gives per newton: a spring without damping.");
}

void RobotConfigFields::describe(Describe<RobotConfigFields>& d) {
    d.help("A robot as a whole: bodies, joints and devices, to be placed by Robot, Grid or Scatter.");
    d.field("SelfCollision", &RobotConfigFields::selfCollision, flag(), "Its bodies collide with each other, save joined ones.");
    d.field("NoContact", &RobotConfigFields::noContact, reference("Body").counted(2, 1000),
            "Pairs of its bodies that do not touch each other in spite of SelfCollision: a,b or a,b, c,d.");
    describeVariant(d, "RobotConfig");
}

void StaticConfigFields::describe(Describe<StaticConfigFields>& d) {
    d.help("Scenery: geoms fixed to the world, to be placed by Static.");
    describeVariant(d, "StaticConfig");
}

void PartConfigFields::describe(Describe<PartConfigFields>& d) {
    d.help("Something that robots, scenery or other parts have several times: a wheel with its motor, an axle, a fence. Used by "
           "Part. A reference to something outside of it, $name, is a Param that every use gives.");
    describeVariant(d, "PartConfig");
}

void PartFields::describe(Describe<PartFields>& d) {
    d.help("One use of a PartConfig: what is in it gets the name of the Part in front, left.wheel. Takes values of the config's "
           "Params, and overrides by path.");
    describePose(d, "PartConfig", "Position of the part's frame in the config that it is in.");
    d.field("In", &PartFields::in, reference("Body"), "The body in whose frame Pos and HPR are, in place of the config's.");
    d.field("Mirror", &PartFields::mirror, oneOf("none|x|y|z"),
            "The mirror image along this axis of the part's frame. What turns keeps its sense: a mirrored wheel drives forwards "
            "under the same command.");
}

void RepeatFields::describe(Describe<RepeatFields>& d) {
    d.help(
        "Blocks of a config or of the world, or geoms of a body, that are there several times: rollers, spokes, posts. Its members "
        "are name_0, name_1 "
        "... "
        "In $( ) in it, index is the number of the member, from 0; with Count=8,4 the first one counts fastest and index2 is the "
        "other.");
    d.field("Count", &RepeatFields::count, whole(1, 200000).required().counted(1, 2), "How many; or how many by how many.");
    d.field("Pos", &RepeatFields::pos, position(), "Position of the member's frame in the config or world that it is in.");
    d.field("HPR", &RepeatFields::hpr, angles(), "Heading, pitch and roll of the member's frame.");
    d.field("In", &RepeatFields::in, reference("Body"), "The body in whose frame Pos and HPR are, in place of the config's.");
}

void RingFields::describe(Describe<RingFields>& d) {
    d.help("Blocks of a config or of the world, or geoms of a body, that are there several times in a circle: the rollers of a wheel, the sensors "
           "of a turret. Its "
           "members "
           "are name_0, name_1 ..., each turned about Axis by its share of 360 degrees; in $( ) in it, index is its number.");
    d.field("Count", &RingFields::count, whole(1, 200000).required(), "How many.");
    d.field(
        "Radius", &RingFields::radius, metres().within(0, kFarthestCoordinate).required(),
        "Distance of the members' frames from the axis. The first one is along x from the centre, along y if that is the axis.");
    d.field("Axis", &RingFields::axis, direction(), "Direction of the axis of the circle; need not have length 1.");
    d.field("Pos", &RingFields::pos, position(), "Centre of the circle in the config or world that it is in.");
    d.field("HPR", &RingFields::hpr, angles(), "Heading, pitch and roll of the circle with its members.");
    d.field("In", &RingFields::in, reference("Body"), "The body in whose frame Pos and HPR are, in place of the config's.");
}

void RobotFields::describe(Describe<RobotFields>& d) {
    d.help("One robot in the world. Holds its controllers, values of the config's Params, and overrides by path. Without "
           "joints, "
           "devices and a controller it is a movable object, a ball or a crate, and is counted as one.");
    describePose(d, "RobotConfig", "Position of its config frame at the start.");
}

void StaticFields::describe(Describe<StaticFields>& d) {
    d.help("One piece of scenery in the world.");
    describePose(d, "StaticConfig", "Its position.");
}

void GridFields::describe(Describe<GridFields>& d) {
    d.help("Equal robots, or pieces of scenery, in rows. Takes what a Robot or Static takes; its members are name_0, name_1 ...");
    describePose(d, "RobotConfig|StaticConfig", "Centre of the pattern.");
    d.field("Count", &GridFields::count, whole(1, 200000).required().counted(1, 2), "How many along x, and along y.");
    d.field("Spacing", &GridFields::spacing, metres().within(0, kFarthestCoordinate).required().counted(1, 2),
            "Distance between neighbours, or along x and along y.");
}

void ScatterFields::describe(Describe<ScatterFields>& d) {
    d.help("Equal robots, or pieces of scenery, at random places clear of each other and of everything else. Takes what a Robot "
           "or Static takes; its members are name_0, name_1 ...");
    describePose(d, "RobotConfig|StaticConfig", "Origin of the area.");
    d.field("Count", &ScatterFields::count, whole(1, 200000).required(), "How many.");
    d.field("Area", &ScatterFields::area, position().required(), "x0, y0, x1, y1 about Pos.");
    d.field("MinDistance", &ScatterFields::minDistance, metres().within(0, kFarthestCoordinate),
            "Between the members' origins; where absent, circles around the largest of them just do not touch.");
    d.field("Heading", &ScatterFields::heading, angles(), "Of every member; random where absent.");
    d.field("Seed", &ScatterFields::seed, whole(0, kLargestWhole), "0 = the experiment's.");
}

void LightFields::describe(Describe<LightFields>& d) {
    d.help("A light: the sun, which replaces the one that everything has, or a lamp.");
    d.field("Mode", &LightFields::mode, oneOf("sun|lamp"), "The first sun counts, and up to eight lamps.");
    d.field("Pos", &LightFields::pos, position(), "Of a lamp.");
    d.field("Direction", &LightFields::direction, number().within(-1e6, 1e6), "Which way the sun shines.");
    d.field("ColorRGB", &LightFields::colour, number().within(0, 1), "Red, green and blue.");
    d.field("Intensity", &LightFields::intensity, number().within(0, 1e6), "Factor on its light; of a lamp, at 1 m.");
    d.field("Shadows", &LightFields::shadows, flag(),
            "Whether it casts shadows on floors. Of the lamps that do, the first three count.");
}

void SkyFields::describe(Describe<SkyFields>& d) {
    d.help("The sky, and the light that comes from everywhere.");
    const Quantity share = number().within(0, 1);
    d.field("Zenith", &SkyFields::zenith, share, "Colour of the sky above: red, green and blue.");
    d.field("Horizon", &SkyFields::horizon, share, "Colour of the sky low down, and of what is very far.");
    d.field("Ambient", &SkyFields::ambient, number().within(0, 100), "Factor on the light that comes from sky and ground.");
}

void ViewFields::describe(Describe<ViewFields>& d) {
    d.help("A place to look from, for pictures and movies.");
    d.field("Mode", &ViewFields::mode, oneOf("fixed|follow|chase"),
            "Fixed in the world; carried along with a robot; or carried and turned with it.");
    d.field("Eye", &ViewFields::eye, position(), "Where it looks from; with a robot, from its origin.");
    d.field("Target", &ViewFields::target, position(), "What is in its middle, in the same frame.");
    d.field("Robot", &ViewFields::robot, reference("Robot"), "Which robot carries it.");
    d.field("FieldOfView", &ViewFields::fieldOfView, degrees().within(1, 170), "From the left edge to the right one.");
}

void RegionFields::describe(Describe<RegionFields>& d) {
    d.help("A box in the world that reports which robots are in it: a goal, a lap line, a zone. Nothing touches it. A robot is "
           "inside "
           "while the point that its pose reports is.");
    d.field("Pos", &RegionFields::pos, position(), "Position of its centre.");
    d.field("HPR", &RegionFields::hpr, angles(), "Heading, pitch and roll.");
    d.field("Size", &RegionFields::size, metres().above(0).atMost(2 * kFarthestCoordinate).required(),
            "Full lengths along x, y and z.");
    d.field("Robots", &RegionFields::robots, reference("Robot|Grid|Scatter").counted(1, 1000),
            "That it reports; all where absent.");
    d.output("count", "", "How many robots are inside.", 1, TRUNDLE_INTEGER_SIGNAL);
    d.output("entered", "", "How often one has entered since the start.", 1, TRUNDLE_INTEGER_SIGNAL);
    d.output("left", "", "How often one has left since the start.", 1, TRUNDLE_INTEGER_SIGNAL);
    d.output("inside", "", "Of each robot that it reports, in the order of the text: whether it is inside.", 1,
             TRUNDLE_BOOLEAN_SIGNAL);
}

void ControllerFields::describe(Describe<ControllerFields>& d) {
    d.field("UpdatePeriod", &ControllerFields::updatePeriod, seconds().within(0, 1e6),
            "Time between its updates; 0 = every tick.");
    d.field("Isolation", &ControllerFields::isolation, oneOf("none|module|robot"),
            "Which controllers share its process; not given: as the experiment says.");
    d.field("Budget", &ControllerFields::budget, milliseconds().above(0),
            "Time an update may take before it is reported as slow.");
}

} // namespace trundle
