#pragma once
#include <QFrame>

#include "base/source_range.h"

class QLabel;

namespace trundle {

struct Row;

/// Describes the focused row: unit and range, help, origin of its value, and why a typed value was refused.
class HelpStrip final : public QFrame {
    Q_OBJECT
public:
    explicit HelpStrip(QWidget* parent);
    void display(const Row& row, const QString& refusal, bool running);
    void displayText(const QString& text); ///< help of the kind, while no row is focused

Q_SIGNALS:
    void jumpRequested(const trundle::SourceRange& place);

private:
    QLabel *m_title, *m_help, *m_origin;
    SourceRange m_place;
};

} // namespace trundle
