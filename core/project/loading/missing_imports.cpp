// Needs: a load with complete diagnostics. Gives: fixes that import definitions from other files.
// Assumes: a file with definitions only can be imported; one that also places robots or has logs is an experiment.
// Method: reads the files below the searched folders once a load and parses, once, those whose bytes contain a name.
// Data: at most kMaxImportFiles files and kMaxReadBytes bytes per load.
#include "project/loading/missing_imports.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "project/loading/import_lines.h"
#include "project/loading/loaded_project.h"
#include "schema/value_reader.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMaxImportFiles = 300, kMaxImportBytes = std::size_t{1} << 20, kMaxReadBytes = std::size_t{16} << 20;
constexpr std::size_t kMaxOffered = 3; ///< files offered per name
constexpr int kMaxImportEntries = 5000, kMaxImportDepth = 3;

/// A file, with its path relative to its search folder: "robots/evbot.sim".
struct ImportableFile {
    std::string path, written;
    std::string bytes;
    std::shared_ptr<const Tree> parsed; ///< null until its bytes contain a name that is missing
};

std::vector<ImportableFile> filesBelow(const std::vector<std::string>& folders, const std::vector<std::string>& loaded) {
    std::vector<ImportableFile> files;
    std::set<std::string> seen(loaded.begin(), loaded.end());
    std::size_t bytes = 0;
    for (const std::string& folder : folders) {
        if (folder.empty()) continue;
        const std::size_t first = files.size();
        std::error_code error;
        fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
        int entries = 0;
        for (; !error && at != end && files.size() < kMaxImportFiles && ++entries < kMaxImportEntries; at.increment(error)) {
            const std::string name = at->path().filename().string();
            std::error_code ignored;
            if (at->is_directory(ignored)) {
                if (name.starts_with(".") || at.depth() >= kMaxImportDepth) at.disable_recursion_pending();
                continue;
            }
            if (!name.ends_with(".sim")) continue;
            const std::string path = canonicalPath(at->path().string());
            if (bytes > kMaxReadBytes || !seen.insert(path).second) continue;
            Result<std::string> text = readFile(path, kMaxImportBytes);
            if (!text) continue;
            bytes += text.value().size();
            files.push_back({path, at->path().lexically_relative(folder).generic_string(), std::move(text).value(), nullptr});
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end(),
                  [](const ImportableFile& a, const ImportableFile& b) { return a.written < b.written; });
    }
    return files;
}

class ImportOffer {
public:
    ImportOffer(const LoadedProject& loaded, const FileSearch& search, const std::vector<std::string>& folders)
        : m_loaded(loaded), m_search(search), m_folders(folders) {}

    void add(Diagnostic& d) {
        const SourceRange used = useOf(d);
        const AssignmentContext site = siteOf(used);
        const std::string name = site.assignment ? nameIn(used, site) : std::string();
        const std::set<std::string> kinds = name.empty() ? std::set<std::string>() : kindsAt(site);
        if (kinds.empty()) return;
        std::vector<Fix> fixes;
        std::string from;
        for (ImportableFile& file : files()) {
            if (fixes.size() == kMaxOffered) break;
            if (file.bytes.find(name) == std::string::npos) continue;
            if (!file.parsed) file.parsed = parse(std::make_shared<const SourceText>(file.path, file.bytes), 0);
            if (!defines(*file.parsed, kinds, name) || !canImport(*file.parsed, file, used.file)) continue;
            Result<std::vector<TextEdit>> edits = editsForImports(m_loaded, used.file, {"#import " + file.written});
            if (!edits || edits.value().empty()) continue;
            if (fixes.empty()) from = file.written;
            fixes.push_back({"#import " + file.written, std::move(edits).value()});
        }
        if (fixes.empty()) return;
        d.message = name + " is defined in " + from + ", which is not imported";
        d.suggestions.clear();
        std::move(d.fixes.begin(), d.fixes.end(), std::back_inserter(fixes));
        d.fixes = std::move(fixes);
    }

private:
    std::vector<ImportableFile>& files() {
        if (!m_read) m_files = filesBelow(m_folders, m_loaded.paths);
        m_read = true;
        return m_files;
    }

    /// Where the name is used, which for one that a Param gives is not where it is reported.
    [[nodiscard]] static SourceRange useOf(const Diagnostic& d) {
        const auto note = std::ranges::find_if(d.notes, [](const auto& n) { return n.first == kUsedHere; });
        return note == d.notes.end() ? d.range : note->second;
    }

    /// An assignment, its block, and the Params in scope.
    struct AssignmentContext {
        const AssignmentItem* assignment = nullptr;
        const BlockItem* block = nullptr;
        std::map<std::string_view, const Value*> params;
    };
    [[nodiscard]] AssignmentContext siteOf(const SourceRange& range) const {
        AssignmentContext site;
        for (const SourceParam& param : m_loaded.outline->params) site.params[param.name->text] = param.value;
        const std::vector<Item>* items = &m_loaded.trees[range.file]->items();
        while (items) {
            const std::vector<Item>* inner = nullptr;
            for (const Item& item : *items) {
                if (const auto* param = item.as<ParamItem>()) site.params[param->name.text] = &param->value;
                if (!item.range.contains(range.range.begin)) continue;
                site.assignment = item.as<AssignmentItem>();
                if (const auto* block = item.as<BlockItem>()) {
                    site.block = block;
                    inner = &block->items;
                }
            }
            items = inner;
        }
        return site;
    }

    /// The name as written, or as given by a Param.
    [[nodiscard]] std::string nameIn(const SourceRange& used, const AssignmentContext& site) const {
        std::string_view name = m_loaded.outline->texts().slice(used);
        if (name.starts_with('$')) {
            const auto param = site.params.find(name.substr(1));
            if (param == site.params.end() || param->second->elements.size() != 1) return {};
            name = param->second->elements[0].text;
        }
        if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
        const auto legal = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
        return std::all_of(name.begin(), name.end(), legal) ? std::string(name) : std::string();
    }

    /// The kinds of block that the property accepts; for an override only the property's name is considered.
    [[nodiscard]] std::set<std::string> kindsAt(const AssignmentContext& site) const {
        if (site.assignment->path.empty()) return {};
        const std::string& key = site.assignment->path.back().text;
        const Kind* own = site.block ? m_loaded.registry->find(site.block->type.text) : nullptr;
        const bool direct = site.assignment->path.size() == 1 && own && own->find(key);
        std::set<std::string> kinds;
        for (const Kind* kind : m_loaded.registry->all()) {
            const Property* property = direct && kind != own ? nullptr : kind->find(key);
            if (property && property->type == PropertyType::Reference)
                kinds.insert(property->choices.begin(), property->choices.end());
        }
        return kinds;
    }

    [[nodiscard]] static bool defines(const Tree& tree, const std::set<std::string>& kinds, const std::string& name) {
        return std::any_of(tree.items().begin(), tree.items().end(), [&](const Item& item) {
            const auto* block = item.as<BlockItem>();
            return block && block->name && block->name->text == name && kinds.contains(block->type.text);
        });
    }

    /// Whether a file has definitions only, none of them already defined; is found under its written path; and does not import
    /// `into`.
    [[nodiscard]] bool canImport(const Tree& tree, const ImportableFile& file, FileId into) const {
        for (const Item& item : tree.items()) {
            if (item.as<AssignmentItem>()) return false;
            const auto* block = item.as<BlockItem>();
            if (!block) continue;
            const Kind* kind = m_loaded.registry->find(block->type.text);
            const NameSpace* space = kind ? m_loaded.outline->spaceOf(*kind) : nullptr;
            if (!space || space == &m_loaded.outline->world) return false;
            if (block->name && space->find(block->name->text)) return false;
        }
        const Result<std::string> found = m_search.find(file.written, folderOf(m_loaded.paths[into]));
        std::set<std::string> seen;
        return found && found.value() == file.path && !reaches(tree, file.path, m_loaded.paths[into], seen);
    }

    [[nodiscard]] bool reaches(const Tree& tree, const std::string& from, const std::string& target,
                               std::set<std::string>& seen) const {
        for (const Item& item : tree.items()) {
            const auto* import = item.as<ImportItem>();
            if (!import || seen.size() > kMaxImportFiles) continue;
            const Result<std::string> found = m_search.find(import->path, folderOf(from));
            if (!found || !seen.insert(found.value()).second) continue;
            if (found.value() == target) return true;
            Result<std::string> bytes = readFile(found.value(), kMaxImportBytes);
            if (!bytes) continue;
            const auto next = parse(std::make_shared<const SourceText>(found.value(), std::move(bytes).value()), 0);
            if (reaches(*next, found.value(), target, seen)) return true;
        }
        return false;
    }

    [[nodiscard]] static std::string folderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

    const LoadedProject& m_loaded;
    const FileSearch& m_search;
    const std::vector<std::string>& m_folders;
    std::vector<ImportableFile> m_files;
    bool m_read = false;
};

} // namespace

void offerImports(const LoadedProject& loaded, const FileSearch& search, const std::vector<std::string>& folders,
                  std::vector<Diagnostic>& diagnostics) {
    ImportOffer offer(loaded, search, folders);
    std::size_t offered = 0;
    constexpr std::size_t kMaxLookedUp = 50; ///< each is a search; more fixes would not be read
    for (Diagnostic& d : diagnostics) {
        if (d.code != Code::UnknownReference || d.range.file >= loaded.trees.size() || loaded.paths[d.range.file].empty())
            continue;
        if (++offered > kMaxLookedUp) return;
        offer.add(d);
    }
}

} // namespace trundle
