#include "editor/outline/problem_counts.h"

#include <algorithm>

namespace trundle {

ProblemCounts::ProblemCounts(const LoadedProject& loaded) {
    const auto& all = loaded.diagnostics.all();
    const auto counts = [](const Diagnostic& d) { return d.severity != Severity::Hint && d.range.known(); };
    if (std::none_of(all.begin(), all.end(), counts)) return;
    for (const auto& part : loaded.outline->parts) place(*part, -1);
    m_sorted.resize(m_placed.size());
    for (std::size_t i = 0; i < m_sorted.size(); ++i) m_sorted[i] = static_cast<int>(i);
    std::stable_sort(m_sorted.begin(), m_sorted.end(), [&](int a, int b) {
        const SourceRange &x = m_placed[std::size_t(a)].part->range, &y = m_placed[std::size_t(b)].part->range;
        return x.file != y.file ? x.file < y.file : x.range.begin < y.range.begin;
    });
    for (const Diagnostic& d : all)
        if (counts(d)) count(d);
}

void ProblemCounts::place(const Part& part, int parent) {
    const int here = static_cast<int>(m_placed.size());
    m_placed.push_back({&part, parent});
    for (const Part& inner : part.parts) place(inner, here);
}

int ProblemCounts::innermost(const SourceRange& range) const {
    const auto after = std::upper_bound(m_sorted.begin(), m_sorted.end(), range, [&](const SourceRange& at, int i) {
        const SourceRange& block = m_placed[std::size_t(i)].part->range;
        return at.file != block.file ? at.file < block.file : at.range.begin < block.range.begin;
    });
    // Blocks nest, so those around a position are the last one that begins before it and the ancestors of that one.
    int i = after == m_sorted.begin() ? -1 : *(after - 1);
    while (i >= 0) {
        const Placed& placed = m_placed[std::size_t(i)];
        if (placed.part->file != range.file) return -1;
        if (range.range.begin < placed.part->range.range.end) return i;
        i = placed.parent;
    }
    return -1;
}

void ProblemCounts::count(const Diagnostic& diagnostic) {
    const Count one = diagnostic.severity == Severity::Error ? Count{1, 0} : Count{0, 1};
    m_all.push_back({diagnostic.range, one});
    m_files[diagnostic.range.file].add(one);
    int i = innermost(diagnostic.range);
    if (i < 0) m_outside.add(one);
    for (; i >= 0; i = m_placed[std::size_t(i)].parent) m_parts[m_placed[std::size_t(i)].part].add(one);
}

ProblemCounts::Count ProblemCounts::outside(const LoadedProject& loaded) const {
    Count count = m_outside;
    for (const ModuleSpec& module : loaded.experiment->modules) {
        const Count there = at(module.range);
        count.errors -= there.errors;
        count.warnings -= there.warnings;
    }
    return count;
}

ProblemCounts::Count ProblemCounts::of(const Part& part) const {
    const auto it = m_parts.find(&part);
    return it == m_parts.end() ? Count{} : it->second;
}

ProblemCounts::Count ProblemCounts::ofFile(FileId file) const {
    const auto it = m_files.find(file);
    return it == m_files.end() ? Count{} : it->second;
}

ProblemCounts::Count ProblemCounts::at(const SourceRange& range) const {
    Count sum;
    for (const auto& [place, count] : m_all)
        if (place.file == range.file && place.range.begin >= range.range.begin && place.range.begin <= range.range.end)
            sum.add(count);
    return sum;
}

} // namespace trundle
