// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include <trundle/description.h>

namespace trundle {
inline namespace sdk1 {
namespace border {

/// TrundleSignal::countFields of a signal.
inline std::uint32_t countFieldBits(const SignalInfo& signal, const std::vector<FieldInfo>& fields) {
    std::uint32_t bits = 0, shift = 0;
    for (const std::string& name : signal.countFields) {
        std::uint32_t at = 0;
        while (at < fields.size() && (fields[at].name != name || !fields[at].number)) ++at;
        if (at == fields.size() || shift > 16)
            throw std::logic_error("no integer field " + name + " for the signal " + signal.name);
        bits |= (at + 1) << shift;
        shift += 16;
    }
    return bits;
}

} // namespace border
} // namespace sdk1
} // namespace trundle
