#include "editor/properties/editors/row_editor.h"

#include "editor/properties/editors/value_field.h"

namespace trundle {

void RowEditor::display(const Row& row) {
    m_row = row;
    refresh();
}

bool RowEditor::commit(ValueField* field, const Change& change, const std::string& mergeKey) {
    const Setter set = m_row.set; // a copy: the change may replace the row
    const QPointer<ValueField> alive(field);
    const Status done = set(change, mergeKey);
    if (!done && alive) alive->setError(QString::fromStdString(done.error().message));
    return done.ok();
}

bool RowEditor::commit(const Change& change, const std::string& mergeKey) {
    const Setter set = m_row.set;
    const QPointer<RowEditor> alive(this);
    const Status done = set(change, mergeKey);
    if (!alive) return done.ok();
    if (!done) refresh();
    Q_EMIT refusedChanged(done ? QString() : QString::fromStdString(done.error().message));
    return done.ok();
}

} // namespace trundle
