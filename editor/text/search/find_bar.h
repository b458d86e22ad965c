#pragma once
#include <QWidget>

#include "editor/text/search/text_search.h"

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace trundle {

/// The row below the text with the search field, and a second one with the replacement.
class FindBar final : public QWidget {
    Q_OBJECT
public:
    explicit FindBar(QWidget* parent = nullptr);

    /// Shows the bar and focuses it; `words`, if not empty, become the search text.
    void open(const QString& words, bool replacing);
    [[nodiscard]] SearchOptions searchOptions() const;
    [[nodiscard]] QString replacement() const;
    [[nodiscard]] bool everywhere() const; ///< in all files, not only the current one
    void setEverywhere(bool everywhere);
    void showStatus(const QString& text, bool wrong = false);

Q_SIGNALS:
    void changed(); ///< the search has changed
    void step(int direction);
    void replaceOne();
    void replaceAll();
    void closed();
    void listRequested(); ///< the focus should move to the list of results

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QHBoxLayout* makeFindRow();
    void makeReplaceRow();
    QToolButton* button(const QString& text, const QString& name, const QString& tip);
    QToolButton* toggle(const QString& text, const QString& name, const QString& tip);

    QLineEdit *m_find, *m_replace;
    QToolButton *m_case, *m_words, *m_regex;
    QCheckBox* m_everywhere;
    QLabel* m_said;
    QWidget* m_second;
};

} // namespace trundle
