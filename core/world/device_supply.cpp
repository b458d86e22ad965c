#include "world/device_supply.h"

#include "world/world_device.h"
#include "world/world_radio.h"
#include "world/world_supply.h"

namespace trundle {

namespace {

struct SupplyCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }
    static bool senses(void* context) { return caller(context).phase->calls == DevicePhase::Calls::Sense; }

    static std::int32_t voltage(void* context, double* now, double* nominal) {
        const RobotSupply* supply = caller(context).host->supply.find(caller(context).device->robot);
        if (!supply) return -1;
        if (now) *now = supply->voltage;
        if (nominal) *nominal = supply->nominal;
        return 0;
    }
    static void draw(void* context, double watts, double conductance) {
        if (senses(context)) caller(context).host->supply.draw(caller(context).device->robot, watts, conductance);
    }
    static void load(void* context, TrundleLoad* load) {
        const RobotSupply* supply = caller(context).host->supply.find(caller(context).device->robot);
        if (load) *load = supply ? supply->load : TrundleLoad{};
    }
    static void setVoltage(void* context, double voltage) {
        const ServiceContext& call = caller(context);
        if (!senses(context) || !call.device->isSupply) return;
        call.host->supply.setVoltage(call.device->robot, voltage);
        if (voltage <= 0) call.host->radio.switchOff(call.device->robot);
    }
};

} // namespace

const TrundleServicesSupply* servicesSupply() {
    static const TrundleServicesSupply table{
        sizeof(TrundleServicesSupply), 0, SupplyCalls::voltage, SupplyCalls::draw, SupplyCalls::load, SupplyCalls::setVoltage};
    return &table;
}

} // namespace trundle
