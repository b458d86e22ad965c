#pragma once
// How strongly an antenna sends and hears in each direction of its own frame. It looks along +x, its up is +z; azimuth 0 is +x and
// grows to the left, elevation grows upwards.

#include <optional>
#include <string_view>
#include <vector>

#include <trundle/geometry.h>

#include "base/result.h"

namespace trundle {

enum class AntennaModel { Isotropic, Dipole, InvertedF, Patch, Yagi, Cosine };

/// "isotropic|dipole|inverted_f|patch|yagi|cosine", as the text writes them.
[[nodiscard]] std::string_view antennaModelWords();
[[nodiscard]] std::optional<AntennaModel> antennaModelNamed(std::string_view word);

/// An angle (rad) and a gain (dBi).
struct GainPoint {
    double angle = 0, gain = 0;
};

class AntennaPattern {
public:
    static constexpr double kFloor = -30; ///< dBi: no null is deeper

    AntennaPattern() = default; ///< isotropic, 0 dBi

    /// A model without losses, or with the given gain at its peak (dBi). `beamWidth` (rad, between the points of half power) shapes
    /// patch, yagi and cosine; of a cosine it follows from the gain where only that is given.
    [[nodiscard]] static AntennaPattern of(AntennaModel model, std::optional<double> peakGain = {},
                                           std::optional<double> beamWidth = {});
    /// From a cut at elevation 0 and one at azimuth 0; either may be empty. Off the cuts both count: az + el - el(0).
    [[nodiscard]] static AntennaPattern fromCuts(std::vector<GainPoint> azimuth, std::vector<GainPoint> elevation);
    /// From lines "azimuth, elevation, gain" (deg, deg, dBi) that fill a grid; one line of words at the top is passed over. Fails with
    /// the line.
    [[nodiscard]] static Result<AntennaPattern> fromCsv(std::string_view text);

    /// dBi towards a direction of any length but 0.
    [[nodiscard]] double gain(const Vec3& direction) const;
    [[nodiscard]] double gain(double azimuth, double elevation) const; ///< rad
    [[nodiscard]] double peak() const { return m_peak; }               ///< dBi
    /// What it radiates of what it gets: the mean of its gain over all directions, 1 for an antenna without losses.
    [[nodiscard]] double radiated() const;

private:
    /// Gains on a grid, azimuth by azimuth; angles in rad, rising. Between the points the dB are interpolated along both angles; around
    /// the azimuth it closes, beyond the last elevation it stays.
    struct Table {
        std::vector<double> azimuths, elevations, gains;
        [[nodiscard]] double at(double azimuth, double elevation) const;
    };
    [[nodiscard]] static AntennaPattern fromTable(Table table);
    [[nodiscard]] double shape(const Vec3& unit) const; ///< relative power of a model
    void normalise(std::optional<double> peakGain);

    AntennaModel m_model = AntennaModel::Isotropic;
    double m_power = 0;  ///< exponent of a lobe, elements of a yagi
    double m_offset = 0; ///< dB on 10 log10(shape)
    double m_peak = 0;
    std::optional<Table> m_table;
};

} // namespace trundle
