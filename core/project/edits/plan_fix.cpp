// needs        a fix, the texts that it was made for, and texts in which some configs have copies
// assumptions  a copy has the tokens of its config in the same order; only its name, file paths and indentation differ
// method       an offset is mapped by the index of its token; a fix whose replaced tokens differ in the copy is refused

#include <algorithm>
#include <string>

#include "project/edits/edit_target.h"
#include "project/edits/plan_targets.h"

namespace trundle {

namespace {

const Part* configAround(const LoadedProject& loaded, const SourceRange& range) {
    for (const Part* config : loaded.outline->configs.all())
        if (isWithin(range, config->range)) return config;
    return nullptr;
}

/// The tokens of a block except spaces, whose number depends on the indentation.
std::vector<Token> tokensOf(const Tree& tree, const TextRange& block) {
    std::vector<Token> tokens;
    for (const Token& token : tree.tokens())
        if (token.kind != TokenKind::Space && block.begin <= token.range.begin && token.range.end <= block.end)
            tokens.push_back(token);
    return tokens;
}

class BlockMapping {
public:
    BlockMapping(const LoadedProject& from, const Part& block, const LoadedProject& to, const Part& copy)
        : m_fromTree(*from.trees[block.file]), m_toTree(*to.trees[copy.file]), m_file(copy.file),
          m_from(tokensOf(m_fromTree, block.range.range)), m_to(tokensOf(m_toTree, copy.range.range)) {}

    [[nodiscard]] Result<TextEdit> map(const TextEdit& edit) const {
        const TextRange range{offset(edit.range.range.begin), offset(edit.range.range.end)};
        const auto textOf = [](const Tree& tree, TextRange r) {
            std::string text(tree.source().slice(r));
            std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
            return text;
        };
        if (m_from.size() != m_to.size() || range.end < range.begin ||
            textOf(m_fromTree, edit.range.range) != textOf(m_toTree, range))
            return Error{Code::EditRefused, "this fix does not fit the copy; edit the copy as text"};
        return TextEdit{{m_file, range}, edit.text};
    }

private:
    [[nodiscard]] std::uint32_t offset(std::uint32_t at) const {
        const auto after = std::ranges::upper_bound(m_from, at, {}, [](const Token& token) { return token.range.begin; });
        if (after == m_from.begin()) return m_to.empty() ? 0 : m_to.front().range.begin;
        const auto index = static_cast<std::size_t>(after - m_from.begin()) - 1;
        if (index >= m_to.size()) return 0; // refused by map()
        const std::uint32_t next = index + 1 < m_to.size() ? m_to[index + 1].range.begin : m_to[index].range.end;
        return std::min(m_to[index].range.begin + (at - m_from[index].range.begin), next);
    }

    const Tree& m_fromTree;
    const Tree& m_toTree;
    FileId m_file;
    std::vector<Token> m_from, m_to;
};

} // namespace

Result<EditPlan> planFix(const LoadedProject& found, const Fix& fix, const LoadedProject& loaded,
                         const std::function<std::string(const std::string&)>& renamed) {
    EditPlan plan;
    for (const TextEdit& edit : fix.edits) {
        const Part* config = configAround(found, edit.range);
        const std::string path = config ? config->kind->name + "." + config->name : std::string(),
                          copyPath = config ? renamed(path) : path;
        if (copyPath == path) {
            if (edit.range.file >= loaded.trees.size() || found.trees[edit.range.file] != loaded.trees[edit.range.file])
                return Error{Code::EditRefused, "this fix changes other texts than the copy; edit them as text"};
            plan.edits[edit.range.file].push_back(edit);
            continue;
        }
        const auto copy = placeOf(loaded, copyPath);
        if (!copy || !copy->part) return Error{Code::NoSuchPath, "there is no " + copyPath};
        Result<TextEdit> mapped = BlockMapping(found, *config, loaded, *copy->part).map(edit);
        if (!mapped) return mapped.error();
        plan.edits[mapped.value().range.file].push_back(std::move(mapped).value());
        plan.selects = {copyPath};
    }
    return plan;
}

std::vector<const Fix*> applicableFixes(const LoadedProject& loaded, const Diagnostic& diagnostic) {
    const auto canChange = [&](const TextEdit& edit) {
        return !isShippedFile(loaded, edit.range.file) || configAround(loaded, edit.range) != nullptr; // a config is copied
    };
    std::vector<const Fix*> fixes;
    for (const Fix& fix : diagnostic.fixes)
        if (std::ranges::all_of(fix.edits, canChange)) fixes.push_back(&fix);
    return fixes;
}

} // namespace trundle
