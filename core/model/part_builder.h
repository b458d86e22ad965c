#pragma once
#include <unordered_map>
#include <unordered_set>

#include "model/block_view.h"
#include "model/part.h"
#include "schema/registry.h"

namespace trundle {

/// Builds the parts of an outline and reports all errors that follow from names and kinds alone.
class PartBuilder {
public:
    PartBuilder(const TextSet& texts, const Registry& registry, Diagnostics& diagnostics)
        : m_texts(texts), m_registry(registry), m_diagnostics(diagnostics) {}

    /// All of the top level, which has to live as long as this: whether the opened file has nothing but blocks that belong in other
    /// blocks, since it is made to be imported there.
    void setTop(const BlockView& top);
    /// `parent` is the enclosing part, nullptr at the top level.
    [[nodiscard]] Part build(const SourceBlock& placed, const Part* parent, std::uint32_t order);

private:
    void fill(Part& part, FileId file);
    void checkParams(const Part& config);
    void nameParts(Part& part);
    [[nodiscard]] bool belongsInside(const BlockItem& block) const;
    [[nodiscard]] bool allows(const Part* parent, const Kind& kind) const;
    [[nodiscard]] std::string placeOf(const Part* parent) const;
    [[nodiscard]] bool fits(Part& part, const Part* parent);
    void unknownKind(const Part& part, const Part* parent);
    bool isMeantAsPath(const Part& part, const Part* parent);
    bool isConfigName(const Part& part, const Part* parent);
    void misplaced(const Part& part, const Part* parent);
    void looseGeoms(const Part& config);

    const TextSet& m_texts;
    const Registry& m_registry;
    Diagnostics& m_diagnostics;
    const BlockView* m_top = nullptr;
    bool m_isFragment = false, m_fragmentReported = false;
    const Kind* m_config = nullptr; ///< of the top-level block, if it is a config
    const Kind* m_holder = nullptr; ///< of the innermost block around that is no Repeat
};

/// Names unnamed parts in order: box, box2 ...; reports E304 for a missing name and E303 for a duplicate.
class PartNames {
public:
    explicit PartNames(Diagnostics& diagnostics) : m_diagnostics(diagnostics) {}
    void reserve(const std::string& name) { m_reserved.insert(name); }
    void take(const std::string& name, SourceRange where) { m_taken.emplace(name, where); }
    /// False if the name is already taken.
    bool name(Part& part);

private:
    Diagnostics& m_diagnostics;
    std::unordered_map<std::string, SourceRange> m_taken;
    std::unordered_set<std::string> m_reserved;
    std::unordered_map<std::string, int> m_counts;
};

} // namespace trundle
