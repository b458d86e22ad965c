#include "editor/document/project_rename.h"

#include <algorithm>
#include <set>

#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "lang/tree_edit.h"
#include "project/edits/edit_target.h"
#include "project/edits/plans.h"

namespace trundle {

namespace {

/// Edits of one loaded project, grouped by the path of the file.
std::map<std::string, std::vector<TextEdit>> byPath(const LoadedProject& loaded, const FileEdits& edits) {
    std::map<std::string, std::vector<TextEdit>> all;
    for (const auto& [file, changes] : edits)
        if (file < loaded.paths.size()) all[loaded.paths[file]] = changes;
    return all;
}

bool isLoaded(const LoadedProject& loaded, const std::string& file) {
    return std::ranges::find(loaded.paths, file) != loaded.paths.end();
}

/// Whether two plans change the same characters of one file: then they rename the same object.
bool sharePlace(const std::map<std::string, std::vector<TextEdit>>& a, const std::map<std::string, std::vector<TextEdit>>& b) {
    return std::ranges::any_of(a, [&](const auto& own) {
        const auto theirs = b.find(own.first);
        return theirs != b.end() && std::ranges::any_of(own.second, [&](const TextEdit& x) {
                   return std::ranges::any_of(theirs->second, [&](const TextEdit& y) { return x.range.range == y.range.range; });
               });
    });
}

} // namespace

ProjectRename::ProjectRename(Document& document, std::string path, const std::string& oldName)
    : m_document(document), m_path(std::move(path)) {
    if (document.isNew()) return;
    const std::string probe = oldName + "_"; // any other name works: the plan only finds the references
    const LoadedProject& loaded = *document.loaded();
    const Result<EditPlan> own = planRename(loaded, m_path, probe);
    if (!own) return;
    if (std::ranges::any_of(own.value().edits, [&](const auto& edit) { return isShippedFile(loaded, edit.first); })) return;
    std::set<std::string> changed;
    for (const auto& [file, edits] : byPath(loaded, own.value().edits)) changed.insert(file);
    ConfigUsers users;
    std::map<std::string, std::size_t> counts;
    for (const std::string& file : users.dependentsOutside(loaded, changed)) {
        if (m_others.size() == kMaxTexts) {
            m_complete = false;
            break;
        }
        const Result<std::shared_ptr<const LoadedProject>> other = document.loading().from(file);
        const Result<FilePlans> plan = other ? planOutside(*other.value(), probe) : Result<FilePlans>(other.error());
        if (!plan || plan.value().empty()) continue;
        m_others.push_back(other.value());
        for (const auto& [path, edits] : plan.value()) counts[path] = std::max(counts[path], edits.size());
    }
    for (const auto& [file, count] : counts) m_uses.push_back({file, count});
}

/// Plans the rename in texts that the document has not loaded; no edits if the path means another object there.
Result<ProjectRename::FilePlans> ProjectRename::planOutside(const LoadedProject& other, const std::string& name) const {
    const LoadedProject& loaded = *m_document.loaded();
    const Result<EditPlan> own = planRename(loaded, m_path, name), theirs = planRename(other, m_path, name);
    if (!own) return own.error();
    if (!theirs) return theirs.error();
    FilePlans plans = byPath(other, theirs.value().edits);
    if (!sharePlace(byPath(loaded, own.value().edits), plans)) return FilePlans{};
    std::erase_if(plans, [&](const auto& plan) { return isLoaded(loaded, plan.first); });
    return plans;
}

Status ProjectRename::apply(const QString& title, const std::string& name, bool everywhere) {
    const LoadedProject& loaded = *m_document.loaded();
    const Result<EditPlan> own = planRename(loaded, m_path, name);
    if (!own || !everywhere || m_others.empty()) return m_document.edits().apply(title, own);
    FilePlans all = byPath(loaded, own.value().edits);
    for (const auto& other : m_others) {
        const Result<FilePlans> plan = planOutside(*other, name);
        if (!plan)
            return m_document.edits().apply(
                title, Error{plan.error().code, m_document.texts().shown(other->paths[0]) + ": " + plan.error().message});
        for (const auto& [file, edits] : plan.value())
            for (const TextEdit& edit : edits)
                if (std::ranges::none_of(all[file], [&](const TextEdit& e) { return e.range.range == edit.range.range; }))
                    all[file].push_back(edit);
    }
    FileTexts texts;
    for (const auto& [file, edits] : all) {
        if (Status added = m_document.edits().addText(file); !added) return m_document.edits().apply(title, added.error());
        Result<std::string> bytes = applyEdits(*m_document.texts().text(file), edits);
        if (!bytes) return m_document.edits().apply(title, bytes.error());
        texts.emplace(file, std::make_shared<const std::string>(std::move(bytes).value()));
    }
    return m_document.edits().replaceTexts(title, texts, own.value().selects);
}

} // namespace trundle
