#include "model/resolve/relative_poses.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr std::size_t kLongestChain = 1000; // of poses, each of which counts from the next one
constexpr std::ptrdiff_t kLongestShown = 20;

} // namespace

void RelativePoses::add(const ExpandedPart& part, const Pose& described, std::string in, SourceRange place) {
    m_bodies.try_emplace(part.name(), Body{part.frame, described, std::move(in), place});
}

std::optional<Pose> RelativePoses::of(const std::string& body) {
    const auto it = m_bodies.find(body);
    if (it == m_bodies.end() || !complete(it->second, body)) return std::nullopt;
    for (PartFrame* at = it->second.frame; at->use; at = at->outer)
        if (!complete(*at)) return std::nullopt;
    return it->second.pose;
}

void RelativePoses::completeFrames(PartFrame& frame) {
    for (PartFrame* at = &frame; at->use; at = at->outer) (void)complete(*at);
}

/// Whether it has to be completed now; reports a circle.
bool RelativePoses::enter(State& state, const std::string& name, SourceRange place) {
    if (state == State::Busy) {
        std::string chain;
        auto it = std::ranges::find(m_chain, name);
        if (m_chain.end() - it > kLongestShown) chain = *it + " > ... > ", it = m_chain.end() - kLongestShown;
        for (; it != m_chain.end(); ++it) chain += *it + " > ";
        m_context.diagnostics.error(Code::WrongPlace, place, "poses count from each other in a circle: " + chain + name);
        state = State::Failed;
    }
    if (state != State::Fresh) return false;
    if (m_chain.size() >= kLongestChain) {
        m_context.diagnostics.error(Code::TooManyObjects, place,
                                    "poses count from each other more than " + std::to_string(kLongestChain) + " deep");
        state = State::Failed;
        return false;
    }
    state = State::Busy;
    m_chain.push_back(name);
    return true;
}

bool RelativePoses::complete(Body& body, const std::string& name) {
    if (body.in.empty()) return true;
    if (!enter(body.state, name, body.place)) return body.state == State::Done;
    const std::optional<Pose> from = seenFrom(body.in, *body.frame, body.place);
    m_chain.pop_back();
    const bool isGood = from && body.state == State::Busy;
    body.state = isGood ? State::Done : State::Failed;
    if (isGood) body.pose = PartPlacement(*from).pose(body.pose);
    return isGood;
}

bool RelativePoses::complete(PartFrame& frame) {
    if (frame.in.empty()) return true;
    State& state = m_frames.try_emplace(&frame, State::Fresh).first->second;
    if (!enter(state, frame.prefix.substr(0, frame.prefix.size() - 1), frame.inRange)) return state == State::Done;
    const std::optional<Pose> from = seenFrom(frame.in, *frame.outer, frame.inRange);
    m_chain.pop_back();
    const bool isGood = from && state == State::Busy;
    state = isGood ? State::Done : State::Failed;
    if (isGood) frame.placement.countFrom(*from);
    return isGood;
}

std::optional<Pose> RelativePoses::seenFrom(const std::string& name, const PartFrame& frame, SourceRange place) {
    const auto it = m_bodies.find(name);
    if (it == m_bodies.end()) return std::nullopt; // it has errors of its own
    Body& body = it->second;
    const PartFrame* around = body.frame;
    while (around && around != &frame) around = around->outer;
    if (!around) {
        const std::string holder = frame.member ? frame.use->title() : frame.config->title();
        m_context.diagnostics.error(Code::WrongPlace, place,
                                    "In names " + name + ", which is outside of " + holder + "; give In to " +
                                        (!frame.use     ? "what is around it"
                                         : frame.member ? frame.use->title()
                                                        : "the Part") + // of any name: all of them are one mistake
                                        " instead");
        return std::nullopt;
    }
    if (!complete(body, name)) return std::nullopt;
    Pose pose = body.pose;
    for (PartFrame* at = body.frame; at != &frame; at = at->outer) {
        if (!complete(*at)) return std::nullopt;
        pose = at->placement.pose(pose);
    }
    return pose;
}

} // namespace trundle
