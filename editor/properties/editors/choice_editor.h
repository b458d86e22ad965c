#pragma once
#include "editor/properties/editors/row_editor.h"

class QCheckBox;
class QComboBox;

namespace trundle {

/// Edits a property with a fixed set of values.
class ChoiceEditor final : public RowEditor {
    Q_OBJECT
public:
    explicit ChoiceEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;

protected:
    void refresh() override;

private:
    QComboBox* m_box;
};

/// Edits a boolean property.
class FlagEditor final : public RowEditor {
    Q_OBJECT
public:
    explicit FlagEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;

protected:
    void refresh() override;

private:
    QCheckBox* m_box;
};

} // namespace trundle
