#pragma once
// Whether long lines are wrapped, at the widget's current width.

#include <QObject>

#include "editor/text/code/qscintilla.h"
#include "editor/widgets/preferences.h"

namespace trundle {

class CodeWrapping final : public QObject {
    Q_OBJECT
public:
    /// `edit` must outlive this object.
    explicit CodeWrapping(QsciScintilla& edit) : m_edit(edit) {}

    void setMode(WrapLines mode);
    void setPlain(bool plain); ///< never, for large texts
    [[nodiscard]] bool wraps() const { return m_wraps; }
    void update(); ///< after a change of the widget's width, margins or font

Q_SIGNALS:
    void changed();

private:
    QsciScintilla& m_edit;
    WrapLines m_mode = WrapLines::InNarrowPanes;
    bool m_plain = false, m_wraps = false;
};

} // namespace trundle
