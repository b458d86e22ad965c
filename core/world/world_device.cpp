#include "world/world_device.h"

#include <algorithm>

#include "base/platform/module_text.h"

namespace trundle {

WorldDevice::~WorldDevice() {
    if (!instance || !kind || !kind->destroy) return;
    const MonitoredCall call(*calls, target, "destructor");
    kind->destroy(instance);
}

bool ServiceContext::mayShare(const char* what) const {
    if (!phase->isApart) return true;
    device->note("its kind says that it is independent of other robots, and it asks for " + std::string(what));
    return false;
}

void WorldDevice::note(const std::string& why) {
    if (failure.empty()) failure = why;
    if (phase) phase->noted.store(true, std::memory_order_relaxed);
}

std::string WorldDevice::lastError() const {
    const std::string text = kind->lastError ? moduleMessage(kind->lastError(instance)) : std::string();
    return text.empty() ? "it reported no reason" : text;
}

const WorldDevice* DeviceList::find(std::uint32_t robot, std::string_view name) const {
    for (std::uint32_t i = firstOf[robot]; i < firstOf[robot + 1]; ++i)
        if (all[i]->spec->name == name) return all[i].get();
    return nullptr;
}

const WorldDevice* DeviceList::find(std::string_view path) const {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& device) { return device->path == path; });
    return found == all.end() ? nullptr : found->get();
}

} // namespace trundle
