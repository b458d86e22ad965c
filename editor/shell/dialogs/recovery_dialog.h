#pragma once
#include <functional>

#include <QDialog>
#include <QListWidget>
#include <QTextBrowser>

#include "editor/document/document.h"

namespace trundle {

/// Offers to restore the unsaved edits of a window that crashed, and shows their differences from the files. Nothing is
/// discarded without a question: closing the dialog keeps the journals, and they are offered again at the next start.
class RecoveryDialog final : public QDialog {
    Q_OBJECT
public:
    /// `confirmClose` asks about unsaved edits that restoring would replace.
    RecoveryDialog(Document& document, std::vector<Recovery> found, std::function<bool()> confirmClose, QWidget* parent);

private:
    void show(int row);
    void restore();
    void discard();

    Document& m_document;
    std::vector<Recovery> m_found;
    std::function<bool()> m_confirmClose;
    QListWidget* m_list = new QListWidget;
    QTextBrowser* m_preview = new QTextBrowser;
};

} // namespace trundle
