// For arbitrary bytes: parsing terminates, printing reproduces them, tokens cover them, formatting is idempotent, edits change only
// their ranges, and resolving reports every error.

#include "base/rng.h"
#include "fuzz/targets.h"
#include "lang/diagnostic_text.h"
#include "lang/formatter.h"
#include "lang/tree_edit.h"

namespace trundle::fuzz {
namespace {

std::shared_ptr<const Tree> parsed(std::string text) {
    return parse(std::make_shared<const SourceText>("fuzz.sim", std::move(text)), 0);
}

void collect(const std::vector<Item>& items, std::vector<const Item*>& all) {
    for (const Item& item : items) {
        all.push_back(&item);
        if (const auto* block = item.as<BlockItem>()) collect(block->items, all);
    }
}

bool hasErrors(const Tree& tree) {
    for (const Diagnostic& d : tree.diagnostics())
        if (d.severity == Severity::Error) return true;
    return false;
}

void checkTokens(const Tree& tree, const std::string& text) {
    require(print(tree) == text);
    std::uint32_t end = 0;
    for (const Token& token : tree.tokens()) {
        require(token.range.begin == end && token.range.end >= end);
        end = token.range.end;
    }
    require(end == text.size());
}

void checkDiagnostics(const Tree& tree) {
    SourceTable table;
    table.add(tree.sharedSource());
    for (const Diagnostic& d : tree.diagnostics()) {
        require(d.range.range.begin <= d.range.range.end && d.range.range.end <= tree.source().bytes().size());
        require(!render(d, table).empty());
        for (const Fix& fix : d.fixes) require(applyEdits(tree, fix.edits).ok());
    }
}

void checkFormat(const Tree& tree) {
    const std::string once = format(tree);
    const auto again = parsed(once);
    require(format(*again) == once);
    require(hasErrors(tree) == hasErrors(*again));
}

/// Applies a few edits chosen by `seed`. An edit of a valid text leaves a valid text.
void checkEdits(std::shared_ptr<const Tree> tree, std::uint64_t seed) {
    for (std::uint64_t step = 0; step < 6; ++step) {
        std::vector<const Item*> items;
        collect(tree->items(), items);
        const Item* item = items.empty() ? nullptr : items[randomBits(seed, 1, step, 0) % items.size()];
        const BlockItem* block = item ? item->as<BlockItem>() : nullptr;
        const AssignmentItem* assignment = item ? item->as<AssignmentItem>() : nullptr;
        TextEdit edit;
        switch (randomBits(seed, 2, step, 0) % 4) {
        case 0:
            if (!assignment) continue;
            edit = editSetValue(*tree, assignment->value, "1, 2 cm");
            break;
        case 1: edit = editAddAssignment(*tree, block, "Key", "3"); break;
        case 2: edit = editAddItem(*tree, block, "Box b {\n  X=1 // x\n}\n"); break;
        default:
            if (!item) continue;
            edit = editRemoveItem(*tree, *item);
            break;
        }
        const auto next = applyEdits(*tree, std::span(&edit, 1));
        require(next.ok());
        if (!hasErrors(*tree) && tree->items().size() < 1000) require(!hasErrors(*next.value()));
        tree = next.value();
    }
}

} // namespace

void tryText(std::span<const std::uint8_t> bytes) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto tree = parsed(text);
    checkTokens(*tree, text);
    checkDiagnostics(*tree);
    checkFormat(*tree);
    checkEdits(tree, fnv1a64(text));
    const auto loaded = open(bytes);
    for (const Diagnostic& d : loaded->diagnostics.all()) require(!render(d, loaded->sources).empty());
}

} // namespace trundle::fuzz
