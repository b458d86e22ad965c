// Method: each obstacle is tried at random places until the circle around it is far enough from those of the others.

#include "project/wizard/obstacle_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/rng.h"

namespace trundle {
namespace {

constexpr int kTries = 2000;     // of places for one obstacle
constexpr double kHighest = 0.4; // m

struct Circle {
    double x = 0, y = 0, radius = 0; // m
};

double tenthOfMillimetre(double metres) { return std::round(metres * 1e4) / 1e4 + 0.0; }

Error fieldFault(std::string text) { return Error{Code::OutOfRange, std::move(text)}; }

} // namespace

Result<std::vector<FieldObstacle>> obstacleField(const ObstacleField& f) {
    const bool isRoom = f.length >= 1 && f.length <= 1000 && f.width >= 1 && f.width <= 1000;
    if (!isRoom) return fieldFault("The room must be from 1 to 1000 m long and wide.");
    if (f.count < 0 || f.count > 2000) return fieldFault("There can be up to 2000 obstacles.");
    if (!(f.least >= 0.02 && f.least <= f.most && f.most <= 100 && f.apart >= 0 && f.apart <= 100))
        return fieldFault("Obstacles are from 0.02 to 100 m across, and at most 100 m apart.");
    std::uint64_t draws = 0;
    const auto between = [&](double low, double high) {
        return low + (high - low) * toUnit(randomBits(f.seed, fnv1a64("obstacles"), 0, draws++));
    };
    std::vector<Circle> taken;
    for (const auto& [x, y, radius] : f.free) taken.push_back({x, y, radius});
    std::vector<FieldObstacle> placed;
    for (int i = 1; i <= f.count; ++i) {
        FieldObstacle at;
        at.isRound = between(0, 1) < 0.5;
        at.name = (at.isRound ? "drum" : "crate") + std::to_string(i);
        at.across = between(f.least, f.most), at.deep = at.isRound ? at.across : between(f.least, at.across);
        at.heading = at.isRound ? 0 : between(-90, 90), at.high = between(0.5, 1) * kHighest;
        const double radius = at.isRound ? at.across / 2 : std::hypot(at.across, at.deep) / 2;
        int tries = 0;
        const auto isTaken = [&] {
            const auto isNear = [&](const Circle& o) { return std::hypot(o.x - at.x, o.y - at.y) < o.radius + radius + f.apart; };
            const auto isBeside = [&](const std::array<double, 4>& o) {
                const double x = at.x - std::clamp(at.x, o[0], o[2]), y = at.y - std::clamp(at.y, o[1], o[3]);
                return std::hypot(x, y) < radius + f.apart;
            };
            return std::ranges::any_of(taken, isNear) || std::ranges::any_of(f.occupied, isBeside);
        };
        const double farX = f.length / 2 - radius, farY = f.width / 2 - radius;
        do {
            if (++tries > kTries || farX <= 0 || farY <= 0)
                return Error{Code::PlacementFailed, "There is no room for " + std::to_string(f.count) +
                                                        " obstacles: the room has " + std::to_string(i - 1) +
                                                        ". Make it larger, or them fewer, smaller or closer."};
            at.x = between(-farX, farX), at.y = between(-farY, farY);
        } while (isTaken());
        taken.push_back({at.x, at.y, radius});
        placed.push_back(std::move(at));
    }
    return placed;
}

std::string obstacleLine(const FieldObstacle& o) {
    char text[300];
    const char* const name = o.name.c_str();
    const double x = tenthOfMillimetre(o.x), y = tenthOfMillimetre(o.y);
    if (o.isRound) {
        std::snprintf(text, sizeof text,
                      "Cylinder %s { Pos=%.4g,%.4g,%.3g Radius=%.3g Length=%.3g Material=blue Surface=wall }\n", name, x, y,
                      o.high / 2, o.across / 2, o.high);
    } else {
        char turn[40] = "";
        if (const double heading = std::round(o.heading); heading != 0)
            std::snprintf(turn, sizeof turn, " HPR=%.0f,0,0", heading);
        std::snprintf(text, sizeof text, "Box %s { Pos=%.4g,%.4g,%.3g Size=%.3g,%.3g,%.3g%s Material=wood Surface=wall }\n", name,
                      x, y, o.high / 2, o.across, o.deep, o.high, turn);
    }
    return text;
}

} // namespace trundle
