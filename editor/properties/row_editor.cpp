#include "editor/properties/row_editor.h"

#include "editor/properties/choice_editor.h"
#include "editor/properties/colour_editor.h"
#include "editor/properties/file_editor.h"
#include "editor/properties/line_editor.h"
#include "editor/properties/numbers_editor.h"
#include "editor/properties/reference_editor.h"
#include "editor/properties/value_field.h"

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

RowEditor* makeEditor(EditorKind kind, QWidget* parent) {
    switch (kind) {
    case EditorKind::Numbers: return new NumbersEditor(parent);
    case EditorKind::Colour: return new ColourEditor(parent);
    case EditorKind::Choice: return new ChoiceEditor(parent);
    case EditorKind::Flag: return new FlagEditor(parent);
    case EditorKind::Reference: return new ReferenceEditor(parent);
    case EditorKind::File: return new FileEditor(parent);
    case EditorKind::Line: break;
    }
    return new LineEditor(parent);
}

} // namespace trundle
