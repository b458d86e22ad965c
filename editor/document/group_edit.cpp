#include "editor/document/group_edit.h"

#include "editor/document/document.h"
#include "project/edits/plan_group.h"

namespace trundle {

// The new file comes first, so that the import resolves.
Status applyGroup(Document& document, const QString& name, const GroupPlan& group) {
    const std::string key = "group " + std::to_string(document.revision());
    if (Status created = document.edits().replaceText(name, group.file, group.text, key); !created) return created;
    const Status done = document.edits().apply(name, group.plan, key);
    if (!done) document.edits().discardMerge(key);
    document.edits().endMerge();
    return done;
}

} // namespace trundle
