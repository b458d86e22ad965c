#include "project/saving/named_files.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/platform/read_file.h"

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

void wordsIn(const Value& value, const std::string& words, std::vector<TextRange>& found) {
    for (const Element& element : value.elements) {
        const bool text = element.kind == Element::Kind::Word || element.kind == Element::Kind::String;
        if (text && element.text == words) found.push_back(element.range);
    }
}

void wordsIn(const std::vector<Item>& items, const std::string& words, std::vector<TextRange>& found) {
    for (const Item& item : items) {
        if (const auto* block = item.as<BlockItem>()) wordsIn(block->items, words, found);
        else if (const auto* assignment = item.as<AssignmentItem>()) wordsIn(assignment->value, words, found);
        else if (const auto* param = item.as<ParamItem>()) wordsIn(param->value, words, found);
    }
}

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

std::vector<TextRange> rangesOf(const Tree& tree, const std::string& words) {
    std::vector<TextRange> found;
    wordsIn(tree.items(), words, found);
    return found;
}

} // namespace trundle
