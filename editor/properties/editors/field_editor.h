#pragma once
#include "editor/properties/editors/row_editor.h"

class QToolButton;

namespace trundle {

/// An editor whose one field contains the whole value as a line of text, formulas included. Texts and names are shown without their
/// quotes.
class FieldEditor : public RowEditor {
    Q_OBJECT
public:
    [[nodiscard]] QWidget* focusField() const override;

protected:
    explicit FieldEditor(QWidget* parent);
    void refresh() override;
    /// Behind the field, in its height.
    QToolButton* addButton(const QString& name, const QString& tip);

    ValueField* m_field;
};

} // namespace trundle
