#pragma once
// Texts that devices print.

#include <vector>

#include "world/world.h"

namespace trundle {

class DeviceTexts {
public:
    /// Texts printed while the world is being built are kept until a listener is set.
    void print(const std::string& path, int severity, const char* text);
    /// Passes what was printed so far to it at once.
    void setListener(DeviceText listener);

private:
    struct EarlyText {
        std::string path;
        int severity = 0;
        std::string text;
    };
    DeviceText m_listener;
    std::vector<EarlyText> m_early;
};

} // namespace trundle
