#pragma once
// How well a robot has driven a square, from its PoseLog.

#include <algorithm>
#include <cmath>
#include <vector>

#include <QByteArray>
#include <QList>

struct SquarePath {
    struct Place {
        double x = 0, y = 0;
    };
    std::vector<Place> places;
    double worst = 0;  ///< m, beside a corner, or from the start at the end
    double across = 0; ///< m, from edge to edge

    /// Of a log with the columns x and y; `radius`: of round corners, whose arcs begin where the straight ways end.
    SquarePath(const QByteArray& csv, double side, double radius) {
        for (const QByteArray& line : csv.split('\n').mid(1))
            if (const QList<QByteArray> cells = line.split(','); cells.size() > 3)
                places.push_back({cells[2].toDouble(), cells[3].toDouble()});
        if (places.empty()) return;
        const double flat = side - 2 * radius, off = radius;
        const std::vector<Place> corners{{0, 0},       {flat, 0}, {flat + off, off},  {flat + off, off + flat},
                                         {flat, side}, {0, side}, {-off, off + flat}, {-off, off}};
        worst = std::hypot(places.back().x, places.back().y);
        for (const Place& corner : corners) worst = std::max(worst, nearest(corner));
        const auto [least, most] = std::ranges::minmax(places, {}, &Place::y);
        across = most.y - least.y;
    }

private:
    [[nodiscard]] double nearest(const Place& to) const {
        double least = 1e9;
        for (const Place& at : places) least = std::min(least, std::hypot(at.x - to.x, at.y - to.y));
        return least;
    }
};
