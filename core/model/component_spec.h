#pragma once
// Devices, controllers and logs: a kind, a name, and resolved values with their source ranges.
#include <map>
#include <string>
#include <vector>

#include "base/source_range.h"
#include "schema/kind.h"

namespace trundle {

/// The source of a value.
enum class Origin { Default, Config, Instance, Param, CommandLine };

struct ResolvedValue {
    PropertyValue value;
    SourceRange range; ///< of the value's text; unknown for a default
    Origin origin = Origin::Default;
    std::vector<SourceRange> names{}; ///< of each text, where there are several

    /// The range of one text of the value.
    [[nodiscard]] const SourceRange& rangeOf(std::size_t text) const { return text < names.size() ? names[text] : range; }
};

/// A device, controller or log; the model has only its schema, not its behaviour. Contains every property that has a value,
/// including defaults.
struct ComponentSpec {
    std::string kind, name;
    std::map<std::string, ResolvedValue, std::less<>> values;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< its name, or its kind if unnamed

    [[nodiscard]] const ResolvedValue* find(std::string_view key) const {
        const auto it = values.find(key);
        return it == values.end() ? nullptr : &it->second;
    }
    [[nodiscard]] double number(std::string_view key, double otherwise = 0) const;
    [[nodiscard]] std::string text(std::string_view key, std::string otherwise = {}) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
};

} // namespace trundle
