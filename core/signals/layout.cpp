#include "signals/layout.h"

namespace trundle {
namespace {

auto robotOf(const std::vector<ImageSpan>& images) {
    return [&images](std::uint32_t i) -> std::string_view { return images[i].robot; };
}

} // namespace

void SignalLayout::beginRobot(std::string name) {
    m_images.push_back({std::move(name), m_slots, 0});
    m_byRobot.add(m_images.back().robot, robotOf(m_images));
}

void SignalLayout::repeatRobot(std::string name, std::size_t equal) {
    m_images.push_back({std::move(name), m_slots, m_images[equal].count, m_images[equal].group});
    m_slots += m_images.back().count;
    m_byRobot.add(m_images.back().robot, robotOf(m_images));
}

std::uint32_t SignalLayout::add(std::string name, std::string unit, SignalType type, SignalDirection direction,
                                std::uint32_t count) {
    if (m_images.empty()) beginRobot({});
    ImageSpan& image = m_images.back();
    if (image.group.use_count() > 1) image.group = std::make_shared<SignalGroup>(*image.group); // others keep theirs
    image.group->add({std::move(name), std::move(unit), type, direction, image.count, count});
    image.count += count;
    m_slots += count;
    return m_slots - count;
}

SignalEntry SignalLayout::entryOf(const ImageSpan& image, const SignalGroup::Item& item) const {
    std::string path;
    path.reserve(image.robot.size() + 1 + item.name.size());
    if (!image.robot.empty()) path.append(image.robot).append("/");
    path += item.name;
    return {std::move(path), item.unit, item.type, item.direction, image.offset + item.offset, item.count};
}

std::optional<SignalEntry> SignalLayout::find(std::string_view path) const {
    const std::size_t slash = path.find('/');
    const bool owned = slash != std::string_view::npos;
    const ImageSpan* image = imageOf(owned ? path.substr(0, slash) : std::string_view());
    const SignalGroup::Item* item = image ? image->group->find(owned ? path.substr(slash + 1) : path) : nullptr;
    return item ? std::optional(entryOf(*image, *item)) : std::nullopt;
}

const ImageSpan* SignalLayout::imageOf(std::string_view robot) const {
    const std::uint32_t image = m_byRobot.find(robot, robotOf(m_images));
    return image == NameIndex::kNone ? nullptr : &m_images[image];
}

SignalLayout::Range SignalLayout::entries() const { return {*this, 0, m_images.size()}; }

SignalLayout::Range SignalLayout::entriesOf(std::string_view robot) const {
    const ImageSpan* image = imageOf(robot);
    const std::size_t first = image ? static_cast<std::size_t>(image - m_images.data()) : 0;
    return {*this, first, first + (image ? 1 : 0)};
}

std::size_t SignalLayout::Range::size() const {
    std::size_t size = 0;
    for (std::size_t i = m_first; i < m_end; ++i) size += m_layout->m_images[i].group->items().size();
    return size;
}

std::uint64_t SignalLayout::hash() const {
    std::uint64_t h = hashNumber(m_images.size(), 0xcbf29ce484222325ull), ofGroup = 0;
    const SignalGroup* last = nullptr; // equal robots follow each other
    for (const ImageSpan& image : m_images) {
        if (image.group.get() != last) ofGroup = image.group->hash();
        last = image.group.get();
        h = hashNumber(ofGroup, hashText(image.robot, h));
        h = hashNumber(image.count, hashNumber(image.offset, h));
    }
    return h;
}

} // namespace trundle
