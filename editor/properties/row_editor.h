#pragma once
#include <QWidget>

#include "editor/properties/row.h"

namespace trundle {

class ValueField;

/// The part of a row in which its value is changed. It shows what it is given and asks the row's setter; it keeps no value.
class RowEditor : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    void display(const Row& row);
    [[nodiscard]] const Row& row() const { return m_row; }
    [[nodiscard]] virtual QWidget* focusField() const = 0; ///< where typing begins

    /// Dragging on the label changes a single number.
    [[nodiscard]] virtual bool canScrub() const { return false; }
    virtual void scrub(double steps) { Q_UNUSED(steps); }

Q_SIGNALS:
    void refusedChanged(const QString& reason); ///< empty: nothing is refused any more
    void scrubEnded();
    void scrubAbandoned(); ///< nothing of it is to be left; scrubEnded() follows

protected:
    virtual void refresh() = 0;
    /// Tries a value; a refusal is shown in the field.
    bool commit(ValueField* field, const Change& change, const std::string& mergeKey = {});
    /// For editors without a text: shows again what holds, and says why.
    bool commit(const Change& change, const std::string& mergeKey = {});

    Row m_row;
};

/// Made on demand, by what the row holds.
[[nodiscard]] RowEditor* makeEditor(EditorKind kind, QWidget* parent);

} // namespace trundle
