#include "lang/parsed_value.h"

namespace trundle {
namespace {

constexpr std::string_view kKey = "v = ";

void moveToStart(TextRange& range) {
    range.begin -= static_cast<std::uint32_t>(kKey.size());
    range.end -= static_cast<std::uint32_t>(kKey.size());
}

} // namespace

std::shared_ptr<const ParsedValue::Parsed> ParsedValue::parse(std::string_view text) {
    auto parsed = std::make_shared<Parsed>();
    parsed->text = text;
    const auto tree = trundle::parse(std::make_shared<const SourceText>("value", std::string(kKey) + parsed->text + "\n"), 0);
    for (const Diagnostic& d : tree->diagnostics()) {
        if (d.severity != Severity::Error) continue;
        // Before the value is the key, which only this text has.
        const bool isOfKey = d.range.range.begin < kKey.size(), isNone = d.code == Code::MissingValue;
        parsed->status = Error{d.code, !isOfKey ? d.message : isNone ? "a value is missing" : "a block is not a value"};
        return parsed;
    }
    const auto* a = tree->items().size() == 1 ? tree->items()[0].as<AssignmentItem>() : nullptr;
    const TextRange whole{static_cast<std::uint32_t>(kKey.size()), static_cast<std::uint32_t>(kKey.size() + text.size())};
    if (!a || a->path.size() != 1 || a->value.elements.empty()) parsed->status = Error{Code::MissingValue, "a value is missing"};
    else if (a->value.range != whole) parsed->status = Error{Code::UnexpectedText, "this is more than one value"};
    if (!parsed->status) return parsed;
    parsed->value = a->value;
    moveToStart(parsed->value.range);
    for (Element& e : parsed->value.elements) {
        moveToStart(e.range);
        if (!e.unit.empty()) moveToStart(e.unitRange);
    }
    return parsed;
}

const ParsedValue::Parsed& ParsedValue::parsed() const {
    static const Parsed nothing{{}, Error{Code::MissingValue, "a value is missing"}, {}};
    return m_parsed ? *m_parsed : nothing;
}

const std::string& ParsedValue::text() const { return parsed().text; }
const Status& ParsedValue::status() const { return parsed().status; }
const Value& ParsedValue::value() const { return parsed().value; }

} // namespace trundle
