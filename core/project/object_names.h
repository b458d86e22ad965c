#pragma once
// Which names things may have. Private to core/project.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "project/project.h"

namespace trundle {

/// Fails with the reason: no name of the language, or a reserved word.
[[nodiscard]] Status legalName(std::string_view name);
/// A legal name near to any wish.
[[nodiscard]] std::string legalised(std::string_view wish);
/// "hinge" for "Hinge": what an unnamed block of a kind is called.
[[nodiscard]] std::string lowerFirst(std::string word);

/// The names of one name space, and those that a plan gives out in it.
class TakenNames {
public:
    /// Inside `parent`; at the top level (nullptr) those of the kind's name space, of all where the kind is unknown.
    TakenNames(const Loaded& loaded, const Part* parent, const Kind* kind);

    /// Who has the name: "Robot robot0"; empty: nobody.
    [[nodiscard]] std::string holder(const std::string& name) const;
    /// `wish`, or the next number behind it that is free. It is taken from now on.
    std::string take(const std::string& wish);

private:
    [[nodiscard]] const Part* beside(const std::string& name) const;
    [[nodiscard]] std::string inSpace(const NameSpace& space, const std::string& name) const;

    const Loaded& m_loaded;
    const Part* m_parent;
    const Kind* m_kind;
    std::vector<const NameSpace*> m_spaces;
    std::set<std::string> m_given;
};

} // namespace trundle
