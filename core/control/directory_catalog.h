#pragma once
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

/// Finds modules on disk. Runs none of their code: it inspects the library file and reads the description file next to it.
class DirectoryCatalog final : public ModuleCatalog {
public:
    explicit DirectoryCatalog(CatalogFolders folders);
    [[nodiscard]] Result<ModuleListing> find(const std::string& written, const std::string& folder) override;
    [[nodiscard]] std::string moduleWith(const std::string& kind) override;

private:
    [[nodiscard]] bool isTrusted(const std::string& folder) const;
    [[nodiscard]] Result<std::string> locate(const std::string& written, const std::string& folder) const;
    CatalogFolders m_folders;
    std::optional<std::map<std::string, std::string>> m_offered; // module by kind, loaded on first request
};

/// File names to try, in order, for `d/n` of a #loadModule: d/libn.so d/n.so libn.so n.so. Accepts `\` for `/` and drops .dll and
/// .so.
[[nodiscard]] std::vector<std::string> moduleFileNames(const std::string& written);

} // namespace trundle
