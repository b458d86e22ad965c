#pragma once
#include "editor/properties/row_editor.h"

namespace trundle {

/// What one line of text shows of a value, and the text that what was typed there becomes. Texts and names stand there without
/// their quotes.
[[nodiscard]] QString lineText(const Row& row);
[[nodiscard]] std::string typedText(const Row& row, const QString& typed);
/// Text, colour, unit and state of a field that holds the whole value.
void showLine(ValueField& field, const Row& row);

/// The value as one line of text: anything may be typed, formulas too.
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
