#include "devices/discharge_curve.h"

namespace trundle {

namespace {

/// Panasonic BK-1100FHU (1.1 A h, 1.2 V): discharge curve in tenths of the capacity, to 5 mV, after the table of the Zephyr Project that
/// names this cell's data sheet as its source.
constexpr double kNickelMetalHydride[] = {0,     1.005, 0.1,   1.195, 0.2,   1.230, 0.3,   1.245, 0.4,   1.255, 0.5,
                                          1.255, 0.6,   1.265, 0.7,   1.265, 0.8,   1.275, 0.9,   1.315, 1,     1.420};
/// A polymer lithium-ion cell, TCL PL-383562 (0.85 A h, 3.7 V): open voltage by M. Chen and G. A. Rincon-Mora, "Accurate Electrical Battery
/// Model Capable of Predicting Runtime and I-V Performance", IEEE Trans. Energy Conversion 21(2), 2006, eq. 2:
/// -1.031 exp(-35 s) + 3.685 + 0.2156 s - 0.1178 s^2 + 0.3201 s^3 at the level s.
constexpr double kLithiumIon[] = {0,   2.654, 0.01, 2.961, 0.02, 3.177, 0.03, 3.331, 0.05, 3.516, 0.075, 3.626,
                                  0.1, 3.675, 0.15, 3.710, 0.2,  3.725, 0.3,  3.748, 0.4,  3.773, 0.5,   3.803,
                                  0.6, 3.841, 0.7,  3.888, 0.8,  3.946, 0.9,  4.017, 1,    4.103};

} // namespace

bool isDischargeCurve(std::span<const double> curve) {
    if (curve.size() < 4 || curve.size() % 2 != 0) return false;
    for (std::size_t i = 2; i < curve.size(); i += 2)
        if (!(curve[i - 2] < curve[i])) return false;
    for (std::size_t i = 1; i < curve.size(); i += 2)
        if (!(curve[i] > 0)) return false;
    return curve[0] >= 0 && curve[curve.size() - 2] <= 1;
}

std::span<const double> dischargeCurveOf(std::string_view chemistry) {
    return chemistry == "LiIon" ? std::span<const double>(kLithiumIon) : std::span<const double>(kNickelMetalHydride);
}

double voltageAt(std::span<const double> curve, double level) {
    std::size_t next = 0;
    while (next < curve.size() && curve[next] < level) next += 2;
    if (next == 0) return curve[1];
    if (next >= curve.size()) return curve.back();
    const double share = (level - curve[next - 2]) / (curve[next] - curve[next - 2]);
    return curve[next - 1] + share * (curve[next + 1] - curve[next - 1]);
}

} // namespace trundle
