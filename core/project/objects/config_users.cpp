#include "project/objects/config_users.h"

#include <algorithm>
#include <filesystem>

#include "project/loading/search.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxProjectEntries = 5000; ///< entries of the project's folder
constexpr std::uint64_t kMaxBytes = 4u << 20;

bool isText(const fs::path& path) { return path.extension() == ".sim" || path.extension() == ".txt"; }

bool isWord(const Element& e) { return e.kind == Element::Kind::Word || e.kind == Element::Kind::String; }

/// Collects the imports of `items` and the names given to `Config`, directly or through a Param.
void collect(const std::vector<Item>& items, std::vector<std::string>& imports, std::set<std::string>& named,
             std::set<std::string>& params, bool& byParam) {
    for (const Item& item : items) {
        if (const auto* block = item.as<BlockItem>()) collect(block->items, imports, named, params, byParam);
        else if (const auto* import = item.as<ImportItem>()) imports.push_back(import->path);
        else if (const auto* param = item.as<ParamItem>()) {
            for (const Element& e : param->value.elements)
                if (isWord(e)) params.insert(e.text);
        } else if (const auto* a = item.as<AssignmentItem>(); a && a->path.size() == 1 && a->path[0].text == "Config") {
            for (const Element& e : a->value.elements) {
                if (isWord(e)) named.insert(e.text);
                byParam = byParam || e.kind == Element::Kind::ParamRef;
            }
        }
    }
}

} // namespace

ConfigUsers::Text ConfigUsers::textOf(const Tree& tree) {
    Text text;
    std::set<std::string> params;
    bool byParam = false;
    collect(tree.items(), text.imports, text.configs, params, byParam);
    if (byParam) text.configs.merge(params);
    return text;
}

std::vector<std::string> ConfigUsers::textsIn(const std::string& folder) {
    std::vector<std::string> found;
    if (folder.empty()) return found;
    std::error_code failed;
    int looked = 0;
    fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, failed), end;
    for (; !failed && it != end && ++looked < kMaxProjectEntries; it.increment(failed)) {
        std::error_code none;
        if (it->path().filename().string().starts_with('.')) {
            if (it->is_directory(none)) it.disable_recursion_pending();
        } else if (isText(it->path()) && it->is_regular_file(none)) {
            found.push_back(canonicalPath(it->path().string()));
        }
    }
    return found;
}

const ConfigUsers::Text* ConfigUsers::read(const LoadedProject& loaded, const std::string& path) {
    if (const auto known = m_ofLoad.find(path); known != m_ofLoad.end()) return &known->second;
    const auto held = std::find(loaded.paths.begin(), loaded.paths.end(), path);
    if (held != loaded.paths.end())
        return &m_ofLoad.emplace(path, textOf(*loaded.trees[static_cast<std::size_t>(held - loaded.paths.begin())]))
                    .first->second;
    const Result<FileStamp> stamp = regularFileStamp(path);
    if (!stamp || stamp.value().size > kMaxBytes) return nullptr;
    const auto [known, isNew] = m_onDisk.try_emplace(path);
    if (!isNew && known->second.stamp == stamp.value()) return &known->second.text;
    Result<std::string> bytes = readRegularFile(path, kMaxBytes);
    if (!bytes) {
        m_onDisk.erase(known);
        return nullptr;
    }
    known->second = {stamp.value(), textOf(*parse(std::make_shared<const SourceText>(path, std::move(bytes).value()), 0))};
    return &known->second.text;
}

bool ConfigUsers::reaches(const LoadedProject& loaded, const std::string& from, const std::string& file,
                          std::set<std::string>& seen) {
    if (from == file) return true;
    if (!seen.insert(from).second || seen.size() > kMaxProjectEntries) return false;
    const Text* text = read(loaded, from);
    if (!text) return false;
    const FileSearch search(loaded.importFolders);
    const std::vector<std::string> imports = text->imports; // copied: read() may move the object that holds them
    return std::any_of(imports.begin(), imports.end(), [&](const std::string& written) {
        const Result<std::string> found = search.find(written, fs::path(from).parent_path().string());
        return found && reaches(loaded, found.value(), file, seen);
    });
}

std::vector<std::string> ConfigUsers::dependentsOutside(const LoadedProject& loaded, const std::set<std::string>& files) {
    m_ofLoad.clear();
    std::vector<std::string> found;
    for (const std::string& path : textsIn(loaded.projectFolder)) {
        if (std::ranges::find(loaded.paths, path) != loaded.paths.end()) continue;
        const bool depends = std::ranges::any_of(files, [&](const std::string& file) {
            std::set<std::string> seen;
            return reaches(loaded, path, file, seen);
        });
        if (depends) found.push_back(path);
    }
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> ConfigUsers::of(const LoadedProject& loaded, const Part& config) {
    m_ofLoad.clear();
    if (config.file >= loaded.paths.size()) return {};
    std::set<std::string> texts;
    for (const std::string& path : loaded.paths)
        if (!path.empty()) texts.insert(path);
    for (std::string& path : textsIn(loaded.projectFolder)) texts.insert(std::move(path));
    std::vector<std::string> users;
    for (const std::string& path : texts) {
        const Text* text = read(loaded, path);
        std::set<std::string> seen;
        if (text && text->configs.contains(config.name) && reaches(loaded, path, loaded.paths[config.file], seen))
            users.push_back(path);
    }
    return users;
}

} // namespace trundle
