#include "world/device_supply.h"

#include "world/world_chargers.h"
#include "world/world_device.h"
#include "world/world_objects.h"
#include "world/world_radio.h"
#include "world/world_supply.h"

namespace trundle {

namespace {

struct SupplyCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }
    static bool senses(void* context) { return caller(context).phase->calls == DevicePhase::Calls::Sense; }

    static std::int32_t voltage(void* context, double* now, double* nominal) {
        const RobotSupply* supply = caller(context).host->supply.find(caller(context).robot);
        if (!supply) return -1;
        if (now) *now = supply->voltage;
        if (nominal) *nominal = supply->nominal;
        return 0;
    }
    static void draw(void* context, double watts, double conductance) {
        if (senses(context)) caller(context).host->supply.draw(caller(context).robot, watts, conductance);
    }
    static void load(void* context, TrundleLoad* load) {
        const RobotSupply* supply = caller(context).host->supply.find(caller(context).robot);
        if (load) *load = supply ? supply->load : TrundleLoad{};
    }
    static void setVoltage(void* context, double voltage) {
        const ServiceContext& call = caller(context);
        if (!senses(context) || !call.device->isSupply || !call.mayShare("a supply's voltage")) return;
        call.host->supply.setVoltage(call.robot, voltage);
        if (voltage <= 0) call.host->radio.switchOff(call.robot);
    }

    static void offer(void* context, std::uint32_t geom, double volts, double amperes) {
        const ServiceContext& call = caller(context);
        if (call.acts() && call.mayShare("a charger") && call.host->objects.isGeom(geom))
            call.host->chargers.offer(call.device->index, geom, volts, amperes);
    }
    static void offered(void* context, std::uint32_t geom, TrundleOffer* offer) {
        if (offer) *offer = caller(context).device->isSupply ? caller(context).host->chargers.offered(geom) : TrundleOffer{};
    }
    static void take(void* context, std::uint32_t geom, double volts, double amperes) {
        const ServiceContext& call = caller(context);
        if (senses(context) && call.device->isSupply && call.mayShare("a charger"))
            call.host->chargers.take(geom, volts, amperes);
    }
    static void taken(void* context, TrundleTaken* taken) {
        if (taken) *taken = caller(context).host->chargers.taken(caller(context).device->index);
    }
};

} // namespace

const TrundleServicesSupply* servicesSupply() {
    static const TrundleServicesSupply table{sizeof(TrundleServicesSupply),
                                             0,
                                             SupplyCalls::voltage,
                                             SupplyCalls::draw,
                                             SupplyCalls::load,
                                             SupplyCalls::setVoltage,
                                             SupplyCalls::offer,
                                             SupplyCalls::offered,
                                             SupplyCalls::take,
                                             SupplyCalls::taken};
    return &table;
}

} // namespace trundle
