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

/// Gains over one angle; 0 where there are none. Round: from its last angle on to its first; else beyond both as there.
class Cut {
public:
    Cut(std::vector<GainPoint> points, bool isRound) : m_isRound(isRound) {
        for (const GainPoint& p : sorted(std::move(points), isRound)) {
            m_angles.push_back(p.angle);
            m_gains.push_back(p.gain);
        }
    }
    [[nodiscard]] double at(double angle) const {
        if (m_angles.empty()) return 0;
        const Span s = spanOf(m_angles, m_isRound ? wrapped(angle) : angle, m_isRound);
        return m_gains[s.low] + s.share * (m_gains[s.high] - m_gains[s.low]);
    }
    [[nodiscard]] const std::vector<double>& angles() const { return m_angles; }
    [[nodiscard]] bool isRound() const { return m_isRound; }

private:
    bool m_isRound;
    std::vector<double> m_angles, m_gains;
};

/// Takes elevations between half a turn down and up. Whether some are beyond straight up or down, so that they are of the side behind.
bool goesRound(std::vector<GainPoint>& elevation) {
    bool round = false;
    for (GainPoint& p : elevation) {
        p.angle = std::remainder(p.angle, kTurn);
        round = round || std::abs(p.angle) > kTurn / 4 + kSameAngle;
    }
    return round;
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
    if (azimuth.empty() && elevation.empty()) return {};
    const bool isRound = goesRound(elevation);
    const Cut level(std::move(azimuth), true), upright(std::move(elevation), isRound);
    Table table{level.angles(), upright.angles(), {}};
    if (upright.isRound()) { // over the top to the side behind
        for (double& e : table.elevations) e = std::remainder(e, kTurn);
        for (double& e : table.elevations) e = std::abs(e) > kTurn / 4 ? std::copysign(kTurn / 2, e) - e : e;
        table.elevations.insert(table.elevations.end(), {-kTurn / 4, kTurn / 4});
        table.azimuths.insert(table.azimuths.end(), {0, kTurn / 2});
    }
    for (std::vector<double>* angles : {&table.azimuths, &table.elevations}) {
        std::ranges::sort(*angles);
        const auto same = [](double x, double y) { return y - x < kSameAngle; };
        angles->erase(std::unique(angles->begin(), angles->end(), same), angles->end());
        if (angles->empty()) angles->push_back(0);
    }
    for (const double a : table.azimuths) {
        const double behind = upright.isRound() ? std::abs(std::remainder(a, kTurn)) / (kTurn / 2) : 0;
        for (const double e : table.elevations) {
            const bool isPole = std::abs(e) > kTurn / 4 - kSameAngle; // there every azimuth is the same direction
            const auto rise = [&](double ahead, double there) {
                return upright.at(there) - (level.angles().empty() ? 0 : upright.at(ahead));
            };
            const double share = isPole ? 0 : behind;
            table.gains.push_back(level.at(isPole ? 0 : a) + (1 - share) * rise(0, e) + share * rise(kTurn / 2, kTurn / 2 - e));
        }
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
