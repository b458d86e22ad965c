#include "control/module_store.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/platform/atomic_file.h"
#include "base/platform/read_file.h"
#include "control/elf_reader.h"
#include "control/kinds_json.h"
#include "control/module_file.h"
#include "control/module_kinds.h"
#include "control/python_kinds.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMaxDescriptionBytes = 16u << 20;
constexpr int kGlobalBinding = 1; // STB_GLOBAL in ELF

/// An absolute path, so that the loader does not search. Links are not resolved: the description is next to the given name.
std::string absolutePath(const std::string& path) {
    std::error_code ignored;
    const auto absolute = std::filesystem::absolute(path, ignored).lexically_normal();
    return absolute.empty() ? path : absolute.string();
}

/// The loader's message without its leading path; includes the symbol name if one is missing.
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

/// The libraries that `$ORIGIN` in a module refers to.
std::vector<std::string> librariesBeside(const std::string& path, const ElfReader& elf) {
    const std::string origin = std::filesystem::path(path).parent_path().string(), searched = elf.searched();
    std::vector<std::string> found;
    for (const std::string& name : elf.needs()) {
        for (std::size_t begin = 0; begin < searched.size();) {
            const std::size_t end = std::min(searched.find(':', begin), searched.size());
            std::string folder = searched.substr(begin, end - begin);
            begin = end + 1;
            bool own = false;
            for (const std::string_view mark : {"$ORIGIN", "${ORIGIN}"})
                if (const std::size_t at = folder.find(mark); at != std::string::npos) {
                    folder.replace(at, mark.size(), origin);
                    own = true;
                }
            std::error_code ignored;
            const std::filesystem::path library = std::filesystem::path(folder) / name;
            if (!std::filesystem::exists(library, ignored)) continue;
            if (own) found.push_back(library.string());
            break;
        }
    }
    return found;
}

/// A copy in memory has another $ORIGIN than the file. Libraries next to the file are therefore loaded first; the loader
/// recognises them by their soname. If a library has no soname, or memory is not available, the file itself is loaded and must
/// not be changed while it is in use.
Result<DynamicLibrary> openModule(const std::string& path, std::string bytes, std::vector<DynamicLibrary>& beside) {
    const ElfReader elf(bytes);
    for (const std::string& library : librariesBeside(path, elf))
        if (auto opened = DynamicLibrary::open(library)) beside.push_back(std::move(opened).value());
    // Unique symbols would be shared with earlier versions of the module, even with another size, and would keep it loaded.
    for (const std::size_t place : elf.uniqueBindings())
        bytes[place] = static_cast<char>((bytes[place] & 0xf) | kGlobalBinding << 4);
    auto copy = DynamicLibrary::openCopy(path, bytes);
    if (copy || copy.error().code == Code::ModuleMissingSymbol) return copy;
    return DynamicLibrary::open(path);
}

/// The description with the common controller fields and without help texts, which do not affect a run.
std::string contentOf(std::vector<Kind> kinds) {
    for (Kind& kind : kinds) {
        addControllerFields(kind);
        kind.help.clear();
        for (Property& property : kind.properties) property.help.clear();
        for (SignalDescription& signal : kind.signals) signal.help.clear();
    }
    std::ranges::sort(kinds, {}, &Kind::name);
    return kindsToJson(kinds);
}

std::vector<Kind> kindsFrom(const std::string& library, const Registry& registry) {
    std::vector<Kind> kinds;
    for (const Kind* kind : registry.all())
        if (kind->module == library) kinds.push_back(*kind);
    return kinds;
}

/// The current content of the description file next to a library; empty if it cannot be read.
std::optional<std::vector<Kind>> describedKinds(const std::string& library) {
    if (isPythonModule(library)) return cachedPythonKinds(library);
    const auto text = readRegularFile(kindsJsonPath(library), kMaxDescriptionBytes);
    if (!text) return {};
    auto kinds = kindsFromJson(text.value(), library);
    if (!kinds) return {};
    return std::move(kinds).value();
}

} // namespace

ModuleStore::~ModuleStore() {
    for (auto& module : m_modules) {
        const MonitoredCall call(*m_calls, module->target, "unload");
        module.reset();
    }
}

Result<const LoadedModule*> ModuleStore::load(const std::string& library) {
    const std::string path = absolutePath(library);
    for (const auto& module : m_modules)
        if (module->library == path) return static_cast<const LoadedModule*>(module.get());
    auto bytes = readModuleFile(path);
    if (!bytes) return bytes.error();
    std::vector<DynamicLibrary> beside;
    const CallTarget* target = m_calls->add({"the module " + path, {}, {}, path});
    const MonitoredCall call(*m_calls, target, "load");
    auto code = openModule(path, std::move(bytes).value(), beside);
    if (!code) return loaderError(path, code.error());
    for (const auto& [begin, end] : code.value().code()) m_calls->addCode(begin, end, target);
    const auto entry = code.value().function<const TrundleModule*()>(TRUNDLE_ENTRY_SYMBOL);
    if (!entry) return Error{Code::ModuleNoEntry, path + " exports no " TRUNDLE_ENTRY_SYMBOL};
    const TrundleModule* descriptor = entry();
    auto kinds = kindsOfModule(descriptor, path);
    if (!kinds) return kinds.error();
    auto module = std::make_unique<LoadedModule>(
        LoadedModule{path, std::move(beside), std::move(code).value(), descriptor, target, std::move(kinds).value()});
    if (auto status = checkNames(*module); !status) return status.error();
    for (const Kind& kind : module->kinds) m_calls->setModule(kind.name, path);
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

Result<std::vector<Kind>> ModuleStore::loadKinds(const std::string& library) {
    const auto module = load(library);
    if (!module) return module.error();
    return module.value()->kinds;
}

void loadModules(const ExperimentSpec& experiment, const Registry& registry, ModuleStore& store, Diagnostics& diagnostics) {
    loadModules(experiment, registry, [&store](const std::string& library) { return store.loadKinds(library); }, diagnostics);
}

void loadModules(const ExperimentSpec& experiment, const Registry& registry, const ModuleLoader& load, Diagnostics& diagnostics) {
    for (const ModuleSpec& spec : experiment.modules) {
        if (spec.library.empty()) continue; // already reported when it was not found
        const auto module = load(spec.library);
        if (!module) {
            diagnostics.error(module.error().code, spec.range, module.error().message).place = module.error().place;
            continue;
        }
        const auto described = describedKinds(spec.library);
        const std::vector<Kind> checked = kindsFrom(spec.library, registry);
        if (!described && checked.empty()) continue; // a missing description has its own warning
        const std::vector<Kind>& now = module.value();
        const bool isPython = isPythonModule(spec.library);
        const bool isOld = !isPython && (!described || kindsToJson(*described) != kindsToJson(now));
        const std::string old = kindsJsonPath(spec.library) + " no longer matches the module; build the module again";
        if (contentOf(checked) != contentOf(now))
            diagnostics.error(Code::ModuleDescriptionStale, spec.range,
                              isOld ? old
                                    : spec.library + (isPython ? " was changed" : " was rebuilt") +
                                          ": load the experiment again (in the window Ctrl+Shift+R)");
        else if (isOld) diagnostics.warning(Code::ModuleDescriptionStale, spec.range, old);
    }
}

bool descriptionChanged(const ExperimentSpec& experiment, const Registry& registry) {
    return std::ranges::any_of(experiment.modules, [&](const ModuleSpec& spec) {
        if (spec.library.empty()) return true;
        return contentOf(kindsFrom(spec.library, registry)) !=
               contentOf(describedKinds(spec.library).value_or(std::vector<Kind>()));
    });
}

Status writeKindsJson(const std::string& library, const std::string& out, std::shared_ptr<CallMonitor> calls) {
    ModuleStore store(std::move(calls));
    const auto module = store.load(library);
    if (!module) return module.error();
    return writeFileAtomically(out, kindsToJson(module.value()->kinds));
}

} // namespace trundle
