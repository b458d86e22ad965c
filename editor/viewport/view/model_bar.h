#pragma once
#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace trundle {

class Actions;
class Document;

/// Above the views while a model is edited: which one, and the buttons that drive it and that return to the experiment.
class ModelBar final : public QFrame {
    Q_OBJECT
public:
    /// Both must outlive this widget.
    ModelBar(const Document& document, Actions& actions, QWidget* parent = nullptr);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addTexts(QHBoxLayout& row);
    void show();
    void fitDetail();
    [[nodiscard]] QString detail() const;

    const Document& m_document;
    Actions& m_actions;
    QLabel *m_title, *m_detail;
};

} // namespace trundle
