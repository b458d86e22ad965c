#pragma once
// Small pictures of things, drawn beside the GUI.

#include <atomic>
#include <memory>
#include <string>

#include <QImage>
#include <QObject>
#include <QThreadPool>

namespace trundle {

class Parts;
class RenderService;

class LibraryPictures final : public QObject {
    Q_OBJECT
public:
    /// `render` is null where no OpenGL is to be had: then nothing is ever drawn. Both outlive this.
    LibraryPictures(Parts& parts, RenderService* render, QObject* parent = nullptr);
    /// Waits for the picture in work.
    ~LibraryPictures() override;

    /// Draws an experiment given as a text whose imports are looked for from `folder`. drawn() follows, unless it cannot be.
    void want(const std::string& experiment, const std::string& folder);

    /// Pictures not drawn yet.
    [[nodiscard]] int wanted() const { return m_wanted; }

Q_SIGNALS:
    void drawn(const std::string& experiment, const QImage& picture);

private:
    [[nodiscard]] QImage picture(const std::string& experiment, const std::string& folder) const;

    Parts& m_parts;
    RenderService* m_render;
    std::atomic<bool> m_ending = false;
    int m_wanted = 0;
    QThreadPool m_pool; // one after the other; the last member, so that it ends first
};

} // namespace trundle
