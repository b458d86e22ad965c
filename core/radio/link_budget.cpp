#include "radio/link_budget.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "radio/propagation.h"

namespace trundle {

namespace {

constexpr double kMaxSigmas = 4, kTwoRayGain = 6.03; ///< limits of the gain by shadowing and by a second ray
constexpr double kPerMetre = 1000; ///< 1/m; positions for shadowing are rounded to 1 mm, as bodies at rest still jitter

Vec3 shadowPlace(const Vec3& p) { return ((p * kPerMetre).array().round() / kPerMetre).matrix(); }

} // namespace

double LinkModel::wavelengthOf(const MediumSettings& settings) { return wavelength(settings.frequency); }

const LinkModel::Obstacles& LinkModel::obstacles(const AntennaPose& low, const AntennaPose& high) const {
    const std::uint64_t pair = static_cast<std::uint64_t>(low.id) << 32 | high.id;
    const auto [it, fresh] = m_obstacles.try_emplace(pair);
    Obstacles& o = it->second;
    const Vec3 a = shadowPlace(low.pose.position), b = shadowPlace(high.pose.position);
    const bool stands = !fresh && o.a == a && o.b == b;
    if (m_settings.shadowing > 0 && !stands) {
        // ordered by key, not by id, so that other radios do not affect the result
        const bool swap = high.key < low.key;
        const std::uint64_t keys[2] = {std::min(low.key, high.key), std::max(low.key, high.key)};
        o.shadow = m_settings.shadowing * shadowing(m_settings.seed, randomBits(keys[0], keys[1], 0, 0), swap ? b : a,
                                                    swap ? a : b, m_settings.correlation);
    }
    if (m_settings.wallLoss > 0 && m_walls)
        // not cached: other objects may have moved
        o.walls = m_settings.wallLoss * m_walls(low.id, low.pose.position, high.id, high.pose.position);
    o.a = a;
    o.b = b;
    return o;
}

LinkBudget LinkModel::between(const AntennaPose& from, const AntennaPose& to, double outputPower) const {
    const bool forward = from.id < to.id;
    const AntennaPose &low = forward ? from : to, &high = forward ? to : from;
    const Vec3 way = high.pose.position - low.pose.position;
    LinkBudget link;
    link.distance = way.norm();
    const auto gainTowards = [](const AntennaPose& end, const Vec3& direction) {
        return end.pattern ? end.pattern->gain(Vec3(end.pose.rotation.conjugate() * direction)) : 0.0;
    };
    const double lowGain = gainTowards(low, way), highGain = gainTowards(high, -way);
    link.sendGain = forward ? lowGain : highGain;
    link.receiveGain = forward ? highGain : lowGain;
    switch (m_settings.model) {
    case PropagationModel::Ideal: link.pathLoss = freeSpaceLoss(link.distance, m_lambda); break;
    case PropagationModel::TwoRay:
        link.pathLoss = twoRayLoss(low.pose.position, high.pose.position, m_lambda, m_settings.permittivity);
        break;
    case PropagationModel::LogDistance: link.pathLoss = logDistanceLoss(link.distance, m_lambda, m_settings.exponent); break;
    }
    if (m_settings.shadowing > 0 || m_settings.wallLoss > 0) {
        const Obstacles& o = obstacles(low, high);
        link.shadow = o.shadow;
        link.wallLoss = o.walls;
    }
    link.power = outputPower + (lowGain + highGain) - (link.pathLoss + link.shadow + link.wallLoss);
    return link;
}

double LinkModel::range(double budget, double power) const {
    double most = budget - power + kMaxSigmas * m_settings.shadowing - freeSpaceLoss(1, m_lambda);
    if (m_settings.model == PropagationModel::TwoRay) most += kTwoRayGain;
    const bool byExponent = m_settings.model == PropagationModel::LogDistance && most > 0; // to 1 m it is free space
    const double exponent = byExponent ? std::max(m_settings.exponent, 0.1) : 2;
    const double far = std::pow(10, most / (10 * exponent));
    return std::max(far * (1 + 1e-9), kNearest * 1.001);
}

} // namespace trundle
