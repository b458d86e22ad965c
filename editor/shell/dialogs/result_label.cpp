#include "editor/shell/dialogs/result_label.h"

#include <algorithm>

#include "editor/widgets/theme.h"

namespace trundle {

ResultLabel::ResultLabel(const char* name, int leastLines) : m_leastLines(leastLines) {
    setObjectName(QLatin1String(name));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignTop | Qt::AlignLeft);
    fit();
}

void ResultLabel::fit() {
    const int least = m_leastLines * fontMetrics().lineSpacing() + 2;
    setMinimumHeight(isVisible() ? std::max(least, heightForWidth(width())) : least);
}

void ResultLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void ResultLabel::show(const QString& text, bool isFault) {
    QPalette palette;
    if (isFault) palette.setColor(QPalette::WindowText, ink(Ink::Error));
    setPalette(palette);
    setText(text);
    fit();
}

} // namespace trundle
