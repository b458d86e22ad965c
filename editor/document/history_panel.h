#pragma once
#include <QWidget>

class QListWidget;

namespace trundle {

class Document;

/// Lists the edits by name, oldest first, below the initial state. The current row is the document's state; selecting another
/// row by mouse or keyboard moves the document there. Undone edits are grey; a mark shows the saved state.
class HistoryPanel final : public QWidget {
    Q_OBJECT
public:
    explicit HistoryPanel(Document& document, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fillRows();
    void goTo(int row);
    void findSaved();

    Document& m_document;
    QListWidget* m_list;
    int m_saved = -1; ///< row of the saved state; -1: none
};

} // namespace trundle
