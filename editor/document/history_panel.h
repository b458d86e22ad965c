#pragma once
#include <QWidget>

class QListWidget;

namespace trundle {

class Document;

/// The edits by name, oldest first, below the state that was opened. The current row is the state the document is in; going to
/// another row, by mouse or keys, takes the document there. Edits that are undone are grey; a mark is at the state that the files
/// hold.
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
    int m_saved = -1; ///< row of the state that the files hold; -1: none has it
};

} // namespace trundle
