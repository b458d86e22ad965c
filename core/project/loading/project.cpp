#include "project/loading/project.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "model/kinds/model_kinds.h"
#include "model/resolver.h"
#include "project/loading/error_limit.h"
#include "project/loading/loader.h"
#include "project/loading/members.h"
#include "project/loading/missing_imports.h"
#include "project/loading/modules.h"
#include "schema/value_reader.h"

namespace trundle {

namespace {

constexpr std::size_t kLargestTable = 16 << 20; ///< bytes

Result<std::string> readTable(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(kLargestTable + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (in.bad() || !in.is_open()) return Error{Code::FileUnreadable, path + " cannot be read"};
    if (text.size() > kLargestTable) return Error{Code::FileUnreadable, path + " holds more than 16 MiB"};
    return text;
}

/// Where imported files are looked for, in this order.
std::vector<std::string> importFolders(const std::string& projectFolder, const ProjectOptions& options) {
    std::vector<std::string> folders{projectFolder};
    folders.insert(folders.end(), options.includeFolders.begin(), options.includeFolders.end());
    folders.push_back(options.shippedConfigs);
    return folders;
}

/// The same for textures and meshes.
std::vector<std::string> pictureFolders(std::vector<std::string> folders, const ProjectOptions& options) {
    if (options.resources.empty()) return folders;
    for (const char* below : {"", "/textures", "/meshes"}) folders.push_back(options.resources + below);
    return folders;
}

bool isUsedElsewhere(const Diagnostic& d) { return !d.notes.empty() && d.notes[0].first == kUsedHere; }

/// Removes repeated errors: a wrong Param is reported once, however many properties use it.
std::vector<Diagnostic> oncePerValue(std::vector<Diagnostic> all) {
    std::map<SourceRange, std::size_t> first; // index in kept
    std::vector<Diagnostic> kept;
    std::vector<std::size_t> others;
    for (Diagnostic& d : all) {
        const bool isAtUse = !d.notes.empty() && d.notes[0].first == kGivenHere, isAtValue = isUsedElsewhere(d);
        if (isAtUse || isAtValue) {
            const auto [at, isNew] = first.emplace(isAtUse ? d.notes[0].second : d.range, kept.size());
            if (!isNew) {
                ++others[at->second];
                continue;
            }
        }
        kept.push_back(std::move(d));
        others.push_back(0);
    }
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (others[i])
            kept[i].message += " (the value is wrong in " + std::to_string(others[i]) +
                               (others[i] == 1 ? " other place too)" : " other places too)");
    return kept;
}

/// Sorts diagnostics by text order and removes duplicates, which arise if a config is resolved for several instances.
Diagnostics tidied(const Diagnostics& given, std::vector<Diagnostic> all) {
    std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.range.file, a.range.range.begin) < std::pair(b.range.file, b.range.range.begin);
    });
    Diagnostics tidy;
    std::set<std::tuple<int, SourceRange, std::string, SourceRange>> said;
    std::vector<Diagnostic> kept;
    for (Diagnostic& d : all) {
        const SourceRange use = isUsedElsewhere(d) ? d.notes[0].second : SourceRange();
        if (said.emplace(static_cast<int>(d.code), d.range, d.message, use).second) kept.push_back(std::move(d));
    }
    for (Diagnostic& d : kept)
        if (d.followUps)
            d.message += " (and in " + std::to_string(d.followUps) + (d.followUps == 1 ? " other place)" : " other places)");
    tidy.append(oncePerValue(std::move(kept)));
    tidy.addOmitted(given);
    tidy.summarize();
    return tidy;
}

constexpr std::size_t kFirstTokens = 250'000; // first limit, about 1 MiB of text
/// Later limits. What would become right only beyond them counts as wrong, so that the memory for a text of mistakes is bounded:
/// of warnings alone, which rarely do, sooner.
constexpr std::size_t kWarnedTokens = 2 * kFirstTokens, kPatientTokens = 4 * kFirstTokens;

FileStamp stampOf(const std::string& path) {
    const Result<FileStamp> stamp = regularFileStamp(path);
    return stamp ? stamp.value() : FileStamp{};
}

constexpr int kMostSuggestions = 100; ///< of missing files: each lists folders

AssetLookup assetsFrom(const std::vector<std::string>& folders, const FileSearch& search, MeshSource& meshes,
                       LoadedProject& loaded) {
    AssetLookup lookup;
    const auto folder = [&folders](FileId file) { return file < folders.size() ? folders[file] : std::string("."); };
    const auto find = [=, &search, &loaded](const std::string& written, FileId file, std::span<const std::string> endings = {}) {
        Result<std::string> path = search.find(written, folder(file), endings);
        if (!canBeFile(written)) return path; // it will not appear either
        const auto [named, isNew] = loaded.named.try_emplace({file, written});
        if (isNew && path) named->second = {path.value(), stampOf(path.value())};
        return path;
    };
    const auto missing = [&search, count = std::make_shared<int>(0)](const Error& error, const std::string& written,
                                                                     const std::string& from) {
        if (error.code != Code::ImportNotFound) return error;
        Error e{Code::MeshUnreadable, error.message};
        if (++*count > kMostSuggestions) return e;
        const std::vector<std::string> near = search.nearest(written, from);
        if (!near.empty()) e.message += "; did you mean " + near.front() + "?";
        return e;
    };
    lookup.mesh = [=, &meshes](const std::string& written, FileId file) -> Result<FoundAsset<TriangleMesh>> {
        Result<std::string> path = find(written, file);
        if (!path.ok()) return missing(path.error(), written, folder(file));
        Result<std::shared_ptr<const TriangleMesh>> mesh = meshes.mesh(path.value());
        if (!mesh.ok()) return mesh.error();
        return FoundAsset<TriangleMesh>{path.value(), mesh.value()};
    };
    lookup.heightMap = [=, &meshes](const std::string& written, FileId file) -> Result<FoundAsset<HeightMap>> {
        Result<std::string> path = find(written, file);
        if (!path.ok()) return missing(path.error(), written, folder(file));
        Result<std::shared_ptr<const HeightMap>> map = meshes.heightMap(path.value());
        if (!map.ok()) return map.error();
        return FoundAsset<HeightMap>{path.value(), map.value()};
    };
    lookup.table = [=](const std::string& written, FileId file) -> Result<std::string> {
        Result<std::string> path = find(written, file);
        if (!path.ok()) return Error{Code::FileUnreadable, missing(path.error(), written, folder(file)).message};
        return readTable(path.value());
    };
    lookup.texture = [=](const std::string& written, FileId file) -> Result<std::string> {
        static const std::string endings[] = {"jpg", "jpeg", "png"};
        Result<std::string> path = find(written, file, endings);
        if (path.ok()) return path;
        Error e = missing(path.error(), written, folder(file));
        return Error{e.code, "the picture " + e.message};
    };
    lookup.picture = [&meshes](const std::string& path) { return meshes.picture(path); };
    return lookup;
}

} // namespace

Project::Project(std::shared_ptr<const Registry> builtIn, ModuleCatalog& catalog, MeshSource& meshes, ProjectOptions options)
    : m_builtIn(std::move(builtIn)), m_catalog(catalog), m_meshes(meshes), m_options(std::move(options)) {}

/// A load that reads a limited amount of text.
struct Project::Attempt {
    std::shared_ptr<LoadedProject> loaded;
    Diagnostics diagnostics;      ///< in the order of their creation
    std::vector<Diagnostic> said; ///< with fixes added for modules and imports
    FileId limitedFile = kNoFile;
};

Result<std::shared_ptr<const LoadedProject>> Project::open(const std::string& path) {
    std::shared_ptr<const LoadedProject> previous = m_options.previous;
    for (std::size_t most = std::min(kFirstTokens, m_options.mostTokens);;) {
        Result<Attempt> tried = attempt(path, most, previous);
        if (!tried.ok()) return tried.error();
        Attempt& a = tried.value();
        const FileId limited = a.limitedFile;
        const bool ends =
            limited != kNoFile && (most >= kPatientTokens ? hasManyMistakes(a.diagnostics)
                                                          : (most >= kWarnedTokens && hasManyWarnings(a.diagnostics)) ||
                                                                hasTooManyErrors(*a.loaded->trees[limited], a.diagnostics));
        if (limited != kNoFile && !ends) {
            if (most == m_options.mostTokens) {
                a.loaded->diagnostics = tooManyTokens(*a.loaded->trees[limited], most); // other errors may come from the cut
                return std::shared_ptr<const LoadedProject>(std::move(a.loaded));
            }
            a.loaded->experiment.reset(); // of its parts only trees and shapes are reused
            a.loaded->outline.reset();
            a.loaded->named.clear();
            a.loaded->sources = {}; // with what of the file was read: it is read again
            a.loaded->trees[limited] = nullptr;
            previous = std::move(a.loaded); // its other trees can be reused
            most =
                std::min(most < kWarnedTokens && hasManyWarnings(a.diagnostics) ? kWarnedTokens : 4 * most, m_options.mostTokens);
            continue;
        }
        a.loaded->diagnostics = tidied(a.diagnostics, std::move(a.said));
        if (limited != kNoFile) a.loaded->diagnostics.addLast(restUnread(*a.loaded->trees[limited]));
        return std::shared_ptr<const LoadedProject>(std::move(a.loaded));
    }
}

Result<Project::Attempt> Project::attempt(const std::string& path, std::size_t mostTokens,
                                          std::shared_ptr<const LoadedProject> previous) {
    Attempt attempt;
    auto loaded = std::make_shared<LoadedProject>();
    loaded->projectFolder = projectFolderOf(path);
    loaded->importFolders = importFolders(loaded->projectFolder, m_options);
    if (!m_options.shippedConfigs.empty()) loaded->shippedConfigs = canonicalPath(m_options.shippedConfigs);
    const FileSearch imports(loaded->importFolders, &m_options.texts);
    const FileSearch pictures(pictureFolders(loaded->importFolders, m_options));

    Diagnostics& diagnostics = attempt.diagnostics;
    Loader loader(
        imports, diagnostics,
        {&m_options.texts, previous.get(), m_options.shownFromProject ? loaded->projectFolder : std::string(), mostTokens});
    if (Status status = loader.open(path); !status.ok()) return status.error();
    auto registry = std::make_shared<Registry>(withControllerProperties(*m_builtIn));
    FoundModules modules = findModules(loader.modules(), m_catalog, *registry, diagnostics);
    loader.addSets(m_options.sets);

    loaded->sources = loader.sources();
    loaded->parses = loader.parses();
    loaded->paths = loader.takePaths();
    const std::vector<std::string> fileFolders = loader.takeFolders();
    auto texts = std::make_shared<TextSet>(loader.takeTexts());
    texts->openModules = modules.open;
    loaded->trees = texts->trees;
    loaded->registry = registry;
    std::shared_ptr<Outline> outline = Outline::build(texts, registry, diagnostics);
    AppliedSets sets = applySets(*outline, diagnostics);
    AssetLookup assets = assetsFrom(fileFolders, pictures, m_meshes, *loaded);
    if (previous && previous->shapes) assets.shapes = previous->shapes;
    loaded->shapes = assets.shapes;
    std::shared_ptr<ExperimentSpec> experiment = resolve(*outline, assets, diagnostics);
    experiment->modules = std::move(modules.modules);
    loaded->pending = m_meshes.pending();
    for (const MemberPath& member : sets.members) reportReplaceBySingles(member, *outline, *experiment, diagnostics);
    loaded->sets = std::move(sets.targets);
    loaded->outline = std::move(outline);
    loaded->experiment = std::move(experiment);
    attempt.said = diagnostics.all();
    offerModules(*loaded, m_catalog, attempt.said);
    offerImports(*loaded, imports, loaded->importFolders, attempt.said);
    attempt.limitedFile = loader.limitedFile();
    attempt.loaded = std::move(loaded);
    return attempt;
}

} // namespace trundle
