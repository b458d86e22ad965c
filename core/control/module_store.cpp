#include "control/module_store.h"

#include <filesystem>

#include "base/platform/read_file.h"
#include "control/kinds_json.h"
#include "control/module_file.h"
#include "control/module_kinds.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMostDescriptionBytes = 16u << 20;

/// Never a bare name for the loader to search for. Links stay: the description lies beside the name that was given.
std::string absolutePath(const std::string& path) {
    std::error_code ignored;
    const auto absolute = std::filesystem::absolute(path, ignored).lexically_normal();
    return absolute.empty() ? path : absolute.string();
}

/// The loader's own words, without the path that they start with, and the symbol's name where one is missing.
Error loaderError(const std::string& path, const Error& error) {
    std::string words = error.message;
    if (words.starts_with(path + ": ")) words.erase(0, path.size() + 2);
    if (error.code == Code::ModuleMissingSymbol) {
        constexpr std::string_view mark = "undefined symbol: ";
        const std::size_t at = words.find(mark);
        const std::string symbol = at == std::string::npos ? words : words.substr(at + mark.size());
        return {error.code,
                path + " needs the symbol " + symbol + ", which nothing provides; link what defines it into the module"};
    }
    return {error.code, path + " cannot be opened: " + words};
}

/// Whether the description beside a library still says what the library says; empty where there is none to compare.
bool isStale(const LoadedModule& module) {
    const auto text = readRegularFile(kindsJsonPath(module.library), kMostDescriptionBytes);
    if (!text) return false;
    const auto described = kindsFromJson(text.value(), module.library);
    return !described || kindsToJson(described.value()) != kindsToJson(module.kinds);
}

} // namespace

Result<const LoadedModule*> ModuleStore::load(const std::string& library) {
    const std::string path = absolutePath(library);
    for (const auto& module : m_modules)
        if (module->library == path) return static_cast<const LoadedModule*>(module.get());
    if (auto status = checkModuleFile(path); !status) return status.error();
    auto code = DynamicLibrary::open(path);
    if (!code) return loaderError(path, code.error());
    const auto entry = code.value().function<const TrundleModule*()>(TRUNDLE_ENTRY_SYMBOL);
    if (!entry) return Error{Code::ModuleNoEntry, path + " exports no " TRUNDLE_ENTRY_SYMBOL};
    const TrundleModule* descriptor = entry();
    auto kinds = kindsOfModule(descriptor, path);
    if (!kinds) return kinds.error();
    auto module =
        std::make_unique<LoadedModule>(LoadedModule{path, std::move(code).value(), descriptor, std::move(kinds).value()});
    if (auto status = checkNames(*module); !status) return status.error();
    m_modules.push_back(std::move(module));
    return static_cast<const LoadedModule*>(m_modules.back().get());
}

Status ModuleStore::checkNames(const LoadedModule& module) const {
    for (const auto& other : m_modules)
        for (const Kind& mine : module.kinds)
            for (const Kind& its : other->kinds)
                if (mine.name == its.name)
                    return Error{Code::ModuleDuplicateKind,
                                 "two modules bring the kind " + mine.name + ": " + other->library + " and " + module.library};
    return {};
}

const LoadedModule* ModuleStore::owner(std::string_view kind, std::uint32_t role) const {
    const Role wanted = role == TRUNDLE_CONTROLLER ? Role::Controller : Role::Device;
    for (const auto& module : m_modules)
        for (const Kind& k : module->kinds)
            if (k.name == kind && k.role == wanted) return module.get();
    return nullptr;
}

const TrundleKind* ModuleStore::find(std::string_view kind, std::uint32_t role) const {
    const LoadedModule* module = owner(kind, role);
    if (!module) return nullptr;
    for (std::uint32_t i = 0; i < module->descriptor->kindCount; ++i) {
        const TrundleKind* table = module->descriptor->kinds[i];
        if (table->role == role && kind == table->name) return table;
    }
    return nullptr;
}

void loadModules(const ExperimentSpec& experiment, ModuleStore& store, Diagnostics& diagnostics) {
    for (const ModuleSpec& spec : experiment.modules) {
        if (spec.library.empty()) continue; // said when it was not found
        const auto module = store.load(spec.library);
        if (!module) {
            diagnostics.error(module.error().code, spec.range, module.error().message);
        } else if (isStale(*module.value())) {
            diagnostics.warning(Code::ModuleDescriptionStale, spec.range,
                                kindsJsonPath(module.value()->library) +
                                    " no longer says what the module says; build the module again");
        }
    }
}

} // namespace trundle
