#include "app/arena_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/module_template.h"
#include "assets/asset_reader.h"
#include "base/clean_text.h"
#include "base/platform/atomic_file.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr double kRobot = 0.25; // m, around a robot that is to drive

/// `picture`: copied beside them; empty: none.
Result<NewArena> writeArena(const std::string& name, const std::string& parent, const std::string& text,
                            const std::string& experiment, const std::string& picture = {}) {
    const std::string file = moduleNameFor(name);
    const fs::path folder = fs::path(parent) / file;
    std::error_code ec;
    if (!fs::create_directory(folder, ec))
        return Error{Code::FileUnwritable, cleanLine(folder.string()) + " cannot be made: " +
                                               (ec ? cleanLine(ec.message()) : "it exists; choose another name or folder")};
    NewArena made{folder.string(), {}, (folder / (file + "_drive.sim")).string()};
    for (const auto& [path, content] : {std::pair{file + ".sim", text}, {file + "_drive.sim", experiment}}) {
        if (const Status written = writeFileAtomically((folder / path).string(), content); !written) {
            fs::remove_all(folder, ec); // made above, so all in it is ours
            return written.error();
        }
        made.files.push_back(path);
    }
    if (picture.empty()) return made;
    const fs::path copy = fs::path(picture).filename();
    if (!fs::copy_file(picture, folder / copy, ec)) {
        Error failed{Code::FileUnwritable, cleanLine(picture) + " cannot be copied: " + cleanLine(ec.message())};
        fs::remove_all(folder, ec);
        return failed;
    }
    made.files.push_back(copy.string());
    return made;
}

} // namespace

std::string arenaNameFault(const std::string& name) { return configNameFault("an arena", name, "Office", "SimpleRobot"); }

Result<std::shared_ptr<const HeightMap>> readPlanPicture(const std::string& picture, const Locations& locations) {
    return AssetReader(locations.meshReader).heightMap(fs::absolute(picture).string());
}

Result<FloorPlan> readFloorPlan(const std::string& picture, const FloorPlanOptions& options, const Locations& locations) {
    const auto read = readPlanPicture(picture, locations);
    if (!read) return read.error();
    return floorPlanFrom(*read.value(), options);
}

Result<NewArena> makePlanArena(const std::string& name, const FloorPlan& plan, double height, const std::string& picture,
                               const std::string& parent) {
    if (const std::string fault = arenaNameFault(name); !fault.empty()) return Error{Code::OutOfRange, fault};
    if (!(height >= 0.01 && height <= 100)) return Error{Code::OutOfRange, "The height of the walls must be from 0.01 to 100 m."};
    if (plan.room < kRobot)
        return Error{Code::OutOfRange, "No robot fits between the walls: make the plan wider, or check the threshold."};
    const double across = std::max(plan.columns, plan.rows) * plan.cell;
    return writeArena(name, parent, arenaText(name, plan, height, fs::path(picture).filename().string()),
                      arenaExperimentText(name, moduleNameFor(name), plan.freest, across));
}

Result<NewArena> makeObstacleArena(const std::string& name, const ObstacleField& field, const std::string& parent) {
    if (const std::string fault = arenaNameFault(name); !fault.empty()) return Error{Code::OutOfRange, fault};
    const Result<std::string> text = obstacleText(name, field);
    if (!text) return text.error();
    return writeArena(name, parent, text.value(),
                      arenaExperimentText(name, moduleNameFor(name), {0, 0}, std::max(field.length, field.width)));
}

Result<NewArena> makeRoomArena(const std::string& name, const RoomPlan& plan, const std::string& comment,
                               const std::string& parent) {
    if (const std::string fault = arenaNameFault(name); !fault.empty()) return Error{Code::OutOfRange, fault};
    return writeArena(
        name, parent, roomText(name, plan, comment),
        arenaExperimentText(name, moduleNameFor(name), {plan.startX, plan.startY}, std::max(plan.length, plan.width)));
}

Result<NewArena> makeHeightsArena(const std::string& name, const std::string& picture, const std::array<double, 3>& size,
                                  const std::string& parent, const Locations& locations) {
    if (const std::string fault = arenaNameFault(name); !fault.empty()) return Error{Code::OutOfRange, fault};
    const auto read = readPlanPicture(picture, locations);
    if (!read) return read.error();
    const Result<std::string> ground = heightsText(fs::path(picture).filename().string(), size);
    if (!ground) return ground.error();
    const double start = heightAt(*read.value(), size, {0, 0}, kRobot);
    return writeArena(name, parent, heightsArenaText(name, ground.value()),
                      arenaExperimentText(name, moduleNameFor(name), {0, 0}, std::max(size[0], size[1]), start), picture);
}

} // namespace trundle
