#pragma once
// The minimum that a program on OSG must do to draw a camera image: a graph of transforms and shapes, then cull, draw and read
// back in one loop on one thread. No render service, no requests, no shared scenes.

#include <memory>
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "signals/block.h"

namespace trundle {

class BareView {
public:
    /// nullptr if OpenGL is not available or there is no such camera.
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
