#include "control/module_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <set>

#include "base/clean_text.h"
#include "base/platform/module_text.h"
#include "base/units.h"
#include "model/component_spec.h"

namespace trundle {
namespace {

constexpr std::uint32_t kMaxKinds = 1000, kMaxFields = 1000, kMaxElements = 100000;
constexpr std::size_t kLongestText = 4000;
constexpr std::uint32_t kPublishedSince = 3, kMaxPublished = 1000; // minor ABI version; numbers per controller

struct CommonFields {
    double updatePeriod = 0, budget = 0;
    std::optional<std::string> isolation;
    static void describe(Describe<CommonFields>& d) {
        d.field("UpdatePeriod", &CommonFields::updatePeriod, seconds().within(0, 1e6),
                "Time between two updates; 0: every tick.");
        d.field("Isolation", &CommonFields::isolation, oneOf("none|module|robot"),
                "Which controllers share a process; not given: as the experiment says.");
        d.field("Budget", &CommonFields::budget, milliseconds().within(0, 1e9),
                "Time an update may take before it is reported as slow; 0: any.");
    }
};

bool isCommonField(const std::string& name) {
    return std::ranges::any_of(descriptionOf<CommonFields>().fields(),
                               [&](const FieldInfo& field) { return field.name == name; });
}

/// Reports what is wrong with a descriptor as a whole.
Status checkDescriptor(const TrundleModule* module, const std::string& library) {
    const auto fault = [&](Code code, const std::string& why) { return Status(Error{code, library + " " + why}); };
    if (!module) return fault(Code::ModuleNoEntry, "gives no description of itself: describing its kinds failed");
    if (module->magic != TRUNDLE_MAGIC)
        return fault(Code::ModuleWrongFormat, "has a bad magic number; it is not a Trundle module");
    if (module->abiMajor != TRUNDLE_ABI_MAJOR || module->abiMinor > TRUNDLE_ABI_MINOR) {
        const auto version = [](std::uint32_t major, std::uint32_t minor) {
            return std::to_string(major) + "." + std::to_string(minor);
        };
        const bool newer = module->abiMajor == TRUNDLE_ABI_MAJOR;
        return fault(Code::ModuleVersion, "is built for module interface " + version(module->abiMajor, module->abiMinor) +
                                              "; this program has " + version(TRUNDLE_ABI_MAJOR, TRUNDLE_ABI_MINOR) +
                                              (newer ? ": build the module again with this program's SDK, or use a newer Trundle"
                                                     : ": build the module again"));
    }
    if (module->size < sizeof(TrundleModule)) return fault(Code::ModuleWrongFormat, "has a description that is too short");
    if (module->kindCount > kMaxKinds || (module->kindCount > 0 && !module->kinds))
        return fault(Code::ModuleWrongFormat, "has a broken table of kinds");
    return {};
}

bool isTerminated(const char* text) { return moduleTextLength(text, kLongestText).has_value(); }

/// Copies the text of a table; `ok` becomes false if it is missing or not terminated.
std::string copied(const char* text, bool& ok) {
    if (!isTerminated(text)) {
        ok = false;
        return {};
    }
    return text;
}

bool copyField(const TrundleField& from, FieldInfo& to) {
    bool ok = true;
    to.name = copied(from.name, ok);
    to.unit = copied(from.unit, ok);
    to.help = cleanText(copied(from.help, ok));
    to.choices = copied(from.choices, ok);
    to.scale = from.scale;
    to.minimum = from.minimum;
    to.maximum = from.maximum;
    to.type = from.type;
    to.minCount = from.minCount;
    to.maxCount = from.maxCount;
    to.flags = from.flags;
    const TrundleValue& value = from.defaultValue;
    const bool numeric = from.type == TRUNDLE_NUMBER || from.type == TRUNDLE_INTEGER || from.type == TRUNDLE_BOOLEAN;
    if (value.count > kMaxElements || (value.count > 0 && !(numeric ? static_cast<const void*>(value.numbers) : value.texts)))
        return false;
    for (std::uint32_t i = 0; i < value.count; ++i) {
        if (numeric) to.defaultNumbers.push_back(value.numbers[i]);
        else to.defaultTexts.push_back(copied(value.texts[i], ok));
    }
    return ok;
}

bool hasFunctions(const TrundleKind& kind) {
    if (!kind.create || !kind.destroy || !kind.set || !kind.lastError) return false;
    return kind.role == TRUNDLE_CONTROLLER ? kind.setupController && kind.update : kind.setupDevice && (kind.act || kind.sense);
}

/// Size of a kind built before ABI 1.1, without the alternatives.
constexpr std::size_t kSizeWithoutAlternatives = offsetof(TrundleKind, alternatives);
constexpr std::size_t kSizeWithAlternatives = offsetof(TrundleKind, saveState);

bool copyAlternatives(const TrundleKind& from, Kind& to) {
    if (from.size < kSizeWithAlternatives) return true;
    if (from.alternativesCount > kMaxFields || (from.alternativesCount > 0 && !from.alternatives)) return false;
    bool ok = true;
    for (std::uint32_t i = 0; i < from.alternativesCount; ++i) {
        const TrundleAlternatives& a = from.alternatives[i];
        to.alternatives.push_back(alternativesFrom({copied(a.names, ok), copied(a.likely, ok)}));
    }
    return ok;
}

/// Copies one kind; an empty fault means success.
std::string copyKind(const TrundleKind& from, Kind& to) {
    bool ok = true;
    to.name = copied(from.name, ok);
    to.help = cleanText(copied(from.help, ok));
    if (!ok) return "has no name or no end";
    if (from.role != TRUNDLE_CONTROLLER && from.role != TRUNDLE_DEVICE) return "is neither a controller nor a device";
    if (!hasFunctions(from)) return "lacks one of its functions";
    const bool broken = from.fieldCount > kMaxFields || from.signalCount > kMaxFields || (from.fieldCount > 0 && !from.fields) ||
                        (from.signalCount > 0 && !from.signals);
    if (broken) return "has a broken table of fields or signals";
    const bool controller = from.role == TRUNDLE_CONTROLLER;
    to.role = controller ? Role::Controller : Role::Device;
    to.parents = controller ? std::vector<std::string>{"Robot", "Grid", "Scatter"} : std::vector<std::string>{"RobotConfig"};
    for (std::uint32_t i = 0; i < from.fieldCount; ++i) {
        FieldInfo field;
        if (!copyField(from.fields[i], field)) return "has a broken field, number " + std::to_string(i + 1);
        to.properties.push_back(propertyFrom(field));
    }
    for (std::uint32_t i = 0; i < from.signalCount; ++i) {
        const TrundleSignal& s = from.signals[i];
        to.signals.push_back(
            {copied(s.name, ok), copied(s.unit, ok), cleanText(copied(s.help, ok)), s.type, s.count, s.direction});
        for (std::uint32_t bits = s.countFields; bits != 0; bits >>= 16) {
            const std::uint32_t field = bits & 0xffff;
            ok = ok && field >= 1 && field <= from.fieldCount;
            if (ok) to.signals.back().countFields.push_back(to.properties[field - 1].name);
        }
        if (!ok) return "has a broken signal, number " + std::to_string(i + 1);
    }
    if (!copyAlternatives(from, to)) return "has a broken table of alternatives";
    return kindFault(to);
}

/// Before ABI 1.3 the signals of a controller had no meaning.
std::string publishedFault(const Kind& kind, std::uint32_t abiMinor) {
    if (kind.role != Role::Controller || abiMinor < kPublishedSince) return {};
    std::uint64_t numbers = 0;
    for (const SignalDescription& s : kind.signals) {
        if (s.direction != TRUNDLE_OUTPUT)
            return "has a signal " + s.name + " that is no output: a controller publishes outputs alone";
        numbers += s.count;
    }
    if (numbers <= kMaxPublished) return {};
    return "publishes " + std::to_string(numbers) + " numbers; at most " + std::to_string(kMaxPublished) + " are possible";
}

bool isName(const std::string& text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    if (text.empty() || !letter(text[0])) return false;
    for (const char c : text)
        if (!letter(c) && !(c >= '0' && c <= '9')) return false;
    return true;
}

std::string propertyFault(const Property& p) {
    if (!isName(p.name)) return "has a field whose name '" + p.name + "' is no name";
    const std::string field = "has a field " + p.name + " ";
    if (!std::isfinite(p.scale) || p.scale == 0) return field + "whose scale is no number";
    if (!(p.minimum <= p.maximum)) return field + "whose range is empty";
    if (p.minCount > p.maxCount || p.maxCount == 0 || p.maxCount > kMaxElements) return field + "whose count is none";
    if (p.type == PropertyType::Choice && p.choices.empty()) return field + "without choices";
    if (p.defaultValue && (p.defaultValue->count() < p.minCount || p.defaultValue->count() > p.maxCount))
        return field + "whose default has the wrong count";
    if (p.defaultValue)
        for (const double number : p.defaultValue->numbers)
            if (!std::isfinite(number)) return field + "whose default is not finite";
    if (p.defaultValue && p.type == PropertyType::Choice)
        for (const std::string& word : p.defaultValue->texts)
            if (std::find(p.choices.begin(), p.choices.end(), word) == p.choices.end())
                return field + "whose default is none of its choices";
    return {};
}

/// A signal whose count depends on fields needs a number for each of them.
std::string countFault(const Kind& kind, const SignalDescription& signal) {
    if (signal.count == 0 || signal.count > kMaxElements) return "has a signal " + signal.name + " of no size";
    for (const std::string& name : signal.countFields) {
        const Property* p = kind.find(name);
        const bool integer = p && p->type == PropertyType::Integer && p->minCount == 1 && p->maxCount == 1 && p->minimum >= 1 &&
                             (p->required || p->defaultValue);
        if (!integer || kind.role != Role::Device)
            return "has a signal " + signal.name + " counted by '" + name + "', which is no field with one positive integer";
    }
    return {};
}

/// Each alternative must be optional, otherwise there is no choice.
std::string alternativesFault(const Kind& kind, const Alternatives& alternatives) {
    if (alternatives.names.size() < 2) return "has a choice between fewer than two fields";
    for (const std::string& name : alternatives.names) {
        const Property* p = kind.find(name);
        if (!p) return "has a choice between fields with '" + name + "', which it does not have";
        if (p->required || p->defaultValue) return "has a choice between fields with " + name + ", which is always there";
    }
    if (!alternatives.likely.empty() && !kind.find(alternatives.likely)) return "likens a field to one that it does not have";
    return {};
}

} // namespace

std::string kindFault(const Kind& kind) {
    if (!isName(kind.name)) return "is no name";
    if (findUnit(kind.name))
        return "has the name of a unit, so it could be read as that of the number before it: choose another name";
    std::set<std::string> names;
    for (const Property& p : kind.properties) {
        if (auto fault = propertyFault(p); !fault.empty()) return fault;
        if (kind.role == Role::Controller && isCommonField(p.name))
            return "has a field " + p.name + ", which every controller has already: choose another name";
        if (!names.insert(p.name).second) return "has two fields named " + p.name;
    }
    for (const Alternatives& a : kind.alternatives)
        if (auto fault = alternativesFault(kind, a); !fault.empty()) return fault;
    names.clear();
    for (const SignalDescription& s : kind.signals) {
        if (!isName(s.name)) return "has a signal whose name '" + s.name + "' is no name";
        if (!names.insert(s.name).second) return "has two signals named " + s.name;
        if (auto fault = countFault(kind, s); !fault.empty()) return fault;
        if (s.type < TRUNDLE_REAL_SIGNAL || s.type > TRUNDLE_BOOLEAN_SIGNAL || s.direction < TRUNDLE_OUTPUT ||
            s.direction > TRUNDLE_TRUTH)
            return "has a signal " + s.name + " of an unknown type";
    }
    return {};
}

Result<std::vector<Kind>> kindsOfModule(const TrundleModule* module, const std::string& library) {
    if (auto status = checkDescriptor(module, library); !status) return status.error();
    std::vector<Kind> kinds;
    std::set<std::string> names;
    for (std::uint32_t i = 0; i < module->kindCount; ++i) {
        const TrundleKind* table = module->kinds[i];
        Kind kind;
        kind.module = library;
        std::string fault = !table || table->size < kSizeWithoutAlternatives ? "is too short" : copyKind(*table, kind);
        if (fault.empty()) fault = publishedFault(kind, module->abiMinor);
        if (fault.empty() && !names.insert(kind.name).second) fault = "is there twice";
        if (!fault.empty()) {
            const std::string name = kind.name.empty() ? "kind number " + std::to_string(i + 1) : "kind '" + kind.name + "'";
            return Error{Code::ModuleWrongFormat, library + " cannot be used: its " + name + " " + fault};
        }
        kinds.push_back(std::move(kind));
    }
    return kinds;
}

void addControllerFields(Kind& kind) {
    if (kind.role != Role::Controller) return;
    for (const FieldInfo& field : descriptionOf<CommonFields>().fields())
        if (!kind.find(field.name)) kind.properties.push_back(propertyFrom(field));
}

} // namespace trundle
