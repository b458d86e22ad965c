// Method: at a corner both pieces reach as far as their outer edges meet, thickness/2 * tan(turn/2), at most half a thickness.

#include "project/wizard/floor_path.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace trundle {
namespace {

constexpr double kSame = 5e-5; // m
constexpr double kDegree = std::numbers::pi / 180;

double lengthOf(const FloorPoint& a, const FloorPoint& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

double directionOf(const FloorPoint& a, const FloorPoint& b) { return std::atan2(b[1] - a[1], b[0] - a[0]); }

/// How far both pieces reach past the corner at `b`.
double reachAt(const FloorPoint& a, const FloorPoint& b, const FloorPoint& c, double thickness) {
    const double turn = std::abs(std::remainder(directionOf(b, c) - directionOf(a, b), 2 * std::numbers::pi));
    return thickness / 2 * std::min(1.0, std::tan(std::min(turn, 3.0) / 2));
}

std::string withName(const FloorPathStyle& style, std::size_t number) { return std::string(style.name) + std::to_string(number); }

/// A wall has no front: the heading is above -90 and up to 90 degrees, exact where it is nearly a multiple of a quarter turn.
double headingOf(double direction) {
    double degrees = std::round(std::remainder(direction / kDegree, 180.) * 100) / 100 + 0.0;
    if (degrees <= -90) degrees += 180;
    return degrees;
}

} // namespace

std::string tidyNumber(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", std::round(value * 1e4) / 1e4 + 0.0);
    return text;
}

FloorPathStyle wallPath() { return {.config = "Wall", .name = "wall"}; }

FloorPathStyle linePath() {
    return {.config = "FloorLine",
            .name = "line",
            .length = 1,
            .thickness = 0.018,
            .top = 0.001,
            .material = "black",
            .surface = "ground",
            .collides = false};
}

std::vector<FloorPiece> piecesAlong(const std::vector<FloorPoint>& corners, double thickness) {
    std::vector<FloorPoint> path;
    for (const FloorPoint& corner : corners)
        if (path.empty() || lengthOf(path.back(), corner) > kSame) path.push_back(corner);
    const bool isClosed = path.size() > 3 && lengthOf(path.front(), path.back()) < kSame;
    std::vector<FloorPiece> pieces;
    const std::size_t count = path.empty() ? 0 : path.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const FloorPoint &from = path[i], &to = path[i + 1];
        double before = 0, after = 0;
        if (i > 0 || isClosed) before = reachAt(i > 0 ? path[i - 1] : path[count - 1], from, to, thickness);
        if (i + 1 < count || isClosed) after = reachAt(from, to, i + 1 < count ? path[i + 2] : path[1], thickness);
        const double direction = directionOf(from, to), along = (after - before) / 2;
        pieces.push_back(
            {{(from[0] + to[0]) / 2 + along * std::cos(direction), (from[1] + to[1]) / 2 + along * std::sin(direction)},
             headingOf(direction),
             lengthOf(from, to) + before + after});
    }
    return pieces;
}

std::string staticsText(const std::vector<FloorPiece>& pieces, const FloorPathStyle& style) {
    std::string text;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const FloorPiece& piece = pieces[i];
        text += "Static " + withName(style, i + 1) + " { Config=" + std::string(style.config);
        const std::string pos = tidyNumber(piece.middle[0]) + "," + tidyNumber(piece.middle[1]),
                          length = tidyNumber(piece.length);
        if (pos != "0,0") text += " Pos=" + pos + ",0";
        if (piece.heading != 0) text += " HPR=" + tidyNumber(piece.heading) + ",0,0";
        if (length != tidyNumber(style.length)) text += " length=" + length;
        text += " }\n";
    }
    return text;
}

std::string boxesText(const std::vector<FloorPiece>& pieces, const FloorPathStyle& style) {
    std::string text;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const FloorPiece& piece = pieces[i];
        const bool isAcross = piece.heading == 90;
        text += "Box " + withName(style, i + 1) + " { Pos=" + tidyNumber(piece.middle[0]) + "," + tidyNumber(piece.middle[1]) +
                "," + tidyNumber((style.bottom + style.top) / 2);
        if (piece.heading != 0 && !isAcross) text += " HPR=" + tidyNumber(piece.heading) + ",0,0";
        const std::string along = tidyNumber(piece.length), across = tidyNumber(style.thickness);
        text += " Size=" + (isAcross ? across + "," + along : along + "," + across) + "," + tidyNumber(style.top - style.bottom);
        if (!style.collides) text += " Collide=false";
        text += " Material=" + std::string(style.material) + " Surface=" + std::string(style.surface) + " }\n";
    }
    return text;
}

} // namespace trundle
