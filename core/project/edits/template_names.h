#pragma once
// What a new block can name in its config, and what the blocks there name. Private to core/project.

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "project/objects/object_location.h"

namespace trundle {

/// A block of a config, of a Part in it, or of a member of a Repeat.
struct NamedBlock {
    const Part* part = nullptr;
    std::string name;    ///< in the config: "chassis.hull", "left.motor", "roller_0.axle"
    std::string prefix;  ///< of what is beside it: "left."
    std::string outside; ///< the same of the innermost Part that it is in
    int depth = 0;       ///< Parts and Repeats around it
};

/// From the values of the text, so that a config without instances has names too. Parts may hold very many blocks: of those that are
/// not in the config itself only some thousands are known.
class TemplateNames {
public:
    /// `repeats`: in which the new block is; of these only the first member counts, and what it has is named as from inside of it.
    TemplateNames(const LoadedProject& loaded, const Part& config, const std::vector<const Part*>& repeats);

    /// Of blocks that fit a choice of a reference: first those in the innermost of `repeats`, then those in few Parts.
    [[nodiscard]] std::vector<std::string> fitting(const std::string& choice) const;
    /// nullptr: nothing has that name.
    [[nodiscard]] const NamedBlock* find(const std::string& name) const;
    /// Whether it is in the innermost of `repeats`; without those, whether it is in the config.
    [[nodiscard]] bool isInside(const NamedBlock& block) const { return block.name.starts_with(m_inside); }
    /// Whether it is the Child of a joint.
    [[nodiscard]] bool isChild(const std::string& body) const;
    /// Whether a block of the kind already names it by the property.
    [[nodiscard]] bool isUsed(const Kind& kind, const std::string& property, const std::string& name) const;
    /// The first block that a block names by a property; nullptr if that is not in this config.
    [[nodiscard]] const NamedBlock* named(const NamedBlock& block, const std::string& property) const;

    [[nodiscard]] const LoadedProject& loaded() const { return m_loaded; }
    [[nodiscard]] std::optional<ObjectLocation> locationOf(const std::string& nameInConfig) const;

private:
    struct Holder {
        const Part* part = nullptr;
        std::string prefix, outside;
        int depth = 0;
    };
    void add(const Holder& holder, const std::vector<const Part*>& repeats);
    void addMembers(const Part& repeat, const Holder& around, bool isOnlyFirst);
    void sortByDistance();
    [[nodiscard]] std::string written(const std::string& name) const;
    [[nodiscard]] std::vector<const NamedBlock*> allNamed(const NamedBlock& block, const std::string& property) const;

    const LoadedProject& m_loaded;
    const Part& m_config;
    std::string m_inside; ///< "roller_0." of the innermost of the Repeats
    std::vector<Holder> m_open;
    std::vector<NamedBlock> m_all;
    std::unordered_map<std::string, std::size_t> m_byName, m_byWritten;
    /// What blocks of a kind name by a property; for no kind, all joints. Collected when it is asked for.
    mutable std::map<std::pair<const Kind*, std::string>, std::set<const NamedBlock*>> m_used;
};

/// Whether a reference that allows `choice` can name a block.
[[nodiscard]] bool fitsChoice(const Part& part, const std::string& choice);

} // namespace trundle
