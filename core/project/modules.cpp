#include "project/modules.h"

#include <set>

#include "model/model_kinds.h"
#include "project/import_lines.h"

namespace trundle {

namespace {

/// Not usable as it stands, but nothing is wrong with the text: its blocks stay raw.
bool onlyUnknown(Code code) { return code == Code::ModuleNotTrusted || code == Code::ModuleUndescribed; }

} // namespace

FoundModules findModules(const std::vector<ModuleMention>& mentions, ModuleCatalog& catalog, Registry& registry,
                         Diagnostics& diagnostics) {
    FoundModules found;
    std::set<std::string> libraries;
    std::set<std::pair<std::string, std::string>> failed; // one message for a module that several files name alike
    std::size_t notFound = 0;
    for (const ModuleMention& mention : mentions) {
        if (notFound > kMostNotFound) break;
        Result<ModuleListing> listing = catalog.find(mention.written, mention.folder);
        if (!listing.ok()) {
            found.open = true;
            if (!failed.emplace(mention.written, mention.folder).second) continue;
            const Severity severity = onlyUnknown(listing.error().code) ? Severity::Warning : Severity::Error;
            Diagnostic& d = diagnostics.add(severity, listing.error().code, mention.range, listing.error().message);
            if (listing.error().code == Code::ModuleNotFound && ++notFound > kMostNotFound)
                d.message = "too many modules are not found; those from here on are not looked for";
            found.modules.push_back({mention.written, {}, mention.range});
            continue;
        }
        const ModuleListing& module = listing.value();
        if (!libraries.insert(module.library).second) continue;
        found.modules.push_back({mention.written, module.library, mention.range});
        if (!module.described) {
            found.open = true;
            diagnostics.warning(Code::ModuleUndescribed, mention.range,
                                mention.written + " has no description file beside it, so its blocks can neither be checked nor "
                                                  "run; build it with trundle_module");
            continue;
        }
        for (Kind kind : module.kinds) {
            if (kind.module.empty()) kind.module = module.library;
            const Status status = registry.add(withControllerProperties(std::move(kind)));
            if (!status.ok()) diagnostics.error(status.error().code, mention.range, status.error().message);
        }
    }
    return found;
}

void offerModules(const Loaded& loaded, ModuleCatalog& catalog, std::vector<Diagnostic>& diagnostics) {
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
