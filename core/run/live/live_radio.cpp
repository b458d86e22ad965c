#include "run/live/live_radio.h"

#include "radio/medium.h"

namespace trundle {
namespace {

/// Moves `fresh` to the end of `waiting`. Returns the number of oldest entries dropped to stay within kMost.
template <class T> std::uint64_t passOn(std::vector<T>& fresh, std::deque<T>& waiting) {
    for (T& one : fresh) waiting.push_back(std::move(one));
    fresh.clear();
    const std::size_t over = waiting.size() > RadioTraceQueue::kMost ? waiting.size() - RadioTraceQueue::kMost : 0;
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(over));
    return over;
}

template <class T> std::vector<T> asVector(std::deque<T>& taken) {
    return {std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end())};
}

} // namespace

LiveRadio RadioTraceQueue::take() {
    std::deque<FrameRecord> records;
    std::deque<AirFrame> frames;
    LiveRadio taken;
    {
        const std::scoped_lock guard(m_lock);
        records.swap(m_records);
        frames.swap(m_frames);
        taken = m_counts;
        taken.radios = m_radios;
        m_counts.droppedRecords = m_counts.droppedFrames = 0;
    }
    taken.records = asVector(records);
    taken.frames = asVector(frames);
    return taken;
}

void RadioTraceQueue::open(const Medium& medium) {
    auto radios = std::make_shared<std::vector<RadioDefinition>>();
    for (RadioId id = 0; id < medium.radioCount(); ++id) radios->push_back(medium.radio(id));
    const std::scoped_lock guard(m_lock);
    m_radios = std::move(radios);
}

void RadioTraceQueue::beforeTick(Medium& medium) {
    if (m_wanted == (m_trace != nullptr)) return;
    if (m_trace) m_trace.reset();
    else m_trace = medium.trace();
}

void RadioTraceQueue::afterTick(const Medium& medium) {
    const std::scoped_lock guard(m_lock);
    m_counts.expected = medium.expected();
    m_counts.inTheAir = medium.inTheAir();
    m_counts.outcomes = medium.outcomes();
    if (!m_trace) return;
    if (m_records.size() + m_trace->records.size() > kDropWeakAbove)
        m_counts.droppedRecords += std::erase_if(
            m_trace->records, [](const FrameRecord& record) { return record.outcome == ReceptionOutcome::TooWeak; });
    m_counts.droppedRecords += passOn(m_trace->records, m_records);
    m_counts.droppedFrames += passOn(m_trace->frames, m_frames);
}

} // namespace trundle
