#include "devices/battery.h"

#include <algorithm>

#include "devices/discharge_curve.h"

namespace trundle {

namespace {

constexpr double kNominalNickel = 1.2, kNominalLithium = 3.7; // V, of a cell

constexpr double kLeastShare = 0.5; // of the open voltage: below it, a resistance cannot give a regulated load more power

} // namespace

void Battery::describe(Describe<Battery>& d) {
    d.help("The battery of the robot, from which all of its devices draw.");
    Quantity cells = number().within(1, 1000);
    cells.type = TRUNDLE_INTEGER;
    d.field("Capacity", &Battery::m_capacity, unitOf("Ah", 3600).above(0).atMost(1e6).required(), "Charge that it holds.");
    d.field("Voltage", &Battery::m_voltage, volts().above(0).atMost(1e6), "Without a load, the same at any charge.");
    d.field("Cells", &Battery::m_cells, cells, "In series; their voltage falls with the charge, by Chemistry.");
    d.exactlyOneOf("Voltage|Cells");
    d.field("Chemistry", &Battery::m_chemistry, oneOf("NiMH|LiIon"),
            "Of its cells: 1.2 V or 3.7 V, by a published discharge curve.");
    d.field(
        "DischargeCurve", &Battery::m_curve, number().within(0, 1e6).counted(0, 1000),
        "Share of the charge that is left, voltage of a cell [V], and so on, by increasing share; instead of that of Chemistry.");
    d.field("InternalResistance", &Battery::m_resistance, ohms().within(0, 1e6).live(),
            "Of the whole battery: loads lower its voltage.");
    d.field("BaseLoad", &Battery::m_baseLoad, unitOf("W").within(0, 1e9).live(),
            "That the robot draws besides its devices, for its computer.");
    d.field("StartLevel", &Battery::m_startLevel, number().within(0, 1), "Share of Capacity at the start.");
    d.field("Contact", &Battery::m_contactPaths, reference("Geom").counted(0, 1000),
            "Geoms of the robot through which a Charger that they touch charges it, body.geom.");
    BatterySignals::describe(d);
}

void Battery::setup(Mount& mount) {
    if (m_voltage.has_value() == m_cells.has_value()) return mount.fail("give either Voltage or Cells");
    if (m_voltage && !m_curve.empty()) return mount.fail("a DischargeCurve is that of a cell: give Cells instead of Voltage");
    double nominal = m_voltage.value_or(0);
    if (m_cells && m_curve.empty()) {
        const std::span<const double> known = dischargeCurveOf(m_chemistry);
        m_curve.assign(known.begin(), known.end());
        nominal = *m_cells * (m_chemistry == "LiIon" ? kNominalLithium : kNominalNickel);
    } else if (m_cells) {
        if (!isDischargeCurve(m_curve))
            return mount.fail(
                "DischargeCurve must be pairs of a share from 0 to 1 and a voltage above 0, with increasing shares");
        nominal = *m_cells * voltageAt(m_curve, 0.5);
    }
    m_charge = m_capacity * m_startLevel;
    for (const std::string& path : m_contactPaths) m_contacts.push_back(mount.geom(path));
    m_touched.reserve(8);
    mount.provideSupply(nominal, m_charge > 0 ? openVoltageAt(m_startLevel) : 0);
}

double Battery::openVoltageAt(double level) const { return m_voltage ? *m_voltage : *m_cells * voltageAt(m_curve, level); }

double Battery::currentOf(const TrundleLoad& load, double volts, double open, const Services& world) {
    if (!(volts > 0)) return 0;
    const double regulated = load.regulated + m_baseLoad;
    if (regulated > 0 && volts < kLeastShare * open && !m_reported) {
        m_reported = true;
        world.warn("its loads take more than it can give with its InternalResistance");
    }
    return load.resistive / volts + regulated / std::max(volts, kLeastShare * open);
}

/// The charger holds its current until the terminals have its voltage, and from then on its voltage: the law of the chargers that makers of
/// cells prescribe, as Panasonic's data sheet of the NCR18650B ("CC-CV, 4.20 V"). At a full battery it carries the devices.
double Battery::chargingCurrent(Sensing& world, double drawn, double open) {
    for (const GeomId contact : m_contacts) {
        world.contacts(contact, m_touched);
        for (const TrundleContact& touched : m_touched) {
            const GeomId geom{touched.other};
            const TrundleOffer offer = world.offered(geom);
            if (!(offer.amperes > 0)) continue;
            const double room = drawn + (m_capacity - m_charge) / world.tick();
            double amperes = std::min(offer.amperes, room);
            if (m_resistance > 0) amperes = std::min(amperes, drawn + (offer.volts - open) / m_resistance);
            else if (open > offer.volts) amperes = 0;
            if (!(amperes > 0)) continue;
            world.takePower(geom, open - m_resistance * (drawn - amperes), amperes);
            return amperes;
        }
    }
    return 0;
}

/// The devices of this tick had the voltage that was set at the end of the last one. That of the next tick is on the line through what they
/// drew now: the current of resistive loads changes with it, that of regulated ones hardly does.
void Battery::sense(Sensing& world) {
    const double volts = world.supply().voltage;
    const TrundleLoad load = world.load();
    const double before = openVoltageAt(m_charge / m_capacity), drawn = currentOf(load, volts, before, world);
    const double charging = world.time() > 0 ? chargingCurrent(world, drawn, before) : 0, amperes = drawn - charging;
    if (world.time() > 0) m_charge = std::clamp(m_charge - amperes * world.tick(), 0.0, m_capacity);
    const double left = m_charge / m_capacity, open = openVoltageAt(left);
    const double fixed = amperes - load.conductance * volts;
    const double next = (open - m_resistance * fixed) / (1 + m_resistance * load.conductance);
    world.setSupplyVoltage(m_charge > 0 ? std::max(next, 0.01 * open) : 0);
    voltage.set(volts);
    current.set(amperes);
    chargeCurrent.set(charging);
    charge.set(m_charge);
    level.set(left);
    openVoltage.set(m_charge > 0 ? open : 0);
}

} // namespace trundle
