#include "project/edits/obsolete_import.h"

#include <algorithm>
#include <set>

#include "project/edits/edit_target.h"
#include "project/edits/plan_targets.h"
#include "project/objects/name_references.h"

namespace trundle {

namespace {

bool hasProblems(const LoadedProject& loaded, const Part& config) {
    return std::ranges::any_of(loaded.diagnostics.all(), [&](const Diagnostic& d) {
        return d.severity != Severity::Hint && d.range.known() && isWithin(d.range, config.range);
    });
}

/// Follows the imports of a project, all but one.
class ImportedFiles {
public:
    ImportedFiles(const TextSet& texts, const ImportItem* without) : m_texts(texts), m_without(without) { visit(0); }

    [[nodiscard]] bool has(FileId file) const { return m_files.contains(file); }

private:
    void visit(FileId file) {
        if (m_files.insert(file).second) visit(m_texts.trees[file]->items());
    }
    void visit(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) visit(block->items);
            const auto* import = item.as<ImportItem>();
            if (!import || import == m_without) continue;
            if (const auto found = m_texts.imports.find(import); found != m_texts.imports.end()) visit(found->second);
        }
    }

    const TextSet& m_texts;
    const ImportItem* m_without;
    std::set<FileId> m_files;
};

/// Whether a file changes an experiment that refers to nothing in it: it has settings, modules or objects of the world.
bool actsByItself(const LoadedProject& loaded, FileId file) {
    const auto& items = loaded.trees[file]->items();
    const bool isSetting =
        std::ranges::any_of(items, [](const Item& item) { return item.as<AssignmentItem>() || item.as<ModuleItem>(); });
    return isSetting || std::ranges::any_of(loaded.outline->world.all(), [&](const Part* part) { return part->file == file; });
}

/// The file of the definition that a reference leads to; kNoFile if that is in no block or Param of the top level.
FileId fileOfTarget(const LoadedProject& loaded, const NameReference& reference) {
    for (const auto& part : loaded.outline->parts)
        if (reference.target && part->block == reference.target) return part->file;
    for (const SourceParam& param : loaded.outline->params)
        if (reference.param && &reference.param->name == param.name) return param.file;
    return kNoFile;
}

/// Those of the files that `remaining` lacks which the project uses, with a copy in place of the config.
std::set<FileId> filesInUse(const LoadedProject& loaded, const Part& config, const std::vector<const Part*>& copied,
                            const ImportedFiles& remaining) {
    std::set<FileId> used;
    for (FileId file = 0; file < loaded.trees.size(); ++file)
        if (!loaded.outline->texts().commandLine(file) && !remaining.has(file) && actsByItself(loaded, file)) used.insert(file);
    for (const NameReference& reference : referencesIn(loaded)) {
        const bool isMoved = reference.target == config.block && reference.property == "Config" &&
                             std::ranges::find(copied, reference.user) != copied.end();
        const FileId from = reference.name.known() ? reference.name.file : reference.user ? reference.user->file : 0;
        if (isMoved || !remaining.has(from)) continue;
        const FileId to = fileOfTarget(loaded, reference);
        if (to != kNoFile && !remaining.has(to)) used.insert(to);
    }
    return used;
}

} // namespace

std::optional<ObsoleteImport> obsoleteImport(const LoadedProject& loaded, const Part& config,
                                             const std::vector<const Part*>& copied, FileId home) {
    const auto isCopied = [&](const Part* instance) { return std::ranges::find(copied, instance) != copied.end(); };
    if (!isShippedFile(loaded, config.file) || !hasProblems(loaded, config) ||
        !std::ranges::all_of(instancesOf(loaded, config), isCopied))
        return std::nullopt;
    return unusedImport(loaded, config, copied, home);
}

std::optional<ObsoleteImport> unusedImport(const LoadedProject& loaded, const Part& definition,
                                           const std::vector<const Part*>& copied, FileId home) {
    const TextSet& texts = loaded.outline->texts();
    for (const Item& item : loaded.trees[home]->items()) {
        const auto* import = item.as<ImportItem>();
        const auto found = import ? texts.imports.find(import) : texts.imports.end();
        if (found == texts.imports.end() || found->second != definition.file) continue;
        const ImportedFiles remaining(texts, import);
        const std::set<FileId> used = filesInUse(loaded, definition, copied, remaining);
        if (remaining.has(definition.file) || used.contains(definition.file)) return std::nullopt;
        ObsoleteImport obsolete{import, {home, item.range}, {}};
        for (const FileId file : used) obsolete.needed.push_back(loaded.paths[file]);
        return obsolete;
    }
    return std::nullopt;
}

} // namespace trundle
