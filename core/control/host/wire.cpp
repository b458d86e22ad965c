#include "control/host/wire.h"

namespace trundle {

WireWriter& WireWriter::value(const PropertyValue& value) {
    number(static_cast<std::uint32_t>(value.type)).numbers(value.numbers).number<std::uint64_t>(value.texts.size());
    for (const std::string& text : value.texts) bytes(text);
    return *this;
}

WireWriter& WireWriter::status(const Status& status) {
    number<std::uint8_t>(status.ok());
    if (!status) number(static_cast<std::int32_t>(status.error().code)).bytes(status.error().message).place(status.error().place);
    return *this;
}

WireWriter& WireWriter::place(const CodePlace& place) { return bytes(place.file).number<std::int32_t>(place.line); }

std::string_view WireReader::take(std::uint64_t count) {
    m_ok = m_ok && count <= m_rest.size();
    if (!m_ok) return m_rest = {};
    const std::string_view taken = m_rest.substr(0, count);
    m_rest.remove_prefix(count);
    return taken;
}

std::uint64_t WireReader::count() {
    const auto count = number<std::uint64_t>();
    m_ok = m_ok && count <= m_rest.size();
    return m_ok ? count : 0;
}

PropertyValue WireReader::value() {
    PropertyValue value;
    value.type = static_cast<PropertyType>(number<std::uint32_t>());
    value.numbers = numbers<double>();
    for (std::uint64_t left = count(); left > 0; --left) value.texts.push_back(text());
    return value;
}

Status WireReader::status() {
    if (number<std::uint8_t>() != 0) return {};
    const auto code = static_cast<Code>(number<std::int32_t>());
    std::string message = text();
    return Error{m_ok ? code : Code::Internal, std::move(message), place()};
}

CodePlace WireReader::place() {
    std::string file = text();
    return {std::move(file), number<std::int32_t>()};
}

} // namespace trundle
