#include "world/device_texts.h"

#include <utility>

namespace trundle {

namespace {

constexpr std::size_t kMaxEarlyTexts = 1000;

} // namespace

void DeviceTexts::print(const std::string& path, int severity, const char* text) {
    if (m_listener) m_listener(path, severity, text);
    else if (m_early.size() < kMaxEarlyTexts) m_early.push_back({path, severity, text});
}

void DeviceTexts::setListener(DeviceText listener) {
    m_listener = std::move(listener);
    if (!m_listener) return;
    for (const EarlyText& early : std::exchange(m_early, {})) m_listener(early.path, early.severity, early.text);
}

} // namespace trundle
