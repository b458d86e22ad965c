#pragma once
#include <QWidget>

#include "editor/text/text_search.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace trundle {

/// The row under the text in which one says what to find, and a second one for what to put there.
class FindBar final : public QWidget {
    Q_OBJECT
public:
    explicit FindBar(QWidget* parent = nullptr);

    /// Shows it and takes the keyboard; `words`, where there are some, are what to find.
    void open(const QString& words, bool replacing);
    [[nodiscard]] SearchWish wish() const;
    [[nodiscard]] QString replacement() const;
    [[nodiscard]] bool everywhere() const; ///< in all files, not only the one in front
    void setEverywhere(bool everywhere);
    void say(const QString& text, bool wrong = false);

Q_SIGNALS:
    void changed(); ///< what to find is another one
    void step(int direction);
    void replaceOne();
    void replaceAll();
    void closed();
    void listWanted(); ///< the keyboard is to go to the list of what was found

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QToolButton* toggle(const QString& text, const QString& name, const QString& tip);

    QLineEdit *m_find, *m_replace;
    QToolButton *m_case, *m_words, *m_regex;
    QCheckBox* m_everywhere;
    QLabel* m_said;
    QWidget* m_second;
};

} // namespace trundle
