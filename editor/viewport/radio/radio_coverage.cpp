#include "editor/viewport/radio/radio_coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/viewport/radio/radio_colours.h"

namespace trundle {
namespace {

constexpr double kRoom = 0.15, kLeastRoom = 0.5; // margin around the scene, as a fraction of its size; at least, m
constexpr double kStep = 0.5;                    // dB per colour step
constexpr double kScaleStep = 5, kHighShare = 0.98;
constexpr double kLoneHeight = 0.1; // m, receiver height if there is no other radio

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Ground groundAround(const Bounds& bounds, const Ground& before) {
    Bounds all = bounds;
    if (all.empty()) return before;
    if (!before.empty()) {
        const Vec3 low(before.x, before.y, all.low.z()), high(before.x + before.width, before.y + before.depth, all.low.z());
        if (((all.low - low).array().head<2>() >= 0).all() && ((high - all.high).array().head<2>() >= 0).all()) return before;
        all.add(low);
        all.add(high);
    }
    const double size = std::max(all.size().x(), all.size().y()), room = std::max(kLeastRoom, kRoom * size);
    const double step = std::pow(10, std::floor(std::log10(std::max(size, 1.0)))) / 2;
    const auto down = [&](double v) { return step * std::floor((v - room) / step); };
    const auto up = [&](double v) { return step * std::ceil((v + room) / step); };
    Ground ground{down(all.low.x()), down(all.low.y())};
    ground.width = up(all.high.x()) - ground.x;
    ground.depth = up(all.high.y()) - ground.y;
    return ground;
}

ImaginedReceiver typicalReceiver(const RadioPoses& places, std::size_t transmitter) {
    const std::vector<RadioNode>& nodes = *places.nodes;
    const std::vector<Pose> antennas = antennasOf(places);
    std::vector<double> heights, sensitivities;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i == transmitter || nodes[i].radio.channel != nodes[transmitter].radio.channel) continue;
        heights.push_back(antennas[i].position.z());
        sensitivities.push_back(nodes[i].radio.minReceivePower);
    }
    if (heights.empty()) return {kLoneHeight, nodes[transmitter].radio.minReceivePower};
    return {std::round(100 * median(heights)) / 100, median(sensitivities)};
}

double Coverage::at(double x, double y) const {
    const double column = std::floor((x - ground.x) / ground.width * columns),
                 row = std::floor((y - ground.y) / ground.depth * rows);
    if (!(column >= 0 && row >= 0 && column < columns && row < rows)) return std::numeric_limits<double>::quiet_NaN();
    return double(power[std::size_t(row) * columns + std::size_t(column)]);
}

std::optional<Coverage> coverageOf(const CoverageRequest& request, const std::function<bool()>& resume) {
    Coverage coverage{{}, 0, request.ground, request.receiver, 0, 0, {}};
    const double cell = std::max(request.ground.width, request.ground.depth) / request.cells;
    coverage.columns = std::uint32_t(std::max(1.0, std::round(request.ground.width / cell)));
    coverage.rows = std::uint32_t(std::max(1.0, std::round(request.ground.depth / cell)));
    coverage.power.reserve(std::size_t(coverage.columns) * coverage.rows);
    const RadioNodes radios = radiosAt(request.places);
    const auto from = RadioId(request.transmitter);
    coverage.transmitter = radios.all()[from].radio.path;
    coverage.sent = radios.all()[from].radio.maxOutputPower;
    AntennaPose probe{RadioId(radios.all().size()), 0, {}, nullptr}; // unused id: only the sender's own body is ignored
    for (std::uint32_t row = 0; row < coverage.rows; ++row) {
        if (!resume()) return std::nullopt;
        const double y = request.ground.y + (row + 0.5) * request.ground.depth / coverage.rows;
        for (std::uint32_t column = 0; column < coverage.columns; ++column) {
            const double x = request.ground.x + (column + 0.5) * request.ground.width / coverage.columns;
            probe.pose.position = {x, y, request.receiver.height};
            coverage.power.push_back(float(radios.reach(from, probe, coverage.sent).power));
        }
    }
    return coverage;
}

PowerScale scaleOf(const Coverage& coverage) {
    const double sensitivity = coverage.receiver.sensitivity;
    std::vector<float> heard;
    std::copy_if(coverage.power.begin(), coverage.power.end(), std::back_inserter(heard),
                 [&](float power) { return power >= sensitivity; });
    PowerScale scale{kScaleStep * std::floor(sensitivity / kScaleStep), 0};
    scale.high = scale.low + 4 * kScaleStep;
    if (heard.empty()) return scale;
    const auto most = heard.begin() + std::ptrdiff_t(kHighShare * double(heard.size() - 1));
    std::nth_element(heard.begin(), most, heard.end());
    const double least = double(*std::min_element(heard.begin(), heard.end()));
    scale.low = kScaleStep * std::floor(least / kScaleStep);
    scale.high = std::max(scale.low + 4 * kScaleStep, kScaleStep * std::ceil(double(*most) / kScaleStep));
    return scale;
}

std::array<std::uint8_t, 4> powerColour(double power, const PowerScale& scale, double sensitivity) {
    if (!(power >= sensitivity)) return {52, 54, 60, 120};
    const double stepped = kStep * std::round(power / kStep);
    const Rgb c = heatColour((stepped - scale.low) / (scale.high - scale.low));
    return {c[0], c[1], c[2], 158};
}

std::shared_ptr<const FloorPicture> pictureOf(const Coverage& coverage, const PowerScale& scale) {
    auto picture = std::make_shared<FloorPicture>();
    const Ground& g = coverage.ground;
    *picture = {g.x, g.y, g.width, g.depth, coverage.columns, coverage.rows, {}};
    picture->pixels.reserve(4 * coverage.power.size());
    for (const float power : coverage.power)
        for (const std::uint8_t part : powerColour(double(power), scale, coverage.receiver.sensitivity))
            picture->pixels.push_back(part);
    return picture;
}

} // namespace trundle
