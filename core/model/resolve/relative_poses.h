#pragma once
// `In = body`: poses that count from another body of the config. Private to core/model.

#include "model/resolve/part_expansion.h"

namespace trundle {

/// Collects the bodies of a config as they are described, then has all poses count from the config's frame, in any order of the text.
class RelativePoses {
public:
    explicit RelativePoses(ResolveContext& context) : m_context(context) {}

    /// `in`: the name of the body that its pose counts from; empty: its frame.
    void add(const ExpandedPart& part, const Pose& described, std::string in, SourceRange place);
    /// The pose of a body in the frame that it is described in; also completes the placements of the frames around it. Nothing, with
    /// a diagnostic, if poses count from each other in a circle, or from a body outside of the frame.
    [[nodiscard]] std::optional<Pose> of(const std::string& body);
    /// Has the placements of a frame, and of those around it, count from the config's frame too, whether there are bodies in it or not.
    void completeFrames(PartFrame& frame);

private:
    enum class State { Fresh, Busy, Done, Failed };
    struct Body {
        PartFrame* frame = nullptr;
        Pose pose;
        std::string in;
        SourceRange place;
        State state = State::Fresh;
    };
    [[nodiscard]] bool complete(Body& body, const std::string& name);
    [[nodiscard]] bool complete(PartFrame& frame);
    [[nodiscard]] std::optional<Pose> seenFrom(const std::string& body, const PartFrame& frame, SourceRange place);
    [[nodiscard]] bool enter(State& state, const std::string& name, SourceRange place);

    ResolveContext& m_context;
    std::map<std::string, Body, std::less<>> m_bodies;
    std::map<const PartFrame*, State> m_frames;
    std::vector<std::string> m_chain; ///< what is being completed
};

} // namespace trundle
