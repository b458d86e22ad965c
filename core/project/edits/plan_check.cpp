// Needs: a load and the edits of its texts. Gives: whether all names in the edited texts lead to something.
// Method: the edited texts are resolved as a whole. That finds what the plan of one edit cannot foresee: the members of Repeats, what
// Parts hand on, kinds of what is found at another place under the same name.
// Data: meshes and pictures are left out, since no name depends on them.
#include "project/edits/plan_check.h"

#include <algorithm>
#include <set>

#include "lang/tree_edit.h"
#include "model/resolver.h"
#include "model/set_targets.h"

namespace trundle {

namespace {

constexpr Code kNameErrors[] = {Code::UnknownKey, Code::UnknownReference, Code::DuplicateKey, Code::UnknownParam,
                                Code::WrongPlace, Code::DuplicateName,    Code::NoSuchPath};

const Diagnostic* nameErrorIn(const Diagnostics& diagnostics) {
    const auto& all = diagnostics.all();
    const auto found = std::ranges::find_if(
        all, [](const Diagnostic& d) { return d.severity == Severity::Error && std::ranges::count(kNameErrors, d.code) > 0; });
    return found == all.end() ? nullptr : &*found;
}

/// The directives of a text, those of imports by their paths.
struct Directives {
    std::vector<const ImportItem*> imports;
    std::size_t modules = 0;

    void collect(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (const auto* import = item.as<ImportItem>()) imports.push_back(import);
            if (item.as<ModuleItem>()) ++modules;
            if (const auto* block = item.as<BlockItem>()) collect(block->items);
        }
    }
};

/// Leads the imports of the edited tree to the files of those that it had before. False if there are others.
bool keepImports(const Tree& before, const Tree& after, TextSet& texts) {
    Directives was, is;
    was.collect(before.items());
    is.collect(after.items());
    if (is.modules > was.modules) return false;
    for (const ImportItem* import : is.imports) {
        const auto same = std::ranges::find(was.imports, import->path, &ImportItem::path);
        if (same == was.imports.end()) return false;
        const auto file = texts.imports.find(*same);
        if (file != texts.imports.end()) texts.imports[import] = FileId{file->second};
    }
    return true;
}

AssetLookup noAssets(const LoadedProject& loaded) {
    AssetLookup lookup;
    const Error none{Code::MeshUnreadable, "not read"};
    lookup.mesh = [none](const std::string&, FileId) -> Result<FoundAsset<TriangleMesh>> { return none; };
    lookup.heightMap = [none](const std::string&, FileId) -> Result<FoundAsset<HeightMap>> { return none; };
    lookup.texture = lookup.table = [none](const std::string&, FileId) -> Result<std::string> { return none; };
    lookup.picture = [none](const std::string&) -> Result<std::shared_ptr<const Raster>> { return none; };
    if (loaded.shapes) lookup.shapes = loaded.shapes;
    return lookup;
}

/// "in line 12" of the edited text, and the file where the edit is in several.
std::string placeIn(const LoadedProject& loaded, const TextSet& texts, const SourceRange& range) {
    if (!range.known()) return {};
    const SourceText& source = texts.trees[range.file]->source();
    return "in line " + std::to_string(source.position(range.range.begin).line) +
           (loaded.paths.size() > 1 ? " of " + source.path() : "") + ": ";
}

} // namespace

Status checkNames(const LoadedProject& loaded, const FileEdits& edits) {
    if (edits.empty() || nameErrorIn(loaded.diagnostics)) return {};
    auto texts = std::make_shared<TextSet>(loaded.outline->texts());
    for (const auto& [file, changes] : edits) {
        const Tree& before = *loaded.trees[file];
        Result<std::shared_ptr<const Tree>> after = applyEdits(before, changes);
        if (!after.ok() || !keepImports(before, *after.value(), *texts)) return {};
        texts->trees[file] = std::move(after).value();
    }
    Diagnostics diagnostics;
    const std::shared_ptr<Outline> outline = Outline::build(texts, loaded.registry, diagnostics);
    (void)applySets(*outline, diagnostics);
    (void)resolve(*outline, noAssets(loaded), diagnostics);
    const Diagnostic* error = nameErrorIn(diagnostics);
    if (!error) return {};
    return Error{error->code,
                 "the text would have an error after this, " + placeIn(loaded, *texts, error->range) + error->message};
}

} // namespace trundle
