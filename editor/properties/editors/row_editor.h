#pragma once
#include <QWidget>

#include "editor/properties/row.h"

namespace trundle {

class ValueField;

/// The widget of a row that edits its value. It has no state: it shows the row's value and calls the row's setter.
class RowEditor : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    void display(const Row& row);
    [[nodiscard]] const Row& row() const { return m_row; }
    [[nodiscard]] virtual QWidget* focusField() const = 0; ///< gets the focus for typing

    /// Whether dragging the row's label changes the value (a single number).
    [[nodiscard]] virtual bool canScrub() const { return false; }
    virtual void scrub(double steps) { Q_UNUSED(steps); }

Q_SIGNALS:
    void refusedChanged(const QString& reason); ///< empty: no refusal any more
    void scrubEnded();
    void scrubCancelled(); ///< discard the drag; scrubEnded() follows

protected:
    virtual void refresh() = 0;
    /// Applies a value; a refusal is shown in the field.
    bool commit(ValueField* field, const Change& change, const std::string& mergeKey = {});
    /// For editors without a text field: on failure shows the current value again and reports the reason.
    bool commit(const Change& change, const std::string& mergeKey = {});

    Row m_row;
};

} // namespace trundle
