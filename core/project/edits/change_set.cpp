// needs        two loads of the same files in the same order
// method       the changed range of each file is what remains between the longest common beginning and end of its two texts; then
//              the blocks are compared from the top down, and a block is the same if its file is, or if it lies outside that range
//              and has only moved with it; what is left is matched by name, and a missing and a new name at one place by kind
// data         ranges of the earlier load refer to its texts, those of the later one to its own

#include "project/edits/change_set.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "model/dotted_path.h"

namespace trundle {

namespace {

/// An import or a module changes which blocks and kinds there are.
bool isDirective(const Item& item) { return item.as<ImportItem>() || item.as<ModuleItem>(); }

bool overlap(const TextRange& range, std::uint32_t begin, std::uint32_t end) { return range.begin <= end && begin <= range.end; }

/// Whether a directive of these items, or of a block among them, is in the range.
bool hasDirectiveIn(const std::vector<Item>& items, std::uint32_t begin, std::uint32_t end) {
    return std::ranges::any_of(items, [&](const Item& item) {
        if (!overlap(item.range, begin, end)) return false;
        const auto* block = item.as<BlockItem>();
        return isDirective(item) || (block && hasDirectiveIn(block->items, begin, end));
    });
}

bool hasErrors(const Tree& tree) {
    return std::ranges::any_of(tree.diagnostics(), [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string topPath(const Outline& outline, const Part& part) {
    const NameSpace* space = part.kind ? outline.spaceOf(*part.kind) : nullptr;
    return space && space != &outline.world ? pathInside(part.kind->name, part.name) : part.name;
}

const std::string& typeOf(const Part& part) { return part.block->type.text; }

} // namespace

/// Compares the blocks of two loads.
class PartComparison {
public:
    explicit PartComparison(ChangeSet& out) : m_out(out), m_was(*out.m_before->outline), m_is(*out.m_after->outline) {}

    void run() {
        m_out.m_settings = differences(m_was.settings, m_is.settings);
        m_out.m_params = differences(m_was.params, m_is.params);
        Siblings was, is;
        for (const auto& part : m_was.parts) was.push_back(part.get());
        for (const auto& part : m_is.parts) is.push_back(part.get());
        const auto path = [](const Outline& outline) { return [&outline](const Part& part) { return topPath(outline, part); }; };
        compareSiblings(was, is, path(m_was), path(m_is));
    }

private:
    using Siblings = std::vector<const Part*>;

    [[nodiscard]] bool isSame(const Part& was, const Part& is) const {
        if (was.block == is.block) return was.name == is.name && !holdsEdited(was);
        const std::optional<SourceRange> now = m_out.nowAt(was.range);
        return now && *now == is.range && was.name == is.name && typeOf(was) == typeOf(is) && !holdsEdited(was);
    }

    /// Whether a block has something from an imported file that was edited.
    [[nodiscard]] bool holdsEdited(const Part& part) const {
        if (m_edited.empty()) {
            for (FileId file = 0; file < m_out.m_splices.size(); ++file)
                if (m_out.m_splices[file]) m_edited.insert(file);
        }
        if (m_edited.size() == 1 && *m_edited.begin() == part.file) return false; // no file imports itself
        const auto isEdited = [&](FileId file) { return file != part.file && m_edited.contains(file); };
        return std::ranges::any_of(part.assignments.all(), [&](const SourceAssignment& a) { return isEdited(a.file); }) ||
               std::ranges::any_of(part.params, [&](const SourceParam& p) { return isEdited(p.valueFile); }) ||
               std::ranges::any_of(part.parts, [&](const Part& inner) { return isEdited(inner.file) || holdsEdited(inner); });
    }

    static SourceRange rangeOf(const SourceAssignment& a) { return {a.file, {a.path.front().range.begin, a.value->range.end}}; }
    static SourceRange rangeOf(const SourceParam& p) {
        if (p.valueFile != p.file) return {p.valueFile, p.value->range};
        return {p.file, {p.name->range.begin, p.description ? p.description->range.range.end : p.value->range.end}};
    }

    std::vector<std::string> differences(const AssignmentList& was, const AssignmentList& is) const {
        std::vector<std::string> keys;
        for (const SourceAssignment& a : is.all()) {
            const SourceAssignment* before = was.find(a.key);
            if (before && m_was.texts().slice(before->valueRange()) == m_is.texts().slice(a.valueRange())) continue;
            keys.push_back(a.key);
            m_out.m_isAt.push_back(rangeOf(a));
            if (before) m_out.m_wasAt.push_back(rangeOf(*before));
        }
        for (const SourceAssignment& a : was.all()) {
            if (is.find(a.key)) continue;
            keys.push_back(a.key);
            m_out.m_wasAt.push_back(rangeOf(a));
        }
        return keys;
    }

    std::vector<std::string> differences(const std::vector<SourceParam>& was, const std::vector<SourceParam>& is) const {
        const auto textOf = [](const Outline& outline, const SourceParam& p) {
            const std::string value(outline.texts().slice(p.valueFile, p.value->range));
            return p.description ? value + std::string(outline.texts().slice(p.description->range)) : value;
        };
        std::map<std::string_view, const SourceParam*> before;
        for (const SourceParam& p : was) before.emplace(p.name->text, &p);
        std::vector<std::string> names;
        for (const SourceParam& p : is) {
            const auto found = before.find(p.name->text);
            const SourceParam* old = found == before.end() ? nullptr : found->second;
            if (old) before.erase(found);
            if (old && textOf(m_was, *old) == textOf(m_is, p)) continue;
            names.push_back(p.name->text);
            m_out.m_isAt.push_back(rangeOf(p));
            if (old) m_out.m_wasAt.push_back(rangeOf(*old));
        }
        for (const auto& [name, param] : before) {
            names.emplace_back(name);
            m_out.m_wasAt.push_back(rangeOf(*param));
        }
        return names;
    }

    void comparePair(const Part& was, const Part& is, const std::string& before, const std::string& after) {
        ++m_out.m_compared;
        PartChange change{before == after ? PartChange::What::Edited : PartChange::What::Renamed,
                          before,
                          after,
                          &was,
                          &is,
                          differences(was.assignments, is.assignments),
                          differences(was.params, is.params)};
        if (before != after || was.file != is.file) m_out.m_structure = true;
        if (before != after || !change.properties.empty() || !change.params.empty()) m_out.m_parts.push_back(std::move(change));
        Siblings inner, innerNow;
        for (const Part& part : was.parts) inner.push_back(&part);
        for (const Part& part : is.parts) innerNow.push_back(&part);
        const auto path = [](const std::string& above) {
            return [&above](const Part& part) { return pathInside(above, part.name); };
        };
        compareSiblings(inner, innerNow, path(before), path(after));
    }

    template <class Path, class PathNow>
    void compareSiblings(const Siblings& was, const Siblings& is, const Path& path, const PathNow& pathNow) {
        std::size_t head = 0, tail = 0;
        const std::size_t most = std::min(was.size(), is.size());
        while (head < most && isSame(*was[head], *is[head])) ++head;
        while (tail < most - head && isSame(*was[was.size() - 1 - tail], *is[is.size() - 1 - tail])) ++tail;
        if (head + tail == most && was.size() == is.size()) return;
        std::unordered_map<std::string, std::vector<std::size_t>> before; // by path and type: one name may be used twice
        const auto key = [](const std::string& at, const Part& part) { return at + " " + typeOf(part); };
        for (std::size_t i = was.size() - tail; i > head; --i) before[key(path(*was[i - 1]), *was[i - 1])].push_back(i - 1);
        std::vector<std::size_t> partner(is.size() - tail, was.size());
        std::vector<bool> isMatched(was.size(), false);
        for (std::size_t i = head; i < partner.size(); ++i) {
            const auto found = before.find(key(pathNow(*is[i]), *is[i]));
            if (found == before.end() || found->second.empty()) continue;
            partner[i] = found->second.back();
            found->second.pop_back();
            isMatched[partner[i]] = true;
        }
        for (std::size_t i = head; was.size() == is.size() && i < partner.size(); ++i) // renamed in place
            if (partner[i] == was.size() && !isMatched[i] && typeOf(*was[i]) == typeOf(*is[i]))
                partner[i] = i, isMatched[i] = true;
        std::size_t last = 0;
        for (std::size_t i = head; i < partner.size(); ++i) {
            if (partner[i] == was.size()) continue;
            if (partner[i] < last) m_out.m_structure = true; // moved
            last = partner[i];
        }
        for (std::size_t i = head; i < was.size() - tail; ++i)
            if (!isMatched[i]) add({PartChange::What::Removed, path(*was[i]), {}, was[i], nullptr, {}, {}});
        for (std::size_t i = head; i < partner.size(); ++i) {
            if (partner[i] == was.size()) add({PartChange::What::Added, {}, pathNow(*is[i]), nullptr, is[i], {}, {}});
            else if (const Part& other = *was[partner[i]]; !isSame(other, *is[i]))
                comparePair(other, *is[i], path(other), pathNow(*is[i]));
        }
    }

    void add(PartChange change) {
        m_out.m_structure = true;
        m_out.m_parts.push_back(std::move(change));
    }

    ChangeSet& m_out;
    const Outline& m_was;
    const Outline& m_is;
    mutable std::set<FileId> m_edited; ///< files that changed; filled on first use
};

ChangeSet::ChangeSet(std::shared_ptr<const LoadedProject> before, std::shared_ptr<const LoadedProject> after)
    : m_before(std::move(before)), m_after(std::move(after)) {
    m_everything = m_problems = !m_before || !m_after || m_before->paths != m_after->paths;
    if (m_everything) return;
    readSplices();
    PartComparison(*this).run();
    compareProblems();
}

ChangeSet ChangeSet::ofEverything(std::shared_ptr<const LoadedProject> before, std::shared_ptr<const LoadedProject> after) {
    ChangeSet all(nullptr, std::move(after));
    all.m_before = std::move(before);
    return all;
}

bool ChangeSet::isLocal() const {
    return !changesStructure() && m_settings.empty() && m_params.empty() &&
           std::ranges::all_of(m_parts, [](const PartChange& part) { return part.params.empty(); });
}

bool ChangeSet::isEdited(const Part& was) const {
    const auto isInside = [](const Part& part, const Part* wanted, const auto& self) -> bool {
        return &part == wanted || std::ranges::any_of(part.parts, [&](const Part& inner) { return self(inner, wanted, self); });
    };
    return m_everything || std::ranges::any_of(m_parts, [&](const PartChange& change) {
               return change.was && isInside(was, change.was, isInside);
           });
}

bool ChangeSet::changesObjects() const {
    const auto places = [](const PartChange& part) {
        const bool isPlaced = part.now && (part.now->is(Role::Instance) || part.now->is(Role::Layout));
        return isPlaced &&
               std::ranges::any_of(part.properties, [](const auto& key) { return key == "Config" || key == "Count"; });
    };
    return !isLocal() || std::ranges::any_of(m_parts, places);
}

void ChangeSet::readSplices() {
    m_splices.resize(m_after->trees.size());
    for (FileId file = 0; file < m_splices.size(); ++file) {
        const Tree &was = *m_before->trees[file], &is = *m_after->trees[file];
        if (&was == &is) continue;
        const std::string_view a = was.source().bytes(), b = is.source().bytes();
        const std::size_t most = std::min(a.size(), b.size());
        const auto head = std::size_t(std::mismatch(a.begin(), a.begin() + std::ptrdiff_t(most), b.begin()).first - a.begin());
        const std::size_t rest = most - head;
        const auto tail =
            std::size_t(std::mismatch(a.rbegin(), a.rbegin() + std::ptrdiff_t(rest), b.rbegin()).first - a.rbegin());
        Splice splice{std::uint32_t(head), std::uint32_t(a.size() - tail), std::uint32_t(b.size() - tail - head)};
        if (splice.begin == splice.end && splice.inserted == 0) continue;
        // Where braces do not match, an edit changes what text far from it means.
        if (hasErrors(was) || hasErrors(is)) splice = {0, std::uint32_t(a.size()), std::uint32_t(b.size())};
        m_splices[file] = splice;
        m_everything = m_everything || hasDirectiveIn(was.items(), splice.begin, splice.end) ||
                       hasDirectiveIn(is.items(), splice.begin, splice.begin + splice.inserted);
    }
}

std::optional<SourceRange> ChangeSet::nowAt(const SourceRange& before) const {
    if (!m_before || !m_after || m_before->paths != m_after->paths) return std::nullopt;
    if (!before.known() || before.file >= m_splices.size() || !m_splices[before.file]) return before;
    const Splice& splice = *m_splices[before.file];
    if (before.range.end < splice.begin) return before;
    if (before.range.begin <= splice.end) return std::nullopt;
    const auto moved = [&](std::uint32_t at) { return at - (splice.end - splice.begin) + splice.inserted; };
    return SourceRange{before.file, {moved(before.range.begin), moved(before.range.end)}};
}

/// Diagnostics are the same if they say the same about a place that has at most moved.
void ChangeSet::compareProblems() {
    using Key = std::tuple<FileId, std::uint32_t, std::uint32_t, int, int, std::string, std::vector<std::string>, std::size_t>;
    const auto key = [](const SourceRange& at, const Diagnostic& d) {
        return Key(at.file, at.range.begin, at.range.end, int(d.code), int(d.severity), d.message, d.suggestions,
                   d.notes.size() + d.fixes.size());
    };
    const auto isIn = [](const std::vector<SourceRange>& all, const SourceRange& range) {
        return std::ranges::any_of(all, [&](const SourceRange& value) {
            return value.file == range.file && value.range.begin <= range.range.begin && range.range.end <= value.range.end;
        });
    };
    std::multiset<Key> known;
    for (const Diagnostic& d : m_before->diagnostics.all()) {
        const auto now = isIn(m_wasAt, d.range) ? std::nullopt : nowAt(d.range);
        if (now) known.insert(key(*now, d));
        else m_problems = true;
    }
    std::vector<const Diagnostic*> caused;
    for (const Diagnostic& d : m_after->diagnostics.all()) {
        if (const auto same = known.find(key(d.range, d)); same != known.end()) known.erase(same);
        else m_problems = true;
        if (d.severity != Severity::Error) continue;
        if (isIn(m_isAt, d.range)) m_valueErrors.push_back(&d);
        else if (std::ranges::any_of(d.notes, [&](const auto& note) { return isIn(m_isAt, note.second); })) caused.push_back(&d);
    }
    m_valueErrors.insert(m_valueErrors.end(), caused.begin(), caused.end());
    m_problems |= !known.empty();
}

} // namespace trundle
