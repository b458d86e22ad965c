#pragma once
// A shipped controller, loaded from its built module and called tick by tick with scripted signals, images, packets and random
// numbers, so that each of its decisions can be checked exactly.
#include <QtTest>

#include <cmath>
#include <deque>
#include <map>
#include <numbers>

#include "base/platform/dynamic_library.h"
#include "sdk/host.h"

namespace sdktest {

inline constexpr double kDegree = std::numbers::pi / 180;

/// The host of a scripted controller: its clock, random numbers, image and packets are set by the test.
struct Script : Host {
    struct Heard {
        std::vector<std::uint8_t> bytes;
        double rssi = 0;
        std::uint32_t from = 0;
    };
    double now = 0;
    std::deque<double> randoms; ///< in [0, 1), taken one by one; 0.5 when there are no more
    std::deque<Heard> heard;    ///< packets that wait in the radio
    std::uint32_t width = 0, height = 0;
    bool blind = false, keepsPictures = true;

    static Script& script(void* context) { return static_cast<Script&>(of(context)); }

    Script() {
        for (const char* signal :
             {"linearVelocity", "angularVelocity", "linearAmount", "angularAmount", "sequence", "done", "busy", "finished"})
            slots[std::string("base/") + signal] = {0};
        for (const char* other :
             {"frontTouch/pressed", "frontTouch/force", "frontTouch/count", "eye/frame", "eye/time", "brain/hops", "brain/cost"})
            slots[other] = {0};
        slots["base/odometry"] = {0, 0, 0};
        directions["base/"] = 0;
        robot.time = [](void* c) { return script(c).now; };
        robot.random = [](void* c) -> std::uint64_t {
            Script& s = script(c);
            double next = 0.5;
            if (!s.randoms.empty()) next = s.randoms.front(), s.randoms.pop_front();
            return static_cast<std::uint64_t>(next * 0x1p53) << 11;
        };
        robot.publish = [](void* c, const char* name, std::uint32_t* count) {
            *count = 1;
            return of(c).find(std::string("brain/") + name);
        };
        radio.receive = [](void* c, std::uint32_t, TrundlePacket* p) -> std::int32_t {
            Script& s = script(c);
            if (s.heard.empty()) return 0;
            const Heard next = s.heard.front();
            s.heard.pop_front();
            *p = {p->size, static_cast<std::uint32_t>(next.bytes.size()), s.now, next.rssi, 99, next.from, 0xffff, 0, {}};
            std::copy(next.bytes.begin(), next.bytes.end(), p->bytes);
            return 1;
        };
        radio.send = [](void* c, std::uint32_t, const std::uint8_t* bytes, std::uint32_t count, std::uint32_t to,
                        double power) -> std::int32_t {
            std::string call = "send";
            for (std::uint32_t i = 0; i < count; ++i) call += ' ' + std::to_string(bytes[i]);
            of(c).record(call + " to " + std::to_string(to) + " with " + text(power));
            return 0;
        };
        cameras.capture = [](void* c, const char*, TrundlePicture* p) -> std::int32_t {
            Script& s = script(c);
            *p = {p->size, s.width, s.height, 0, s.now, s.pixels.data(), nullptr, nullptr};
            return s.blind;
        };
        cameras.save = [](void* c, const char* camera, const char* file) -> std::int32_t {
            of(c).record(std::string("save ") + camera + ' ' + file);
            return !script(c).keepsPictures;
        };
    }
};

/// One controller of a module in the folder of the shipped modules.
class ScriptedController {
public:
    using Values = std::map<std::string, std::vector<double>>; ///< SI, by field

    Script host;

    ScriptedController(const std::string& module, const std::string& kind, const Values& values = {}) {
        auto library = trundle::DynamicLibrary::open(TRUNDLE_BINARY_DIR "/lib/trundle/" + module);
        if (!library) qFatal("%s", library.error().message.c_str());
        library.value().keepLoaded(); // its tables are used until the test ends
        const TrundleModule* table = library.value().function<const TrundleModule*()>(TRUNDLE_ENTRY_SYMBOL)();
        for (std::uint32_t i = 0; i < table->kindCount; ++i)
            if (table->kinds[i]->name == kind) m_kind = table->kinds[i];
        if (!m_kind) qFatal("no %s in %s", kind.c_str(), module.c_str());
        m_instance = m_kind->create();
        for (const auto& [field, numbers] : values) set(field, numbers);
    }
    ~ScriptedController() { m_kind->destroy(m_instance); }
    ScriptedController(const ScriptedController&) = delete;
    ScriptedController& operator=(const ScriptedController&) = delete;

    [[nodiscard]] const TrundleKind& kind() const { return *m_kind; }
    /// Sets a field of numbers or of one text.
    void set(const std::string& field, const std::vector<double>& numbers, const char* text = nullptr) {
        for (std::uint32_t i = 0; i < m_kind->fieldCount; ++i) {
            if (m_kind->fields[i].name != field) continue;
            const TrundleValue value{numbers.data(), &text, text ? 1 : static_cast<std::uint32_t>(numbers.size())};
            if (m_kind->set(m_instance, i, &value) == 0) return;
        }
        qFatal("no field %s", field.c_str());
    }
    bool setup() { return m_kind->setupController(m_instance, &host.robot) == 0; }
    /// One update at this time.
    void update(double time) {
        host.now = time;
        if (m_kind->update(m_instance, 0) != 0) host.record(std::string("failed: ") + m_kind->lastError(m_instance));
    }
    /// One update at the time of the last one.
    void update() { update(host.now); }

    /// The command that the drive has: "v w", with amounts "v w for a b, number n".
    [[nodiscard]] QString command() {
        const auto value = [this](const char* signal) { return Host::text(drive(signal) + 0.0); }; // never -0
        std::string text = value("linearVelocity") + ' ' + value("angularVelocity");
        if (drive("linearAmount") != 0 || drive("angularAmount") != 0)
            text += " for " + value("linearAmount") + ' ' + value("angularAmount") + ", number " + value("sequence");
        return QString::fromStdString(text);
    }
    [[nodiscard]] double& drive(const std::string& signal) { return host.slots.at("base/" + signal).front(); }
    /// The amount that was commanded last has been driven.
    void arrive() { drive("finished") = drive("sequence"); }
    void stand(double x, double y, double heading) { host.slots["base/odometry"] = {x, y, heading}; }
    void touch(bool pressed) { host.slots["frontTouch/pressed"] = {pressed ? 1.0 : 0.0}; }
    /// What it printed, opened, wrote, saved or sent since the last call, joined by " | ".
    [[nodiscard]] QString calls() {
        QStringList all;
        for (const std::string& call : std::exchange(host.calls, {})) all << QString::fromStdString(call);
        return all.join(" | ");
    }

private:
    const TrundleKind* m_kind = nullptr;
    void* m_instance = nullptr;
};

} // namespace sdktest
