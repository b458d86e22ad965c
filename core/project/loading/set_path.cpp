#include "project/loading/set_path.h"

#include <algorithm>

#include "lang/edit_style.h"
#include "lang/tree_edit.h"

namespace trundle {

namespace {

/// Adds an edit; insertions at the same position are combined in order.
void addEdit(std::vector<TextEdit>& edits, TextEdit edit) {
    for (TextEdit& other : edits) {
        if (other.range == edit.range && other.range.range.size() == 0) {
            other.text += edit.text;
            return;
        }
    }
    edits.push_back(std::move(edit));
}

/// Where a joint is and along what comes before its stops.
std::optional<TextEdit> beforeStops(const Tree& tree, const SetTarget& target, const std::string& text) {
    if (!target.part || !target.part->is(Role::Joint) || (target.key != "Anchor" && target.key != "Axis")) return std::nullopt;
    for (const Item& item : target.part->block->items) {
        const auto* stop = item.as<AssignmentItem>();
        if (!stop || stop->path.size() != 1 || stop->path[0].text.find("Stop") == std::string::npos) continue;
        const SourceText& source = tree.source();
        const std::string equals(source.slice({stop->path[0].range.end, stop->value.range.begin}));
        const std::string_view before = source.bytes().substr(0, item.range.begin);
        const std::string_view indent = before.substr(before.find_last_of('\n') + 1);
        const bool beginsLine = indent.find_first_not_of(" \t") == std::string_view::npos;
        const std::string behind = beginsLine ? editStyle(tree).lineEnd + std::string(indent) : " ";
        return TextEdit{{tree.file(), {item.range.begin, item.range.begin}}, target.key + equals + text + behind};
    }
    return std::nullopt;
}

} // namespace

std::map<FileId, std::vector<TextEdit>> editsForTargets(const LoadedProject& loaded, const std::vector<SetTarget>& sets,
                                                        const std::function<std::string_view(const SourceRange& value)>& textOf) {
    const TextSet& texts = loaded.outline->texts();
    std::vector<SetTarget> targets;
    for (const SetTarget& set : sets) { // a later set of the same path replaces an earlier one
        const auto same = std::find_if(targets.begin(), targets.end(),
                                       [&](const SetTarget& t) { return t.part == set.part && t.key == set.key; });
        if (same == targets.end()) targets.push_back(set);
        else same->value = set.value;
    }
    std::map<FileId, std::vector<TextEdit>> edits;
    for (const SetTarget& t : targets) {
        const std::string text(textOf(t.value));
        if (t.before.known()) {
            if (texts.slice(t.before) != text)
                addEdit(edits[t.before.file], editSetValue(*loaded.trees[t.before.file], t.before.range, text));
            continue;
        }
        const FileId file = t.part ? t.part->file : FileId{0};
        const Tree& tree = *loaded.trees[file];
        const BlockItem* block = t.part ? t.part->block : nullptr;
        if (auto edit = beforeStops(tree, t, text)) {
            addEdit(edits[file], std::move(*edit));
            continue;
        }
        constexpr std::string_view kParam = "Param "; // it is declared with its value
        addEdit(edits[file], block && t.key.starts_with(kParam) ? editAddParam(tree, *block, t.key.substr(kParam.size()), text)
                                                                : editAddAssignment(tree, block, t.key, text));
    }
    std::erase_if(edits, [](const auto& entry) { return entry.second.empty(); });
    return edits;
}

std::map<FileId, std::vector<TextEdit>> editsForSets(const LoadedProject& loaded) {
    return editsForTargets(loaded, loaded.sets, [&](const SourceRange& value) { return loaded.outline->texts().slice(value); });
}

bool setsFailed(const LoadedProject& loaded) {
    const std::vector<Diagnostic>& all = loaded.diagnostics.all();
    return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
        return d.severity == Severity::Error && loaded.outline->texts().commandLine(d.range.file);
    });
}

} // namespace trundle
