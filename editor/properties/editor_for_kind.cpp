#include "editor/properties/editor_for_kind.h"

#include "editor/properties/choice_editor.h"
#include "editor/properties/colour_editor.h"
#include "editor/properties/file_editor.h"
#include "editor/properties/line_editor.h"
#include "editor/properties/numbers_editor.h"
#include "editor/properties/reference_editor.h"

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
