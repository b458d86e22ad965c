#pragma once
// Blocks given as text on their way to places of their own. Private to core/project.

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "lang/tree.h"
#include "project/project.h"

namespace trundle {

class PastedBlocks {
public:
    struct Entry {
        const Item* item = nullptr;
        const BlockItem* block = nullptr;
        const Kind* kind = nullptr;   ///< nullptr: not known here
        const Part* target = nullptr; ///< block it goes into; nullptr: the top level
        std::string name;             ///< that it gets; empty: it stays without one
        TextRange whole;              ///< with the comments before it, and behind it on its line
    };

    /// Fails where the text cannot be read or holds something else than blocks and directives.
    [[nodiscard]] static Result<PastedBlocks> read(const Registry& registry, const std::string& text);

    std::vector<Entry> entries;
    struct GivenParam {
        std::string text, value; ///< "Param side = 3", "3"
    };
    std::map<std::string, GivenParam> params; ///< of the top level, by their names
    std::vector<std::string> directives;      ///< "#import robots/rover.sim"

    /// The entry's text under its name, where what it says of other entries that got another name is changed as well.
    [[nodiscard]] std::string textOf(const Loaded& loaded, const Entry& entry) const;
    /// What the entry's text names and there is not where it goes: "$side", "Material red"; empty: nothing. `round` are the blocks
    /// round its place, the innermost last.
    [[nodiscard]] std::string missing(const Loaded& loaded, const Entry& entry, const std::vector<const Part*>& round) const;

private:
    struct Seen;
    [[nodiscard]] std::string missingIn(const Loaded& loaded, const Entry& entry, const BlockItem& block, Seen seen) const;
    [[nodiscard]] bool leadsSomewhere(const Loaded& loaded, const Entry& entry, const Kind& kind, const Property& property,
                                      const std::string& word, const Seen& seen) const;
    /// What `entry` means by `name` in a value that takes `choices`: the new name, or nothing.
    [[nodiscard]] const Entry* named(const Loaded& loaded, const Entry& user, const Property& property,
                                     std::string_view name) const;
    void collect(const Loaded& loaded, const Entry& entry, const BlockItem& block, const Kind* kind,
                 std::vector<TextEdit>& edits) const;

    std::shared_ptr<const Tree> m_tree;
};

} // namespace trundle
