#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "project/sources.h"

namespace trundle {

struct CatalogFolders {
    std::vector<std::string> modules; ///< each --modules; trusted
    std::string program;              ///< the program's own module folder; trusted
    std::vector<std::string> trusted; ///< folders whose files may bring modules beside them
    bool trustAll = false;            ///< --trust
};

/// Finds modules on disk. Runs none of their code: it looks at the file and reads the description beside it.
class DirectoryCatalog final : public ModuleCatalog {
public:
    explicit DirectoryCatalog(CatalogFolders folders);
    [[nodiscard]] Result<ModuleListing> find(const std::string& written, const std::string& folder) override;
    [[nodiscard]] std::string moduleWith(const std::string& kind) override;

private:
    [[nodiscard]] bool isTrusted(const std::string& folder) const;
    [[nodiscard]] Result<std::string> locate(const std::string& written, const std::string& folder) const;
    CatalogFolders m_folders;
    std::optional<std::map<std::string, std::string>> m_offered; // module by kind, once somebody asked
};

/// `d/n` of a #loadModule as file names to try, in order: d/libn.so d/n.so libn.so n.so. Takes `\` for `/` and drops .dll and .so.
[[nodiscard]] std::vector<std::string> moduleFileNames(const std::string& written);

} // namespace trundle
