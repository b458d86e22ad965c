#include "control/module_store.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/platform/read_file.h"
#include "control/elf_reader.h"
#include "control/kinds_json.h"
#include "control/module_file.h"
#include "control/module_kinds.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMostDescriptionBytes = 16u << 20;
constexpr int kGlobalBinding = 1; // STB_GLOBAL of ELF

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

/// The libraries that `$ORIGIN` in a module leads to.
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

/// A copy has another origin than the file. What lies beside the file is therefore opened first: the loader knows it again by the
/// name that it gives itself. Where it gives none, or the system no memory, the file itself is opened: it must stay as it is then.
Result<DynamicLibrary> openModule(const std::string& path, std::string bytes, std::vector<DynamicLibrary>& beside) {
    const ElfReader elf(bytes);
    for (const std::string& library : librariesBeside(path, elf))
        if (auto opened = DynamicLibrary::open(library)) beside.push_back(std::move(opened).value());
    // Unique symbols would be shared with the module's earlier versions, whatever their size was there, and keep it loaded.
    for (const std::size_t place : elf.uniqueBindings())
        bytes[place] = static_cast<char>((bytes[place] & 0xf) | kGlobalBinding << 4);
    auto copy = DynamicLibrary::openCopy(path, bytes);
    if (copy || copy.error().code == Code::ModuleMissingSymbol) return copy;
    return DynamicLibrary::open(path);
}

/// Without words for people, which change nothing of a run, and with what every controller has.
std::string substanceOf(std::vector<Kind> kinds) {
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

/// What the file beside a library says now; nothing where there is none that can be read.
std::optional<std::vector<Kind>> describedKinds(const std::string& library) {
    const auto text = readRegularFile(kindsJsonPath(library), kMostDescriptionBytes);
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

void loadModules(const ExperimentSpec& experiment, const Registry& registry, ModuleStore& store, Diagnostics& diagnostics) {
    for (const ModuleSpec& spec : experiment.modules) {
        if (spec.library.empty()) continue; // said when it was not found
        const auto module = store.load(spec.library);
        if (!module) {
            diagnostics.error(module.error().code, spec.range, module.error().message);
            continue;
        }
        const auto described = describedKinds(spec.library);
        const std::vector<Kind> checked = kindsFrom(spec.library, registry);
        if (!described && checked.empty()) continue; // no description at all is another's warning
        const std::vector<Kind>& now = module.value()->kinds;
        const bool isOld = !described || kindsToJson(*described) != kindsToJson(now);
        const std::string old = kindsJsonPath(spec.library) + " no longer says what the module says; build the module again";
        if (substanceOf(checked) != substanceOf(now))
            diagnostics.error(Code::ModuleDescriptionStale, spec.range,
                              isOld ? old : spec.library + " was rebuilt: reload it (Ctrl+Shift+R)");
        else if (isOld) diagnostics.warning(Code::ModuleDescriptionStale, spec.range, old);
    }
}

bool describedAnew(const ExperimentSpec& experiment, const Registry& registry) {
    return std::ranges::any_of(experiment.modules, [&](const ModuleSpec& spec) {
        if (spec.library.empty()) return false;
        return substanceOf(kindsFrom(spec.library, registry)) !=
               substanceOf(describedKinds(spec.library).value_or(std::vector<Kind>()));
    });
}

} // namespace trundle
