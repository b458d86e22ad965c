#pragma once
// A thread that reckons links and coverage: always the newest that is wanted of each, the rest is never begun.

#include <memory>

#include "editor/viewport/radio_coverage.h"

namespace trundle {

class RadioReckoner {
public:
    /// Called on the thread, with the number that the wish came with. They must not block.
    struct Answers {
        std::function<void(std::uint64_t number, RadioLinks links)> links;
        /// `last`: no finer one of this wish follows.
        std::function<void(std::uint64_t number, CoverageMap map, bool last)> coverage;
        std::function<void(std::uint64_t number)> coverageGivenUp; ///< forgotten while it was reckoned
    };
    explicit RadioReckoner(Answers answers);
    /// Waits until the row that is reckoned is done.
    ~RadioReckoner();

    void wantLinks(std::uint64_t number, RadioPlaces places, std::vector<bool> selected);
    /// A coarse one comes first where a fine one takes its time.
    void wantCoverage(std::uint64_t number, CoverageWish wish);
    /// Whatever was wanted is not wanted any more; what is being reckoned is given up.
    void forget();

private:
    struct Thread;
    std::unique_ptr<Thread> m_thread;
};

} // namespace trundle
