#include "devices/transceiver.h"

namespace trundle {

namespace {

Quantity wholeNumber(double low, double high) {
    Quantity q = number().within(low, high);
    q.type = TRUNDLE_INTEGER;
    return q;
}

} // namespace

void Transceiver::describe(Describe<Transceiver>& d) {
    d.help("Sends and receives packets by radio.").independent();
    d.field("Body", &Transceiver::m_bodyName, reference("Body").required(), "The body that carries its antenna.");
    d.field("Pos", &Transceiver::m_pos, metres().within(-1e5, 1e5), "Position of its antenna in the body.");
    d.field("HPR", &Transceiver::m_hpr, degrees().within(-1e6, 1e6),
            "How its antenna is turned: it looks along its +x, its up is +z.");
    d.field("Antenna", &Transceiver::m_antenna, reference("AntennaPattern"),
            "An AntennaPattern, or a model with its defaults: isotropic, dipole, inverted_f, patch, yagi, cosine.");
    d.field("MaxOutputPower", &Transceiver::m_maxOutputPower, decibelMilliwatts().within(-100, 100), "It sends with no more.");
    d.field("MinReceivePower", &Transceiver::m_minReceivePower, decibelMilliwatts().within(-200, 100),
            "What arrives with less is dropped.");
    d.field("MaxReceivePower", &Transceiver::m_maxReceivePower, decibelMilliwatts().within(-200, 100), "Its RSSI ends here.");
    d.field("RssiStep", &Transceiver::m_rssiStep, decibels().within(0, 20), "Its RSSI is rounded to this; 0 = exact.");
    d.field("BufferLimit", &Transceiver::m_bufferLimit, wholeNumber(1, 100000),
            "Packets that wait to be read, and packets that wait to be sent.");
    d.field("Channel", &Transceiver::m_channel, wholeNumber(0, 26), "Only radios on the same channel receive each other.");
    d.field("BitRate", &Transceiver::m_bitRate, unitOf("bit/s").within(1, 1e9), "How fast bits go out.");
    d.field("Address", &Transceiver::m_address, wholeNumber(0, 65534), "Packets may be sent to it; 0 = the next free one.");
    d.field("PowerLevels", &Transceiver::m_powerLevels, decibelMilliwatts().within(-100, 100).counted(0, 1000),
            "The output powers that it has; any where absent.");
    d.field("TransmitCurrent", &Transceiver::m_transmitCurrent, amperes().within(0, 100).counted(0, 1000),
            "While it sends: one, or one for each of PowerLevels.");
    d.field("ReceiveCurrent", &Transceiver::m_receiveCurrent, amperes().within(0, 100), "While it listens.");
    d.field("SupplyVoltage", &Transceiver::m_supply, volts().within(0, 1000), "For its energy.");
    using T = Transceiver;
    d.output("address", &T::m_ownAddress, "", "Its address.");
    d.output("rssi", &T::m_rssi, "dBm", "Of the last packet received; 0 before the first.");
    d.output("lqi", &T::m_lqi, "", "Link quality of the last packet received, 110 at best.");
    d.output("pending", &T::m_pending, "", "Packets that wait to be read.");
    d.output("queued", &T::m_queued, "", "Packets that wait to be sent.");
    d.output("sent", &T::m_sent, "", "Frames sent, repetitions included.");
    d.output("received", &T::m_received, "", "Packets received.");
    d.output("dropped", &T::m_dropped, "", "Packets received and dropped because the buffer was full.");
    d.output("failed", &T::m_failed, "", "Packets refused, or given up for a busy channel or a missing acknowledgement.");
    d.output("energy", &T::m_energy, "J", "Drawn since the start.");
}

void Transceiver::setup(Mount& mount) {
    const Pose antenna{Vec3(m_pos.data()), rotationFromHpr(Vec3(m_hpr.data()))};
    TrundleRadioSettings s{};
    s.size = sizeof s;
    s.body = mount.body(m_bodyName).index;
    for (int i = 0; i < 3; ++i) s.position[i] = antenna.position[i];
    s.quaternion[0] = antenna.rotation.w();
    s.quaternion[1] = antenna.rotation.x();
    s.quaternion[2] = antenna.rotation.y();
    s.quaternion[3] = antenna.rotation.z();
    s.antenna = m_antenna.c_str();
    s.maxOutputPower = m_maxOutputPower;
    s.minReceivePower = m_minReceivePower;
    s.maxReceivePower = m_maxReceivePower;
    s.rssiStep = m_rssiStep;
    s.bitRate = m_bitRate;
    s.supply = m_supply;
    s.receiveCurrent = m_receiveCurrent;
    s.bufferLimit = static_cast<std::uint32_t>(m_bufferLimit);
    s.channel = static_cast<std::uint32_t>(m_channel);
    s.address = static_cast<std::uint32_t>(m_address);
    s.powerLevels = m_powerLevels.data();
    s.powerLevelCount = static_cast<std::uint32_t>(m_powerLevels.size());
    s.transmitCurrents = m_transmitCurrent.data();
    s.transmitCurrentCount = static_cast<std::uint32_t>(m_transmitCurrent.size());
    m_radio = mount.radio(s);
}

void Transceiver::sense(Sensing& world) {
    const TrundleRadioState s = world.radioState(m_radio);
    m_ownAddress.set(s.address);
    m_rssi.set(s.rssi);
    m_lqi.set(s.lqi);
    m_pending.set(s.pending);
    m_queued.set(s.queued);
    m_sent.set(static_cast<double>(s.sent));
    m_received.set(static_cast<double>(s.received));
    m_dropped.set(static_cast<double>(s.dropped));
    m_failed.set(static_cast<double>(s.failed));
    if (world.time() > 0) world.draw((s.energy - m_energy.get()) / world.tick());
    m_energy.set(s.energy);
}

} // namespace trundle
