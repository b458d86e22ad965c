#include "model/signal_count.h"

#include <algorithm>
#include <cmath>

namespace trundle {

std::uint32_t signalCount(const SignalDescription& signal, const ComponentSpec& component) {
    double count = std::max(signal.count, 1u);
    for (const std::string& field : signal.countFields) count *= std::max(std::floor(component.number(field, 1)), 1.0);
    return count <= static_cast<double>(kMaxSignalNumbers) ? static_cast<std::uint32_t>(count) : 1;
}

} // namespace trundle
