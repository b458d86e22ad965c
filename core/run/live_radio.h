#pragma once
// What flies between a live run's radios, from its thread to whoever watches.

#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "radio/radio_settings.h"
#include "radio/radio_trace.h"

namespace trundle {

class Medium;

/// What flew since the last look. What nobody fetched in time is counted and gone, oldest first.
struct LiveRadio {
    std::shared_ptr<const std::vector<RadioDefinition>> radios; ///< by RadioId; null until built and in a world without radios
    std::vector<FrameRecord> records;                           ///< frames at their receivers, in the order of their ends
    std::vector<AirFrame> frames;                               ///< in the order of their starts
    std::uint64_t droppedRecords = 0, droppedFrames = 0;
    /// Since the start of the run, fetched or not: data frames times the radios of their channel, and what became of them.
    std::uint64_t expected = 0, inTheAir = 0;
    std::array<std::uint64_t, kFates> fates{};
};

/// Stands between the run's thread and another one; neither waits for more than a copy.
class RadioTap {
public:
    static constexpr std::size_t kMost = 20'000; ///< records, and frames, that wait to be fetched
    /// Where more than this many wait, what was too weak for its receiver is left out: in a large network it is nearly everything.
    static constexpr std::size_t kFlood = kMost / 10;

    // --- who watches ---
    void want(bool wanted) { m_wanted = wanted; } ///< from the next tick on
    [[nodiscard]] LiveRadio take();

    // --- the run's thread ---
    void open(const Medium& medium);
    void beforeTick(Medium& medium);
    void afterTick(const Medium& medium);

private:
    std::atomic<bool> m_wanted = false;
    std::shared_ptr<RadioTrace> m_trace; ///< of the run's thread
    std::mutex m_lock;                   ///< for the rest
    std::shared_ptr<const std::vector<RadioDefinition>> m_radios;
    std::deque<FrameRecord> m_records;
    std::deque<AirFrame> m_frames;
    LiveRadio m_counts; ///< its figures alone
};

} // namespace trundle
