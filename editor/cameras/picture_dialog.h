#pragma once
#include <functional>

#include <QDialog>

#include "render/service.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace trundle {

class SizeChoice;

/// Asks for the size and file of an image of a viewport, then renders and writes it.
class PictureDialog final : public QDialog {
    Q_OBJECT
public:
    using PictureSource = std::function<PictureRequest(std::uint32_t width, std::uint32_t height)>;
    /// `still` returns the request for an image of a given size, with the state at the time of the call. The service outlives
    /// this.
    PictureDialog(RenderService& render, PictureSource still, QSize shown, const QString& file, QWidget* parent);
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
    PictureSource m_still;
    std::shared_ptr<Inbox> m_inbox;
    SizeChoice* m_size;
    QLineEdit* m_file;
    QLabel* m_words;
    QPushButton* m_save;
};

} // namespace trundle
