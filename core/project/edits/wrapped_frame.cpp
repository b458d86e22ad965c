#include "project/edits/wrapped_frame.h"

#include <algorithm>
#include <cmath>

#include "lang/tree_edit.h"
#include "project/edits/moved_block.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr int kLongestChain = 100; // of bodies, each of which counts from the next one

/// Where the body is that the blocks count from, in the frame of their config.
struct BodyFrame {
    Pose pose;
    bool isFixed = true, isTurnFixed = true; ///< not from Params: the pose, its orientation

    void add(const Part& part) {
        const auto isOfNumbers = [&](const char* key) {
            const SourceAssignment* a = part.assignments.find(key);
            return !a ||
                   std::ranges::all_of(a->value->elements, [](const Element& e) { return e.kind == Element::Kind::Number; });
        };
        isTurnFixed = isTurnFixed && isOfNumbers("HPR");
        isFixed = isFixed && isTurnFixed && isOfNumbers("Pos");
    }
};

bool isPosed(const Part& part) { return part.is(Role::Body) || part.isPartUse() || part.isRepeat() || part.is(Role::Geom); }

class FrameChange {
public:
    FrameChange(const LoadedProject& loaded, WrappedBlocks& blocks, const std::vector<NameReference>& references)
        : m_loaded(loaded), m_blocks(blocks), m_references(references) {}

    Result<std::string> run() {
        for (const Part* block : m_blocks.blocks()) {
            if (!isPosed(*block)) continue;
            if (const SourceAssignment* in = outerIn(*block)) {
                if (!m_from) m_from = block, m_in = in;
                if (!isSame(*in))
                    return Error{Code::Conflict, block->title() + " counts from " + textOf(*in) + ", " + m_from->title() +
                                                     " from " + textOf(*m_in) + "; select what counts from one body"};
            } else if (!m_other && !isInner(*block)) {
                m_other = block;
            }
        }
        if (!m_from) return std::string();
        if (m_other)
            return Error{Code::Conflict, m_other->title() + " counts from " + m_blocks.config().title() + ", " + m_from->title() +
                                             " from " + textOf(*m_in) + "; give both the same In, or select one of them"};
        const std::string in = textOf(*m_in);
        for (const Part* block : m_blocks.blocks())
            if (block->is(Role::Joint))
                if (Status status = describeAnew(*block); !status.ok()) return status.error();
        for (const Part* block : m_blocks.blocks())
            if (isPosed(*block) && outerIn(*block)) m_blocks.remove(*block, "In");
        return in;
    }

private:
    std::string textOf(const SourceAssignment& a) const { return std::string(m_loaded.outline->texts().slice(a.valueRange())); }

    /// The block that it names; nullptr: a Param does.
    const BlockItem* targetOf(const SourceAssignment& in) const {
        const BlockItem* target = nullptr; // of left.wheel the last one
        for (const NameReference& m : m_references)
            if (m.target && isWithin(m.name, in.valueRange())) target = m.target;
        return target;
    }
    bool isSame(const SourceAssignment& in) const {
        return textOf(in) == textOf(*m_in) || (targetOf(in) && targetOf(in) == targetOf(*m_in));
    }

    /// Its In, if that leads out of the selection.
    const SourceAssignment* outerIn(const Part& block) const {
        const SourceAssignment* in = block.assignments.find("In");
        return in && !m_blocks.find(targetOf(*in)) && textOf(*in) != "world" ? in : nullptr;
    }

    /// Whether it counts from another one of the selection.
    bool isInner(const Part& block) const {
        const SourceAssignment* in = block.assignments.find("In");
        return in && m_blocks.find(targetOf(*in));
    }

    /// Nothing if the text of the config does not show it.
    std::optional<BodyFrame> frameOf(const std::string& name, int depth = 0) const {
        const std::optional<ObjectLocation> place = placeOf(m_loaded, pathOfConfig(m_blocks.config()) + "." + name);
        if (!place || !place->part || !place->part->is(Role::Body) || depth > kLongestChain) return std::nullopt;
        const auto isInPart = [](const Part* part) { return part->isPartUse() || part->isRepeat(); };
        const bool isOfPart = std::ranges::any_of(place->above, isInPart);
        BodyFrame frame;
        frame.add(*place->part);
        const Pose own = poseAt(m_loaded, *place);
        if (const auto in = valueAt(m_loaded, *place, "In"); in && !in->texts.empty()) {
            const std::optional<BodyFrame> from = isOfPart ? std::nullopt : frameOf(in->texts[0], depth + 1);
            if (!from) return std::nullopt;
            const bool isNamed = isNamedBy(*place->part);
            return BodyFrame{from->pose * own, from->isFixed && frame.isFixed && isNamed,
                             from->isTurnFixed && frame.isTurnFixed && isNamed};
        }
        for (const Part* part : place->above) {
            if (isInPart(part) && part->assignments.find("In")) return std::nullopt;
            if (isInPart(part)) frame.add(*part);
        }
        const DescribedFrame described = describedFrame(m_loaded, *place);
        frame.pose = described.pose * described.mirrored(own);
        return frame;
    }
    /// Whether its In is a name, not a Param.
    static bool isNamedBy(const Part& part) {
        const SourceAssignment* in = part.assignments.find("In");
        return !in ||
               std::ranges::all_of(in->value->elements, [](const Element& e) { return e.kind != Element::Kind::ParamRef; });
    }

    /// Writes the anchors and axes of a joint or spring in the frame of the body.
    Status describeAnew(const Part& joint) {
        for (const char* key : {"Anchor", "Anchor2", "Axis", "Axis2"}) {
            const Property* property = joint.kind->find(key);
            const SourceAssignment* a = joint.assignments.find(key);
            const bool isAxis = std::string_view(key).starts_with("Axis");
            if (!property || (!a && !isAxis)) continue; // without an Anchor it is at the body
            if (Status status = describeAnew(joint, *property, a, isAxis); !status.ok()) return status;
        }
        return {};
    }
    Status describeAnew(const Part& joint, const Property& property, const SourceAssignment* a, bool isAxis) {
        const std::string what = property.name + " of " + joint.title() + " counts from " + m_blocks.config().title() +
                                 " and would count from " + textOf(*m_in);
        const auto place = placeOf(m_loaded, pathOfConfig(m_blocks.config()) + "." + joint.name);
        const auto in = placeOf(m_loaded, pathOfConfig(m_blocks.config()) + "." + m_from->name);
        const auto named = in ? valueAt(m_loaded, *in, "In") : std::nullopt;
        const auto frame = named && !named->texts.empty() ? frameOf(named->texts[0]) : std::nullopt;
        const auto value = place ? valueAt(m_loaded, *place, property.name) : std::nullopt;
        if (!frame || !value || value->numbers.size() != 3)
            return Error{Code::Conflict, what + ", whose pose is not in the text of the config; write it as a number first"};
        const bool isTurned = std::abs(frame->pose.rotation.w()) < 1 - 1e-15;
        const bool isFixed = isNamedBy(*m_from) && (isAxis ? frame->isTurnFixed : frame->isFixed);
        if (!isFixed)
            return Error{Code::ExpressionValue, what + ", whose pose depends on Params; select it without " + joint.title()};
        if (!isTurned && (isAxis || frame->pose.position.isZero(0))) return {};
        for (const NameReference& m : m_references) {
            const bool isOverride =
                m.target == joint.block && !m_blocks.contains(m.name) && m.user && m.property.ends_with("." + property.name);
            if (isOverride)
                return Error{Code::Conflict, what + ", but " + m.user->title() + " sets it too; remove that value first"};
        }
        const Vec3 was(value->numbers[0], value->numbers[1], value->numbers[2]);
        const Quat back = frame->pose.rotation.conjugate();
        std::string text = positionText(back * (isAxis ? was : Vec3(was - frame->pose.position)));
        if (!a) {
            m_blocks.add(joint, property.name, text);
            return {};
        }
        std::optional<std::string> written;
        if (!isTurned) written = shiftedPosition(*a->value, m_loaded.trees[a->file]->source().bytes(), -frame->pose.position);
        else if (std::ranges::all_of(a->value->elements, [](const Element& e) { return e.kind == Element::Kind::Number; }))
            written = std::move(text);
        if (!written) return Error{Code::ExpressionValue, what + ", which is turned; write it as three numbers first"};
        m_blocks.change({a->valueRange(), *written});
        return {};
    }

    const LoadedProject& m_loaded;
    WrappedBlocks& m_blocks;
    const std::vector<NameReference>& m_references;
    const Part* m_from = nullptr;           ///< the first block that counts from a body outside
    const SourceAssignment* m_in = nullptr; ///< its In
    const Part* m_other = nullptr;          ///< one that counts from the frame of the config
};

} // namespace

Result<std::string> takeIn(const LoadedProject& loaded, WrappedBlocks& blocks, const std::vector<NameReference>& references) {
    return FrameChange(loaded, blocks, references).run();
}

} // namespace trundle
