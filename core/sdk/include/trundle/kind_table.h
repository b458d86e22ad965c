// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Builds the C function table of a class with a describe(). Exceptions do not cross the ABI: each is caught here, and its text is
// returned by lastError.

#include <exception>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include <trundle/count_fields.h>
#include <trundle/describe.h>

namespace trundle {
inline namespace sdk1 {

class Device;
class Mount;
class Actuation;
class Sensing;

/// A TrundleKind and the memory that its pointers refer to. Never moves.
struct KindTable {
    TrundleKind kind{};
    std::string name;
    std::vector<TrundleField> fields;
    std::vector<TrundleSignal> signals;
    std::vector<TrundleAlternatives> alternatives;
    std::vector<std::vector<const char*>> defaultTexts;
};

namespace border {

/// The object behind a handle, and the error text of its last call.
template <class T> struct Instance {
    T object{};
    std::string error;
};

inline constexpr std::size_t kNoteBytes = 256;
/// Why an object could not be created, for lastError(NULL), since no object exists to store it.
inline char (&creationError())[kNoteBytes] {
    static thread_local char text[kNoteBytes] = "";
    return text;
}

/// The text of the exception that is being handled. Not part of guarded(), so that this is small enough to be inlined.
inline void describeException(std::string& error) noexcept {
    try {
        try {
            throw;
        } catch (const std::exception& e) { error = e.what(); } catch (...) {
            error = "an exception that is no std::exception";
        }
    } catch (...) {} // no memory for the text
}

template <class Call> std::int32_t guarded(std::string& error, Call&& call) {
    try {
        call();
        return 0;
    } catch (...) { describeException(error); }
    return 1;
}

template <class T> Instance<T>& at(void* handle) { return *static_cast<Instance<T>*>(handle); }

template <class T> void* create() {
    std::string error;
    Instance<T>* made = nullptr;
    if (guarded(error, [&] { made = new Instance<T>; }) != 0) {
        auto& note = creationError();
        note[error.copy(note, kNoteBytes - 1)] = '\0';
    }
    return made;
}
template <class T> void destroy(void* handle) {
    std::string error;
    guarded(error, [&] { delete static_cast<Instance<T>*>(handle); });
}
template <class T> std::int32_t set(void* handle, std::uint32_t field, const TrundleValue* value) {
    auto& instance = at<T>(handle);
    return guarded(instance.error, [&] {
        const FieldInfo& info = descriptionOf<T>().fields().at(field);
        info.set(&instance.object, *value);
    });
}
template <class T> const char* lastError(void* handle) { return handle ? at<T>(handle).error.c_str() : creationError(); }

inline TrundleField fieldTable(const FieldInfo& f, const std::vector<const char*>& texts) {
    TrundleField t{f.name.c_str(), f.unit.c_str(), f.help.c_str(), f.choices.c_str(), f.scale, f.minimum,
                   f.maximum,      f.type,         f.minCount,     f.maxCount,        f.flags, {nullptr, nullptr, 0}};
    t.defaultValue = {f.defaultNumbers.data(), texts.data(), static_cast<std::uint32_t>(f.defaultNumbers.size() + texts.size())};
    return t;
}

/// Everything of a table except the functions specific to its role.
template <class T> std::unique_ptr<KindTable> commonTable(const char* name, std::uint32_t role) {
    const Describe<T>& d = descriptionOf<T>();
    auto table = std::make_unique<KindTable>();
    table->name = name;
    table->defaultTexts.reserve(d.fields().size());
    for (const FieldInfo& f : d.fields()) {
        auto& texts = table->defaultTexts.emplace_back();
        for (const std::string& text : f.defaultTexts) texts.push_back(text.c_str());
        table->fields.push_back(fieldTable(f, texts));
    }
    for (const SignalInfo& s : d.signals())
        table->signals.push_back(
            {s.name.c_str(), s.unit.c_str(), s.help.c_str(), s.type, s.count, s.direction, countFieldBits(s, d.fields())});
    for (const AlternativesInfo& a : d.alternatives()) table->alternatives.push_back({a.names.c_str(), a.likely.c_str()});
    TrundleKind& k = table->kind;
    k.size = sizeof(TrundleKind);
    k.role = role;
    k.name = table->name.c_str();
    k.help = d.helpText().c_str();
    k.fields = table->fields.data();
    k.signals = table->signals.data();
    k.fieldCount = static_cast<std::uint32_t>(table->fields.size());
    k.signalCount = static_cast<std::uint32_t>(table->signals.size());
    k.alternatives = table->alternatives.data();
    k.alternativesCount = static_cast<std::uint32_t>(table->alternatives.size());
    k.traits = d.traits();
    k.create = &create<T>;
    k.destroy = &destroy<T>;
    k.set = &set<T>;
    k.lastError = &lastError<T>;
    return table;
}

template <class T, class OnRobot> std::int32_t setupDevice(void* handle, const TrundleMount* mount) {
    auto& instance = at<T>(handle);
    const std::int32_t failed = guarded(instance.error, [&] {
        OnRobot wrapped(*mount);
        wrapped.bindSignals(instance.object);
        instance.object.setup(wrapped);
        instance.error = wrapped.failure();
    });
    return failed || !instance.error.empty();
}
template <class T, class Acting> std::int32_t actDevice(void* handle, const TrundleServices* services) {
    auto& instance = at<T>(handle);
    return guarded(instance.error, [&] {
        Acting world(*services);
        instance.object.act(world);
    });
}
template <class T, class Asking> std::int32_t senseDevice(void* handle, const TrundleServices* services) {
    auto& instance = at<T>(handle);
    return guarded(instance.error, [&] {
        Asking world(*services);
        instance.object.sense(world);
    });
}

} // namespace border

// The real classes are default template arguments, so that this header does not include device.h.
template <class T, class Base = Device, class OnRobot = Mount, class Acting = Actuation, class Asking = Sensing>
std::unique_ptr<KindTable> deviceTable(const char* name) {
    static_assert(std::is_base_of_v<Base, T>, "a device derives from trundle::Device");
    auto table = border::commonTable<T>(name, TRUNDLE_DEVICE);
    table->kind.setupDevice = &border::setupDevice<T, OnRobot>;
    if constexpr (!std::is_same_v<decltype(&T::act), void (Base::*)(Acting&)>) table->kind.act = &border::actDevice<T, Acting>;
    if constexpr (!std::is_same_v<decltype(&T::sense), void (Base::*)(Asking&)>)
        table->kind.sense = &border::senseDevice<T, Asking>;
    return table;
}

} // namespace sdk1
} // namespace trundle
