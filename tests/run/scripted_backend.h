#pragma once
#include <trundle/abi.h>

#include "control/backend.h"

namespace trundle {

/// Records its calls.
class ScriptedBackend final : public ControllerBackend {
public:
    std::string* story;
    std::vector<double>* gaps;
    std::uint64_t failAt = ~0ull, finishAt = ~0ull;
    bool failStart = false;
    std::string kind;
    ControllerOutputs outputs;

    Status start(const SignalLayout&, SignalBlock&, ControllerOutputs given) override {
        outputs = std::move(given);
        if (failStart) return Error{Code::UnknownPort, "there is no port arm"};
        return {};
    }
    Status tick(std::uint64_t tick, double time, double sinceLast) override {
        if (tick == failAt) return Error{Code::ControllerFailed, "brain failed"};
        if (tick >= finishAt) outputs.finish("reached " + std::to_string(tick));
        if (tick >= finishAt) outputs.finish("again"); // of several in one tick the first counts
        *story += "think ";
        gaps->push_back(sinceLast);
        outputs.print(TRUNDLE_INFO, "t=" + std::to_string(time));
        return {};
    }
    Status set(const std::string& property, const PropertyValue&) override {
        *story += "set " + property + " ";
        return {};
    }
    void stop() override { *story += "stop "; }
    std::string describe() const override { return "scripted"; }
};

} // namespace trundle
