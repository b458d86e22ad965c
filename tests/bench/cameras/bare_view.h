#pragma once
// The least that any program on OSG must do to draw what a camera sees: a graph of transforms and shapes, then cull, draw and read
// in one loop on one thread. No service, no requests, no shared scenes.

#include <memory>
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "signals/block.h"

namespace trundle {

class BareView {
public:
    /// nullptr where there is no OpenGL or no such camera.
    [[nodiscard]] static std::unique_ptr<BareView> create(const ExperimentSpec& experiment, const SignalLayout& layout,
                                                          const std::string& camera);
    ~BareView();
    /// Red, green, blue; rows from the top.
    [[nodiscard]] const std::vector<std::uint8_t>& draw(const SignalBlock& block);

private:
    struct Parts;
    explicit BareView(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

} // namespace trundle
