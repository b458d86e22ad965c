#include "cli/new_arena.h"

#include <cstdio>

#include "base/clean_text.h"
#include "cli/messages.h"
#include "cli/standard_streams.h"

namespace trundle {

void addArenaOptions(CLI::App& command, ArenaArguments& a) {
    const auto add = [&](const char* name, auto& to, const char* help, const char* type, const char* group) {
        return command.add_option(name, to, help)->type_name(type)->group(group);
    };
    constexpr const char *kPlan = "Of an arena from a floor plan", *kField = "Of an arena with obstacles";
    add("--plan", a.picture, "A picture: PNG, JPEG, BMP, PGM or PPM; what is dark is wall", "FILE", kPlan)
        ->check(CLI::ExistingFile);
    add("--plan-width", a.plan.width, "Of the whole picture, 10 where it is not given", "M", kPlan);
    add("--threshold", a.plan.threshold, "Of the brightness, between 0 and 1: 0.5", "T", kPlan);
    command.add_flag("--light-walls", a.plan.isInverted, "What is light is wall")->group(kPlan);
    add("--wall-height", a.wallHeight, "0.5", "M", kPlan);
    add("--most-boxes", a.plan.mostBoxes, "A picture that needs more is made coarser: 2000", "N", kPlan)
        ->check(CLI::Range(1, 20000));
    add("--obstacles", a.field.count, "How many boxes and cylinders: 12", "N", kField);
    add("--room-length", a.field.length, "Inside: 6", "M", kField);
    add("--room-width", a.field.width, "Inside: 4", "M", kField);
    add("--apart", a.field.apart, "Least distance between two obstacles: 0.35", "M", kField);
    add("--field-seed", a.field.seed, "The same seed gives the same field: 1", "N", kField);
}

ExitCode makeNewArena(const ArenaArguments& a, const std::string& name, const std::string& parent, const Locations& locations) {
    std::string text;
    Result<NewArena> made = [&]() -> Result<NewArena> {
        if (a.picture.empty()) return makeObstacleArena(name, a.field, parent);
        const Result<FloorPlan> plan = readFloorPlan(a.picture, a.plan, locations);
        if (!plan) return plan.error();
        char walls[160];
        std::snprintf(walls, sizeof walls, "\n%zu walls, %.4g m x %.4g m; a cell is %.4g m", plan.value().walls.size(),
                      plan.value().columns * plan.value().cell, plan.value().rows * plan.value().cell, plan.value().cell);
        text = walls;
        if (plan.value().step > 1) text += ", " + std::to_string(plan.value().step) + " pixels, since more boxes would be needed";
        return makePlanArena(name, plan.value(), a.wallHeight, a.picture, parent);
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
