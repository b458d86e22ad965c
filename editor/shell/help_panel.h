#pragma once
#include <QTextBrowser>

namespace trundle {

/// The user guide: the Markdown files of resources/guide.
class HelpPanel final : public QTextBrowser {
    Q_OBJECT
public:
    explicit HelpPanel(QWidget* parent = nullptr);

private:
    void setType();
    void fitPictures();

protected:
    void resizeEvent(QResizeEvent* event) override;
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;
};

} // namespace trundle
