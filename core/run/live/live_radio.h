#pragma once
// Passes the radio frames of a live run from its thread to observers.

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

/// Radio frames since the last take(). If too many are waiting, the oldest are dropped and counted.
struct LiveRadio {
    std::shared_ptr<const std::vector<RadioDefinition>> radios; ///< by RadioId; null until built, and in a world without radios
    std::vector<FrameRecord> records;                           ///< frames at their receivers, ordered by end
    std::vector<AirFrame> frames;                               ///< ordered by start
    std::uint64_t droppedRecords = 0, droppedFrames = 0;
    /// Totals since the start of the run: see Medium::expected() and Medium::outcomes().
    std::uint64_t expected = 0, inTheAir = 0;
    std::array<std::uint64_t, kReceptionOutcomes> outcomes{};
};

/// Queue between the run's thread and one reader; both hold the lock only for a copy.
class RadioTraceQueue {
public:
    static constexpr std::size_t kMost = 20'000; ///< limit for waiting records, and for waiting frames
    /// Above this number of records those with TooWeak are dropped: in a large network they are the great majority.
    static constexpr std::size_t kDropWeakAbove = kMost / 10;

    // --- reader ---
    void setEnabled(bool wanted) { m_wanted = wanted; } ///< effective from the next tick
    [[nodiscard]] LiveRadio take();

    // --- run thread ---
    void open(const Medium& medium);
    void beforeTick(Medium& medium);
    void afterTick(const Medium& medium);

private:
    std::atomic<bool> m_wanted = false;
    std::shared_ptr<RadioTrace> m_trace; ///< used by the run thread only
    std::mutex m_lock;                   ///< guards the members below
    std::shared_ptr<const std::vector<RadioDefinition>> m_radios;
    std::deque<FrameRecord> m_records;
    std::deque<AirFrame> m_frames;
    LiveRadio m_counts; ///< without records and frames
};

} // namespace trundle
