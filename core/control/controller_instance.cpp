// The functions of a robot's table work on its signal image alone, so they are the same in the program and in a host process.
#include "control/controller_instance.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

#include "base/platform/module_text.h"
#include "base/rng.h"
#include "model/signal_count.h"
#include "schema/live_value.h"

namespace trundle {
namespace {

/// Random numbers drawn in setup must differ from those of tick 0.
constexpr std::uint64_t kSetupTick = std::numeric_limits<std::uint64_t>::max();

constexpr std::size_t kMostState = 64u << 20; // bytes

/// Modules that are built for an older interface have shorter tables.
bool savesState(const TrundleKind& code) {
    return code.size >= offsetof(TrundleKind, loadState) + sizeof code.loadState && code.saveState && code.loadState;
}

/// Each controller of a robot draws other random numbers; those of the first do not depend on the others.
std::string randomName(const RobotSpec& robot, std::size_t controller) {
    return controller == 0 ? robot.name : robot.name + "/" + robot.controllers[controller].name;
}

Status noPictures() { return Error{Code::NoGraphics, "this run takes no pictures"}; }

Status noSharedPictures() {
    return Error{Code::ControllerFailed, "its kind says that it is independent of other robots, and it asks for a picture"};
}

ControllerInstance& self(void* context) { return *static_cast<ControllerInstance*>(context); }

} // namespace

ControllerInstance::ControllerInstance(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
                                       const TrundleKind& code)
    : m_robot(robot), m_index(controller), m_code(code), m_noNumber(std::numeric_limits<double>::quiet_NaN()), m_seed(settings.seed),
      m_pathHash(fnv1a64(randomName(robot, controller))), m_tick(kSetupTick) {
    m_table.size = sizeof m_table;
    m_table.context = this;
    m_table.name = m_robot.name.c_str();
    m_table.tick = settings.tick;
    m_table.bind = &bind;
    m_table.time = &time;
    m_table.print = &print;
    m_table.fail = &fail;
    m_table.random = &random;
    m_table.openLog = &openLog;
    m_table.writeLog = &writeLog;
    m_table.signalInfo = &signalInfo;
    m_table.radio = &kRadio;
    m_cameras = {sizeof m_cameras, 0, this, &capture, &savePicture, &objectName, &cameraError};
    m_table.cameras = &m_cameras;
    m_table.publish = &publish;
    m_table.finish = &finish;
}

Status ControllerInstance::start(const SignalLayout& layout, SlotImages images, ControllerOutputs outputs) {
    stop();
    m_layout = &layout;
    m_images = images;
    m_outputs = std::move(outputs);
    m_failure.reset();
    m_gaveUp = false;
    m_tick = kSetupTick;
    m_draws = 0;
    m_instance = m_code.create();
    if (!m_instance) return failed("could not be made", m_code.lastError(nullptr));
    for (std::uint32_t i = 0; i < m_code.fieldCount; ++i)
        if (auto status = setField(i); !status) return status;
    const bool refused = m_code.setupController(m_instance, &m_table) != 0;
    m_gaveUp = m_failure.has_value();
    if (m_failure) return *m_failure; // a missing port is a better message than the setup error it caused
    if (refused) return failed("failed in setup", m_code.lastError(m_instance));
    return {};
}

Status ControllerInstance::tick(std::uint64_t tick, double time, double sinceLast) {
    if (!m_instance) return failed("was not started", nullptr);
    m_tick = tick;
    m_time = time;
    m_draws = 0;
    m_ticks = true;
    const bool stopped = m_code.update(m_instance, sinceLast) != 0;
    m_ticks = false;
    if (stopped) return failed("failed", m_code.lastError(m_instance));
    m_gaveUp = m_failure.has_value();
    if (m_failure) return *m_failure;
    return {};
}

Status ControllerInstance::set(const std::string& property, const PropertyValue& value) {
    return setLive(m_code, m_instance, "the controller of " + m_robot.name, property, value);
}

Result<std::string> ControllerInstance::saveState() {
    std::string state;
    if (!m_instance || !savesState(m_code)) return state;
    const auto write = [](void* to, const char* bytes, std::uint64_t count) {
        if (bytes) static_cast<std::string*>(to)->assign(bytes, count);
    };
    if (m_code.saveState(m_instance, write, &state) != 0) return failed("failed in saveState", m_code.lastError(m_instance));
    if (state.size() > kMostState) return failed("saved more than 64 MiB of state", nullptr);
    return state;
}

Status ControllerInstance::loadState(std::string_view state) {
    if (!m_instance || !savesState(m_code)) return {};
    if (m_code.loadState(m_instance, state.data(), state.size()) == 0) return {};
    return failed("failed in loadState", m_code.lastError(m_instance));
}

void ControllerInstance::stop() {
    if (m_instance) m_code.destroy(m_instance);
    m_instance = nullptr;
}

Error ControllerInstance::failed(const std::string& how, const char* why) const {
    const std::string reason = moduleMessage(why);
    const std::string title = spec() ? controllerTitle(m_robot, *spec()) : "the controller " + std::string(m_code.name) + " of " + m_robot.name;
    return {Code::ControllerFailed, title + " " + how + (reason.empty() ? "" : ": ") + reason};
}

Status ControllerInstance::setField(std::uint32_t index) {
    const ResolvedValue* given = spec() ? spec()->find(m_code.fields[index].name) : nullptr;
    if (!given) return {};
    const PropertyValue& value = given->value;
    std::vector<const char*> texts;
    for (const std::string& text : value.texts) texts.push_back(text.c_str());
    const TrundleField& field = m_code.fields[index];
    const bool numeric = field.type == TRUNDLE_NUMBER || field.type == TRUNDLE_INTEGER || field.type == TRUNDLE_BOOLEAN;
    const std::size_t count = numeric ? value.numbers.size() : texts.size();
    // The class reads as many elements as its member has: an outdated description must not make it read out of bounds.
    if (count < field.minCount || count > field.maxCount)
        return failed(std::string("cannot take the value of ") + field.name, "wrong count of elements");
    const TrundleValue crossing{value.numbers.data(), texts.data(), static_cast<std::uint32_t>(count)};
    if (m_code.set(m_instance, index, &crossing) == 0) return {};
    return failed(std::string("refuses the value of ") + field.name, m_code.lastError(m_instance));
}

double* ControllerInstance::bind(void* context, const char* kind, const char* device, const char* signal) {
    auto& me = self(context);
    const std::string ofKind = moduleName(kind), named = moduleName(device), asked = moduleName(signal);
    const auto entry = me.names().bind(ofKind, named, asked);
    if (entry && asked == "frame" && me.isAlwaysNew(ofKind, named)) return &me.m_noNumber;
    const bool isCommand = entry && entry.value().direction == SignalDirection::Command;
    const Status claimed = isCommand && me.m_outputs.claim ? me.m_outputs.claim(entry.value().path) : Status();
    if (entry && claimed) return me.slot(entry.value(), isCommand);
    if (!me.m_failure) me.m_failure = entry ? claimed.error() : entry.error();
    return nullptr;
}

double* ControllerInstance::slot(const SignalEntry& entry, bool writable) const {
    return (writable ? m_images.commands : m_images.sensors) + entry.offset;
}

/// A camera without a stream renders on request, so every image is new to its port.
bool ControllerInstance::isAlwaysNew(const std::string& kind, const std::string& device) const {
    if (kind != "Camera") return false;
    const auto named = [&](const ComponentSpec& component) { return component.name == device; };
    const auto found = std::ranges::find_if(m_robot.config->devices, named);
    return found != m_robot.config->devices.end() && !(found->number("UpdatePeriod") > 0);
}

double* ControllerInstance::publish(void* context, const char* signal, std::uint32_t* count) {
    auto& me = self(context);
    const auto entry = me.names().published(moduleName(signal));
    if (entry && count) *count = entry.value().count;
    if (entry) return me.slot(entry.value(), true);
    // A controller that came during the run publishes what this run has no signals for.
    for (const SignalDescription& described : me.spec() ? me.spec()->published : std::vector<SignalDescription>())
        if (described.name == moduleName(signal) && described.direction == TRUNDLE_OUTPUT) {
            std::vector<double>& values = me.m_unlisted[described.name];
            values.resize(signalCount(described, *me.spec()));
            if (count) *count = static_cast<std::uint32_t>(values.size());
            return values.data();
        }
    if (!me.m_failure) me.m_failure = entry.error();
    return nullptr;
}

void ControllerInstance::finish(void* context, const char* reason) {
    if (self(context).m_outputs.finish) self(context).m_outputs.finish(moduleMessage(reason));
}

std::int32_t ControllerInstance::signalInfo(void* context, const char* device, const char* signal, std::uint32_t* count,
                               std::uint32_t* direction) {
    auto& me = self(context);
    const auto entry = me.names().look(moduleName(device), moduleName(signal));
    if (!entry) return 1;
    if (count) *count = entry->count;
    if (direction) *direction = static_cast<std::uint32_t>(entry->direction);
    return 0;
}

double ControllerInstance::time(void* context) { return self(context).m_time; }

void ControllerInstance::print(void* context, std::int32_t severity, const char* text) {
    if (self(context).m_outputs.print) self(context).m_outputs.print(severity, moduleMessage(text));
}

void ControllerInstance::fail(void* context, const char* text) {
    auto& me = self(context);
    if (me.m_failure) return;
    me.m_failure = me.failed("gave up", text);
    if (me.m_outputs.gaveUp) me.m_outputs.gaveUp(moduleMessage(text));
}

std::uint64_t ControllerInstance::random(void* context) {
    auto& me = self(context);
    return randomBits(me.m_seed, me.m_pathHash, me.m_tick, me.m_draws++);
}

std::int32_t ControllerInstance::openLog(void* context, const char* fileName) {
    auto& me = self(context);
    if (!me.mayShare()) {
        print(context, TRUNDLE_ERROR, "its kind says that it is independent of other robots: it opens its logs in setup");
        return -1;
    }
    return me.m_outputs.openLog ? me.m_outputs.openLog(moduleName(fileName)) : -1;
}

void ControllerInstance::writeLog(void* context, std::int32_t log, const char* bytes, std::uint64_t count) {
    const auto& write = self(context).m_outputs.writeLog;
    if (write && log >= 0 && bytes) write(log, std::string_view(bytes, count));
}

std::int32_t ControllerInstance::reportStatus(const Status& status) {
    m_cameraError = status ? std::string() : status.error().message;
    return status ? 0 : 1;
}

std::int32_t ControllerInstance::capture(void* context, const char* camera, TrundlePicture* picture) {
    auto& me = self(context);
    if (!me.mayShare()) return me.reportStatus(noSharedPictures());
    if (!me.m_outputs.capture || !picture) return me.reportStatus(noPictures());
    const Result<const CameraImage*> taken = me.m_outputs.capture(moduleName(camera));
    if (!taken) return me.reportStatus(taken.error());
    const CameraImage& frame = *taken.value();
    TrundlePicture all{picture->size, frame.width, frame.height, 0, frame.time, frame.pixels.data(), nullptr, nullptr};
    if (!frame.depth.empty()) all.depth = frame.depth.data();
    if (!frame.objects.empty()) all.objects = frame.objects.data();
    std::memcpy(picture, &all, std::min<std::size_t>(picture->size, sizeof all));
    return me.reportStatus({});
}

std::int32_t ControllerInstance::savePicture(void* context, const char* camera, const char* fileName) {
    auto& me = self(context);
    if (!me.mayShare()) return me.reportStatus(noSharedPictures());
    return me.reportStatus(me.m_outputs.savePicture ? me.m_outputs.savePicture(moduleName(camera), moduleName(fileName))
                                                    : noPictures());
}

const char* ControllerInstance::objectName(void* context, std::uint32_t object) {
    auto& me = self(context);
    if (!me.m_outputs.objectName) return nullptr;
    me.m_objectName = me.m_outputs.objectName(object);
    return me.m_objectName.empty() ? nullptr : me.m_objectName.c_str();
}

const char* ControllerInstance::cameraError(void* context) { return self(context).m_cameraError.c_str(); }

std::int32_t ControllerInstance::findRadio(void* context, const char* component, std::uint32_t* radio) {
    auto& me = self(context);
    const auto entry = me.names().bind("Transceiver", moduleName(component), "rssi");
    const auto found = me.m_outputs.radios && !me.isIndependent()
                           ? me.m_outputs.radios->find(me.m_robot.name + "/" + moduleName(component))
                           : std::nullopt;
    if (found) {
        *radio = *found;
        return 0;
    }
    const char* const why =
        me.isIndependent() ? "says that it is independent of other robots, and asks for a radio" : "has no medium for its radio";
    if (!me.m_failure) me.m_failure = entry ? me.failed(why, nullptr) : entry.error();
    return 1;
}

std::uint32_t ControllerInstance::radioAddress(void* context, std::uint32_t radio) {
    const auto& me = self(context);
    return me.isRadio(radio) ? me.m_outputs.radios->address(radio) : 0;
}

std::int32_t ControllerInstance::sendPacket(void* context, std::uint32_t radio, const std::uint8_t* bytes, std::uint32_t count,
                               std::uint32_t to, double power) {
    const auto& me = self(context);
    return me.isRadio(radio) && me.m_outputs.radios->send(radio, {bytes, count}, to, power) ? 0 : 1;
}

std::int32_t ControllerInstance::receivePacket(void* context, std::uint32_t radio, TrundlePacket* out) {
    auto& me = self(context);
    if (!me.isRadio(radio) || !out || out->size < sizeof(TrundlePacket)) return 0;
    RadioPacket packet;
    if (!me.m_outputs.radios->receive(radio, packet)) return 0;
    out->count = static_cast<std::uint32_t>(std::min(packet.bytes.size(), sizeof out->bytes));
    std::copy_n(packet.bytes.begin(), out->count, out->bytes);
    out->time = packet.time;
    out->rssi = packet.rssi;
    out->lqi = static_cast<std::uint32_t>(packet.lqi);
    out->from = packet.from;
    out->to = packet.to;
    out->sequence = packet.sequence;
    return 1;
}

const TrundleRobotRadio ControllerInstance::kRadio{sizeof(TrundleRobotRadio), 0, &findRadio, &radioAddress, &sendPacket,
                                                   &receivePacket};

} // namespace trundle
