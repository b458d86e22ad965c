#pragma once
// Blocks given as text, and the blocks that they are to be inserted into. Private to core/project.

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "lang/tree.h"
#include "project/loading/project.h"

namespace trundle {

class PastedBlocks {
public:
    struct Entry {
        const Item* item = nullptr;
        const BlockItem* block = nullptr;
        const Kind* kind = nullptr;   ///< nullptr: unknown kind
        const Part* target = nullptr; ///< the block to insert it into; nullptr: the top level
        std::string name;             ///< its new name; empty: unnamed
        TextRange whole;              ///< including comments before it, and after it on its line
    };

    /// Fails if the text has syntax errors or contains anything but blocks and directives.
    [[nodiscard]] static Result<PastedBlocks> read(const Registry& registry, const std::string& text);

    std::vector<Entry> entries;
    struct GivenParam {
        std::string text, value; ///< "Param side = 3", "3"
    };
    std::map<std::string, GivenParam> params; ///< of the top level, by name
    std::vector<std::string> directives;      ///< "#import robots/rover.sim"

    /// The entry's text under its new name, with its references to renamed entries updated.
    [[nodiscard]] std::string textOf(const LoadedProject& loaded, const Entry& entry) const;
    /// The first name in the entry's text that is undefined at its target: "$side", "Material red"; empty: none. `round` are the
    /// blocks around the target, innermost last.
    [[nodiscard]] std::string missing(const LoadedProject& loaded, const Entry& entry,
                                      const std::vector<const Part*>& round) const;

private:
    struct PasteContext;
    [[nodiscard]] std::string missingIn(const LoadedProject& loaded, const Entry& entry, const BlockItem& block,
                                        PasteContext seen) const;
    [[nodiscard]] bool leadsSomewhere(const LoadedProject& loaded, const Entry& entry, const Kind& kind, const Property& property,
                                      const std::string& word, const PasteContext& seen) const;
    /// The entry that `entry` refers to by `name` in a value that accepts `choices`, or nullptr.
    [[nodiscard]] const Entry* named(const LoadedProject& loaded, const Entry& user, const Property& property,
                                     std::string_view name) const;
    void collect(const LoadedProject& loaded, const Entry& entry, const BlockItem& block, const Kind* kind,
                 std::vector<TextEdit>& edits) const;

    std::shared_ptr<const Tree> m_tree;
};

} // namespace trundle
