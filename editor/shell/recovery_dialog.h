#pragma once
#include <functional>

#include <QDialog>
#include <QListWidget>
#include <QTextBrowser>

#include "editor/document/document.h"

namespace trundle {

/// Offers what a window that ended badly has left, with what differs from the disk. Nothing is thrown away unasked: closing the
/// dialog keeps the journals, and the next start offers them again.
class RecoveryDialog final : public QDialog {
    Q_OBJECT
public:
    /// `mayLeave` asks what becomes of unsaved edits that would give way to those brought back.
    RecoveryDialog(Document& document, std::vector<Recovery> found, std::function<bool()> mayLeave, QWidget* parent);

private:
    void show(int row);
    void bringBack();
    void discard();

    Document& m_document;
    std::vector<Recovery> m_found;
    std::function<bool()> m_mayLeave;
    QListWidget* m_list = new QListWidget;
    QTextBrowser* m_preview = new QTextBrowser;
};

} // namespace trundle
