#pragma once
// Outside the test file, where moc takes `signals` for its keyword.
#include <string>

#include "control/module_kinds.h"

namespace trundle {

/// A module with one valid kind of each role; the fields of a test change one value.
struct Tables {
    double numbers[4] = {1, 2, 3, 4};
    const char* texts[1] = {"slow"};
    TrundleField fields[3] = {
        {"Speed", "m/s", "help", "", 1, 0, 2, TRUNDLE_NUMBER, 1, 1, 0, {numbers, nullptr, 1}},
        {"Mood", "", "help", "slow|fast", 1, 0, 0, TRUNDLE_CHOICE, 1, 1, 0, {nullptr, texts, 1}},
        {"Way", "m", "help", "", 1, -5, 5, TRUNDLE_NUMBER, 3, 3, TRUNDLE_OPTIONAL, {nullptr, nullptr, 0}},
    };
    TrundleSignal signals[2] = {{"where", "m", "help", TRUNDLE_REAL_SIGNAL, 3, TRUNDLE_OUTPUT, 0},
                                {"count", "", "help", TRUNDLE_INTEGER_SIGNAL, 1, TRUNDLE_OUTPUT, 0}};
    TrundleAlternatives alternatives[1] = {{"Way|Other", "Speed"}};
    TrundleKind kind{};
    const TrundleKind* kinds[2] = {&kind, nullptr};
    TrundleModule module{TRUNDLE_MAGIC, sizeof(TrundleModule), TRUNDLE_ABI_MAJOR, TRUNDLE_ABI_MINOR, "test", kinds, 1, 0};

    Tables() {
        kind.size = sizeof kind;
        kind.role = TRUNDLE_CONTROLLER;
        kind.name = "Walker";
        kind.help = "Walks.";
        kind.fields = fields;
        kind.fieldCount = 3;
        kind.signals = signals;
        kind.signalCount = 2;
        kind.create = [] { return static_cast<void*>(nullptr); };
        kind.destroy = [](void*) {};
        kind.set = [](void*, std::uint32_t, const TrundleValue*) { return std::int32_t{0}; };
        kind.lastError = [](void*) { return ""; };
        kind.setupController = [](void*, const TrundleRobot*) { return std::int32_t{0}; };
        kind.update = [](void*, double) { return std::int32_t{0}; };
    }
    void makeDevice() {
        kind.role = TRUNDLE_DEVICE;
        kind.setupDevice = [](void*, const TrundleMount*) { return std::int32_t{0}; };
        kind.act = [](void*, const TrundleServices*) { return std::int32_t{0}; };
    }
    [[nodiscard]] std::string fault() const {
        const auto result = kindsOfModule(&module, "lib.so");
        return result.ok() ? "" : codeName(result.error().code) + " " + result.error().message;
    }
};

} // namespace trundle
