#pragma once
#include <cstddef>
#include <vector>

namespace trundle {

/// The last values of a quantity of one or more numbers, with their times, in a ring of fixed size.
class Trace {
public:
    static constexpr std::size_t kCapacity = 300; ///< samples: 10 s of a run in real time

    explicit Trace(std::size_t width) : m_width(width) {}

    /// Replaces the newest sample if it has the same time; an earlier time begins anew.
    void add(double time, const double* values);
    /// The next sample is not connected with the previous ones.
    void interrupt() { m_interrupted = true; }
    void clear();

    [[nodiscard]] std::size_t size() const { return m_times.size(); }
    [[nodiscard]] std::size_t width() const { return m_width; }
    /// s, simulated; `i`: 0 is the oldest sample.
    [[nodiscard]] double time(std::size_t i) const { return m_times[slot(i)]; }
    [[nodiscard]] double value(std::size_t i, std::size_t k) const { return m_values[slot(i) * m_width + k]; }
    [[nodiscard]] bool isConnected(std::size_t i) const { return m_connected[slot(i)]; }         ///< with the sample before it
    [[nodiscard]] double seconds() const { return size() < 2 ? 0 : time(size() - 1) - time(0); } ///< from oldest to newest

private:
    [[nodiscard]] std::size_t slot(std::size_t i) const { return (m_first + i) % m_times.size(); }

    std::size_t m_width, m_first = 0;
    std::vector<double> m_times, m_values;
    std::vector<bool> m_connected;
    bool m_interrupted = true;
};

} // namespace trundle
