#include "editor/document/save_companions.h"

#include <filesystem>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "control/directory_catalog.h"
#include "control/kinds_json.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr qint64 kMaxGltfBytes = 64 << 20;

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

} // namespace

std::string libraryOf(const std::string& written, const std::string& folder, const Application& parts,
                      const OpenOptions& options) {
    DirectoryCatalog all({options.modules, parts.locations().modules, {}, true}); // reads descriptions, loads no module
    const Result<ModuleListing> found = all.find(written, folder);
    return found ? found.value().library : std::string();
}

std::vector<NamedThere> namedBy(const LoadedProject& loaded, const Application& parts, const OpenOptions& options) {
    std::vector<NamedThere> named;
    for (const auto& [use, file] : loaded.named) {
        const auto& [text, written] = use;
        if (!file.path.empty() && text < loaded.paths.size() && !loaded.paths[text].empty())
            named.push_back({text, written, {}, file.path, false});
    }
    for (FileId text = 0; text < loaded.paths.size(); ++text) {
        if (loaded.paths[text].empty()) continue;
        std::vector<const ModuleItem*> modules;
        modulesIn(loaded.trees[text]->items(), modules);
        const std::string folder = fs::path(loaded.paths[text]).parent_path().string();
        for (const ModuleItem* module : modules)
            if (std::string library = libraryOf(module->path, folder, parts, options); !library.empty())
                named.push_back({text, module->path, module->pathRange, std::move(library), true});
    }
    return named;
}

std::vector<std::string> partsOf(const NamedThere& file) {
    const fs::path path = file.path;
    std::vector<std::string> parts;
    if (file.module) parts.push_back(fs::path(kindsJsonPath(file.path)).filename().string());
    if (path.extension() == ".gltf") {
        QFile json(QString::fromStdString(file.path));
        if (!json.open(QIODevice::ReadOnly) || json.size() > kMaxGltfBytes) return parts;
        for (const QJsonValue buffer : QJsonDocument::fromJson(json.readAll()).object().value(u"buffers"_qs).toArray()) {
            const std::string uri = buffer.toObject().value(u"uri"_qs).toString().toStdString();
            const fs::path inner = fs::path(uri).lexically_normal();
            const bool below = inner.is_relative() && !inner.empty() && *inner.begin() != "..";
            if (below && !uri.starts_with("data:")) parts.push_back(inner.string());
        }
    }
    std::error_code none;
    std::erase_if(parts, [&](const std::string& part) { return !fs::is_regular_file(path.parent_path() / part, none); });
    return parts;
}

std::vector<TextRange> placesOf(const Tree& tree, const std::string& words) {
    std::vector<TextRange> found;
    wordsIn(tree.items(), words, found);
    return found;
}

} // namespace trundle
