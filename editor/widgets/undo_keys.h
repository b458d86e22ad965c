#pragma once
#include <QObject>

namespace trundle {

/// Of the whole program: a line of text that has nothing to undo leaves Ctrl+Z and Ctrl+Shift+Z to the experiment.
class UndoKeys final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace trundle
