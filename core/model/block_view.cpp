#include "model/block_view.h"

#include <algorithm>
#include <utility>

#include "model/literals.h"

namespace trundle {

namespace {

constexpr std::size_t kLinear = 12; ///< up to this length a linear search is fastest
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::string joined(std::span<const Name> path) {
    std::string key = path.front().text;
    for (const Name& name : path.subspan(1)) key += "." + name.text;
    return key;
}

class Expander {
public:
    Expander(const TextSet& texts, Diagnostics& diagnostics) : m_texts(texts), m_diagnostics(diagnostics) {}

    BlockView expand(const std::vector<Item>& items, FileId file) {
        m_visited.insert(file);
        m_view.assignments = collect(items, file);
        for (const auto& [before, later] : m_disagreements) warnOf(before, later);
        return std::move(m_view);
    }

private:
    /// Adds the blocks and params of `items` to the view in order; returns the assignments that apply to these items.
    AssignmentList collect(const std::vector<Item>& items, FileId file) {
        AssignmentList own, imported;
        const auto known = static_cast<std::ptrdiff_t>(m_disagreements.size());
        reportImportedTwice(items, file);
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) m_view.blocks.push_back({&item, block, file});
            else if (const auto* assignment = item.as<AssignmentItem>()) addOwn(own, *assignment, file);
            else if (const auto* param = item.as<ParamItem>()) addParam(*param, file);
            else if (const auto* import = item.as<ImportItem>()) addImport(imported, *import);
        }
        const auto isDecided = [&](const auto& both) { return own.find(both.second.key) != nullptr; };
        m_disagreements.erase(std::remove_if(m_disagreements.begin() + known, m_disagreements.end(), isDecided),
                              m_disagreements.end());
        for (const SourceAssignment& a : imported.all()) {
            if (!own.find(a.key)) own.add(a);
        }
        return own;
    }

    void addOwn(AssignmentList& own, const AssignmentItem& item, FileId file) {
        if (item.path.empty()) return;
        SourceAssignment a{joined(item.path), item.path, &item.value, file, &item};
        if (const SourceAssignment* first = own.find(a.key)) {
            Diagnostic& d = m_diagnostics.error(Code::DuplicateKey, a.keyRange(), a.key + " is set twice in one block");
            d.notes.push_back({"first set here", first->keyRange()});
            return;
        }
        own.add(std::move(a));
    }

    void addParam(const ParamItem& item, FileId file) {
        const auto [it, fresh] = m_params.try_emplace(item.name.text, m_view.params.size());
        if (!fresh) {
            const SourceParam& first = m_view.params[it->second];
            Diagnostic& d = m_diagnostics.error(Code::DuplicateName, {file, item.name.range},
                                                "Param " + item.name.text + " is defined twice");
            d.notes.push_back({"first defined here", first.nameRange()});
            return;
        }
        m_view.params.push_back({&item.name, &item.value, file, file, &item, false, descriptionOf(item, file, m_diagnostics)});
    }

    /// A second import of a file in one block has no effect.
    void reportImportedTwice(const std::vector<Item>& items, FileId file) {
        std::unordered_map<FileId, const ImportItem*> first;
        for (const Item& item : items) {
            const auto* import = item.as<ImportItem>();
            const auto target = import ? m_texts.imports.find(import) : m_texts.imports.end();
            if (target == m_texts.imports.end()) continue;
            const auto [at, isNew] = first.emplace(target->second, import);
            if (isNew) continue;
            Diagnostic& d = m_diagnostics.warning(Code::ImportedTwice, {file, import->pathRange},
                                                  import->path + " is imported twice in one block; once is enough");
            d.notes.push_back({"first imported here", {file, at->second->pathRange}});
            d.fixes.push_back({"remove it", {{{file, withLineEnd(item.range, file)}, ""}}});
        }
    }

    TextRange withLineEnd(TextRange range, FileId file) const {
        const std::string_view bytes = m_texts.trees[file]->source().bytes();
        if (bytes.substr(range.end, 2) == "\r\n") return {range.begin, range.end + 2};
        return bytes.substr(range.end, 1) == "\n" ? TextRange{range.begin, range.end + 1} : range;
    }

    void addImport(AssignmentList& imported, const ImportItem& item) {
        const auto target = m_texts.imports.find(&item);
        if (target == m_texts.imports.end() || !m_visited.insert(target->second).second) return;
        m_view.imported.push_back(target->second);
        const AssignmentList theirs = collect(m_texts.trees[target->second]->items(), target->second);
        for (const SourceAssignment& a : theirs.all()) {
            if (const SourceAssignment* before = imported.find(a.key); before && !isSame(*before, a))
                m_disagreements.emplace_back(*before, a);
            imported.replace(a);
        }
    }

    /// Written alike, or equal: 10 ms and 0.01.
    bool isSame(const SourceAssignment& before, const SourceAssignment& later) const {
        if (m_texts.slice(before.valueRange()) == m_texts.slice(later.valueRange())) return true;
        const auto isLiteral = [](const Element& e) {
            return e.kind != Element::Kind::ParamRef && e.kind != Element::Kind::Expression;
        };
        return std::ranges::equal(before.value->elements, later.value->elements, [&](const Element& a, const Element& b) {
            return isLiteral(a) && isLiteral(b) && areEqual(literalOf(a, before.file), literalOf(b, later.file));
        });
    }

    void warnOf(const SourceAssignment& before, const SourceAssignment& later) {
        const std::string_view a = m_texts.slice(before.valueRange()), b = m_texts.slice(later.valueRange());
        Diagnostic& d = m_diagnostics.warning(Code::ImportDisagrees, later.valueRange(),
                                              "imported files disagree: " + later.key + " is " + std::string(a.substr(0, 40)) +
                                                  " in " + m_texts.trees[before.file]->source().path() + " and " +
                                                  std::string(b.substr(0, 40)) + " here; the later one holds");
        d.notes.push_back({"the other one", before.valueRange()});
    }

    const TextSet& m_texts;
    Diagnostics& m_diagnostics;
    BlockView m_view;
    std::unordered_set<FileId> m_visited;
    std::unordered_map<std::string_view, std::size_t> m_params;
    std::vector<std::pair<SourceAssignment, SourceAssignment>> m_disagreements; ///< of imported files, the later one second
};

/// Counts the blocks of an expansion without storing it. Imports are limited too, so that empty files cannot make it slow.
class Counter {
public:
    Counter(const TextSet& texts, std::size_t limit) : m_texts(texts), m_limit(limit) {}

    std::size_t count() {
        std::unordered_set<FileId> visited{0};
        walk(m_texts.trees[0]->items(), visited);
        return m_blocks;
    }

private:
    void walk(const std::vector<Item>& items, std::unordered_set<FileId>& visited) {
        for (const Item& item : items) {
            if (m_blocks > m_limit || m_imports > m_limit * 4) break;
            if (const auto* block = item.as<BlockItem>()) {
                ++m_blocks;
                std::unordered_set<FileId> inner;
                walk(block->items, inner);
            } else if (const auto* import = item.as<ImportItem>()) {
                ++m_imports;
                const auto target = m_texts.imports.find(import);
                if (target != m_texts.imports.end() && visited.insert(target->second).second) {
                    walk(m_texts.trees[target->second]->items(), visited);
                }
            }
        }
        if (m_imports > m_limit * 4) m_blocks = m_limit + 1;
    }

    const TextSet& m_texts;
    std::size_t m_limit, m_blocks = 0, m_imports = 0;
};

} // namespace

std::size_t AssignmentList::place(std::string_view key) const {
    if (m_all.size() > kLinear) {
        const auto it = m_index.find(std::string(key));
        return it == m_index.end() ? kNone : it->second;
    }
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        if (m_all[i].key == key) return i;
    }
    return kNone;
}

const SourceAssignment* AssignmentList::find(std::string_view key) const {
    const std::size_t i = place(key);
    return i == kNone ? nullptr : &m_all[i];
}

void AssignmentList::add(SourceAssignment assignment) {
    m_all.push_back(std::move(assignment));
    if (m_all.size() == kLinear + 1) {
        for (std::size_t i = 0; i < m_all.size(); ++i) m_index.emplace(m_all[i].key, i);
    } else if (m_all.size() > kLinear) {
        m_index.emplace(m_all.back().key, m_all.size() - 1);
    }
}

void AssignmentList::replace(SourceAssignment assignment) {
    const std::size_t i = place(assignment.key);
    if (i == kNone) add(std::move(assignment));
    else m_all[i] = std::move(assignment);
}

BlockView viewOf(const TextSet& texts, const std::vector<Item>& items, FileId file, Diagnostics& diagnostics) {
    return Expander(texts, diagnostics).expand(items, file);
}

std::size_t countBlocks(const TextSet& texts, std::size_t limit) { return Counter(texts, limit).count(); }

} // namespace trundle
