#pragma once
// A property row as data: what it shows, and how its value is set. Its editor widget is created when it is shown.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "lang/parsed_value.h"
#include "project/objects/object_values.h"

namespace trundle {

/// Returns the new value given the current one; called for each selected object. Empty: the value is removed.
using Change = std::function<ParsedValue(const FieldValue&)>;
/// Sets a value in all selected objects as one undo step, or fails with the reason and changes nothing.
using Setter = std::function<Status(const Change& change, const std::string& mergeKey)>;

enum class EditorKind { Line, Numbers, Colour, Choice, Flag, Reference, File };

struct Row {
    std::string id; ///< the same for every selection that has the row: "Pos", "controller.Speed"
    QString label, section;
    std::vector<FieldValue> values; ///< one per selected object, never empty
    std::shared_ptr<const LoadedProject> loaded;
    bool afterReset = false;                              ///< the run has another value until it is reset
    std::function<QString()> now;                         ///< position or rotation in the run; null: the row has none
    std::string folder;                                   ///< of the file that contains the value; file paths are relative to it
    std::function<std::vector<std::string>()> candidates; ///< valid names for a reference, or for a Param that stands for one
    Setter set;

    [[nodiscard]] const FieldValue& first() const { return values.front(); }
    [[nodiscard]] const Property* property() const { return values.front().property; }
    /// The words to choose from, of a property or a described Param; empty: none.
    [[nodiscard]] std::vector<std::string> choices() const;
    [[nodiscard]] bool mixed() const;
    [[nodiscard]] bool mixedElement(std::size_t i) const;
    [[nodiscard]] bool given() const;  ///< set for at least one object
    [[nodiscard]] bool isLong() const; ///< a value is too long to be shown; it can only be reset
    [[nodiscard]] EditorKind editor() const;
    /// Number of fields if the row edits single numbers.
    [[nodiscard]] std::size_t fieldCount() const;
};

} // namespace trundle
