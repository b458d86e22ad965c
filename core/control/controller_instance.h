#pragma once
// One controller of a module with the function table of its robot: the same code in this process and in a host process.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <trundle/abi.h>

#include "control/backend.h"
#include "control/port_names.h"
#include "schema/kind_traits.h"

namespace trundle {

/// The slots that a controller's pointers refer to, both with the offsets of the layout. In this process both are the block.
struct SlotImages {
    double* sensors = nullptr;  ///< outputs of devices and ground truth; mapped read-only in a host process
    double* commands = nullptr; ///< commands, and what the controller publishes
};

class ControllerInstance {
public:
    /// `controller`: its index in the robot; beyond the last: one of no text. `code` must outlive the object, as the module that
    /// it is from.
    ControllerInstance(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings, const TrundleKind& code);
    ControllerInstance(const ControllerInstance&) = delete;
    ControllerInstance& operator=(const ControllerInstance&) = delete;
    ~ControllerInstance() { stop(); }

    // As in ControllerBackend.
    [[nodiscard]] Status start(const SignalLayout& layout, SlotImages images, ControllerOutputs outputs);
    [[nodiscard]] Status tick(std::uint64_t tick, double time, double sinceLast);
    [[nodiscard]] Status set(const std::string& property, const PropertyValue& value);
    [[nodiscard]] Result<std::string> saveState();
    [[nodiscard]] Status loadState(std::string_view state);
    void stop();

    /// Whether the error of the last start() or tick() came from fail(), where the controller asked for the end of the run, or from a
    /// port that there is not. Otherwise it threw.
    [[nodiscard]] bool gaveUp() const { return m_gaveUp; }
    [[nodiscard]] const char* kind() const { return m_code.name; }
    [[nodiscard]] bool isIndependent() const { return trundle::isIndependent(m_code); }

private:
    /// False in an update of one that is independent: what it asks for is shared by robots, or put out at once.
    [[nodiscard]] bool mayShare() const { return !(m_ticks && isIndependent()); }
    [[nodiscard]] Error failed(const std::string& how, const char* why) const;
    [[nodiscard]] Status setField(std::uint32_t index);
    [[nodiscard]] const ControllerSpec* spec() const { return m_index < m_robot.controllers.size() ? &m_robot.controllers[m_index] : nullptr; }
    [[nodiscard]] PortNames names() const { return {m_robot, spec(), *m_layout}; }
    [[nodiscard]] double* slot(const SignalEntry& entry, bool writable) const;
    [[nodiscard]] bool isAlwaysNew(const std::string& kind, const std::string& device) const;
    std::int32_t reportStatus(const Status& status);
    [[nodiscard]] bool isRadio(std::uint32_t radio) const {
        return m_outputs.radios && !isIndependent() && m_outputs.radios->exists(radio);
    }

    // The functions of the tables; `context` is the ControllerInstance.
    static double* bind(void* context, const char* kind, const char* device, const char* signal);
    static double* publish(void* context, const char* signal, std::uint32_t* count);
    static void finish(void* context, const char* reason);
    static std::int32_t signalInfo(void* context, const char* device, const char* signal, std::uint32_t* count,
                                   std::uint32_t* direction);
    static double time(void* context);
    static void print(void* context, std::int32_t severity, const char* text);
    static void fail(void* context, const char* text);
    static std::uint64_t random(void* context);
    static std::int32_t openLog(void* context, const char* fileName);
    static void writeLog(void* context, std::int32_t log, const char* bytes, std::uint64_t count);
    static std::int32_t capture(void* context, const char* camera, TrundlePicture* picture);
    static std::int32_t savePicture(void* context, const char* camera, const char* fileName);
    static const char* objectName(void* context, std::uint32_t object);
    static const char* cameraError(void* context);
    static std::int32_t findRadio(void* context, const char* component, std::uint32_t* radio);
    static std::uint32_t radioAddress(void* context, std::uint32_t radio);
    static std::int32_t sendPacket(void* context, std::uint32_t radio, const std::uint8_t* bytes, std::uint32_t count,
                                   std::uint32_t to, double power);
    static std::int32_t receivePacket(void* context, std::uint32_t radio, TrundlePacket* out);
    static const TrundleRobotRadio kRadio;

    const RobotSpec m_robot; // a copy, because pointers to its name and values are passed to the controller
    const std::size_t m_index;
    const TrundleKind& m_code;
    TrundleRobot m_table{};
    TrundleCameras m_cameras{};
    std::string m_cameraError, m_objectName;
    std::map<std::string, std::vector<double>> m_unlisted; ///< published, but without a signal in this run
    double m_noNumber;
    void* m_instance = nullptr;
    const SignalLayout* m_layout = nullptr;
    SlotImages m_images;
    ControllerOutputs m_outputs;
    std::optional<Error> m_failure;
    bool m_gaveUp = false, m_ticks = false; ///< m_ticks: an update is under way
    std::uint64_t m_seed, m_pathHash, m_tick, m_draws = 0;
    double m_time = 0;
};

} // namespace trundle
