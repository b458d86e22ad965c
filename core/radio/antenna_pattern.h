#pragma once
// Gain of an antenna by direction, for sending and receiving. Antenna frame: main direction +x, up +z; azimuth 0 is +x and
// increases to the left, elevation increases upwards.

#include <optional>
#include <string_view>
#include <vector>

#include <trundle/geometry.h>

#include "base/result.h"

namespace trundle {

enum class AntennaModel { Isotropic, Dipole, InvertedF, Patch, Yagi, Cosine };

[[nodiscard]] std::optional<AntennaModel> antennaModelNamed(std::string_view word);

/// An angle (rad) and a gain (dBi).
struct GainPoint {
    double angle = 0, gain = 0;
};

class AntennaPattern {
public:
    static constexpr double kFloor = -30; ///< dBi, lowest gain of any direction

    AntennaPattern() = default; ///< isotropic, 0 dBi

    /// A lossless model, or one with the given peak gain (dBi). `beamWidth` (rad, between the half-power points) shapes patch,
    /// yagi and cosine; for a cosine it follows from the gain if only that is given.
    [[nodiscard]] static AntennaPattern of(AntennaModel model, std::optional<double> peakGain = {},
                                           std::optional<double> beamWidth = {});
    /// From a cut at elevation 0 and one at azimuth 0; either may be empty. Between the cuts the gain is az + el - el(0).
    [[nodiscard]] static AntennaPattern fromCuts(std::vector<GainPoint> azimuth, std::vector<GainPoint> elevation);
    /// From lines "azimuth, elevation, gain" (deg, deg, dBi) that form a complete grid; one header line is skipped. The error
    /// names the line.
    [[nodiscard]] static Result<AntennaPattern> fromCsv(std::string_view text);

    /// Gain (dBi) in a direction (antenna frame, any length except 0).
    [[nodiscard]] double gain(const Vec3& direction) const;
    [[nodiscard]] double gain(double azimuth, double elevation) const; ///< dBi; angles in rad
    [[nodiscard]] double peak() const { return m_peak; }               ///< dBi
    /// What it sends to the left is sent to the right.
    [[nodiscard]] AntennaPattern mirrored() const;
    [[nodiscard]] bool isSymmetric() const { return !m_table; } ///< to left and right, as all models are
    /// Efficiency: the mean gain over all directions; 1 for a lossless antenna.
    [[nodiscard]] double radiated() const;

private:
    /// Gains (dBi) on a grid, ordered by azimuth, then elevation; angles in rad, increasing. Interpolated linearly in dB along
    /// both angles; azimuth wraps around, elevation is clamped.
    struct Table {
        std::vector<double> azimuths, elevations, gains;
        [[nodiscard]] double at(double azimuth, double elevation) const;
    };
    [[nodiscard]] static AntennaPattern fromTable(Table table);
    [[nodiscard]] double shape(const Vec3& unit) const; ///< relative power of a model
    void normalise(std::optional<double> peakGain);

    AntennaModel m_model = AntennaModel::Isotropic;
    double m_power = 0;  ///< lobe exponent, or number of elements of a yagi
    double m_offset = 0; ///< dB on 10 log10(shape)
    double m_peak = 0;
    std::optional<Table> m_table;
};

} // namespace trundle
