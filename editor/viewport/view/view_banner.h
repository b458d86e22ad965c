#pragma once
#include <string>

#include <QFrame>

class QLabel;
class QPushButton;

namespace trundle {

struct ViewContext;

/// Says over the views why the selection cannot be moved or scaled, with a button where one step helps.
class ViewBanner final : public QFrame {
    Q_OBJECT
public:
    /// The context must outlive this widget.
    ViewBanner(const ViewContext& context, QWidget* parent);

    /// Shows what holds now, or hides the banner. `busy`: during a drag a tool shows its own message, so none appears.
    void refresh(bool busy);
    /// Below `top` (pixels of the parent), as wide as its text or the parent allow.
    void place(int top);

private:
    void apply();

    const ViewContext& m_context;
    QLabel* m_text;
    QPushButton* m_button;
    std::string m_blockingLayout; // the layout that the button replaces by single instances
};

} // namespace trundle
