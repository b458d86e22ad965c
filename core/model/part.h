#pragma once
// A named block of an experiment, and lists of them by name.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/block_view.h"
#include "schema/kind.h"

namespace trundle {

/// A Param that no text declares: `$name` as the reference of a PartConfig to something outside of it.
struct ImpliedParam {
    Name name;
    Value value; ///< without elements
};

/// One block with its name and its inner blocks.
struct Part {
    const BlockItem* block = nullptr;
    FileId file = kNoFile;
    SourceRange range;          ///< the whole block
    const Kind* kind = nullptr; ///< nullptr: unknown kind (reported, or kept as raw text)
    std::string name;           ///< given or generated: box, box2 ...
    std::uint32_t order = 0;    ///< of its top-level block
    bool usable = true;         ///< false: misplaced, unknown or a duplicate name
    bool isInWorld = false;     ///< of a Repeat: at the top level, not in a config
    AssignmentList assignments;
    std::vector<SourceParam> params;
    std::vector<Part> parts;                            ///< inner blocks, in order
    std::unordered_map<std::string, std::size_t> index; ///< parts by name, only for long lists
    const Part* config = nullptr;                       ///< of a Part: the PartConfig that it uses, see Outline::linkParts()
    std::vector<std::shared_ptr<const ImpliedParam>> implied; ///< of a PartConfig: the texts of its implied Params

    [[nodiscard]] SourceRange nameRange() const { return {file, block->name ? block->name->range : block->type.range}; }
    [[nodiscard]] SourceRange typeRange() const { return {file, block->type.range}; }
    /// For messages: "Cylinder tyre".
    [[nodiscard]] std::string title() const { return block->name ? block->type.text + " " + name : block->type.text; }
    /// What has that name inside; of a Part also what its PartConfig has. The name of a member, roller_3, leads to its Repeat.
    [[nodiscard]] const Part* find(std::string_view part) const;
    /// The same for a path, "left.wheel.tyre".
    [[nodiscard]] const Part* findPath(std::string_view path) const;
    [[nodiscard]] bool is(Role role) const { return kind && kind->role == role; }
    [[nodiscard]] const SourceParam* param(std::string_view key) const;
    /// Whether it is a Part: an instance inside a config, with parts of its own.
    [[nodiscard]] bool isPartUse() const { return kind && kind->name == "Part"; }
    /// Whether it is a Repeat or Ring: its parts are there once for each of its members, roller_0, roller_1 ...
    [[nodiscard]] bool isRepeat() const { return is(Role::Repeat); }
    void makeIndex();

private:
    [[nodiscard]] const Part* findOwn(std::string_view part) const;
};

/// Calls `visit` for every Part that a config holds, also in its Repeats.
template <class Visit> void eachPartUse(const Part& config, const Visit& visit) {
    for (const Part& part : config.parts) {
        if (part.isRepeat()) eachPartUse(part, visit);
        else if (part.isPartUse()) visit(part);
    }
}

/// Parts with unique names, in order.
class NameSpace {
public:
    /// Also of what is in a Repeat, "row_3.cart" or "row.cart", with its name, and of a member, "row_3", its Repeat.
    [[nodiscard]] const Part* find(std::string_view name) const;
    [[nodiscard]] const std::vector<const Part*>& all() const { return m_all; }
    [[nodiscard]] std::vector<std::string> names() const;
    /// Adds a part; if the name is taken, returns the part that has it instead.
    const Part* add(const Part& part);

private:
    std::vector<const Part*> m_all;
    std::unordered_map<std::string_view, const Part*> m_byName;
};

[[nodiscard]] std::vector<std::string> propertyNames(const Kind& kind);
[[nodiscard]] const char* roleName(Role role);
/// Limits the effort for suggestions: after this many messages they are not useful, and computing them would take minutes.
[[nodiscard]] inline bool manyAlready(const Diagnostics& diagnostics) { return diagnostics.all().size() > 500; }

} // namespace trundle
