// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// A port made from the table of a device's signals: the struct that the device derives from, so that each signal is named once.

#include <cstdint>

#include <trundle/describe.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// Access of a controller, or of another device of the robot, to a device with the signals S (since 1.5). S has CommandSlot,
/// OutputSlot and TruthSlot members, a `kKind` and `template <class D> static void describe(D& d)`. Outputs are read, commands are
/// read and written; truth does not compile. An unbound port reads 0 and ignores writes.
template <class S> class Port {
public:
    [[nodiscard]] bool bound() const { return m_bound; }
    template <class V> [[nodiscard]] double get(OutputSlot<V> S::*signal, std::uint32_t element = 0) const {
        return (m_signals.*signal).get(element);
    }
    template <class V> [[nodiscard]] double get(CommandSlot<V> S::*signal, std::uint32_t element = 0) const {
        return (m_signals.*signal).get(element);
    }
    template <class V> void set(CommandSlot<V> S::*signal, double value) { (m_signals.*signal).set(value); }
    template <class V> void set(CommandSlot<V> S::*signal, std::uint32_t element, double value) {
        (m_signals.*signal).set(element, value);
    }

protected:
    S m_signals;

private:
    friend class PortBinder;
    friend class RobotPorts;
    friend class Mount;
    /// Binds each signal of the table for which `accept(info)` holds to the slot that `find(info)` returns.
    template <class Accept, class Find> void bind(const Accept& accept, const Find& find) {
        m_bound = true;
        for (const SignalInfo& s : descriptionOf<S>().signals()) {
            if (!accept(s)) continue;
            const Slot slot = find(s);
            s.bind(&m_signals, slot, s.name.c_str());
            m_bound = m_bound && slot.bound();
        }
    }
    bool m_bound = false;
};

} // namespace sdk1
} // namespace trundle
