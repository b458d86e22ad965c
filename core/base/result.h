#pragma once
// The result of an operation that may fail: a value, or the reason why there is none.

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/assert.h"
#include "base/code_place.h"
#include "base/codes.h"

namespace trundle {

/// Why an operation failed; becomes a Diagnostic where a source range is known.
struct Error {
    Code code = Code::Internal;
    std::string message;
    CodePlace place = {}; ///< in the source of a module, where the fault is there
};

template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::move(value)) {}
    Result(Error error) : m_state(std::move(error)) {}

    [[nodiscard]] bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T& value() & {
        TRUNDLE_ASSERT(ok());
        return *std::get_if<0>(&m_state);
    }
    [[nodiscard]] const T& value() const& {
        TRUNDLE_ASSERT(ok());
        return *std::get_if<0>(&m_state);
    }
    [[nodiscard]] T&& value() && {
        TRUNDLE_ASSERT(ok());
        return std::move(*std::get_if<0>(&m_state));
    }
    [[nodiscard]] const Error& error() const {
        TRUNDLE_ASSERT(!ok());
        return *std::get_if<1>(&m_state);
    }

private:
    std::variant<T, Error> m_state;
};

/// A Result without a value.
class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Error error) : m_error(std::move(error)) {}

    [[nodiscard]] bool ok() const { return !m_error.has_value(); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] const Error& error() const {
        TRUNDLE_ASSERT(!ok());
        return *m_error;
    }

private:
    std::optional<Error> m_error;
};

} // namespace trundle
