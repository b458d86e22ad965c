#include "render/sensor_model.h"

#include "base/rng.h"

namespace trundle {
namespace {

std::uint8_t toByte(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

/// Bilinear interpolation; pixels beyond the edge repeat the outermost ones.
void mixed(const Image& image, LensMap::Source at, std::uint8_t* to) {
    const float x = at.x - 0.5f, y = at.y - 0.5f, left = std::floor(x), top = std::floor(y);
    const auto pixel = [&](float column, float row) {
        return image.at(static_cast<std::uint32_t>(std::clamp(column, 0.f, static_cast<float>(image.width - 1))),
                        static_cast<std::uint32_t>(std::clamp(row, 0.f, static_cast<float>(image.height - 1))));
    };
    const std::uint8_t *a = pixel(left, top), *b = pixel(left + 1, top), *c = pixel(left, top + 1), *d = pixel(left + 1, top + 1);
    const float u = x - left, v = y - top;
    for (int k = 0; k < 3; ++k) to[k] = toByte((1 - v) * ((1 - u) * a[k] + u * b[k]) + v * ((1 - u) * c[k] + u * d[k]));
}

void makeGrey(std::vector<std::uint8_t>& pixels) {
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3) {
        const std::uint32_t grey = (299u * pixels[i] + 587u * pixels[i + 1] + 114u * pixels[i + 2] + 500u) / 1000u;
        pixels[i] = pixels[i + 1] = pixels[i + 2] = static_cast<std::uint8_t>(grey);
    }
}

/// Near is bright; logarithmic, so that near and far distances are resolved equally.
std::uint8_t depthShade(const CameraModel& camera, float depth) {
    if (!std::isfinite(depth)) return 0;
    const double share = std::log(depth / camera.nearPlane) / std::log(camera.farPlane / camera.nearPlane);
    return toByte(255 - 235 * std::clamp(share, 0.0, 1.0));
}

/// Adjacent numbers get clearly different colours; none is black.
std::array<std::uint8_t, 3> objectColour(std::uint32_t object) {
    if (object == 0) return {0, 0, 0};
    const std::uint64_t bits = randomBits(0, 0, 0, object);
    return {static_cast<std::uint8_t>(64 + bits % 192), static_cast<std::uint8_t>(64 + (bits >> 16) % 192),
            static_cast<std::uint8_t>(64 + (bits >> 32) % 192)};
}

CameraImage emptyFrame(const CameraModel& camera) {
    CameraImage frame;
    frame.width = camera.width;
    frame.height = camera.height;
    return frame;
}

} // namespace

CameraImage applySensorModel(const CameraModel& camera, const std::optional<LensMap>& lens, Image drawn) {
    CameraImage frame = emptyFrame(camera);
    if (lens) {
        frame.pixels.assign(lens->sources.size() * 3, 0);
        for (std::size_t i = 0; i < lens->sources.size(); ++i)
            if (lens->sources[i].x >= 0) mixed(drawn, lens->sources[i], frame.pixels.data() + 3 * i);
    } else {
        frame.pixels = std::move(drawn.pixels);
    }
    if (camera.mode == CameraMode::Grey) makeGrey(frame.pixels);
    return frame;
}

CameraImage applySensorModel(const CameraModel& camera, const std::optional<LensMap>& lens, DataImage drawn) {
    CameraImage frame = emptyFrame(camera);
    if (lens) {
        // Not interpolated: between a near and a far surface there is no valid depth.
        frame.depth.assign(lens->sources.size(), std::numeric_limits<float>::infinity());
        frame.objects.assign(lens->sources.size(), 0);
        for (std::size_t i = 0; i < lens->sources.size(); ++i) {
            if (lens->sources[i].x < 0) continue;
            const auto x = std::min(static_cast<std::uint32_t>(lens->sources[i].x), drawn.width - 1);
            const auto y = std::min(static_cast<std::uint32_t>(lens->sources[i].y), drawn.height - 1);
            frame.depth[i] = drawn.depth[std::size_t(y) * drawn.width + x];
            frame.objects[i] = drawn.objects[std::size_t(y) * drawn.width + x];
        }
    } else {
        frame.depth = std::move(drawn.depth);
        frame.objects = std::move(drawn.objects);
    }
    frame.pixels.reserve(frame.depth.size() * 3);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        const std::uint8_t shade = depthShade(camera, frame.depth[i]);
        const auto colour = camera.mode == CameraMode::Depth ? std::array{shade, shade, shade} : objectColour(frame.objects[i]);
        frame.pixels.insert(frame.pixels.end(), colour.begin(), colour.end());
    }
    if (camera.mode == CameraMode::Depth) frame.objects.clear();
    return frame;
}

void addNoise(const CameraModel& camera, std::uint64_t seed, CameraImage& frame) {
    if (!(camera.noise > 0) || camera.mode == CameraMode::Segmentation) return;
    const std::uint64_t path = fnv1a64(camera.path);
    const auto normal = [&](std::size_t index) {
        return toNormal(randomBits(seed, path, frame.tick, 2 * index), randomBits(seed, path, frame.tick, 2 * index + 1));
    };
    if (camera.mode == CameraMode::Depth) {
        // Relative to the distance, as the error of such sensors grows with it.
        for (std::size_t i = 0; i < frame.depth.size(); ++i) {
            if (!std::isfinite(frame.depth[i])) continue;
            frame.depth[i] = static_cast<float>(std::max(0.0, frame.depth[i] * (1 + camera.noise * normal(i))));
            const std::uint8_t shade = depthShade(camera, frame.depth[i]);
            for (std::size_t k = 0; k < 3; ++k) frame.pixels[3 * i + k] = shade;
        }
        return;
    }
    const std::size_t step = camera.mode == CameraMode::Grey ? 3 : 1;
    for (std::size_t i = 0; i < frame.pixels.size(); i += step) {
        const std::uint8_t value = toByte(frame.pixels[i] + 255 * camera.noise * normal(i));
        for (std::size_t k = 0; k < step; ++k) frame.pixels[i + k] = value;
    }
}

} // namespace trundle
