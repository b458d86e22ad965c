#include "editor/properties/editors/editor_for_kind.h"

#include "editor/properties/editors/choice_editor.h"
#include "editor/properties/editors/colour_editor.h"
#include "editor/properties/editors/file_editor.h"
#include "editor/properties/editors/line_editor.h"
#include "editor/properties/editors/numbers_editor.h"
#include "editor/properties/editors/reference_editor.h"

namespace trundle {

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
