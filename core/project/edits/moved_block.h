#pragma once
// The text of one block while it is moved.

#include <optional>
#include <string>
#include <string_view>

#include <trundle/geometry.h>

#include "lang/tree.h"

namespace trundle {

/// The text of a position shifted by `offset` (m), as shift() below writes it; nothing if it is not three numbers or expressions.
/// `source` is the text of its file.
[[nodiscard]] std::optional<std::string> shiftedPosition(const Value& value, std::string_view source, const Vec3& offset);

class MovedBlock {
public:
    explicit MovedBlock(std::string text);

    [[nodiscard]] const std::string& text() const { return m_text; }
    /// Writes a value, replacing the existing assignment or adding one.
    void set(std::string_view key, const std::string& value);
    void remove(std::string_view key);
    void rename(const std::string& name);
    [[nodiscard]] const AssignmentItem* find(std::string_view key) const; ///< nullptr without one
    /// Shifts the position in `key` by `offset` (m): numbers keep their units, expressions become sums. Without an assignment,
    /// writes `otherwise`.
    void shift(std::string_view key, const Vec3& offset, const Vec3& otherwise);

private:
    [[nodiscard]] const BlockItem* block() const;
    void apply(const TextEdit& edit);

    std::string m_text;
    std::shared_ptr<const Tree> m_tree;
};

} // namespace trundle
