// The crowd of bare_ode.cpp on MuJoCo: the same robots, room and commands, nothing else.
//
// Differs: wheels follow their rates by a stiff damper without a torque limit, since MuJoCo computes dampers implicitly; tyres
// meet the floor as spheres, which have one contact below the axle, as Trundle's have. MuJoCo 2 takes all memory at the start, with the square of the
// rows of contacts: it refuses 1,000 robots.
//
//   bare_mujoco -n 100 -t 20 -h 0.01 [-nx 10 -ny 10]     prints one line: rtf=... us_per_robot_tick=... contacts_per_robot=... x=... y=... kb=...

#include <chrono>
#include <cstdarg>
#include <cstring>
#include <memory>
#include <vector>

#include <mujoco/mujoco.h>

#include "bench/crowd.h"

namespace {

using namespace crowd;

constexpr double kServo = 0.5; // N m s

void add(std::string& text, const char* pattern, ...) __attribute__((format(printf, 2, 3)));
void add(std::string& text, const char* pattern, ...) {
    char line[1000];
    va_list values;
    va_start(values, pattern);
    std::vsnprintf(line, sizeof line, pattern, values);
    va_end(values);
    text += line;
}

/// Of two geoms the friction of the one with the higher priority holds: plastic against all, nothing for the slider.
void addRobot(std::string& text, int index, std::array<double, 2> at) {
    const auto box = [&](const std::array<double, 3>& size, const std::array<double, 3>& place, double mass) {
        add(text,
            R"(<geom type="box" size="%g %g %g" pos="%g %g %g" mass="%g" friction="%g" priority="1" contype="2" conaffinity="2"/>)",
            size[0] / 2, size[1] / 2, size[2] / 2, place[0], place[1], place[2], mass, kPlasticFriction);
    };
    add(text, R"(<body pos="%.6f %.6f 0"><freejoint/>)", at[0], at[1]);
    box(kHullSize, kHullAt, kHullMass);
    box(kBumperSize, kBumperAt, kBumperMass);
    add(text, R"(<geom type="sphere" size="%g" pos="%g %g %g" mass="%g" condim="1" priority="2" contype="0" conaffinity="1"/>)",
        kSliderRadius, kSliderAt[0], kSliderAt[1], kSliderAt[2], kSliderMass);
    for (const int side : {0, 1}) {
        add(text, R"(<body pos="%g %g %g"><joint name="w%d_%d" type="hinge" axis="0 1 0" damping="%g"/>)", kAxleX,
            side == 0 ? kTrack / 2 : -kTrack / 2, kWheelRadius, index, side, kServo);
        add(text, R"(<geom type="cylinder" size="%g %g" euler="90 0 0" mass="%g" friction="%g" contype="2" conaffinity="2"/>)",
            kWheelRadius, kWheelWidth / 2, kWheelMass, kTyreFriction);
        add(text, R"(<geom type="sphere" size="%g" mass="0" friction="%g" contype="0" conaffinity="1"/></body>)", kWheelRadius,
            kTyreFriction);
    }
    text += "</body>";
}

std::string modelText(const Options& options) {
    const double x = halfRoom(options.columns), y = halfRoom(options.rows);
    const long rows = 40L * options.count + 200,
               stack = 2'000'000 + 20'000L * options.count + 400L * options.count * options.count;
    std::string text;
    add(text, R"(<mujoco><size nconmax="%d" njmax="%ld" nstack="%ld"/>)", 16 * options.count + 60, rows, stack);
    add(text,
        R"(<option timestep="%g" solver="Newton" cone="pyramidal" jacobian="sparse"/><default><geom condim="3"/></default><worldbody>)",
        options.tick);
    add(text, R"(<geom type="plane" size="0 0 1" friction="%g" contype="1" conaffinity="1"/>)", kTyreFriction);
    const auto wall = [&](double atX, double atY, double halfX, double halfY) {
        add(text,
            R"(<geom type="box" size="%g %g 0.15" pos="%g %g 0.15" friction="%g" priority="1" contype="2" conaffinity="2"/>)",
            halfX, halfY, atX, atY, kPlasticFriction);
    };
    for (const int side : {-1, 1}) {
        wall(0, side * (y + 0.05), x + 0.1, 0.05);
        wall(side * (x + 0.05), 0, 0.05, y);
    }
    for (int i = 0; i < options.count; ++i) addRobot(text, i, startOf(i, options));
    text += "</worldbody><actuator>";
    for (int i = 0; i < options.count; ++i)
        for (const int side : {0, 1}) add(text, R"(<motor joint="w%d_%d"/>)", i, side);
    return text + "</actuator></mujoco>";
}

mjModel* load(const std::string& text) {
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    if (mj_makeEmptyFileVFS(files.get(), "crowd.xml", static_cast<int>(text.size())) != 0) return nullptr;
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), "crowd.xml")], text.data(), text.size());
    char why[1000] = "";
    mjModel* model = mj_loadXML("crowd.xml", files.get(), why, sizeof why);
    if (!model) std::fprintf(stderr, "bare_mujoco: %s\n", why);
    mj_deleteVFS(files.get());
    return model;
}

} // namespace

int main(int argc, char** argv) {
    const Options options = parse("bare_mujoco", argc, argv);
    mjModel* model = load(modelText(options));
    mjData* data = model ? mj_makeData(model) : nullptr;
    if (!data) return 1;
    std::vector<Drive> drives;
    for (int i = 0; i < options.count; ++i) drives.emplace_back(static_cast<std::size_t>(i));
    const long ticks = std::lround(options.seconds / options.tick);
    long contacts = 0;
    const auto start = std::chrono::steady_clock::now();
    for (long i = 0; i < ticks; ++i) {
        for (std::size_t k = 0; k < drives.size(); ++k) {
            drives[k].think(i, options.tick);
            const std::array<double, 2> rates = drives[k].wheelRates();
            for (std::size_t side = 0; side < 2; ++side) data->ctrl[2 * k + side] = kServo * rates[side];
        }
        mj_step(model, data);
        contacts += data->ncon;
    }
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("rtf=%.4f us_per_robot_tick=%.4f contacts_per_robot=%.3f outside=0 x=%.9f y=%.9f kb=%ld\n",
                options.seconds / wall, wall * 1e6 / static_cast<double>(ticks) / options.count,
                static_cast<double>(contacts) / static_cast<double>(ticks) / options.count, data->qpos[0], data->qpos[1],
                peakKb());
    mj_deleteData(data);
    mj_deleteModel(model);
    return 0;
}
