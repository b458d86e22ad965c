#include "world/reflectance.h"

#include <algorithm>
#include <cmath>

#include "model/lighting_spec.h"
#include "model/picture_place.h"

namespace trundle {

namespace {

constexpr std::uint32_t kSamples = 64; // along each side of a texture

double luminance(double red, double green, double blue) {
    return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue;
}

double averageOf(const Raster& picture) {
    const std::uint32_t columns = std::min(kSamples, picture.width), rows = std::min(kSamples, picture.height);
    double sum = 0;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::size_t y = std::size_t{j} * picture.height / rows, x = std::size_t{i} * picture.width / columns;
            const std::uint8_t* p = &picture.pixels[3 * (y * picture.width + x)];
            sum += luminance(p[0] / 255., p[1] / 255., p[2] / 255.);
        }
    return sum / (static_cast<double>(columns) * rows);
}

/// Linear between the middles of four pixels, repeated in both directions; (0, 0) is the top left corner, (1, 1) the lower right one.
double luminanceAt(const Raster& picture, double u, double v) {
    const auto split = [](double at, std::uint32_t count, std::uint32_t& first, std::uint32_t& second) {
        const double pixel = (at - std::floor(at)) * count - 0.5, whole = std::floor(pixel);
        const auto index = static_cast<std::int64_t>(whole) + count;
        first = static_cast<std::uint32_t>(index % count);
        second = static_cast<std::uint32_t>((index + 1) % count);
        return pixel - whole;
    };
    std::uint32_t left = 0, right = 0, top = 0, low = 0;
    const double across = split(u, picture.width, left, right), down = split(v, picture.height, top, low);
    double rgb[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto pixel = [&](std::uint32_t x, std::uint32_t y) {
            return picture.pixels[3 * (std::size_t{y} * picture.width + x) + k] / 255.;
        };
        rgb[k] = (1 - down) * ((1 - across) * pixel(left, top) + across * pixel(right, top)) +
                 down * ((1 - across) * pixel(left, low) + across * pixel(right, low));
    }
    return luminance(rgb[0], rgb[1], rgb[2]);
}

} // namespace

double reflectanceOf(const MaterialSpec& material) {
    const auto& c = material.colour;
    return std::clamp(material.picture ? averageOf(*material.picture) : luminance(c[0], c[1], c[2]), 0., 1.);
}

double reflectanceAt(const MaterialSpec& material, GeomShape shape, const Vec3& point, const Vec3& normal, const Vec3& low,
                     const Vec3& size) {
    const bool findable = point.allFinite() && normal.allFinite();
    if (!material.picture || !findable) return reflectanceOf(material);
    Eigen::Vector2d at(point.x(), -point.y()); // a plane has it once in each metre
    if (shape != GeomShape::Plane)
        at =
            pictureAt<double>((point - low).cwiseQuotient(size.cwiseMax(1e-9)), normal, pictureMapOf(material.textureMap, shape));
    at *= material.textureScale;
    return at.allFinite() ? std::clamp(luminanceAt(*material.picture, at.x(), at.y()), 0., 1.) : reflectanceOf(material);
}

std::vector<TrundleLight> lightsOf(const ExperimentSpec& experiment) {
    const LightingSpec spec = lightingSpecOf(experiment);
    const auto strength = [](const std::array<double, 3>& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
    const Vec3& sun = spec.toSun;
    std::vector<TrundleLight> all{{{sun.x(), sun.y(), sun.z()}, strength(spec.sun), TRUNDLE_SUN, spec.sunShadows ? 1u : 0u},
                                  {{0, 0, 0}, strength(spec.sky), TRUNDLE_SKY, 0},
                                  {{0, 0, 0}, strength(spec.ground), TRUNDLE_GROUND, 0}};
    for (const LampSpec& lamp : spec.lamps)
        all.push_back({{lamp.position.x(), lamp.position.y(), lamp.position.z()},
                       strength(lamp.light),
                       TRUNDLE_LAMP,
                       lamp.shadows ? 1u : 0u});
    return all;
}

std::pair<Vec3, Vec3> pictureBox(const GeomSpec& geom) {
    Vec3 half = Vec3::Zero(), low = Vec3::Zero(), high = Vec3::Zero();
    switch (geom.shape) {
    case GeomShape::Box: half = geom.size / 2; break;
    case GeomShape::Sphere: half = Vec3::Constant(geom.radius); break;
    case GeomShape::Cylinder: half = {geom.radius, geom.radius, geom.length / 2}; break;
    case GeomShape::Capsule: half = {geom.radius, geom.radius, geom.length / 2 + geom.radius}; break;
    case GeomShape::Heightfield: return {{-geom.size.x() / 2, -geom.size.y() / 2, 0}, geom.size};
    case GeomShape::Convex:
    case GeomShape::Mesh:
        if (!geom.mesh || geom.mesh->points.empty()) break;
        low = high = Vec3(geom.mesh->points[0].data());
        for (const auto& p : geom.mesh->points) {
            low = low.cwiseMin(Vec3(p.data()));
            high = high.cwiseMax(Vec3(p.data()));
        }
        return {low, high - low};
    case GeomShape::Plane: break;
    }
    return {-half, 2 * half};
}

} // namespace trundle
