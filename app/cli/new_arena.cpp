#include "cli/new_arena.h"

#include <algorithm>
#include <cstdio>

#include "base/clean_text.h"
#include "cli/messages.h"
#include "cli/standard_streams.h"

namespace trundle {

namespace {

constexpr const char* kRoomGroup = "Of a room or a maze";

void addRoomOptions(CLI::App& command, ArenaArguments& a) {
    const auto add = [&](const char* name, auto& to, const char* help, const char* type) {
        return command.add_option(name, to, help)->type_name(type)->group(kRoomGroup);
    };
    add("--room", a.roomSize, "A room: its length along x and its width along y, inside", "M")->expected(2);
    add("--maze", a.mazeSize, "A maze: its rows and columns", "N")->expected(2);
    add("--door", a.doorSide, "Of the room, an opening in the middle of a side: north, east, south, west", "SIDE")
        ->check(CLI::IsMember({"none", "north", "east", "south", "west"}));
    add("--door-width", a.room.doorWidth, "0.8", "M");
    add("--cell", a.maze.cell, "Of the maze, from the middle of a wall to that of the next: 0.6", "M");
    add("--wall-thickness", a.wallThickness, "0.1, of a maze 0.05", "M");
    add("--maze-seed", a.maze.seed, "The same seed gives the same maze: 1", "N");
}

/// An option, and those of which one has to be given with it; none: of an arena with obstacles.
struct Companions {
    const char* option;
    std::vector<const char*> with;
};
const std::vector<const char*> kSorts = {"--plan", "--room", "--maze", "--heights"};
const std::vector<Companions> kCompanions = {{"--plan-width", {"--plan"}},
                                             {"--threshold", {"--plan"}},
                                             {"--light-walls", {"--plan"}},
                                             {"--most-boxes", {"--plan"}},
                                             {"--wall-height", {"--plan", "--room", "--maze"}},
                                             {"--wall-thickness", {"--room", "--maze"}},
                                             {"--door", {"--room"}},
                                             {"--door-width", {"--room"}},
                                             {"--cell", {"--maze"}},
                                             {"--maze-seed", {"--maze"}},
                                             {"--heights-size", {"--heights"}},
                                             {"--obstacles", {}},
                                             {"--room-length", {}},
                                             {"--room-width", {}},
                                             {"--apart", {}},
                                             {"--field-seed", {}}};

RoomSide sideNamed(const std::string& name) {
    constexpr const char* kNames[] = {"none", "north", "east", "south", "west"};
    for (int i = 0; i < 5; ++i)
        if (name == kNames[i]) return static_cast<RoomSide>(i);
    return RoomSide::None;
}

std::string withNumbers(const char* format, double a, double b) {
    char text[160];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

Result<NewArena> makeRoom(ArenaArguments a, const std::string& name, const std::string& parent, std::string& text) {
    const bool isMaze = !a.mazeSize.empty();
    if (isMaze) {
        a.maze.rows = a.mazeSize[0], a.maze.columns = a.mazeSize[1];
        a.maze.height = a.wallHeight.value_or(a.maze.height), a.maze.thickness = a.wallThickness.value_or(a.maze.thickness);
    } else {
        a.room.length = a.roomSize[0], a.room.width = a.roomSize[1], a.room.doorSide = sideNamed(a.doorSide);
        a.room.height = a.wallHeight.value_or(a.room.height), a.room.thickness = a.wallThickness.value_or(a.room.thickness);
    }
    const Result<RoomPlan> plan = isMaze ? mazePlan(a.maze) : roomPlan(a.room);
    if (!plan) return plan.error();
    text = "\n" + std::to_string(plan.value().walls.size()) + " walls, " +
           withNumbers("%.4g m x %.4g m", plan.value().length, plan.value().width);
    return makeRoomArena(name, plan.value(), name + ": " + (isMaze ? describe(a.maze) : describe(a.room)), parent);
}

} // namespace

void addArenaOptions(CLI::App& command, ArenaArguments& a) {
    const auto add = [&](const char* name, auto& to, const char* help, const char* type, const char* group) {
        return command.add_option(name, to, help)->type_name(type)->group(group);
    };
    constexpr const char *kPlan = "Of an arena from a floor plan", *kField = "Of an arena with obstacles",
                         *kHeights = "Of an arena from a height map";
    add("--plan", a.picture, "A picture: PNG, JPEG, BMP, PGM or PPM; what is dark is wall", "FILE", kPlan)
        ->check(CLI::ExistingFile);
    add("--plan-width", a.plan.width, "Of the whole picture, 10 where it is not given", "M", kPlan);
    add("--threshold", a.plan.threshold, "Of the brightness, between 0 and 1: 0.5", "T", kPlan);
    command.add_flag("--light-walls", a.plan.isInverted, "What is light is wall")->group(kPlan);
    add("--wall-height", a.wallHeight, "0.5, of a maze 0.3", "M", kPlan);
    add("--most-boxes", a.plan.mostBoxes, "A picture that needs more is made coarser: 2000", "N", kPlan)
        ->check(CLI::Range(1, 20000));
    add("--obstacles", a.field.count, "How many boxes and cylinders: 12", "N", kField);
    add("--room-length", a.field.length, "Inside: 6", "M", kField);
    add("--room-width", a.field.width, "Inside: 4", "M", kField);
    add("--apart", a.field.apart, "Least distance between two obstacles: 0.35", "M", kField);
    add("--field-seed", a.field.seed, "The same seed gives the same field: 1", "N", kField);
    addRoomOptions(command, a);
    add("--heights", a.heights, "A grey picture, black is low: PNG, also of 16 bit, JPEG, BMP, PGM or PPM", "FILE", kHeights)
        ->check(CLI::ExistingFile);
    add("--heights-size", a.heightsSize, "Along x, along y and height of white: 10 10 1", "M", kHeights)->expected(3);
}

void checkArenaOptions(const CLI::App& command) {
    const auto isGiven = [&](const char* name) { return command.get_option(name)->count() > 0; };
    const auto sort = std::ranges::find_if(kSorts, isGiven);
    for (const char* other : kSorts)
        if (sort != kSorts.end() && isGiven(other) && other != *sort)
            throw CLI::ValidationError(other, "an arena is made from one thing: not with " + std::string(*sort));
    for (const auto& [option, with] : kCompanions) {
        if (!isGiven(option) || std::ranges::any_of(with, isGiven)) continue;
        if (with.empty() && sort == kSorts.end()) continue;
        std::string names = with.empty() ? "it is for an arena with obstacles: not with " + std::string(*sort) : "only with ";
        for (std::size_t i = 0; i < with.size(); ++i)
            names += (i == 0 ? "" : i + 1 == with.size() ? " or " : ", ") + std::string(with[i]);
        throw CLI::ValidationError(option, names);
    }
}

ExitCode makeNewArena(const ArenaArguments& a, const std::string& name, const std::string& parent, const Locations& locations) {
    std::string text;
    Result<NewArena> made = [&]() -> Result<NewArena> {
        if (!a.roomSize.empty() || !a.mazeSize.empty()) return makeRoom(a, name, parent, text);
        if (!a.heights.empty())
            return makeHeightsArena(name, a.heights, {a.heightsSize[0], a.heightsSize[1], a.heightsSize[2]}, parent, locations);
        if (a.picture.empty()) return makeObstacleArena(name, a.field, parent);
        const Result<FloorPlan> plan = readFloorPlan(a.picture, a.plan, locations);
        if (!plan) return plan.error();
        char walls[160];
        std::snprintf(walls, sizeof walls, "\n%zu walls, %.4g m x %.4g m; a cell is %.4g m", plan.value().walls.size(),
                      plan.value().columns * plan.value().cell, plan.value().rows * plan.value().cell, plan.value().cell);
        text = walls;
        if (plan.value().step > 1) text += ", " + std::to_string(plan.value().step) + " pixels, since more boxes would be needed";
        return makePlanArena(name, plan.value(), a.wallHeight.value_or(0.5), a.picture, parent);
    }();
    if (!made) {
        printProblem(made.error().message);
        return kExitUsage;
    }
    std::string wrote = "wrote";
    for (const std::string& file : made.value().files) wrote += ' ' + cleanLine(made.value().folder) + '/' + file;
    return writeOut(wrote + text + "\n\nTo see it:\n  trundle " + cleanLine(made.value().experiment) + "\n") ? kExitDone
                                                                                                             : kExitText;
}

} // namespace trundle
