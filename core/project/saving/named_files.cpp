#include "project/saving/named_files.h"

#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

#include "base/platform/read_file.h"
#include "model/param_reference.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMaxGltfBytes = 64 << 20;

void modulesIn(const std::vector<Item>& items, std::vector<const ModuleItem*>& found) {
    for (const Item& item : items) {
        if (const auto* block = item.as<BlockItem>()) modulesIn(block->items, found);
        else if (const auto* module = item.as<ModuleItem>(); module && !module->path.empty()) found.push_back(module);
    }
}

/// Follows Params by their names alone, without their scopes.
class FileWordSearch {
public:
    explicit FileWordSearch(const LoadedProject& loaded) : m_registry(*loaded.registry) {
        for (const Kind* kind : m_registry.all())
            for (const Property& property : kind->properties)
                if (property.type == PropertyType::File) m_keys.insert(property.name);
        for (FileId text = 0; text < loaded.trees.size(); ++text) search(loaded.trees[text]->items(), nullptr, text);
    }

    FileWords run() {
        while (!m_open.empty()) {
            const auto given = m_given.find(m_open.back());
            m_open.pop_back();
            if (given == m_given.end()) continue;
            for (const auto& [value, text] : given->second) add(*value, text);
        }
        return std::move(m_found);
    }

private:
    /// `kind`: of the block; nullptr: it is unknown, or the items are in no block of this text.
    void search(const std::vector<Item>& items, const Kind* kind, FileId text) {
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) search(block->items, m_registry.find(block->type.text), text);
            if (const auto* param = item.as<ParamItem>()) m_given[param->name.text].emplace_back(&param->value, text);
            const auto* a = item.as<AssignmentItem>();
            if (!a || a->path.empty()) continue;
            const std::string& key = a->path.back().text;
            const bool isOwn = kind && a->path.size() == 1;
            const Property* own = isOwn ? kind->find(key) : nullptr;
            if (!own) m_given[key].emplace_back(&a->value, text);
            if (own ? own->type == PropertyType::File : !isOwn && m_keys.contains(key)) add(a->value, text);
        }
    }

    void add(const Value& value, FileId text) {
        const auto follow = [this](const std::string& param) {
            if (m_params.insert(param).second) m_open.push_back(param);
        };
        for (const Element& e : value.elements) {
            if (e.kind == Element::Kind::Word || e.kind == Element::Kind::String) m_found[{text, e.text}].push_back(e.range);
            if (e.kind == Element::Kind::ParamRef) follow(e.text);
            if (e.expression) eachNameGiven(*e.expression, follow);
        }
    }

    const Registry& m_registry;
    std::set<std::string> m_keys;    ///< properties of any kind that are files
    std::set<std::string> m_params;  ///< that give a file its name
    std::vector<std::string> m_open; ///< those of them that are still to be followed
    /// To Params, in their declarations and in instances.
    std::map<std::string, std::vector<std::pair<const Value*, FileId>>> m_given;
    FileWords m_found;
};

/// The files in the folder of a glTF file, or below it, that hold its numbers.
std::vector<std::string> gltfBuffers(const std::string& path) {
    std::vector<std::string> buffers;
    const Result<std::string> bytes = readRegularFile(path, kMaxGltfBytes);
    if (!bytes) return buffers;
    const auto json = nlohmann::json::parse(bytes.value(), nullptr, false);
    const auto list = json.is_object() ? json.find("buffers") : json.end();
    if (list == json.end() || !list->is_array()) return buffers;
    for (const auto& buffer : *list) {
        const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
        if (uri == buffer.end() || !uri->is_string()) continue;
        const std::string written = uri->get<std::string>();
        const fs::path inner = fs::path(written).lexically_normal();
        const bool below = inner.is_relative() && !inner.empty() && *inner.begin() != "..";
        if (below && !written.starts_with("data:")) buffers.push_back(inner.string());
    }
    return buffers;
}

} // namespace

std::string libraryOf(const std::string& written, const std::string& folder, ModuleCatalog& modules) {
    const Result<ModuleListing> found = modules.find(written, folder);
    return found ? found.value().library : std::string();
}

std::vector<NamedFileUse> namedFiles(const LoadedProject& loaded, ModuleCatalog& modules) {
    std::vector<NamedFileUse> named;
    for (const auto& [use, file] : loaded.named) {
        const auto& [text, written] = use;
        if (!file.path.empty() && text < loaded.paths.size() && !loaded.paths[text].empty())
            named.push_back({text, written, {}, file.path, false});
    }
    for (FileId text = 0; text < loaded.paths.size(); ++text) {
        if (loaded.paths[text].empty()) continue;
        std::vector<const ModuleItem*> directives;
        modulesIn(loaded.trees[text]->items(), directives);
        const std::string folder = fs::path(loaded.paths[text]).parent_path().string();
        for (const ModuleItem* directive : directives)
            if (std::string library = libraryOf(directive->path, folder, modules); !library.empty())
                named.push_back({text, directive->path, directive->pathRange, std::move(library), true});
    }
    return named;
}

std::vector<std::string> neededBy(const NamedFileUse& file) {
    const fs::path path = file.path;
    std::vector<std::string> needed;
    if (file.module) needed.push_back(fs::path(kindsJsonPath(file.path)).filename().string());
    if (path.extension() == ".gltf") needed = gltfBuffers(file.path);
    std::error_code none;
    std::erase_if(needed, [&](const std::string& name) { return !fs::is_regular_file(path.parent_path() / name, none); });
    return needed;
}

FileWords fileWordsIn(const LoadedProject& loaded) { return FileWordSearch(loaded).run(); }

} // namespace trundle
