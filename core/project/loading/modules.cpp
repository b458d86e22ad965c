#include "project/loading/modules.h"

#include <algorithm>
#include <set>

#include "model/kinds/model_kinds.h"
#include "project/loading/import_lines.h"

namespace trundle {

bool isUnavailableModule(Code code) { return code == Code::ModuleNotTrusted || code == Code::ModuleUndescribed; }

bool hasAllModules(const Diagnostics& diagnostics) {
    return std::ranges::none_of(diagnostics.all(), [](const Diagnostic& d) { return isUnavailableModule(d.code); });
}

FoundModules findModules(const std::vector<ModuleReference>& references, ModuleCatalog& catalog, Registry& registry,
                         Diagnostics& diagnostics) {
    FoundModules found;
    std::set<std::string> libraries;
    std::set<std::pair<std::string, std::string>> failed; // one message for a module that several files load by the same name
    std::size_t notFound = 0;
    for (const ModuleReference& reference : references) {
        if (notFound > kMaxNotFound) break;
        Result<ModuleListing> listing = catalog.find(reference.written, reference.folder);
        if (!listing.ok()) {
            found.open = true;
            if (!failed.emplace(reference.written, reference.folder).second) continue;
            const Severity severity = isUnavailableModule(listing.error().code) ? Severity::Warning : Severity::Error;
            Diagnostic& d = diagnostics.add(severity, listing.error().code, reference.range, listing.error().message);
            d.place = listing.error().place;
            if (listing.error().code == Code::ModuleNotFound && ++notFound > kMaxNotFound)
                d.message = "too many modules are not found; those from here on are not looked for";
            found.modules.push_back({reference.written, {}, reference.range});
            continue;
        }
        const ModuleListing& module = listing.value();
        if (!libraries.insert(module.library).second) continue;
        found.modules.push_back({reference.written, module.library, reference.range});
        if (!module.described) {
            found.open = true;
            diagnostics.warning(Code::ModuleUndescribed, reference.range,
                                reference.written +
                                    " has no description file beside it, so its blocks can neither be checked nor "
                                    "run; build it with trundle_module");
            continue;
        }
        for (Kind kind : module.kinds) {
            if (kind.module.empty()) kind.module = module.library;
            const Status status = registry.add(withControllerProperties(std::move(kind)));
            if (!status.ok()) diagnostics.error(status.error().code, reference.range, status.error().message);
        }
    }
    return found;
}

void offerModules(const LoadedProject& loaded, ModuleCatalog& catalog, std::vector<Diagnostic>& diagnostics) {
    for (Diagnostic& d : diagnostics) {
        if (d.code != Code::UnknownKind || d.range.file >= loaded.trees.size()) continue;
        const std::string kind(loaded.outline->texts().slice(d.range)), module = catalog.moduleWith(kind);
        if (module.empty()) continue;
        const std::string line = "#loadModule " + module;
        Result<std::vector<TextEdit>> edits = editsForImports(loaded, d.range.file, {line});
        if (!edits || edits.value().empty()) continue;
        d.message = kind + " is a kind of the module " + module + ", which is not loaded";
        d.suggestions.clear();
        d.fixes = {{line, std::move(edits).value()}};
    }
}

} // namespace trundle
