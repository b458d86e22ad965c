#pragma once
#include <QTextBrowser>

#include "editor/shell/guide_index.h"

namespace trundle {

/// The user guide: the Markdown files of resources/guide.
class HelpPanel final : public QTextBrowser {
    Q_OBJECT
public:
    explicit HelpPanel(QWidget* parent = nullptr);

    /// Shows the section that explains the kind; the first page if there is none, or for nullptr.
    void showKind(const Kind* kind);
    void showConstruct(const QString& word); ///< "#import", "Param"

private:
    void showPlace(const QString& place);
    void onSourceChanged(const QUrl& source);
    void setType();
    void fitPictures();

protected:
    void resizeEvent(QResizeEvent* event) override;
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;

private:
    GuideIndex m_index;
};

} // namespace trundle
