#include "project/set_path.h"

#include <algorithm>

#include "lang/tree_edit.h"

namespace trundle {

namespace {

/// Two additions to one block begin at the same place: one edit, the texts in their order.
void addEdit(std::vector<TextEdit>& edits, TextEdit edit) {
    for (TextEdit& other : edits) {
        if (other.range == edit.range && other.range.range.size() == 0) {
            other.text += edit.text;
            return;
        }
    }
    edits.push_back(std::move(edit));
}

} // namespace

std::map<FileId, std::vector<TextEdit>> editsForSets(const Loaded& loaded) {
    const TextSet& texts = loaded.outline->texts();
    std::vector<SetTarget> targets;
    for (const SetTarget& set : loaded.sets) { // a later one of the same path takes the place of the earlier
        const auto same = std::find_if(targets.begin(), targets.end(),
                                       [&](const SetTarget& t) { return t.part == set.part && t.key == set.key; });
        if (same == targets.end()) targets.push_back(set);
        else same->value = set.value;
    }
    std::map<FileId, std::vector<TextEdit>> edits;
    for (const SetTarget& t : targets) {
        const std::string text(texts.slice(t.value));
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

bool setsFailed(const Loaded& loaded) {
    const std::vector<Diagnostic>& all = loaded.diagnostics.all();
    return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
        return d.severity == Severity::Error && loaded.outline->texts().commandLine(d.range.file);
    });
}

} // namespace trundle
