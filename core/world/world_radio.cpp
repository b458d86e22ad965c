// Poses of radios in the world, and the obstacles between them.
#include <algorithm>
#include <cmath>

#include "world/built_world.h"

namespace trundle {

namespace {

constexpr int kMaxSolids = 64;
constexpr double kPast = 1e-4; ///< m behind a surface, where the ray continues

std::vector<double> listOf(const double* numbers, std::uint32_t count) {
    return numbers && count <= 100000 ? std::vector<double>(numbers, numbers + count) : std::vector<double>();
}

} // namespace

/// Implementation of the radio tables of a mount (the context is the device) and of the services (the context is the world).
struct RadioCalls {
    static std::int32_t open(void* context, const TrundleRadioSettings* s, std::uint32_t* radio) {
        Device& d = *static_cast<Device*>(context);
        BuiltWorld& w = *d.world;
        if (!s || s->size < sizeof(TrundleRadioSettings) || s->body >= w.m_bodyPaths.size()) {
            d.note("its radio has no body to sit on");
            return -1;
        }
        RadioDefinition r;
        r.path = d.path;
        const std::string antenna = s->antenna ? s->antenna : "";
        r.antenna = antennaNamed(*w.m_experiment, antenna.empty() ? "isotropic" : antenna);
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
                           r.bufferLimit > 0 && r.channel < 1000 && r.address < kBroadcastAddress && w.m_medium;
        if (!sound || w.m_medium->find(r.path)) {
            d.note(sound ? "a device has one radio" : "the values of its radio are invalid");
            return -1;
        }
        const Pose mount{Vec3(s->position),
                         Quat(s->quaternion[0], s->quaternion[1], s->quaternion[2], s->quaternion[3]).normalized()};
        const RadioId id = w.m_medium->open(std::move(r));
        w.m_radioMounts.resize(id + 1);
        w.m_radioMounts[id] = {s->body, d.robot, mount};
        if (radio) *radio = id;
        return 0;
    }

    static void state(void* context, std::uint32_t radio, TrundleRadioState* out) {
        const BuiltWorld& w = *static_cast<BuiltWorld*>(context);
        if (!out || out->size < sizeof(TrundleRadioState) || radio >= w.m_radioMounts.size()) return;
        const RadioCounts& c = w.m_medium->counts(radio);
        out->address = w.m_medium->radio(radio).address;
        out->pending = static_cast<std::uint32_t>(w.m_medium->pending(radio));
        out->queued = static_cast<std::uint32_t>(w.m_medium->queued(radio));
        out->lqi = static_cast<std::uint32_t>(c.lastLqi);
        out->sent = c.sent;
        out->received = c.received;
        out->dropped = c.dropped;
        out->failed = c.refused + c.noChannel + c.noAck;
        out->rssi = c.lastRssi;
        out->energy = c.energy;
    }
};

const TrundleMountRadio* mountRadio() {
    static const TrundleMountRadio table{sizeof(TrundleMountRadio), 0, RadioCalls::open};
    return &table;
}

const TrundleServicesRadio* servicesRadio() {
    static const TrundleServicesRadio table{sizeof(TrundleServicesRadio), 0, RadioCalls::state};
    return &table;
}

void BuiltWorld::openMedium() {
    m_medium = std::make_unique<Medium>(m_experiment->medium);
    m_medium->setWalls(
        [this](RadioId first, const Vec3& a, RadioId second, const Vec3& b) { return solids(first, a, second, b); });
}

void BuiltWorld::placeRadios() {
    for (RadioId id = 0; id < m_radioMounts.size(); ++id) {
        const BodyState& s = m_engine->state({m_radioMounts[id].body});
        m_medium->place(id, Pose{s.position, s.rotation} * m_radioMounts[id].mount);
    }
}

/// Advances the medium by the tick that is about to be stepped, with the poses at its start.
void BuiltWorld::airTime() {
    if (!m_radioMounts.empty())
        m_medium->advance(std::llround(static_cast<double>(m_ticks + 1) * m_experiment->settings.tick * 1e6));
}

/// Number of solids between two radios, each counted once, without those of their own robots.
int BuiltWorld::solids(RadioId first, const Vec3& a, RadioId second, const Vec3& b) const {
    const Vec3 way = b - a;
    const double length = way.norm();
    if (length < kPast) return 0;
    const Vec3 direction = way / length;
    const std::string own[2] = {m_robots[m_radioMounts[first].robot].spec->name + "/",
                                m_robots[m_radioMounts[second].robot].spec->name + "/"};
    std::vector<std::uint32_t> met;
    double gone = 0;
    for (int i = 0; i < kMaxSolids && gone < length; ++i) {
        const auto hit =
            m_engine->ray(a + gone * direction, direction, length - gone, m_robots[m_radioMounts[first].robot].handles.actor);
        if (!hit) break;
        gone += hit->distance + kPast;
        const std::string& path = m_geomPaths[hit->geom.index];
        const bool isOwn = path.starts_with(own[0]) || path.starts_with(own[1]);
        if (!isOwn && std::find(met.begin(), met.end(), hit->geom.index) == met.end()) met.push_back(hit->geom.index);
    }
    return static_cast<int>(met.size());
}

} // namespace trundle
