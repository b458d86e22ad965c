#pragma once
// Checks and generates names. Private to core/project.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "project/loading/project.h"

namespace trundle {

/// Fails with the reason: not an identifier, or a reserved word.
[[nodiscard]] Status legalName(std::string_view name);
/// The nearest legal name.
[[nodiscard]] std::string legalised(std::string_view preferred);
/// The default name of an unnamed block: "hinge" for "Hinge".
[[nodiscard]] std::string lowerFirst(std::string word);

/// The names used in one name space, including those that a plan has generated.
class UsedNames {
public:
    /// Inside `parent`; at the top level (nullptr) in the kind's name space, or in all of them if the kind is unknown.
    UsedNames(const LoadedProject& loaded, const Part* parent, const Kind* kind);

    /// The block that has the name, such as "Robot robot0"; empty if it is free.
    [[nodiscard]] std::string holder(const std::string& name) const;
    /// Reserves `preferred`, or the next free name with a number.
    std::string take(const std::string& preferred);

private:
    [[nodiscard]] const Part* beside(const std::string& name) const;
    [[nodiscard]] std::string inSpace(const NameSpace& space, const std::string& name) const;

    const LoadedProject& m_loaded;
    const Part* m_parent;
    const Kind* m_kind;
    std::vector<const NameSpace*> m_spaces;
    std::set<std::string> m_given;
};

} // namespace trundle
