#include "project/loading/set_path.h"

#include <algorithm>

#include "lang/tree_edit.h"
#include "project/loading/loader.h"
#include "project/loading/members.h"

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

/// `valueOf` returns the text of a new value.
template <class ValueOf>
std::map<FileId, std::vector<TextEdit>> editsFor(const LoadedProject& loaded, const std::vector<SetTarget>& sets,
                                                 ValueOf valueOf) {
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
        const std::string text(valueOf(t.value));
        if (t.before.known()) {
            if (texts.slice(t.before) != text) addEdit(edits[t.before.file], {t.before, text});
            continue;
        }
        const FileId file = t.part ? t.part->file : FileId{0};
        addEdit(edits[file], editAddAssignment(*loaded.trees[file], t.part ? t.part->block : nullptr, t.key, text));
    }
    std::erase_if(edits, [](const auto& entry) { return entry.second.empty(); });
    return edits;
}

} // namespace

std::map<FileId, std::vector<TextEdit>> editsForSets(const LoadedProject& loaded) {
    return editsFor(loaded, loaded.sets, [&](const SourceRange& value) { return loaded.outline->texts().slice(value); });
}

Result<std::map<FileId, std::vector<TextEdit>>> editsForSets(const LoadedProject& loaded, const std::vector<std::string>& sets) {
    const auto first = static_cast<FileId>(loaded.trees.size()); // after the FileIds in use
    std::vector<std::shared_ptr<const Tree>> trees;
    std::vector<SetText> texts;
    Diagnostics diagnostics;
    for (const std::string& set : sets) {
        const auto file = static_cast<FileId>(first + trees.size());
        trees.push_back(parse(std::make_shared<const SourceText>("--set", set), file));
        diagnostics.append(trees.back()->diagnostics());
        texts.push_back({file, assignmentOf(*trees.back(), diagnostics)});
    }
    const AppliedSets applied = targetsOfSets(*loaded.outline, texts, diagnostics);
    for (const MemberPath& member : applied.members)
        reportReplaceBySingles(member, *loaded.outline, *loaded.experiment, diagnostics);
    for (const Diagnostic& d : diagnostics.all())
        if (d.severity == Severity::Error) return Error{d.code, d.message};
    return editsFor(loaded, applied.targets,
                    [&](const SourceRange& value) { return trees[value.file - first]->source().slice(value.range); });
}

bool setsFailed(const LoadedProject& loaded) {
    const std::vector<Diagnostic>& all = loaded.diagnostics.all();
    return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
        return d.severity == Severity::Error && loaded.outline->texts().commandLine(d.range.file);
    });
}

} // namespace trundle
