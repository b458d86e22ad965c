#include "editor/viewport/radio/antenna_lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "editor/viewport/radio/radio_colours.h"

namespace trundle {

double lobeRadius(double gain, double unit) { return unit * std::max(0.0, 1 - gain / kLobeFloor); }

std::shared_ptr<const TintedMesh> lobeMesh(const AntennaPattern& pattern, double unit, int spokes) {
    auto mesh = std::make_shared<TintedMesh>();
    const int rings = spokes / 2; // from straight down to straight up
    const auto at = [&](int ring, int spoke) { return std::uint32_t(ring * spokes + spoke % spokes); };
    for (int ring = 0; ring <= rings; ++ring) {
        const double elevation = std::numbers::pi * (double(ring) / rings - 0.5);
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double azimuth = 2 * std::numbers::pi * spoke / spokes, across = std::cos(elevation);
            const Vec3 way(across * std::cos(azimuth), across * std::sin(azimuth), std::sin(elevation));
            const double gain = pattern.gain(way);
            mesh->points.push_back((lobeRadius(gain, unit) * way).cast<float>());
            mesh->colours.push_back(gainColour(gain));
        }
    }
    mesh->normals.assign(mesh->points.size(), Eigen::Vector3f::Zero());
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Eigen::Vector3f normal =
            (mesh->points[b] - mesh->points[a]).cross(mesh->points[c] - mesh->points[a]); // length is twice the triangle's area
        for (const std::uint32_t corner : {a, b, c}) {
            mesh->indices.push_back(corner);
            mesh->normals[corner] += normal;
        }
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            if (ring > 0) add(at(ring, spoke), at(ring, spoke + 1), at(ring + 1, spoke + 1));
            if (ring + 1 < rings) add(at(ring, spoke), at(ring + 1, spoke + 1), at(ring + 1, spoke));
        }
    for (std::size_t i = 0; i < mesh->normals.size(); ++i) {
        Eigen::Vector3f& normal = mesh->normals[i];
        if (normal.norm() > 1e-12f) normal.normalize();
        else normal = Eigen::Vector3f::UnitZ(); // in a null the surface has no extent
    }
    return mesh;
}

double lobeUnitBeside(double robotRadius) {
    const double wanted = std::clamp(robotRadius, 1e-3, 1e3), ten = std::pow(10.0, std::floor(std::log10(wanted)));
    double best = ten;
    for (const double step : {2.0, 5.0, 10.0})
        if (std::abs(std::log(step * ten / wanted)) < std::abs(std::log(best / wanted))) best = step * ten;
    return best;
}

} // namespace trundle
