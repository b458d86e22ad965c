#pragma once
#include <string>

#include <trundle/device.h>

namespace trundle {

/// A command slot as read by its device: an infinite or NaN value counts as 0 and is reported once.
class CommandSlot {
public:
    void bind(Mount& mount, const char* name) {
        m_name = name;
        m_slot = mount.signal(name);
    }
    [[nodiscard]] double read(const Services& world) {
        const double value = m_slot.get();
        if (std::isfinite(value)) return value;
        if (!m_reported) world.warn(std::string(m_name) + " was given a value that is no finite number; it counts as 0");
        m_reported = true;
        return 0;
    }

private:
    Slot m_slot;
    const char* m_name = "";
    bool m_reported = false;
};

} // namespace trundle
