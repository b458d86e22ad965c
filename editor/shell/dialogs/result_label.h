#pragma once
#include <QLabel>

namespace trundle {

/// In a dialog: what will be written, or in the colour of errors why nothing can be. The dialog grows with the text.
class ResultLabel final : public QLabel {
    Q_OBJECT
public:
    explicit ResultLabel(const char* name, int leastLines = 2); ///< that many do not move what is below

    void show(const QString& text, bool isFault);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    const int m_leastLines;
};

} // namespace trundle
