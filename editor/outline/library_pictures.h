#pragma once
// Renders the library's previews on a worker thread.

#include <atomic>
#include <memory>
#include <string>

#include <QImage>
#include <QObject>
#include <QThreadPool>

namespace trundle {

class Application;
class RenderService;

class LibraryPictures final : public QObject {
    Q_OBJECT
public:
    /// `render` is null without OpenGL; then nothing is rendered. Both must outlive this object.
    LibraryPictures(Application& application, RenderService* render, QObject* parent = nullptr);
    /// Waits for the preview being rendered.
    ~LibraryPictures() override;

    /// Requests the preview of an experiment given as text; `folder` is the search folder of its imports. drawn() follows,
    /// except on failure.
    void want(const std::string& experiment, const std::string& folder);

    /// Number of previews not rendered yet.
    [[nodiscard]] int wanted() const { return m_wanted; }

Q_SIGNALS:
    void drawn(const std::string& experiment, const QImage& picture);

private:
    [[nodiscard]] QImage picture(const std::string& experiment, const std::string& folder) const;

    Application& m_application;
    RenderService* m_render;
    std::atomic<bool> m_ending = false;
    int m_wanted = 0;
    QThreadPool m_pool; // one preview at a time; the last member: destroyed first, it waits for its thread
};

} // namespace trundle
