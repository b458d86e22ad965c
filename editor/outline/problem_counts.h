#pragma once
// Counts errors and warnings per block, including those of nested blocks.

#include <unordered_map>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

class ProblemCounts {
public:
    struct Count {
        int errors = 0, warnings = 0;
        void add(const Count& more) { errors += more.errors, warnings += more.warnings; }
        bool operator==(const Count&) const = default;
    };

    /// Cheap if there are no diagnostics.
    explicit ProblemCounts(const LoadedProject& loaded);

    [[nodiscard]] Count of(const Part& part) const;
    [[nodiscard]] Count ofFile(FileId file) const;
    /// Outside of every block, without those of modules, which have rows of their own.
    [[nodiscard]] Count outside(const LoadedProject& loaded) const;
    [[nodiscard]] Count at(const SourceRange& range) const;   ///< located within a range

private:
    struct Placed {
        const Part* part;
        int parent; ///< index of the enclosing block in m_placed; -1: top level
    };
    void place(const Part& part, int parent);
    [[nodiscard]] int innermost(const SourceRange& range) const;
    void count(const Diagnostic& diagnostic);

    std::vector<Placed> m_placed;
    std::vector<int> m_sorted; // indices into m_placed, by file and begin
    std::vector<std::pair<SourceRange, Count>> m_all;
    std::unordered_map<const Part*, Count> m_parts;
    std::unordered_map<FileId, Count> m_files;
    Count m_outside;
};

} // namespace trundle
