#pragma once
// A device whose mount, act and sense are closures of the test.
#include <functional>
#include <map>
#include <string>

#include "world/fixtures.h"

namespace fixture {

/// One device: its mount, act and sense are closures; one per test, owned by the test.
struct Probe {
    std::function<std::int32_t(const TrundleMount&)> setup;
    std::function<std::int32_t(const TrundleServices&)> act, sense;
};

struct Bench {
    std::map<std::string, Probe> probes; ///< by the device's field Probe
};
inline Bench* bench = nullptr; // of the running test; the C tables carry no context before create()

struct ProbeDevice {
    std::string name;
    std::string error;
};

inline const TrundleSignal kProbeSignals[] = {{"in", "", "", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_COMMAND, 0},
                                              {"out", "", "", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT, 0}};
inline const TrundleField kProbeFields[] = {
    {"Probe", "", "", "", 1, 0, 0, TRUNDLE_TEXT, 1, 1, TRUNDLE_REQUIRED, {nullptr, nullptr, 0}}};

inline const TrundleKind* probeKind() {
    static const TrundleKind k{sizeof(TrundleKind),
                               TRUNDLE_DEVICE,
                               "Probe",
                               "",
                               kProbeFields,
                               kProbeSignals,
                               1,
                               2,
                               [] { return static_cast<void*>(new ProbeDevice); },
                               [](void* i) { delete static_cast<ProbeDevice*>(i); },
                               [](void* i, std::uint32_t, const TrundleValue* v) {
                                   static_cast<ProbeDevice*>(i)->name = v->texts[0];
                                   return std::int32_t{0};
                               },
                               [](void*) { return "the probe says no"; },
                               nullptr,
                               nullptr,
                               [](void* i, const TrundleMount* m) {
                                   auto& f = bench->probes[static_cast<ProbeDevice*>(i)->name].setup;
                                   return f ? f(*m) : 0;
                               },
                               [](void* i, const TrundleServices* s) {
                                   auto& f = bench->probes[static_cast<ProbeDevice*>(i)->name].act;
                                   return f ? f(*s) : 0;
                               },
                               [](void* i, const TrundleServices* s) {
                                   auto& f = bench->probes[static_cast<ProbeDevice*>(i)->name].sense;
                                   return f ? f(*s) : 0;
                               }};
    return &k;
}

inline const TrundleKind* code(const std::string& kind) { return kind == "Probe" ? probeKind() : rowOnly(kind); }

inline ComponentSpec probe(const std::string& name) {
    ComponentSpec spec;
    spec.kind = "Probe";
    spec.name = name;
    spec.values["Probe"] = textValue(name);
    spec.values["Gain"] = numberValue(2.5);
    return spec;
}

/// Robot R0 with these probes, before a wall whose face is at x = 2.
inline Scene withProbes(const std::vector<std::string>& names, const Pose& pose = {}) {
    Scene scene = r0Scene();
    auto config = std::make_shared<RobotConfigSpec>(*r0());
    for (const std::string& name : names) config->devices.push_back(probe(name));
    scene.scenery({plane("floor", {}, 1), box("wall", {0.2, 4, 1}, at(2.1, 0, 0.5), 3)}).robot("r", pose, config);
    return scene;
}

} // namespace fixture
