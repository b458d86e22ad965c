#include "devices/builtin.h"

#include <trundle/device.h>

#include "devices/camera_device.h"
#include "devices/differential_drive.h"
#include "devices/encoder.h"
#include "devices/rotary_motor.h"
#include "devices/touch_sensor.h"
#include "devices/transceiver.h"

namespace trundle {

Status addDeviceKinds(Registry& registry) {
    const auto add = [&registry]<class T>(const T*, const char* name) {
        return registry.add(kindOf<T>(name, Role::Device, {"RobotConfig"}));
    };
    if (auto s = add(static_cast<const RotaryMotor*>(nullptr), "RotaryMotor"); !s) return s;
    if (auto s = add(static_cast<const DifferentialDrive*>(nullptr), "DifferentialDrive"); !s) return s;
    if (auto s = add(static_cast<const Encoder*>(nullptr), "Encoder"); !s) return s;
    if (auto s = add(static_cast<const Camera*>(nullptr), "Camera"); !s) return s;
    if (auto s = add(static_cast<const Transceiver*>(nullptr), "Transceiver"); !s) return s;
    return add(static_cast<const TouchSensor*>(nullptr), "TouchSensor");
}

const TrundleKind* findBuiltInDevice(std::string_view kind) {
    static const ModuleRegistry builtIn = [] { // immutable after construction
        ModuleRegistry r;
        r.device<RotaryMotor>("RotaryMotor");
        r.device<DifferentialDrive>("DifferentialDrive");
        r.device<Encoder>("Encoder");
        r.device<TouchSensor>("TouchSensor");
        r.device<Transceiver>("Transceiver");
        r.device<Camera>("Camera");
        return r;
    }();
    for (const auto& table : builtIn.tables())
        if (kind == table->kind.name) return &table->kind;
    return nullptr;
}

} // namespace trundle
