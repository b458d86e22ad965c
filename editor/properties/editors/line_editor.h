#pragma once
#include "editor/properties/editors/field_editor.h"

namespace trundle {

/// The value as one line of text. A number of a Param can be scrubbed.
class LineEditor final : public FieldEditor {
    Q_OBJECT
public:
    explicit LineEditor(QWidget* parent);
    [[nodiscard]] bool canScrub() const override;
    void scrub(double steps) override;

private:
    std::map<std::string, std::string> m_start; ///< texts by path when the drag began
};

} // namespace trundle
