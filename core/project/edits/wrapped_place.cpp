#include "project/edits/wrapped_place.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "project/edits/mirrored_text.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kRounding = 1e-15; // of a metre: of a sum of numbers with a few digits each

class PlaceChange {
public:
    PlaceChange(const LoadedProject& loaded, WrappedBlocks& blocks, const std::vector<NameReference>& references)
        : m_loaded(loaded), m_blocks(blocks), m_references(references) {}

    std::string run() {
        for (const Part* block : m_blocks.blocks()) {
            if (block->isRepeat() || block->isPartUse() || !staysAtItsBody(*block)) return {};
            if (!m_first && block->is(Role::Body) && !isInner(*block)) m_first = block;
        }
        const SourceAssignment* pos = m_first ? placeIn(*m_first, "Pos") : nullptr;
        if (!pos || !canBeMirrored(textOf(*pos))) return {};
        for (const Part* block : m_blocks.blocks())
            if (block != m_first && !shift(*block, *pos)) return {};
        for (TextEdit& edit : m_edits) m_blocks.change(std::move(edit));
        std::string text = textOf(*pos);
        m_blocks.remove(*m_first, "Pos");
        return text;
    }

private:
    std::string textOf(const SourceAssignment& a) const { return std::string(m_loaded.outline->texts().slice(a.valueRange())); }

    const BlockItem* targetOf(const Part& block, std::string_view key) const {
        const BlockItem* target = nullptr; // of left.wheel the last one
        for (const NameReference& m : m_references)
            if (m.user == &block && m.property == key && m.target) target = m.target;
        return target;
    }
    /// Whether it counts from another body of the selection.
    bool isInner(const Part& block) const { return block.assignments.find("In") && m_blocks.find(targetOf(block, "In")); }
    /// Whether a device is described in the frame of a body that is taken along, or has no pose.
    bool staysAtItsBody(const Part& block) const {
        return !block.is(Role::Device) || !block.kind->find("Pos") || m_blocks.find(targetOf(block, "Body"));
    }

    /// Where the block itself says it, and no override does.
    const SourceAssignment* placeIn(const Part& block, const std::string& key) const {
        const SourceAssignment* a = block.assignments.find(key);
        const auto setsIt = [&](const NameReference& m) {
            return m.target == block.block && !m_blocks.contains(m.name) && m.property.ends_with("." + key);
        };
        return a && m_blocks.contains(a->valueRange()) && std::ranges::none_of(m_references, setsIt) ? a : nullptr;
    }
    static bool canBeMirrored(const std::string& pos) {
        return std::ranges::all_of(std::string("xyz"),
                                   [&](char axis) { return mirroredPart("Part a { Pos=" + pos + " }", "b", axis).ok(); });
    }

    /// Takes the place off what a block says about itself.
    bool shift(const Part& block, const SourceAssignment& place) {
        if (!block.is(Role::Body) && !block.is(Role::Joint)) return true;
        if (block.is(Role::Body) && isInner(block)) return true;
        for (const char* key : {"Pos", "Anchor", "Anchor2"}) {
            if (!block.kind->find(key)) continue;
            const SourceAssignment* a = block.assignments.find(key);
            if (!a && key == std::string_view("Pos")) return false;
            if (!a) continue;                                                           // at the body
            if (m_first->assignments.find("In") && block.is(Role::Joint)) return false; // takeIn() describes it anew
            const std::string text = placeIn(block, key) ? difference(*a->value, *place.value) : std::string();
            if (text.empty()) return false;
            m_edits.push_back({a->valueRange(), text});
        }
        return true;
    }
    /// Empty where the sum with `from` would be another number when rounded, and for what is not three numbers in metres.
    static std::string difference(const Value& value, const Value& from) {
        if (value.elements.size() != 3 || from.elements.size() != 3) return {};
        Vec3 apart;
        for (int i = 0; i < 3; ++i) {
            const Element &a = value.elements[static_cast<std::size_t>(i)], &b = from.elements[static_cast<std::size_t>(i)];
            if (a.kind != Element::Kind::Number || b.kind != a.kind || !a.unit.empty() || !b.unit.empty()) return {};
            apart[i] = std::strtod(shortNumber(a.number - b.number).c_str(), nullptr);
            if (std::abs(apart[i] + b.number - a.number) > kRounding) return {};
        }
        return positionText(apart);
    }

    const LoadedProject& m_loaded;
    WrappedBlocks& m_blocks;
    const std::vector<NameReference>& m_references;
    const Part* m_first = nullptr; ///< the body whose place it is
    std::vector<TextEdit> m_edits;
};

} // namespace

std::string takePlace(const LoadedProject& loaded, WrappedBlocks& blocks, const std::vector<NameReference>& references) {
    return PlaceChange(loaded, blocks, references).run();
}

} // namespace trundle
