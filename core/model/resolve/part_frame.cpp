#include "model/resolve/part_frame.h"

#include "model/dotted_path.h"

namespace trundle {

const Part* PartFrame::find(std::string_view name) const {
    const std::string_view first = firstWord(name);
    if (!config) return nullptr; // names in the world are looked up among the robots
    if (first != name)
        if (const auto it = inner.find(first); it != inner.end()) return it->second->find(withoutFirstWord(name));
    const Part* part = config->find(first);
    return part && part->isRepeat() ? nullptr : config->findPath(name); // what is in a Repeat has the name of a member in front
}

bool PartFrame::isUnfinished(std::string_view name) const {
    const PartFrame* in = this;
    while (true) {
        const std::string_view first = firstWord(name);
        if (first == name) break;
        const auto next = in->inner.find(first);
        if (next == in->inner.end()) break;
        in = next->second;
        name = withoutFirstWord(name);
    }
    const std::string_view first = firstWord(name);
    const std::optional<MemberName> one = memberName(first);
    if (in->unfinished.contains(first) || (one && in->unfinished.contains(one->stem))) return true;
    return in == this && member && outer->isUnfinished(name);
}

const PartFrame& PartFrame::holder() const {
    const PartFrame* at = this;
    while (at->member) at = at->outer;
    return *at;
}

const PartFrame& PartFrame::frameOf(std::string_view name) const {
    const PartFrame* at = this;
    while (at->member && !at->find(name)) at = at->outer;
    return at->find(name) ? *at : *this;
}

std::vector<const Part*> PartFrame::writers() const {
    std::vector<const Part*> all;
    for (const PartFrame* at = &holder(); at; at = at->outer ? &at->outer->holder() : nullptr) {
        const auto first = static_cast<std::ptrdiff_t>(all.size());
        for (const Part* config = at->config; config; config = config->config) all.insert(all.begin() + first, config);
        if (at->use) all.push_back(at->use);
    }
    return all;
}

} // namespace trundle
