#include "project/edits/moved_block.h"

#include <algorithm>

#include "base/units.h"
#include "lang/tree_edit.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// One element of a position plus `by` (m). Empty if it is not a single number.
std::string shifted(const Element& e, std::string_view written, double by) {
    if (by == 0) return std::string(written);
    const std::string sum = (by < 0 ? " - " : " + ") + shortNumber(std::abs(by)) + ")";
    switch (e.kind) {
    case Element::Kind::Number: {
        const std::optional<double> step = e.unit.empty() ? by : convertUnit(by, "m", e.unit);
        if (!step) return {};
        const std::string gap(
            written.size() > e.unit.size() && !e.unit.empty() && written[written.size() - e.unit.size() - 1] == ' ' ? " " : "");
        return shortNumber(e.number + *step) + gap + e.unit;
    }
    case Element::Kind::Expression: return "$(" + std::string(written.substr(1)) + sum;
    case Element::Kind::ParamRef: return "$(" + e.text + sum;
    default: return {};
    }
}

} // namespace

std::optional<std::string> shiftedPosition(const Value& value, std::string_view source, const Vec3& offset) {
    if (value.elements.size() != 3) return std::nullopt;
    std::string text;
    std::uint32_t done = value.range.begin;
    for (int i = 0; i < 3; ++i) {
        const Element& e = value.elements[static_cast<std::size_t>(i)];
        const std::string element = shifted(e, source.substr(e.range.begin, e.range.size()), offset[i]);
        if (element.empty()) return std::nullopt;
        text += std::string(source.substr(done, e.range.begin - done)) + element;
        done = e.range.end;
    }
    return text;
}

MovedBlock::MovedBlock(std::string text) : m_text(std::move(text)) {
    m_tree = parse(std::make_shared<const SourceText>("the text", m_text), 0);
}

const BlockItem* MovedBlock::block() const { return m_tree->items().empty() ? nullptr : m_tree->items()[0].as<BlockItem>(); }

const AssignmentItem* MovedBlock::find(std::string_view key) const {
    if (!block()) return nullptr;
    for (const Item& item : block()->items) {
        const auto* a = item.as<AssignmentItem>();
        if (a && a->path.size() == 1 && a->path[0].text == key) return a;
    }
    return nullptr;
}

void MovedBlock::apply(const TextEdit& edit) {
    const Result<std::string> text = applyEdits(m_text, std::span(&edit, 1));
    if (text.ok()) *this = MovedBlock(text.value());
}

void MovedBlock::set(std::string_view key, const std::string& value) {
    if (const AssignmentItem* a = find(key)) apply(editSetValue(*m_tree, a->value, value));
    else if (block()) apply(editAddAssignment(*m_tree, block(), key, value));
}

void MovedBlock::remove(std::string_view key) {
    const AssignmentItem* a = find(key);
    if (!a) return;
    const auto& items = block()->items;
    const auto item = std::find_if(items.begin(), items.end(), [a](const Item& i) { return i.as<AssignmentItem>() == a; });
    apply(editRemoveItem(*m_tree, *item));
}

void MovedBlock::rename(const std::string& name) {
    if (!block()) return;
    const std::uint32_t end = block()->type.range.end;
    apply(block()->name ? editReplace(*m_tree, block()->name->range, name) : TextEdit{{0, {end, end}}, " " + name});
}

void MovedBlock::shift(std::string_view key, const Vec3& offset, const Vec3& otherwise) {
    const AssignmentItem* a = find(key);
    const auto value = a ? shiftedPosition(a->value, m_tree->source().bytes(), offset) : std::nullopt;
    set(key, value.value_or(positionText(otherwise + offset)));
}

} // namespace trundle
