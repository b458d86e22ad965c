#pragma once
#include <functional>

#include <QWidget>

class QLineEdit;
class QTextBrowser;

namespace trundle {

/// Above a page of the guide: back, forward, contents, and a search in all pages.
class GuideBar final : public QWidget {
    Q_OBJECT
public:
    struct Acts {
        std::function<void()> showContents;
        std::function<bool(const QString& words)> findNext; ///< false: no page has them
    };
    GuideBar(QTextBrowser& pages, Acts acts);
    void focusSearch();

private:
    void search();

    Acts m_acts;
    QLineEdit* m_words;
};

} // namespace trundle
