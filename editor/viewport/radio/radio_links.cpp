#include "editor/viewport/radio/radio_links.h"

#include <algorithm>

namespace trundle {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Each pair once, the lower index first.
std::vector<Pair> pairsOf(const RadioNodes& radios, const std::vector<bool>& selected, std::size_t& nearest) {
    const std::vector<RadioNode>& nodes = radios.all();
    std::vector<std::uint32_t> meant;
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        if (selected.empty() || selected[i]) meant.push_back(i);
    const std::size_t most = meant.size() * (nodes.size() - std::min<std::size_t>(nodes.size(), 1));
    nearest = most > 2 * kMaxLinkPairs ? std::max<std::size_t>(4, 2 * kMaxLinkPairs / meant.size()) : 0;
    std::vector<Pair> pairs;
    std::vector<std::pair<double, std::uint32_t>> others;
    for (const std::uint32_t i : meant) {
        others.clear();
        for (std::uint32_t k = 0; k < nodes.size(); ++k)
            if (k != i && nodes[k].radio.channel == nodes[i].radio.channel)
                others.emplace_back((radios.antenna(k).pose.position - radios.antenna(i).pose.position).squaredNorm(), k);
        if (nearest > 0 && others.size() > nearest) {
            std::nth_element(others.begin(), others.begin() + std::ptrdiff_t(nearest), others.end());
            others.resize(nearest);
        }
        for (const auto& [far, k] : others) pairs.emplace_back(std::min(i, k), std::max(i, k));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

} // namespace

std::vector<Pose> antennasOf(const RadioPoses& places) {
    std::vector<Pose> antennas;
    for (const RadioNode& node : *places.nodes)
        antennas.push_back(node.body < places.poses->size() ? (*places.poses)[node.body] * node.mounting : node.mounting);
    return antennas;
}

RadioNodes radiosAt(const RadioPoses& places) {
    RadioNodes radios(places.objects->experiment().medium, *places.nodes);
    radios.place(*places.poses);
    radios.setWalls(wallsBetween(places.objects, places.poses, *places.nodes));
    return radios;
}

RadioLinks linksOf(const RadioPoses& places, const std::vector<bool>& selected) {
    const RadioNodes radios = radiosAt(places);
    const auto margin = [&](RadioId from, RadioId to) {
        return radios.link(from, to, radios.all()[from].radio.maxOutputPower).margin;
    };
    RadioLinks result;
    for (const auto& [a, b] : pairsOf(radios, selected, result.nearest)) {
        const double there = margin(a, b), back = margin(b, a);
        if (there < 0 && back < 0) continue;
        if (there >= 0 && back >= 0) result.links.push_back({a, b, std::min(there, back), false});
        else if (there >= 0) result.links.push_back({a, b, there, true});
        else result.links.push_back({b, a, back, true});
    }
    result.reaching = result.links.size();
    const auto stronger = [](const RadioLink& a, const RadioLink& b) {
        return a.margin != b.margin ? a.margin > b.margin : std::pair(a.from, a.to) < std::pair(b.from, b.to);
    };
    const auto last = result.links.begin() + std::ptrdiff_t(std::min(kMaxLinks, result.links.size()));
    std::partial_sort(result.links.begin(), last, result.links.end(), stronger);
    result.links.erase(last, result.links.end());
    return result;
}

} // namespace trundle
