#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "project/loading/sources.h"

namespace trundle {

struct CatalogFolders {
    std::vector<std::string> modules; ///< each --modules; trusted
    std::string program;              ///< the program's own module folder; trusted
    std::vector<std::string> trusted; ///< folders whose files may load modules located next to them
    bool trustAll = false;            ///< --trust
};

/// Describes a trusted Python file; its code runs, in another process.
using PythonDescription = std::function<Result<std::vector<Kind>>(const std::string& file)>;

/// Finds modules on disk. Runs no code of a library: it inspects the file and reads the description file next to it. A Python file
/// is described by `python`, or without that from the user's cache alone.
class DirectoryCatalog final : public ModuleCatalog {
public:
    explicit DirectoryCatalog(CatalogFolders folders, PythonDescription python = {});
    [[nodiscard]] Result<ModuleListing> find(const std::string& written, const std::string& folder) override;
    [[nodiscard]] std::string moduleWith(const std::string& kind) override;

private:
    [[nodiscard]] bool isTrusted(const std::string& folder) const;
    [[nodiscard]] Result<std::string> locate(const std::string& written, const std::string& folder) const;
    [[nodiscard]] Result<ModuleListing> findPython(const std::string& file) const;
    CatalogFolders m_folders;
    PythonDescription m_python;
    std::optional<std::map<std::string, std::string>> m_offered; // module by kind, loaded on first request
};

/// File names to try, in order, for `d/n` of a #loadModule: d/libn.so d/n.so d/n.py libn.so n.so n.py; for `d/n.py` the .py alone.
/// Accepts `\` for `/` and drops .dll and .so.
[[nodiscard]] std::vector<std::string> moduleFileNames(const std::string& written);

} // namespace trundle
