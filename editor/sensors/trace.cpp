#include "editor/sensors/trace.h"

#include <algorithm>

namespace trundle {

void Trace::add(double time, const double* values) {
    if (size() > 0 && time < this->time(size() - 1)) clear();
    std::size_t at = 0;
    if (size() > 0 && time == this->time(size() - 1)) {
        at = slot(size() - 1);
    } else {
        if (size() < kCapacity) {
            at = size();
            m_times.push_back(time);
            m_values.resize(m_values.size() + m_width);
            m_connected.push_back(false);
        } else {
            at = m_first;
            m_first = (m_first + 1) % kCapacity;
            m_times[at] = time;
        }
        m_connected[at] = !m_interrupted;
        m_interrupted = false;
    }
    std::copy_n(values, m_width, m_values.begin() + std::ptrdiff_t(at * m_width));
}

void Trace::clear() {
    m_first = 0;
    m_times.clear();
    m_values.clear();
    m_connected.clear();
    m_interrupted = true;
}

} // namespace trundle
