#pragma once
#include <functional>

#include <QDialog>

#include "render/service.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace trundle {

class SizeChoice;

/// Asks how large a picture of a view is to be and where it goes, then draws and writes it.
class PictureDialog final : public QDialog {
    Q_OBJECT
public:
    using Still = std::function<PictureRequest(std::uint32_t width, std::uint32_t height)>;
    /// `still` gives what is drawn in each size, as things stand when it is asked. The service outlives this.
    PictureDialog(RenderService& render, Still still, QSize shown, const QString& file, QWidget* parent);
    ~PictureDialog() override;

Q_SIGNALS:
    void written(const QString& path);

public Q_SLOTS:
    void save();

private:
    struct Inbox;
    void showReady();
    void browse();
    void take(const QString& path, const QString& failure);

    RenderService& m_render;
    Still m_still;
    std::shared_ptr<Inbox> m_inbox;
    SizeChoice* m_size;
    QLineEdit* m_file;
    QLabel* m_words;
    QPushButton* m_save;
};

} // namespace trundle
