#pragma once
// The text of one block while its place changes.

#include <optional>
#include <string>
#include <string_view>

#include <trundle/geometry.h>

#include "lang/tree.h"

namespace trundle {

/// The text of a position moved by `offset` (m), as shift() below writes it; nothing where it is not three numbers or formulas.
/// `source` is the file's.
[[nodiscard]] std::optional<std::string> shiftedPosition(const Value& value, std::string_view source, const Vec3& offset);

class PlacedText {
public:
    explicit PlacedText(std::string text);

    [[nodiscard]] const std::string& text() const { return m_text; }
    /// Writes a value, in place of the one that stands there or as a new assignment.
    void set(std::string_view key, const std::string& value);
    void rename(const std::string& name);
    /// Moves what `key` says by `offset` (m): numbers keep their units, formulas become sums. Where nothing stands there, it is
    /// written as `otherwise` says.
    void shift(std::string_view key, const Vec3& offset, const Vec3& otherwise);

private:
    [[nodiscard]] const BlockItem* block() const;
    [[nodiscard]] const AssignmentItem* find(std::string_view key) const;
    void apply(const TextEdit& edit);

    std::string m_text;
    std::shared_ptr<const Tree> m_tree;
};

} // namespace trundle
