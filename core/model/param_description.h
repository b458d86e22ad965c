#pragma once
// What a text says about a Param in braces behind its value: `Param r = 5 cm { Min=2 cm Max=20 cm Help="wheel radius" }`.

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/tree.h"
#include "schema/given_value.h"
#include "schema/kind.h"

namespace trundle {

/// Immutable; shared by the Param, those that variants inherit, and rows.
struct ParamDescription {
    Property property;                 ///< name, help, limits in `unit`; the choices as words
    std::vector<GivenElement> choices; ///< empty: any value
    bool hasLimits = false;
    SourceRange range;                 ///< of the braces

    /// "from 2 to 20 cm", "slow or fast"; empty: any value.
    [[nodiscard]] std::string limits() const;
};

/// The note on a value that a description forbids; it refers to the description.
inline constexpr const char* kDescribedHere = "its values are described here";

struct DescriptionKey {
    std::string name, help;
};
/// What a description may say, in the order in which it is offered.
[[nodiscard]] const std::vector<DescriptionKey>& descriptionKeys();

/// The description of a Param with its mistakes reported; null: it has none.
[[nodiscard]] std::shared_ptr<const ParamDescription> descriptionOf(const ParamItem& param, FileId file, Diagnostics& diagnostics);

/// Whether a value is one that the description allows; if not, reports it where the value is given.
[[nodiscard]] bool checkValue(const ParamDescription& description, const GivenValue& value, Diagnostics& diagnostics);

} // namespace trundle
