#pragma once
// The text of one value and what it says, parsed once: what an edit carries from a property row to the tree.

#include <concepts>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "lang/tree.h"

namespace trundle {

/// Immutable; copying shares the parsed value.
class ParsedValue {
public:
    ParsedValue() = default; ///< no text: removes a value
    template <std::convertible_to<std::string_view> Text>
    ParsedValue(const Text& text) : m_parsed(parse(std::string_view(text))) {}

    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] bool empty() const { return text().empty(); }
    /// Fails with the reason if the text is not exactly one value.
    [[nodiscard]] const Status& status() const;
    /// Ranges of the elements begin at the text's first byte; those in expressions do not. Empty if status() has failed.
    [[nodiscard]] const Value& value() const;

    [[nodiscard]] bool operator==(const ParsedValue& other) const { return text() == other.text(); }

private:
    struct Parsed {
        std::string text;
        Status status;
        Value value;
    };
    [[nodiscard]] static std::shared_ptr<const Parsed> parse(std::string_view text);
    [[nodiscard]] const Parsed& parsed() const;

    std::shared_ptr<const Parsed> m_parsed;
};

} // namespace trundle
