#include "editor/running/module_list.h"

#include <algorithm>
#include <filesystem>

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include "control/directory_catalog.h"
#include "control/kinds_json.h"

namespace trundle {
namespace {

constexpr qint64 kMaxDescriptionBytes = 16 << 20;

QString versionOf(const std::string& library) {
    QFile file(QString::fromStdString(kindsJsonPath(library)));
    if (!file.open(QIODevice::ReadOnly) || file.size() > kMaxDescriptionBytes) return {};
    return QJsonDocument::fromJson(file.readAll()).object().value(QStringLiteral("sdk")).toString();
}

/// A robot that has a block of one of these kinds.
std::string userOf(const LoadedProject& loaded, const std::vector<std::string>& kinds) {
    const auto has = [&](const std::string& kind) { return std::ranges::find(kinds, kind) != kinds.end(); };
    for (const auto& top : loaded.outline->parts)
        for (const Part& inner : top->parts)
            if (has(inner.block->type.text)) return top->name;
    return {};
}

} // namespace

std::vector<ModuleInfo> modulesOf(const LoadedProject& loaded, const OpenOptions& options, const Locations& places) {
    DirectoryCatalog catalog({options.modules, places.modules, options.trusted, options.trust});
    DirectoryCatalog open({options.modules, places.modules, {}, true}); // reads descriptions, loads no module
    std::vector<ModuleInfo> modules;
    for (const ModuleSpec& spec : loaded.experiment->modules) {
        ModuleInfo info;
        info.written = spec.written;
        info.range = spec.range;
        const std::string file = spec.range.file < loaded.paths.size() ? loaded.paths[spec.range.file] : std::string();
        const std::string folder = std::filesystem::path(file).parent_path().string();
        const Result<ModuleListing> allowed = catalog.find(spec.written, folder);
        const Result<ModuleListing> found = allowed ? allowed : open.find(spec.written, folder);
        if (found) {
            info.library = found.value().library;
            info.version = versionOf(info.library);
            for (const Kind& kind : found.value().kinds) info.kinds.push_back(kind.name);
            info.usedBy = userOf(loaded, info.kinds);
            if (!found.value().described)
                info.trouble = QCoreApplication::translate("ControllersPanel",
                                                           "no description file beside it: build it with trundle_module");
        }
        if (!allowed) {
            info.trusted = !found;
            info.trouble = found ? QCoreApplication::translate("ControllersPanel", "its folder is not trusted")
                                 : QString::fromStdString(allowed.error().message);
        }
        modules.push_back(std::move(info));
    }
    return modules;
}

} // namespace trundle
