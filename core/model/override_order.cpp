#include "model/override_order.h"

#include <algorithm>

#include "model/dotted_path.h"

namespace trundle {

namespace {

bool isFor(std::span<const OverrideWord> path, const SourceAssignment& a) {
    if (a.path.size() != path.size()) return false;
    for (std::size_t i = path.size(); i-- > 0;) // the property first: it differs most often
        if (a.path[i].text != path[i].name && (path[i].all.empty() || a.path[i].text != path[i].all)) return false;
    return true;
}

class Order {
public:
    Order(std::span<const OverrideWord> path, std::span<const OverrideLayer> layers) : m_path(path), m_layers(layers) {}

    /// Whether `a` holds before `b`.
    bool operator()(const FoundOverride& a, const FoundOverride& b) const {
        const std::size_t first = m_layers[a.layer].first, other = m_layers[b.layer].first;
        for (std::size_t i = m_path.size(); i-- > std::max(first, other);)
            if (const bool one = isOfOne(a, i); one != isOfOne(b, i)) return one;
        return first != other ? first < other : a.layer < b.layer;
    }

private:
    bool isOfOne(const FoundOverride& found, std::size_t word) const {
        return found.assignment->path[word - m_layers[found.layer].first].text == m_path[word].name;
    }

    std::span<const OverrideWord> m_path;
    std::span<const OverrideLayer> m_layers;
};

} // namespace

std::vector<FoundOverride> overridesFor(std::span<const OverrideWord> path, std::span<const OverrideLayer> layers) {
    std::vector<FoundOverride> found;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        const AssignmentList& assignments = layers[layer].instance->assignments;
        const std::span<const OverrideWord> inside = path.subspan(layers[layer].first);
        if (std::ranges::all_of(inside, &std::string::empty, &OverrideWord::all)) { // one key; the list may be long
            std::string key;
            for (const OverrideWord& word : inside) key = pathInside(key, word.name);
            if (const SourceAssignment* a = assignments.find(key)) found.push_back({a, layer});
            continue;
        }
        for (const SourceAssignment& a : assignments.all())
            if (isFor(inside, a)) found.push_back({&a, layer});
    }
    std::ranges::sort(found, Order(path, layers));
    return found;
}

} // namespace trundle
