#include "control/directory_catalog.h"

#include <algorithm>
#include <filesystem>

#include "base/platform/read_file.h"
#include "base/spelling.h"
#include "control/kinds_json.h"
#include "control/module_file.h"
#include "control/module_kinds.h"
#include "control/python_kinds.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kMaxDescriptionBytes = 16u << 20;

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// Resolves symbolic links and removes a trailing slash.
fs::path realPath(const fs::path& path) {
    std::error_code ignored;
    const fs::path result = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    return result.empty() ? path : result.has_filename() ? result : result.parent_path();
}

std::string absolutePath(const fs::path& path) {
    std::error_code ignored;
    return fs::absolute(path, ignored).lexically_normal().string();
}

bool isBelow(const fs::path& path, const fs::path& folder) {
    const fs::path inner = realPath(path), outer = realPath(folder);
    return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

std::string slashed(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

bool endsLike(const std::string& text, std::string_view ending) {
    if (text.size() < ending.size()) return false;
    return std::equal(ending.begin(), ending.end(), text.end() - static_cast<std::ptrdiff_t>(ending.size()),
                      [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

/// `d/n` without the library extension of any system.
fs::path stem(const std::string& written) {
    std::string path = slashed(written);
    for (const std::string_view ending : {".dll", ".so"})
        if (endsLike(path, ending)) {
            path.resize(path.size() - ending.size());
            break;
        }
    return path;
}

/// The sources that a module is to be built from, as `trundle-cli new` writes them: the folder of its name, or the one that holds
/// its build folder; empty: there are none.
fs::path sourcesOf(const fs::path& module, const std::vector<std::string>& places) {
    const fs::path built = module.parent_path();
    for (const std::string& place : places)
        for (const fs::path& folder : {module, built.filename() == "build" ? built.parent_path() : fs::path()})
            if (!folder.empty() && isThere(fs::path(place) / folder / "CMakeLists.txt")) return folder;
    return {};
}

bool climbs(const fs::path& path) { return std::find(path.begin(), path.end(), "..") != path.end(); }

Error notTrusted(const std::string& written, const fs::path& library) {
    return {Code::ModuleNotTrusted, "the module " + written +
                                        " is not run, its folder is not trusted; that is changed by Trust… in the window, or by "
                                        "--trust, or --modules with the "
                                        "folder, on a command line: " +
                                        library.string()};
}

std::string joined(const std::vector<std::string>& paths) {
    std::string text;
    for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + path;
    return text;
}

/// All modules in a folder and its direct subfolders, named as in #loadModule: controllers/linear_motion.
std::vector<std::string> modulesIn(const std::string& folder) {
    constexpr std::size_t kMaxLookedAt = 10'000;
    std::vector<std::string> names;
    std::error_code ignored;
    std::size_t looked = 0;
    for (fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, ignored), end;
         !ignored && at != end && looked < kMaxLookedAt; at.increment(ignored), ++looked) {
        if (at.depth() > 0) at.disable_recursion_pending();
        const fs::path file = at->path();
        const bool isPython = file.extension() == ".py";
        if ((file.extension() != ".so" && !isPython) || !at->is_regular_file(ignored)) {
            ignored.clear(); // a dangling link does not end the search
            continue;
        }
        std::string name = file.stem().string();
        if (name.starts_with("lib") && !isPython) name.erase(0, 3);
        if (isPython) name += ".py";
        names.push_back((at.depth() > 0 ? file.parent_path().filename() / name : fs::path(name)).string());
    }
    std::ranges::sort(names);
    return names;
}

/// The most likely intended module, if the name is misspelt or its folder is missing or wrong.
std::string nearestModule(const std::string& written, const std::vector<std::string>& folders) {
    std::vector<std::string> names;
    for (const std::string& folder : folders)
        if (!folder.empty())
            for (std::string& name : modulesIn(folder)) names.push_back(std::move(name));
    const std::string plain = fs::path(written).filename().string();
    for (const std::string& name : names)
        if (fs::path(name).filename() == plain) return name;
    const std::vector<std::string> near = nearestWords(written, names, 1);
    return near.empty() ? std::string() : near.front();
}

} // namespace

std::vector<std::string> moduleFileNames(const std::string& written) {
    const fs::path path = stem(written);
    const std::string folder = path.parent_path().string(), name = path.filename().string();
    const std::string plain = name.starts_with("lib") ? name.substr(3) : name; // for a name written as the file name libn.so
    std::vector<std::string> files{"lib" + name + ".so", name + ".so", "lib" + plain + ".so"};
    if (isPythonModule(name)) files = {name};
    else if (path == slashed(written)) files.push_back(name + ".py");
    std::vector<std::string> names;
    const auto add = [&](const std::string& where, const std::string& file) {
        const std::string full = where.empty() ? file : (fs::path(where) / file).string();
        if (std::find(names.begin(), names.end(), full) == names.end()) names.push_back(full);
    };
    for (const std::string& where : {folder, std::string()})
        for (const std::string& file : files)
            if (!fs::path(folder).is_absolute() || where == folder) add(where, file);
    return names;
}

DirectoryCatalog::DirectoryCatalog(CatalogFolders folders, PythonDescription python)
    : m_folders(std::move(folders)), m_python(std::move(python)) {}

bool DirectoryCatalog::isTrusted(const std::string& folder) const {
    if (m_folders.trustAll) return true;
    const auto below = [&](const std::string& trusted) { return !trusted.empty() && isBelow(folder, trusted); };
    return std::any_of(m_folders.modules.begin(), m_folders.modules.end(), below) ||
           std::any_of(m_folders.trusted.begin(), m_folders.trusted.end(), below) || below(m_folders.program);
}

/// The path of the library. Searches `folder`, then each --modules folder, then the program's module folder.
Result<std::string> DirectoryCatalog::locate(const std::string& written, const std::string& folder) const {
    std::vector<std::string> places{folder};
    places.insert(places.end(), m_folders.modules.begin(), m_folders.modules.end());
    if (!m_folders.program.empty()) places.push_back(m_folders.program);

    std::vector<std::string> tried;
    fs::path untrusted;
    for (const std::string& place : places) {
        for (const std::string& name : moduleFileNames(written)) {
            const fs::path path = (fs::path(place) / name).lexically_normal();
            if (std::find(tried.begin(), tried.end(), path.string()) != tried.end()) continue;
            tried.push_back(path.string());
            if (!isThere(path)) continue;
            // For an absolute path, or one that leaves the search folder with `..`, only the target's folder is checked for
            // trust; otherwise the search folder counts too.
            const bool leadsAway = climbs(name) || fs::path(name).is_absolute();
            if (isTrusted(path.parent_path().string()) || (!leadsAway && isTrusted(place))) return absolutePath(path);
            if (untrusted.empty()) untrusted = path;
        }
    }
    if (!untrusted.empty()) return notTrusted(written, untrusted);
    if (const fs::path sources = sourcesOf(stem(written), places); !sources.empty())
        return Error{Code::ModuleNotFound, "there is no module " + written + ", but sources in the folder " + sources.string() +
                                               ": build them, and name " + (sources / "build" / sources.filename()).string() +
                                               "; tried " + joined(tried)};
    std::vector<std::string> shelves = m_folders.modules; // without the experiment's folder, which may be a home folder
    shelves.push_back(m_folders.program);
    const std::string near = nearestModule(stem(written).string(), shelves);
    return Error{Code::ModuleNotFound, "there is no module " + written + (near.empty() ? "" : " (did you mean " + near + "?)") +
                                           "; tried " + joined(tried)};
}

std::string DirectoryCatalog::moduleWith(const std::string& kind) {
    if (!m_offered) {
        m_offered.emplace();
        for (const std::string& name : m_folders.program.empty() ? std::vector<std::string>() : modulesIn(m_folders.program)) {
            if (isPythonModule(name)) continue; // what comes with the program in Python is offered in C++
            if (const Result<ModuleListing> module = find(name, m_folders.program))
                for (const Kind& offered : module.value().kinds) m_offered->emplace(offered.name, name);
        }
    }
    const auto it = m_offered->find(kind);
    return it == m_offered->end() ? std::string() : it->second;
}

Result<ModuleListing> DirectoryCatalog::findPython(const std::string& file) const {
    ModuleListing listing{file, false, {}};
    if (m_python) {
        auto kinds = m_python(file);
        if (!kinds) return kinds.error();
        listing.described = true;
        listing.kinds = std::move(kinds).value();
    } else if (auto cached = cachedPythonKinds(file)) {
        listing.described = true;
        listing.kinds = std::move(*cached);
    }
    for (Kind& kind : listing.kinds) addControllerFields(kind);
    return listing;
}

Result<ModuleListing> DirectoryCatalog::find(const std::string& written, const std::string& folder) {
    if (stem(written).filename().empty())
        return Error{Code::ModuleNotFound, "there is no module '" + written + "': the path names no file"};
    const auto library = locate(written, folder);
    if (!library) return library.error();
    if (isPythonModule(library.value())) return findPython(library.value());
    if (auto status = checkModuleFile(library.value()); !status) return status.error();

    ModuleListing listing{library.value(), false, {}};
    const std::string description = kindsJsonPath(library.value());
    if (!isThere(description)) return listing;
    const auto text = readRegularFile(description, kMaxDescriptionBytes);
    if (!text) return Error{Code::ModuleUndescribed, text.error().message};
    auto kinds = kindsFromJson(text.value(), library.value());
    if (!kinds) return kinds.error();
    listing.described = true;
    listing.kinds = std::move(kinds).value();
    for (Kind& kind : listing.kinds) addControllerFields(kind);
    return listing;
}

} // namespace trundle
