#pragma once
// How many errors and warnings stand in each block, with those of the blocks inside it.

#include <unordered_map>
#include <vector>

#include "project/project.h"

namespace trundle {

class ProblemCounts {
public:
    struct Count {
        int errors = 0, warnings = 0;
        void add(const Count& more) { errors += more.errors, warnings += more.warnings; }
        bool operator==(const Count&) const = default;
    };

    /// Costs nothing to speak of where there are no problems.
    explicit ProblemCounts(const Loaded& loaded);

    [[nodiscard]] Count of(const Part& part) const;
    [[nodiscard]] Count ofFile(FileId file) const;
    [[nodiscard]] Count outside() const { return m_outside; } ///< in no block of any file
    [[nodiscard]] Count at(const SourceRange& range) const;   ///< whose place is within a range

private:
    struct Placed {
        const Part* part;
        int parent; ///< in m_placed, -1: stands at the top level
    };
    void place(const Part& part, int parent);
    [[nodiscard]] int innermost(const SourceRange& range) const;
    void count(const Diagnostic& diagnostic);

    std::vector<Placed> m_placed;
    std::vector<int> m_sorted; // places in m_placed by file and begin
    std::vector<std::pair<SourceRange, Count>> m_all;
    std::unordered_map<const Part*, Count> m_parts;
    std::unordered_map<FileId, Count> m_files;
    Count m_outside;
};

} // namespace trundle
