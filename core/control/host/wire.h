#pragma once
// Values as bytes in the messages between a run and its host processes. Both sides are of the same build, so numbers are written
// as they are in memory.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/result.h"
#include "schema/kind.h"

namespace trundle {

class WireWriter {
public:
    template <class T> WireWriter& number(T value) {
        static_assert(std::is_arithmetic_v<T>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    WireWriter& bytes(std::string_view bytes) {
        number<std::uint64_t>(bytes.size());
        m_bytes.append(bytes);
        return *this;
    }
    template <class T> WireWriter& numbers(const std::vector<T>& values) {
        return bytes({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }
    WireWriter& value(const PropertyValue& value);
    WireWriter& status(const Status& status);
    WireWriter& place(const CodePlace& place);

    [[nodiscard]] std::string_view view() const { return m_bytes; }
    [[nodiscard]] std::string take() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// Reads what a WireWriter wrote. The bytes may come from a process that code of a module has damaged: past their end every value
/// is 0 or empty, and ok() is false.
class WireReader {
public:
    explicit WireReader(std::string_view bytes) : m_rest(bytes) {}

    template <class T> [[nodiscard]] T number() {
        static_assert(std::is_arithmetic_v<T>);
        T value{};
        if (const std::string_view from = take(sizeof value); m_ok) std::memcpy(&value, from.data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string_view bytes() { return take(number<std::uint64_t>()); }
    [[nodiscard]] std::string text() { return std::string(bytes()); }
    template <class T> [[nodiscard]] std::vector<T> numbers() {
        const std::string_view from = bytes();
        std::vector<T> values(from.size() / sizeof(T));
        if (!values.empty()) std::memcpy(values.data(), from.data(), values.size() * sizeof(T));
        return values;
    }
    /// The number of elements that follow; 0 if so many do not fit into the rest.
    [[nodiscard]] std::uint64_t count();
    [[nodiscard]] PropertyValue value();
    [[nodiscard]] Status status();
    [[nodiscard]] CodePlace place();

    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }

private:
    [[nodiscard]] std::string_view take(std::uint64_t count);
    std::string_view m_rest;
    bool m_ok = true;
};

} // namespace trundle
