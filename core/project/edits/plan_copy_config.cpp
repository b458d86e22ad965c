// needs        a config and the instances that are to use a copy of it, or a material, surface, antenna pattern or Param
// assumptions  names in the config resolve wherever the copy is; only file paths are relative to the folder of the file
// method       the block's text, with its name and file paths changed, is inserted before the first instance, and the Config of
//             each instance is set; of another definition before the first block, and the references to it are changed. The import of a
//             shipped config with problems is removed if nothing else in its file is used
// data         edits of the block have offsets relative to its first byte

#include <algorithm>
#include <filesystem>
#include <set>

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "project/edits/edit_builder.h"
#include "project/edits/edit_target.h"
#include "project/edits/obsolete_import.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/loading/search.h"
#include "project/objects/object_names.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;

/// The first block of the opened file; nullptr if it has no blocks.
const Part* firstBlock(const LoadedProject& loaded) {
    const Part* first = nullptr;
    for (const auto& part : loaded.outline->parts)
        if (part->file == 0 && (!first || part->range.range.begin < first->range.range.begin)) first = part.get();
    return first;
}

std::string commentOfCopy(const LoadedProject& loaded, const std::string& name, FileId from) {
    return "// A copy of " + name + " in " + shownInProject(loaded.paths[from], loaded.projectFolder) +
           ", for this file alone.\n";
}

/// Whether a reference to a shipped definition is changed into one to its copy in the opened file.
bool usesCopy(const LoadedProject& loaded, const NameReference& reference) {
    if (!reference.name.known()) return false;
    if (reference.name.file == 0) return true;
    if (!isShippedFile(loaded, reference.name.file)) return false;
    const std::vector<const Part*>& configs = loaded.outline->configs.all();
    return std::ranges::any_of(configs, [&](const Part* config) {
        return isWithin(reference.name, config->range) &&
               std::ranges::any_of(instancesOf(loaded, *config), [](const Part* instance) { return instance->file == 0; });
    });
}

bool declares(const Part& part, const std::string& param) {
    return part.param(param) || std::ranges::any_of(part.parts, [&](const Part& inner) { return declares(inner, param); });
}

Result<EditPlan> planCopyParam(const LoadedProject& loaded, const SourceParam& param) {
    const Outline& outline = *loaded.outline;
    const auto isTaken = [&](const std::string& name) {
        return std::ranges::any_of(outline.params, [&](const SourceParam& p) { return p.name->text == name; }) ||
               std::ranges::any_of(outline.parts, [&](const auto& part) { return declares(*part, name); });
    };
    std::string name;
    for (int number = 2; name.empty() || isTaken(name); ++number) name = param.name->text + std::to_string(number);
    EditBuilder sheet(loaded);
    const std::string_view value = loaded.trees[param.file]->source().slice(param.value->range);
    addBefore(loaded, firstBlock(loaded), 0,
              commentOfCopy(loaded, param.name->text, param.file) + "Param " + name + " = " + std::string(value), sheet);
    for (const NameReference& reference : referencesIn(loaded))
        if (reference.param && &reference.param->name == param.name && usesCopy(loaded, reference))
            sheet.add({reference.name, name});
    return sheet.plan({name});
}

const SourceParam* paramAt(const LoadedProject& loaded, const std::string& path) {
    const auto& params = loaded.outline->params;
    const auto found = std::ranges::find_if(params, [&](const SourceParam& p) { return p.name->text == path; });
    return found == params.end() ? nullptr : &*found;
}

class BlockCopy {
public:
    BlockCopy(const LoadedProject& loaded, const Part& config, std::vector<const Part*> instances,
              const std::set<std::string>& inlined)
        : m_loaded(loaded), m_config(config), m_instances(std::move(instances)), m_inlined(inlined), m_sheet(loaded) {
        std::stable_sort(m_instances.begin(), m_instances.end(),
                         [](const Part* a, const Part* b) { return a->range.range.begin < b->range.range.begin; });
        if (!m_instances.empty()) m_home = m_instances.front()->file;
    }

    Result<EditPlan> plan() {
        const std::string name = UsedNames(m_loaded, nullptr, m_config.kind).take(m_config.name);
        const Result<std::string> text = block(name);
        if (!text.ok()) return text.error();
        write(text.value());
        for (const Part* instance : m_instances) {
            const SourceAssignment* a = instance->assignments.find("Config");
            if (a && a->file == m_home) m_sheet.add(editSetValue(*m_loaded.trees[m_home], *a->value, name));
        }
        if (Status status = import(); !status.ok()) return status.error();
        return m_sheet.plan({m_config.kind->name + "." + name});
    }

    /// A material, surface or antenna pattern, for the references in the opened file.
    Result<EditPlan> planDefinition() {
        const std::string name = UsedNames(m_loaded, nullptr, m_config.kind).take(m_config.name);
        const Result<std::string> text = block(name);
        if (!text.ok()) return text.error();
        writeBeforeBlocks(text.value());
        for (const NameReference& reference : referencesIn(m_loaded))
            if (reference.target == m_config.block && usesCopy(m_loaded, reference)) m_sheet.add({reference.name, name});
        if (Status status = import(); !status.ok()) return status.error();
        return m_sheet.plan({m_config.kind->name + "." + name});
    }

    /// The block stays where it is, and imports in it are expanded.
    Result<EditPlan> expand() {
        m_home = m_config.file;
        std::vector<TextEdit> edits;
        if (Status status = collect(m_config.block->items, m_config.kind, m_home, edits); !status.ok()) return status.error();
        if (edits.empty()) return EditPlan{};
        for (TextEdit& edit : edits) m_sheet.add(std::move(edit));
        if (Status status = import(); !status.ok()) return status.error();
        return m_sheet.plan({m_config.kind->name + "." + m_config.name});
    }

private:
    /// The text of the block under its new name, without the indent of its surroundings.
    Result<std::string> block(const std::string& name) {
        const SourceRange whole = m_config.range;
        std::vector<TextEdit> edits{{{whole.file, m_config.block->name->range}, name}};
        m_copied = {whole};
        if (Status status = collect(m_config.block->items, m_config.kind, whole.file, edits); !status.ok()) return status.error();
        for (TextEdit& edit : edits) {
            edit.range.range.begin -= whole.range.begin;
            edit.range.range.end -= whole.range.begin;
        }
        const Result<std::string> text = applyEdits(m_loaded.outline->texts().slice(whole), edits);
        if (!text.ok()) return text.error();
        const std::size_t indent = indentOfLine(m_loaded.trees[whole.file]->source().bytes(), whole.range.begin).size();
        std::string from;
        if (whole.file != m_home) from = commentOfCopy(m_loaded, m_config.name, whole.file);
        return from + dedented(text.value(), indent);
    }

    /// Collects the changes inside the copy: file paths that would not lead to the same file from its new folder, and imports
    /// that are expanded.
    Status collect(const std::vector<Item>& items, const Kind* kind, FileId file, std::vector<TextEdit>& edits) {
        for (const Item& item : items) {
            if (const auto* inner = item.as<BlockItem>())
                if (Status status = collect(inner->items, m_loaded.registry->find(inner->type.text), file, edits); !status.ok())
                    return status;
            if (const auto* import = item.as<ImportItem>())
                if (Status status = collectImport(item, *import, kind, file, edits); !status.ok()) return status;
            const auto* a = item.as<AssignmentItem>();
            const Property* property = a && kind && a->path.size() == 1 ? kind->find(a->path[0].text) : nullptr;
            if (!property || property->type != PropertyType::File) continue;
            for (const Element& e : a->value.elements) {
                const auto named = m_loaded.named.find({file, e.text});
                if (named != m_loaded.named.end() && !named->second.path.empty())
                    change({file, e.range}, e.text, named->second.path, edits);
            }
        }
        return {};
    }

    Status collectImport(const Item& item, const ImportItem& import, const Kind* kind, FileId file,
                         std::vector<TextEdit>& edits) {
        const auto& imports = m_loaded.outline->texts().imports;
        const auto found = imports.find(&import);
        if (found == imports.end()) return {};
        const std::string& path = m_loaded.paths[found->second];
        if (!leadsToInlined(found->second)) {
            change({file, import.pathRange}, import.path, path, edits);
            return {};
        }
        const Tree& tree = *m_loaded.trees[found->second];
        std::vector<TextEdit> within;
        if (Status status = collect(tree.items(), kind, found->second, within); !status.ok()) return status;
        const Result<std::string> bytes = applyEdits(tree.source().bytes(), within);
        if (!bytes.ok()) return bytes.error();
        m_copied.push_back({found->second, {0, static_cast<std::uint32_t>(tree.source().bytes().size())}});
        std::string_view text = bytes.value();
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        while (!text.empty() && (isBlank(text.back()) || text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
        const std::string indent = indentOfLine(m_loaded.trees[file]->source().bytes(), item.range.begin);
        std::string out = "// From " + shownInProject(path, m_loaded.projectFolder) + "\n" + indent;
        for (std::size_t i = 0; i < text.size(); ++i) {
            out += text[i];
            const bool isLine = text[i] == '\n' && i + 1 < text.size() && text[i + 1] != '\n' && text[i + 1] != '\r';
            if (isLine) out += indent;
        }
        edits.push_back({{file, item.range}, out});
        return {};
    }

    /// Whether a file is to be expanded, or imports one that is, directly or through other files.
    bool leadsToInlined(FileId file) const {
        std::set<FileId> seen;
        return leadsToInlined(file, seen);
    }
    bool leadsToInlined(FileId file, std::set<FileId>& seen) const {
        if (m_inlined.contains(m_loaded.paths[file])) return true;
        return seen.insert(file).second && haveInlined(m_loaded.trees[file]->items(), seen);
    }
    bool haveInlined(const std::vector<Item>& items, std::set<FileId>& seen) const {
        const auto& imports = m_loaded.outline->texts().imports;
        return std::ranges::any_of(items, [&](const Item& item) {
            if (const auto* block = item.as<BlockItem>()) return haveInlined(block->items, seen);
            const auto* import = item.as<ImportItem>();
            const auto found = import ? imports.find(import) : imports.end();
            return found != imports.end() && leadsToInlined(found->second, seen);
        });
    }

    void change(const SourceRange& range, const std::string& written, const std::string& path,
                std::vector<TextEdit>& edits) const {
        const fs::path here = fs::path(m_loaded.paths[m_home]).parent_path();
        const FileSearch search(m_loaded.importFolders);
        const auto leads = [&](const std::string& words) {
            const Result<std::string> found = search.find(words, here.string());
            return found && found.value() == path;
        };
        std::error_code none;
        const fs::path before = fs::path(m_loaded.paths[range.file]).parent_path();
        const bool beside = fs::weakly_canonical(before / written, none) == path;
        if (!beside || leads(written)) return; // found in a search folder, independent of the file's folder
        std::vector<std::string> words;
        for (const std::string& folder : m_loaded.importFolders)
            if (!folder.empty()) words.push_back(fs::path(path).lexically_relative(folder).string());
        words.push_back(fs::path(path).lexically_relative(here).string());
        const auto fit = std::find_if(words.begin(), words.end(),
                                      [&](const std::string& w) { return !w.empty() && !w.starts_with("..") && leads(w); });
        edits.push_back({range, "\"" + (fit == words.end() ? words.back() : *fit) + "\""});
    }

    void write(const std::string& text) {
        const Part* first = m_instances.empty() ? nullptr : m_instances.front();
        for (const auto& part : m_loaded.outline->parts) // configs are at the top level, instances also in Repeats and configs
            if (first && isWithin(first->range, part->range)) first = part.get();
        addBefore(m_loaded, first, m_home, text, m_sheet);
    }
    void writeBeforeBlocks(const std::string& text) { addBefore(m_loaded, firstBlock(m_loaded), m_home, text, m_sheet); }

    /// Imports the definitions that the block uses, unless they are already imported.
    Status import() {
        if (std::ranges::all_of(m_copied, [this](const SourceRange& copied) { return copied.file == m_home; })) return {};
        std::vector<std::string> paths;
        for (const NameReference& reference : referencesIn(m_loaded)) {
            const auto isUser = [&](const SourceRange& copied) {
                return reference.user && isWithin(reference.user->range, copied);
            };
            if (std::none_of(m_copied.begin(), m_copied.end(), isUser)) continue;
            for (const auto& part : m_loaded.outline->parts)
                if (reference.target == part->block && part->file != m_home) paths.push_back(m_loaded.paths[part->file]);
            for (const SourceParam& param : m_loaded.outline->params)
                if (reference.param && param.name == &reference.param->name && param.file != m_home)
                    paths.push_back(m_loaded.paths[param.file]);
        }
        const std::optional<ObsoleteImport> obsolete = obsoleteImport(m_loaded, m_config, m_instances, m_home);
        if (obsolete) {
            paths.insert(paths.end(), obsolete->needed.begin(), obsolete->needed.end());
            m_sheet.removeItem(obsolete->directive);
        }
        Result<std::vector<TextEdit>> edits = editsForImports(m_loaded, m_home, paths, obsolete ? obsolete->import : nullptr);
        if (!edits.ok()) return edits.error();
        for (TextEdit& edit : edits.value()) m_sheet.addFirst(std::move(edit));
        return {};
    }

    const LoadedProject& m_loaded;
    const Part& m_config;
    std::vector<const Part*> m_instances;
    const std::set<std::string>& m_inlined;
    std::vector<SourceRange> m_copied; ///< source ranges that are part of the copy
    EditBuilder m_sheet;
    FileId m_home = 0;
};

} // namespace

Result<EditPlan> planExpandImports(const LoadedProject& loaded, const Part& config, const std::set<std::string>& inlined) {
    return BlockCopy(loaded, config, {}, inlined).expand();
}

Result<EditPlan> planCopyConfig(const LoadedProject& loaded, const Part& config, const std::vector<const Part*>& instances,
                                const std::set<std::string>& inlined) {
    if (!config.kind || !config.block->name) return Error{Code::WrongPlace, config.title() + " cannot be copied: it has no name"};
    for (const Part* instance : instances)
        if (isShippedFile(loaded, instance->file))
            return Error{Code::FileUnwritable, instance->title() + " is in " + loaded.trees[instance->file]->source().path() +
                                                   ", which came with the program and is read-only; place one in your own file"};
    return BlockCopy(loaded, config, instances, inlined).plan();
}

Result<EditPlan> planCopyDefinition(const LoadedProject& loaded, const std::string& definition) {
    if (const SourceParam* param = paramAt(loaded, definition)) return planCopyParam(loaded, *param);
    const std::optional<ObjectLocation> place = placeOf(loaded, definition);
    if (!place || !place->part || !place->part->block->name) return Error{Code::NoSuchPath, "there is no " + definition};
    return BlockCopy(loaded, *place->part, {}, {}).planDefinition();
}

std::vector<FileId> otherFilesUsing(const LoadedProject& loaded, const std::string& definition) {
    const SourceParam* param = paramAt(loaded, definition);
    const std::optional<ObjectLocation> place = param ? std::nullopt : placeOf(loaded, definition);
    const BlockItem* block = place && place->part ? place->part->block : nullptr;
    std::set<FileId> files;
    for (const NameReference& reference : referencesIn(loaded)) {
        const bool isUse = param ? reference.param && &reference.param->name == param->name : block && reference.target == block;
        const FileId file = reference.name.file;
        if (isUse && reference.name.known() && file != 0 && !isShippedFile(loaded, file)) files.insert(file);
    }
    return {files.begin(), files.end()};
}

} // namespace trundle
