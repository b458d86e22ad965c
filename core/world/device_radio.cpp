#include "world/device_radio.h"

#include <cmath>

#include "world/world_device.h"
#include "world/world_radio.h"

namespace trundle {

namespace {

std::vector<double> listOf(const double* numbers, std::uint32_t count) {
    return numbers && count <= 100000 ? std::vector<double>(numbers, numbers + count) : std::vector<double>();
}

struct RadioCalls {
    static std::int32_t open(void* context, const TrundleRadioSettings* s, std::uint32_t* radio) {
        WorldDevice& d = *static_cast<WorldDevice*>(context);
        const DeviceHost& host = *d.host;
        Medium& medium = host.radio.medium();
        if (!s || s->size < sizeof(TrundleRadioSettings) || !host.objects.isBody(s->body)) {
            d.note("its radio has no body to sit on");
            return -1;
        }
        RadioDefinition r;
        r.path = d.path;
        const std::string antenna = s->antenna ? s->antenna : "";
        r.antenna = antennaNamed(host.experiment, antenna.empty() ? "isotropic" : antenna);
        if (!r.antenna) {
            d.note("there is no AntennaPattern " + antenna);
            return -1;
        }
        r.maxOutputPower = s->maxOutputPower;
        r.minReceivePower = s->minReceivePower;
        r.maxReceivePower = s->maxReceivePower;
        r.rssiStep = s->rssiStep;
        r.bitRate = s->bitRate;
        r.supply = s->supply;
        r.receiveCurrent = s->receiveCurrent;
        r.bufferLimit = s->bufferLimit;
        r.channel = s->channel;
        r.address = s->address;
        r.powerLevels = listOf(s->powerLevels, s->powerLevelCount);
        r.transmitCurrents = listOf(s->transmitCurrents, s->transmitCurrentCount);
        const bool sound = std::isfinite(r.maxOutputPower) && std::isfinite(r.minReceivePower) && r.bitRate >= 1 &&
                           r.bufferLimit > 0 && r.channel < 1000 && r.address < kBroadcastAddress;
        if (!sound || medium.find(r.path)) {
            d.note(sound ? "a device has one radio" : "the values of its radio are invalid");
            return -1;
        }
        const Pose mount{Vec3(s->position),
                         Quat(s->quaternion[0], s->quaternion[1], s->quaternion[2], s->quaternion[3]).normalized()};
        const RadioId id = host.radio.open(std::move(r), {s->body, d.robot, mount});
        if (radio) *radio = id;
        return 0;
    }

    static void state(void* context, std::uint32_t radio, TrundleRadioState* out) {
        const Medium& medium = static_cast<const ServiceContext*>(context)->host->radio.medium();
        if (!out || out->size < sizeof(TrundleRadioState) || radio >= medium.radioCount()) return;
        const RadioCounts& c = medium.counts(radio);
        out->address = medium.radio(radio).address;
        out->pending = static_cast<std::uint32_t>(medium.pending(radio));
        out->queued = static_cast<std::uint32_t>(medium.queued(radio));
        out->lqi = static_cast<std::uint32_t>(c.lastLqi);
        out->sent = c.sent;
        out->received = c.received;
        out->dropped = c.dropped;
        out->failed = c.refused + c.noChannel + c.noAck;
        out->rssi = c.lastRssi;
        out->energy = c.energy;
    }
};

} // namespace

const TrundleMountRadio* mountRadio() {
    static const TrundleMountRadio table{sizeof(TrundleMountRadio), 0, RadioCalls::open};
    return &table;
}

const TrundleServicesRadio* servicesRadio() {
    static const TrundleServicesRadio table{sizeof(TrundleServicesRadio), 0, RadioCalls::state};
    return &table;
}

} // namespace trundle
