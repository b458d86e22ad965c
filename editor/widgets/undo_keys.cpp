#include "editor/widgets/undo_keys.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace trundle {

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* line = qobject_cast<QLineEdit*>(watched);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool hasNone = line && ((key->matches(QKeySequence::Undo) && !line->isUndoAvailable()) ||
                                  (key->matches(QKeySequence::Redo) && !line->isRedoAvailable()));
    if (!hasNone) return false;
    event->ignore(); // else the line would accept it, and do nothing
    return true;
}

} // namespace trundle
