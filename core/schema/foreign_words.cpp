#include "schema/foreign_words.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/spelling.h"

namespace trundle {
namespace {

struct Meaning {
    std::string_view foreign; ///< in small letters, separated by blanks
    std::string_view ours;    ///< the same, as written here
};

// The words of URDF and SDF (their specifications), of the manuals of Webots, CoppeliaSim and MuJoCo, and everyday ones.
constexpr std::array<Meaning, 45> kMeanings{{
    {"link rigidbody solid", "Body"},
    {"revolute revolutejoint hingejoint continuous pivot axle rotational", "Hinge"},
    {"prismatic prismaticjoint sliderjoint linear linearjoint", "Slider"},
    {"balljoint spherical sphericaljoint socket ballsocket", "Ball"},
    {"fixedjoint weld rigid", "Fixed"},
    {"universaljoint cardan", "Universal"},
    {"joint", "Hinge Slider Ball Fixed"},
    {"motor engine actuator dcmotor rotationalmotor rotarymotor", "RotaryMotor LinearMotor Servo"},
    {"damper shock springdamper", "Spring Suspension"},
    {"wheel roller disc disk tyre tire", "Cylinder"},
    {"shape geometry geom collision visual boundingobject", "Box Sphere Cylinder"},
    {"cube block cuboid", "Box"},
    {"hull convexhull", "Convex"},
    {"terrain elevationgrid elevation heightmap hfield", "Heightfield"},
    {"floor ground groundplane", "Plane"},
    {"loop array for foreach pattern linearpattern", "Repeat Grid"},
    {"circle circular polar polararray circulararray", "Ring"},
    {"zone area trigger goal volume", "Region"},
    {"connector magnet sucker vacuumgripper attach", "Latch"},
    {"distancesensor rangefinder ultrasonic sonar infrared proximity proximitysensor ir", "RangeSensor"},
    {"laser laserscanner ray gpuray scanner", "Lidar"},
    {"gyro gyroscope accelerometer inertialunit inertial", "Imu"},
    {"bumper contactsensor bumpersensor", "TouchSensor"},
    {"positionsensor jointsensor resolver", "Encoder"},
    {"force torquesensor forcetorque ftsensor loadcell", "ForceSensor"},
    {"sensor detector", "RangeSensor TouchSensor Camera"},
    {"radio emitter receiver wifi", "Transceiver"},
    {"robotmodel model prefab proto", "RobotConfig"},
    {"arena world scene environment", "StaticConfig"},
    {"template macro module subassembly assembly group", "PartConfig"},
    {"from body1 bodya body0 linka link1 parentlink base", "Parent"},
    {"to body2 bodyb linkb link2 childlink", "Child"},
    {"lower lowerlimit lowlimit minangle lowerstop minstop minposition", "LowStop"},
    {"upper upperlimit highlimit maxangle upperstop maxstop maxposition", "HighStop"},
    {"limit limits range stops", "LowStop HighStop"},
    {"n number copies times repetitions instances", "Count"},
    {"diameter", "Radius"},
    {"height depth", "Length"},
    {"position translation location origin xyz pose place offset", "Pos"},
    {"rotation orientation rpy euler angles rot yaw", "HPR"},
    {"dimensions extents extent width scale halfextents", "Size"},
    {"distance gap", "Spacing MinDistance"},
    {"color colour appearance texture", "Material ColorRGB"},
    {"gearratio reduction ratio", "GearRatio Ratio"},
    {"weight", "Mass"},
}};

std::string plain(std::string_view word) {
    std::string small;
    for (const char c : word)
        if (c != '_') small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

/// Calls `take` with each of some words, until it returns true.
template <class Take> bool eachWord(std::string_view words, Take take) {
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (take(words.substr(0, end))) return true;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return false;
}

} // namespace

std::vector<std::string> foreignWords(std::string_view word, std::span<const std::string> candidates) {
    const std::string small = plain(word);
    std::vector<std::string> meant;
    for (const auto& [foreign, ours] : kMeanings) {
        if (!eachWord(foreign, [&](std::string_view each) { return each == small; })) continue;
        eachWord(ours, [&](std::string_view each) {
            const bool isThere = std::ranges::find(candidates, each) != candidates.end();
            if (isThere && std::ranges::find(meant, each) == meant.end()) meant.emplace_back(each);
            return false;
        });
    }
    return meant;
}

std::vector<std::string> meantWords(std::string_view word, std::span<const std::string> candidates) {
    std::vector<std::string> meant = foreignWords(word, candidates);
    return meant.empty() ? nearestWords(word, candidates) : meant;
}

} // namespace trundle
