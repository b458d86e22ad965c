// Antenna patterns from measured tables.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "radio/antenna_pattern.h"

namespace trundle {

namespace {

constexpr double kTurn = 2 * std::numbers::pi, kDegree = std::numbers::pi / 180;
constexpr double kSameAngle = 1e-9;

double wrapped(double angle) {
    const double a = std::fmod(angle, kTurn);
    return a < 0 ? a + kTurn : a;
}

/// Sorted by angle; of two equal angles the later entry is kept.
std::vector<GainPoint> sorted(std::vector<GainPoint> points, bool around) {
    if (around)
        for (GainPoint& p : points) {
            p.angle = wrapped(p.angle);
            if (kTurn - p.angle < kSameAngle) p.angle = 0; // 360 degrees is the same as 0
        }
    std::stable_sort(points.begin(), points.end(), [](const GainPoint& a, const GainPoint& b) { return a.angle < b.angle; });
    std::vector<GainPoint> out;
    for (const GainPoint& p : points) {
        if (!out.empty() && p.angle - out.back().angle < kSameAngle) out.back() = p;
        else out.push_back(p);
    }
    return out;
}

/// The two neighbouring angles and the interpolation weight of the second.
struct Span {
    std::size_t low = 0, high = 0;
    double share = 0;
};

Span spanOf(const std::vector<double>& angles, double at, bool around) {
    const std::size_t n = angles.size();
    if (n < 2) return {};
    const auto above = static_cast<std::size_t>(std::upper_bound(angles.begin(), angles.end(), at) - angles.begin());
    if (above > 0 && above < n) return {above - 1, above, (at - angles[above - 1]) / (angles[above] - angles[above - 1])};
    if (!around) return above == 0 ? Span{0, 0, 0} : Span{n - 1, n - 1, 0};
    const double gap = angles.front() + kTurn - angles.back();
    const double past = above == 0 ? at + kTurn - angles.back() : at - angles.back();
    return {n - 1, 0, past / gap};
}

/// Reads three numbers from a line, separated by commas, semicolons or blanks. False if the line has anything else.
bool threeNumbers(std::string_view line, double (&out)[3]) {
    std::size_t at = 0;
    for (double& number : out) {
        while (at < line.size() && (line[at] == ' ' || line[at] == '\t' || line[at] == ',' || line[at] == ';')) ++at;
        if (at < line.size() && line[at] == '+') ++at;
        const auto [end, problem] = std::from_chars(line.data() + at, line.data() + line.size(), number);
        if (problem != std::errc() || !std::isfinite(number)) return false;
        at = static_cast<std::size_t>(end - line.data());
    }
    return line.find_first_not_of(" \t,;\r", at) == std::string_view::npos;
}

Error atLine(std::size_t line, const std::string& what) {
    return {Code::FileUnreadable, "line " + std::to_string(line) + ": " + what};
}

} // namespace

double AntennaPattern::Table::at(double azimuth, double elevation) const {
    const Span a = spanOf(azimuths, wrapped(azimuth), true), e = spanOf(elevations, elevation, false);
    const std::size_t rows = elevations.size();
    const auto along = [&](std::size_t column) {
        const double low = gains[column * rows + e.low], high = gains[column * rows + e.high];
        return low + e.share * (high - low);
    };
    const double low = along(a.low), high = along(a.high);
    return low + a.share * (high - low);
}

AntennaPattern AntennaPattern::fromTable(Table table) {
    AntennaPattern p;
    p.m_peak = std::max(kFloor, *std::max_element(table.gains.begin(), table.gains.end()));
    p.m_table = std::move(table);
    return p;
}

AntennaPattern AntennaPattern::mirrored() const {
    if (!m_table) return *this;
    const std::size_t rows = m_table->elevations.size();
    std::map<double, std::size_t> columns; // by the mirrored azimuth
    for (std::size_t i = 0; i < m_table->azimuths.size(); ++i) columns.emplace(wrapped(0 - m_table->azimuths[i]), i);
    Table table{{}, m_table->elevations, {}};
    for (const auto& [azimuth, column] : columns) {
        table.azimuths.push_back(azimuth);
        const auto gains = m_table->gains.begin() + static_cast<std::ptrdiff_t>(column * rows);
        table.gains.insert(table.gains.end(), gains, gains + static_cast<std::ptrdiff_t>(rows));
    }
    return fromTable(std::move(table));
}

AntennaPattern AntennaPattern::fromCuts(std::vector<GainPoint> azimuth, std::vector<GainPoint> elevation) {
    azimuth = sorted(std::move(azimuth), true);
    elevation = sorted(std::move(elevation), false);
    if (azimuth.empty() && elevation.empty()) return {};
    Table column;
    for (const GainPoint& p : elevation) {
        column.elevations.push_back(p.angle);
        column.gains.push_back(p.gain);
    }
    if (elevation.empty()) column = {{}, {0}, {0}};
    column.azimuths = {0};
    if (azimuth.empty()) return fromTable(std::move(column));
    const double ahead = column.at(0, 0);
    Table table{{}, column.elevations, {}};
    for (const GainPoint& p : azimuth) {
        table.azimuths.push_back(p.angle);
        for (const double gain : column.gains) table.gains.push_back(p.gain + gain - ahead);
    }
    return fromTable(std::move(table));
}

Result<AntennaPattern> AntennaPattern::fromCsv(std::string_view text) {
    std::map<std::pair<double, double>, double> grid; // (azimuth, elevation) in degrees
    std::map<double, std::size_t> azimuths, elevations;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        if (line.find_first_not_of(" \t\r,;") == std::string_view::npos || line.front() == '#') continue;
        double v[3];
        if (!threeNumbers(line, v)) {
            if (grid.empty() && number == 1) continue;
            return atLine(number, "an azimuth, an elevation and a gain belong here");
        }
        if (v[1] < -90 || v[1] > 90) return atLine(number, "an elevation lies between -90 and 90 degrees");
        if (v[2] < -200 || v[2] > 100) return atLine(number, "a gain lies between -200 and 100 dBi");
        double azimuth = std::fmod(v[0], 360);
        if (azimuth < 0) azimuth += 360;
        const auto [it, fresh] = grid.emplace(std::pair(azimuth, v[1]), v[2]);
        if (!fresh && it->second != v[2]) return atLine(number, "this direction is listed already with another gain");
        azimuths.emplace(azimuth, 0);
        elevations.emplace(v[1], 0);
    }
    if (grid.empty()) return Error{Code::FileUnreadable, "it holds no line with an azimuth, an elevation and a gain"};
    if (grid.size() != azimuths.size() * elevations.size())
        return Error{Code::FileUnreadable, "its " + std::to_string(grid.size()) + " directions do not fill a grid of " +
                                               std::to_string(azimuths.size()) + " azimuths and " +
                                               std::to_string(elevations.size()) + " elevations"};
    Table table;
    for (const auto& [azimuth, unused] : azimuths) table.azimuths.push_back(azimuth * kDegree);
    for (const auto& [elevation, unused] : elevations) table.elevations.push_back(elevation * kDegree);
    for (const auto& [direction, gain] : grid) table.gains.push_back(gain); // sorted by azimuth, then elevation
    return fromTable(std::move(table));
}

} // namespace trundle
