#pragma once
#include <QTextBrowser>

#include "editor/shell/guide_index.h"

namespace trundle {

class GuideBar;

/// The user guide: the Markdown files of resources/guide.
class HelpPanel final : public QTextBrowser {
    Q_OBJECT
public:
    explicit HelpPanel(QWidget* parent = nullptr);

    /// Shows the section that explains the kind; the first page if there is none, or for nullptr.
    void showKind(const Kind* kind);
    void showConstruct(const QString& word); ///< "#import", "Param"
    /// Selects what follows the caret, in this page or in those after it, from the last one on in the first. False: no page has it.
    bool findNext(const QString& words);

private:
    void showPlace(const QString& place);
    void onSourceChanged(const QUrl& source);
    void setType();
    void fitPictures();

protected:
    void resizeEvent(QResizeEvent* event) override;
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void placeBar();

    GuideIndex m_index;
    GuideBar* m_bar;
};

} // namespace trundle
