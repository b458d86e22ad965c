#pragma once
// The named parts of an experiment as the text declares them: what stands where under which name, before any value is read.
// References, overrides, provenance and edits all find their way in it.

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/block_view.h"
#include "schema/registry.h"

namespace trundle {

/// One block with its name and what it holds.
struct Part {
    const BlockItem* block = nullptr;
    FileId file = kNoFile;
    SourceRange range;          ///< the whole block
    const Kind* kind = nullptr; ///< nullptr: no such kind (said, or to be left as raw text)
    std::string name;           ///< given, or made: box, box2 ...
    std::uint32_t order = 0;    ///< of the top-level block it stands in
    bool usable = true;         ///< false: misplaced, unknown or a second one of its name
    AssignmentList assignments;
    std::vector<PlacedParam> params;
    std::vector<Part> parts;                            ///< blocks inside, in order
    std::unordered_map<std::string, std::size_t> index; ///< of the parts by name, only where there are many

    [[nodiscard]] SourceRange nameRange() const { return {file, block->name ? block->name->range : block->type.range}; }
    [[nodiscard]] SourceRange typeRange() const { return {file, block->type.range}; }
    /// "Cylinder tyre".
    [[nodiscard]] std::string title() const { return block->name ? block->type.text + " " + name : block->type.text; }
    [[nodiscard]] const Part* find(std::string_view part) const;
    [[nodiscard]] bool is(Role role) const { return kind && kind->role == role; }
    [[nodiscard]] const PlacedParam* param(std::string_view key) const;
    void makeIndex();
};

/// Parts that share one name space, in order.
class NameSpace {
public:
    [[nodiscard]] const Part* find(std::string_view name) const;
    [[nodiscard]] const std::vector<const Part*>& all() const { return m_all; }
    [[nodiscard]] std::vector<std::string> names() const;
    /// The one that has the name already, or nullptr after adding.
    const Part* add(const Part& part);

private:
    std::vector<const Part*> m_all;
    std::unordered_map<std::string_view, const Part*> m_byName;
};

/// Points into the trees of its TextSet and the kinds of its registry, and keeps both alive.
class Outline {
public:
    /// Says what is unknown, misplaced, unnamed or twice there. Gives an empty outline with E312 when the text holds too much.
    [[nodiscard]] static std::shared_ptr<Outline> build(std::shared_ptr<const TextSet> texts,
                                                        std::shared_ptr<const Registry> registry, Diagnostics& diagnostics);

    AssignmentList settings;
    std::vector<PlacedParam> params;
    std::vector<std::unique_ptr<Part>> parts; ///< everything at the top level, in order
    NameSpace materials, surfaces, patterns, configs, world;
    std::unordered_set<std::string> unknown; ///< names of blocks that could not be placed: no follow-ups about them

    [[nodiscard]] const TextSet& texts() const { return *m_texts; }
    [[nodiscard]] const Registry& registry() const { return *m_registry; }
    /// The name space of `Surface.rubber`'s first word: by kind, nullptr for an unknown one.
    [[nodiscard]] const NameSpace* spaceOf(const Kind& kind) const;

private:
    std::shared_ptr<const TextSet> m_texts;
    std::shared_ptr<const Registry> m_registry;
};

/// "swarm" and 12 from "swarm_12" when swarm is a Grid or Scatter of this outline.
[[nodiscard]] const Part* layoutOfMember(const Outline& outline, std::string_view name);
/// Names of the parts inside, of its Params and of its properties.
[[nodiscard]] std::vector<std::string> partNames(const Part& part);
[[nodiscard]] std::vector<std::string> propertyNames(const Kind& kind);
[[nodiscard]] const char* roleName(Role role);
/// After so many messages nobody reads suggestions, and a text of nothing but faults must not take minutes.
[[nodiscard]] inline bool manyAlready(const Diagnostics& diagnostics) { return diagnostics.all().size() > 500; }

} // namespace trundle
