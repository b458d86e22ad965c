#pragma once
// The assignments, Params and blocks of one block (or of the top level) with its imports expanded.

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/diagnostic.h"
#include "model/param_description.h"
#include "model/text_set.h"

namespace trundle {

struct SourceAssignment {
    std::string key;            ///< the path joined by dots
    std::span<const Name> path; ///< its words, relative to the block
    const Value* value = nullptr;
    FileId file = kNoFile;
    const AssignmentItem* item = nullptr;

    [[nodiscard]] SourceRange keyRange() const { return {file, {path.front().range.begin, path.back().range.end}}; }
    [[nodiscard]] SourceRange valueRange() const { return {file, value->range}; }
};

/// Assignments with unique keys. Lookup by key takes constant time.
class AssignmentList {
public:
    [[nodiscard]] const SourceAssignment* find(std::string_view key) const;
    void add(SourceAssignment assignment);
    void replace(SourceAssignment assignment); ///< adds it if the key is new
    [[nodiscard]] const std::vector<SourceAssignment>& all() const { return m_all; }

private:
    [[nodiscard]] std::size_t place(std::string_view key) const;
    std::vector<SourceAssignment> m_all;
    std::unordered_map<std::string, std::size_t> m_index; ///< only for long lists
};

struct SourceParam {
    const Name* name = nullptr; ///< in the declaration
    const Value* value = nullptr;
    FileId file = kNoFile;      ///< of the declaration
    FileId valueFile = kNoFile; ///< differs when --set gives the value
    const ParamItem* item = nullptr; ///< the declaration; nullptr: implied
    bool required = false;      ///< implied, see ImpliedParam: every use must give it
    std::shared_ptr<const ParamDescription> description = nullptr; ///< null: nothing is said about it

    [[nodiscard]] SourceRange nameRange() const { return {file, name->range}; }
};

struct SourceBlock {
    const Item* item = nullptr;
    const BlockItem* block = nullptr;
    FileId file = kNoFile;
};

struct BlockView {
    AssignmentList assignments;
    std::vector<SourceParam> params;
    std::vector<SourceBlock> blocks; ///< in text order; imported ones at the position of their directive
    std::vector<FileId> imported;    ///< imported files, in order
};

/// Expands imports. A file imported a second time in one block has no effect; the same key twice in one file is E210; the
/// importing file's assignment overrides an imported one; if two imported files disagree on another key, the later one is used,
/// with E215.
[[nodiscard]] BlockView viewOf(const TextSet& texts, const std::vector<Item>& items, FileId file, Diagnostics& diagnostics);

/// The number of blocks in the full expansion, counted up to `limit` without building it.
[[nodiscard]] std::size_t countBlocks(const TextSet& texts, std::size_t limit);

} // namespace trundle
