#pragma once
// A row of the property panel as data: what it shows, and how it sets a value. Its editor is made when it is shown.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "editor/properties/object_values.h"

namespace trundle {

/// Gives the new text of a value from the present one: called for each selected object. Empty: the value is to be taken out.
using Change = std::function<std::string(const FieldValue&)>;
/// Sets a value in all selected objects as one step of undo, or fails with the reason and changes nothing.
using Setter = std::function<Status(const Change& change, const std::string& mergeKey)>;

enum class EditorKind { Line, Numbers, Colour, Choice, Flag, Reference, File };

struct Row {
    std::string id; ///< the same in any selection that has the row: "Pos", "controller.Speed"
    QString label, section;
    std::vector<FieldValue> values; ///< of each selected object, never empty
    std::shared_ptr<const Loaded> loaded;
    bool afterReset = false;                              ///< what runs has another value and keeps it until reset
    std::function<QString()> now;                         ///< where it stands in the run, empty at its start; none: no such thing
    std::string folder;                                   ///< of the file that holds the value, for files named relative to it
    std::function<std::vector<std::string>()> candidates; ///< names that fit a reference
    Setter set;

    [[nodiscard]] const FieldValue& first() const { return values.front(); }
    [[nodiscard]] const Property* property() const { return values.front().property; }
    [[nodiscard]] bool mixed() const;
    [[nodiscard]] bool mixedElement(std::size_t i) const;
    [[nodiscard]] bool given() const; ///< by at least one
    [[nodiscard]] EditorKind editor() const;
    /// Single numbers side by side.
    [[nodiscard]] std::size_t fieldCount() const;
};

} // namespace trundle
