#pragma once
// A host in memory: the C tables that a module gets, backed by maps, with a record of every call.
#include <map>
#include <string>
#include <vector>

#include <trundle/abi.h>

namespace sdktest {

struct Host {
    std::map<std::string, std::vector<double>> slots; ///< "base/odometry"
    std::map<std::string, std::uint32_t> directions;  ///< of those that signalInfo knows
    std::vector<std::string> calls;
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(2 * 3 * 3);
    std::vector<float> depth{1, 2, 3, 4, 5, 6};
    std::vector<std::uint32_t> objects{0, 1, 2, 3, 4, 5};
    std::vector<std::uint8_t> packet; ///< to be received; empty: none

    static Host& of(void* context) { return *static_cast<Host*>(context); }
    double* find(const std::string& path) {
        const auto it = slots.find(path);
        return it == slots.end() ? nullptr : it->second.data();
    }
    void record(std::string call) { calls.push_back(std::move(call)); }
    static std::string text(double value) {
        std::string s = std::to_string(value);
        return s.substr(0, s.find_last_not_of('0') + (s[s.find_last_not_of('0')] == '.' ? 0 : 1));
    }

    TrundleCameras cameras{sizeof(TrundleCameras),
                           0,
                           this,
                           [](void* c, const char* camera, TrundlePicture* p) -> std::int32_t {
                               if (std::string(camera) == "blind") return 1;
                               Host& h = of(c);
                               for (std::size_t i = 0; i < h.pixels.size(); ++i) h.pixels[i] = static_cast<std::uint8_t>(i);
                               *p = {p->size, 3, 2, 0, 0.5, h.pixels.data(), h.depth.data(), h.objects.data()};
                               return 0;
                           },
                           [](void* c, const char* camera, const char* file) -> std::int32_t {
                               of(c).record(std::string("save ") + camera + " " + file);
                               return std::string(file) == "no.png";
                           },
                           [](void*, std::uint32_t object) { return object == 7 ? "robot1/chassis" : nullptr; },
                           [](void*) { return "it is dark"; }};
    TrundleRobotRadio radio{
        sizeof(TrundleRobotRadio),
        0,
        [](void*, const char* name, std::uint32_t* id) -> std::int32_t { return std::string(name) == "radio" ? *id = 9, 0 : 1; },
        [](void*, std::uint32_t id) { return id * 100; },
        [](void* c, std::uint32_t id, const std::uint8_t* bytes, std::uint32_t count, std::uint32_t to,
           double power) -> std::int32_t {
            of(c).record("send " + std::to_string(id) + " " + std::string(bytes, bytes + count) + " to " + std::to_string(to) +
                         " " + text(power));
            return 0;
        },
        [](void* c, std::uint32_t, TrundlePacket* p) -> std::int32_t {
            Host& h = of(c);
            if (h.packet.empty()) return 0;
            *p = {p->size, static_cast<std::uint32_t>(h.packet.size()), 1.5, -60, 99, 3, 4, 17, {}};
            std::copy(h.packet.begin(), h.packet.end(), p->bytes);
            return 1;
        }};
    TrundleRobot robot{
        sizeof(TrundleRobot),
        0,
        this,
        "robot7",
        0.02,
        [](void* c, const char*, const char* component, const char* signal) {
            return of(c).find(std::string(component) + "/" + signal);
        },
        [](void*) { return 3.25; },
        [](void* c, std::int32_t severity, const char* t) { of(c).record("print " + std::to_string(severity) + " " + t); },
        [](void* c, const char* t) { of(c).record(std::string("fail ") + t); },
        [](void*) { return std::uint64_t{0xc000000000000000ull}; },
        [](void* c, const char* file) -> std::int32_t {
            of(c).record(std::string("open ") + file);
            return std::string(file) == "no.csv" ? -1 : 5;
        },
        [](void* c, std::int32_t log, const char* bytes, std::uint64_t count) {
            of(c).record("write " + std::to_string(log) + " " + std::string(bytes, count));
        },
        [](void* c, const char* component, const char* signal, std::uint32_t* count, std::uint32_t* direction) -> std::int32_t {
            const std::string path = std::string(component) + "/" + signal;
            const auto it = of(c).directions.find(path);
            if (it == of(c).directions.end()) return 1;
            *direction = it->second;
            if (const auto slot = of(c).slots.find(path); slot != of(c).slots.end())
                *count = static_cast<std::uint32_t>(slot->second.size());
            return 0;
        },
        &cameras,
        &radio,
        [](void* c, const char* name, std::uint32_t* count) {
            *count = 2;
            return of(c).find(std::string("brain/") + name);
        },
        [](void* c, const char* why) { of(c).record(std::string("finish ") + why); }};
};

} // namespace sdktest
