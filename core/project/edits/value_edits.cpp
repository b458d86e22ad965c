#include "project/edits/value_edits.h"

#include "project/loading/members.h"
#include "project/loading/set_path.h"
#include "project/objects/object_names.h"

namespace trundle {

Result<FileEdits> editsForValues(const LoadedProject& loaded, const std::vector<ValueEdit>& values) {
    std::vector<AssignmentItem> items(values.size());
    std::vector<SetText> sets; // the index of the value takes the place of a FileId
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i].value.status()) return values[i].value.status().error();
        if (values[i].path.empty()) return Error{Code::NoSuchPath, "the name of a property is missing"};
        for (const std::string& word : values[i].path.words()) {
            if (const Status legal = legalName(word); !legal) return legal.error();
            items[i].path.push_back({word, {}});
        }
        items[i].value = values[i].value.value();
        sets.push_back({static_cast<FileId>(i), &items[i]});
    }
    Diagnostics diagnostics;
    const AppliedSets applied = targetsOfSets(*loaded.outline, sets, diagnostics);
    for (const MemberPath& member : applied.members)
        reportReplaceBySingles(member, *loaded.outline, *loaded.experiment, diagnostics);
    for (const Diagnostic& d : diagnostics.all())
        if (d.severity == Severity::Error) return Error{d.code, d.message};
    return editsForTargets(loaded, applied.targets,
                           [&](const SourceRange& value) -> std::string_view { return values[value.file].value.text(); });
}

} // namespace trundle
