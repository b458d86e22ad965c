#pragma once
// Worker thread for links and coverage. Of each kind only the newest request is computed; older ones are dropped from the queue.

#include <memory>

#include "editor/viewport/radio/radio_coverage.h"

namespace trundle {

class RadioWorker {
public:
    /// Callbacks, called on the worker thread with the number of the request. They must not block.
    struct Answers {
        std::function<void(std::uint64_t number, RadioLinks links)> links;
        /// `last`: no finer map of this request follows.
        std::function<void(std::uint64_t number, CoverageMap map, bool last)> coverage;
        std::function<void(std::uint64_t number)> coverageGivenUp; ///< cancelled by forget()
    };
    explicit RadioWorker(Answers answers);
    /// Waits for the row in progress.
    ~RadioWorker();

    void requestLinks(std::uint64_t number, RadioPoses places, std::vector<bool> selected);
    /// If the fine map takes long, a coarse one is reported first.
    void requestCoverage(std::uint64_t number, CoverageRequest request);
    /// Drops all requests and cancels the one in progress.
    void forget();

private:
    struct Thread;
    std::unique_ptr<Thread> m_thread;
};

} // namespace trundle
