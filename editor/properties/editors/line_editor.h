#pragma once
#include "editor/properties/editors/row_editor.h"

namespace trundle {

/// Converts between a value and the line of text in which it is edited. Texts and names are shown without their quotes.
[[nodiscard]] QString lineText(const Row& row);
[[nodiscard]] ParsedValue typedValue(const Row& row, const QString& typed);
/// Sets text, colour, unit and state of a field that contains the whole value.
void showLine(ValueField& field, const Row& row);

/// The value as one line of text; accepts any text, formulas included.
class LineEditor final : public RowEditor {
    Q_OBJECT
public:
    explicit LineEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;
    [[nodiscard]] bool canScrub() const override;
    void scrub(double steps) override;

protected:
    void refresh() override;

private:
    ValueField* m_field;
    std::map<std::string, std::string> m_start; ///< texts by path when the drag began
};

} // namespace trundle
