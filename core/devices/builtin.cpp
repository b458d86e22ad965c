#include "devices/builtin.h"

#include <type_traits>

#include <trundle/device.h>

#include "devices/ackermann_drive.h"
#include "devices/battery.h"
#include "devices/belt.h"
#include "devices/camera_device.h"
#include "devices/charger.h"
#include "devices/compass.h"
#include "devices/differential_drive.h"
#include "devices/encoder.h"
#include "devices/force_sensor.h"
#include "devices/gps.h"
#include "devices/gripper.h"
#include "devices/ground_sensor.h"
#include "devices/imu.h"
#include "devices/latch_device.h"
#include "devices/led.h"
#include "devices/lidar.h"
#include "devices/light_sensor.h"
#include "devices/omni_drive.h"
#include "devices/pen.h"
#include "devices/range_sensor.h"
#include "devices/rotary_motor.h"
#include "devices/servo.h"
#include "devices/touch_sensor.h"
#include "devices/track_drive.h"
#include "devices/transceiver.h"

namespace trundle {

namespace {

/// Calls `visit` with the type and the name of each kind.
template <class Visit> void eachDevice(const Visit& visit) {
    visit(std::type_identity<RotaryMotor>(), "RotaryMotor");
    visit(std::type_identity<DifferentialDrive>(), "DifferentialDrive");
    visit(std::type_identity<Encoder>(), "Encoder");
    visit(std::type_identity<Camera>(), "Camera");
    visit(std::type_identity<Transceiver>(), "Transceiver");
    visit(std::type_identity<TouchSensor>(), "TouchSensor");
    visit(std::type_identity<RangeSensor>(), "RangeSensor");
    visit(std::type_identity<Lidar>(), "Lidar");
    visit(std::type_identity<Imu>(), "Imu");
    visit(std::type_identity<Compass>(), "Compass");
    visit(std::type_identity<Gps>(), "Gps");
    visit(std::type_identity<GroundSensor>(), "GroundSensor");
    visit(std::type_identity<LightSensor>(), "LightSensor");
    visit(std::type_identity<Servo>(), "Servo");
    visit(std::type_identity<LinearMotor>(), "LinearMotor");
    visit(std::type_identity<Battery>(), "Battery");
    visit(std::type_identity<Gripper>(), "Gripper");
    visit(std::type_identity<SkidDrive>(), "SkidDrive");
    visit(std::type_identity<Belt>(), "Belt");
    visit(std::type_identity<Track>(), "Track");
    visit(std::type_identity<TrackDrive>(), "TrackDrive");
    visit(std::type_identity<Pen>(), "Pen");
    visit(std::type_identity<OmniDrive>(), "OmniDrive");
    visit(std::type_identity<MecanumDrive>(), "MecanumDrive");
    visit(std::type_identity<AckermannDrive>(), "AckermannDrive");
    visit(std::type_identity<Led>(), "Led");
    visit(std::type_identity<Charger>(), "Charger");
    visit(std::type_identity<ForceSensor>(), "ForceSensor");
    visit(std::type_identity<Latch>(), "Latch");
}

} // namespace

Status addDeviceKinds(Registry& registry) {
    Status status;
    const auto add = [&]<class T>(std::type_identity<T>, const char* name) {
        if (status) status = registry.add(kindOf<T>(name, Role::Device, {"RobotConfig"}));
    };
    eachDevice(add);
    return status;
}

const TrundleKind* findBuiltInDevice(std::string_view kind) {
    static const ModuleRegistry builtIn = [] { // immutable after construction
        ModuleRegistry r;
        eachDevice([&r]<class T>(std::type_identity<T>, const char* name) { r.device<T>(name); });
        return r;
    }();
    for (const auto& table : builtIn.tables())
        if (kind == table->kind.name) return &table->kind;
    return nullptr;
}

} // namespace trundle
