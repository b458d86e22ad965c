#include "project/edits/module_lines.h"

#include <array>
#include <filesystem>

#include "lang/tree_edit.h"
#include "project/loading/import_lines.h"
#include "project/loading/import_path.h"
#include "project/loading/search.h"

namespace trundle {

namespace fs = std::filesystem;

Result<EditPlan> planLoadModule(const LoadedProject& loaded, const std::string& written) {
    Result<std::vector<TextEdit>> edits = editsForImports(loaded, 0, {"#loadModule " + written});
    if (!edits) return edits.error();
    if (edits.value().empty()) return Error{Code::DuplicateName, "the module " + written + " is loaded already"};
    EditPlan plan;
    plan.edits[0] = std::move(edits).value();
    return plan;
}

Result<EditPlan> planUnloadModule(const LoadedProject& loaded, FileId file, const std::string& written) {
    const Error none{Code::NoSuchPath, "no text loads " + written};
    if (file >= loaded.trees.size()) return none;
    const Tree& tree = *loaded.trees[file];
    EditPlan plan;
    for (const Item& item : tree.items())
        if (const ModuleItem* directive = item.as<ModuleItem>(); directive && directive->path == written)
            plan.edits[file].push_back(editRemoveItem(tree, item));
    if (plan.edits.empty()) return none;
    return plan;
}

std::string writtenFor(const std::string& library, const LoadedProject& loaded, const std::string& shippedModules,
                       const std::vector<std::string>& moduleFolders) {
    const fs::path path = fs::path(library).lexically_normal();
    std::string stem = path.stem().string();
    if (stem.starts_with("lib") && stem.size() > 3) stem.erase(0, 3);
    const std::string plain = (path.parent_path() / stem).generic_string();
    const std::string own = loaded.paths.empty() ? std::string() : fs::path(loaded.paths[0]).parent_path().string();
    if (const auto below = pathBelow(plain, std::array{shippedModules, own})) return *below;
    if (!own.empty() &&
        pathBelow(plain, std::array{loaded.projectFolder})) { // relative to the opened file, as modules are resolved
        const fs::path there = fs::path(canonicalPath(path.parent_path().string())) / stem;
        return there.lexically_relative(canonicalPath(own)).generic_string();
    }
    return pathBelow(plain, moduleFolders).value_or(plain);
}

} // namespace trundle
