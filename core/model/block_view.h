#pragma once
// The settings, Params and blocks of one block (or of the top level) once its imports have taken their places.

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/diagnostic.h"
#include "model/text_set.h"

namespace trundle {

struct PlacedAssignment {
    std::string key;            ///< the path joined by dots
    std::span<const Name> path; ///< its words, relative to the block
    const Value* value = nullptr;
    FileId file = kNoFile;
    const AssignmentItem* item = nullptr;

    [[nodiscard]] SourceRange keyRange() const { return {file, {path.front().range.begin, path.back().range.end}}; }
    [[nodiscard]] SourceRange valueRange() const { return {file, value->range}; }
};

/// Each key once. Found by key in constant time, however many there are.
class AssignmentList {
public:
    [[nodiscard]] const PlacedAssignment* find(std::string_view key) const;
    void add(PlacedAssignment assignment);
    void replace(PlacedAssignment assignment); ///< adds it where the key is new
    [[nodiscard]] const std::vector<PlacedAssignment>& all() const { return m_all; }

private:
    [[nodiscard]] std::size_t place(std::string_view key) const;
    std::vector<PlacedAssignment> m_all;
    std::unordered_map<std::string, std::size_t> m_index; ///< only for long lists
};

struct PlacedParam {
    const Name* name = nullptr; ///< the declaration's
    const Value* value = nullptr;
    FileId file = kNoFile;      ///< of the declaration
    FileId valueFile = kNoFile; ///< differs when --set gives the value

    [[nodiscard]] SourceRange nameRange() const { return {file, name->range}; }
};

struct PlacedBlock {
    const Item* item = nullptr;
    const BlockItem* block = nullptr;
    FileId file = kNoFile;
};

struct BlockView {
    AssignmentList assignments;
    std::vector<PlacedParam> params;
    std::vector<PlacedBlock> blocks; ///< in text order, imported ones in the place of their directive
    std::vector<FileId> imported;    ///< files that were brought in, in order
};

/// Expands imports. A file a second time in one block adds nothing; same key twice in one file is E210; the importing file's
/// setting beats an imported one; of two imported files that disagree the later wins with E215.
[[nodiscard]] BlockView viewOf(const TextSet& texts, const std::vector<Item>& items, FileId file, Diagnostics& diagnostics);

/// How many blocks a full expansion holds, counted up to `limit` without building anything.
[[nodiscard]] std::size_t countBlocks(const TextSet& texts, std::size_t limit);

} // namespace trundle
