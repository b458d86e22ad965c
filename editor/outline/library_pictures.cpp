#include "editor/outline/library_pictures.h"

#include "app/application.h"
#include "project/loading/search.h"
#include "render/service.h"

namespace trundle {

static constexpr std::uint32_t kWidth = 280, kHeight = 132; // pixels; aspect ratio of a library cell: nothing is cropped

LibraryPictures::LibraryPictures(Application& application, RenderService* render, QObject* parent)
    : QObject(parent), m_application(application), m_render(render) {
    m_pool.setMaxThreadCount(1);
}

LibraryPictures::~LibraryPictures() {
    m_ending = true;
    m_pool.clear();
    m_pool.waitForDone();
}

void LibraryPictures::want(const std::string& experiment, const std::string& folder) {
    if (!m_render) return;
    ++m_wanted;
    m_pool.start([this, experiment, folder] {
        const auto deliver = [this, experiment, picture = picture(experiment, folder)] {
            --m_wanted;
            if (!picture.isNull()) Q_EMIT drawn(experiment, picture);
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

/// Null if there is nothing to render.
QImage LibraryPictures::picture(const std::string& experiment, const std::string& folder) const {
    if (m_ending) return {};
    const std::string path = canonicalPath(folder + "/.library-picture.sim"); // only in the text overlay
    OpenOptions options;
    options.texts.emplace(path, std::make_shared<const std::string>(experiment));
    const Result<std::shared_ptr<const LoadedProject>> loaded = m_application.open(path, options);
    if (!loaded || m_ending) return {};
    const ExperimentSpec& shown = *loaded.value()->experiment;
    if (shown.robots.empty() && shown.statics.empty()) return {};
    PictureRequest request;
    request.scene = m_render->addScene(loaded.value()->experiment);
    request.width = kWidth;
    request.height = kHeight;
    const Result<Image> image = m_render->draw(request).get();
    m_render->removeScene(request.scene);
    if (!image) return {};
    const Image& pixels = image.value();
    return QImage(pixels.pixels.data(), int(pixels.width), int(pixels.height), int(pixels.width) * 3, QImage::Format_RGB888)
        .copy();
}

} // namespace trundle
