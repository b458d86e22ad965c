#include "app/render_library.h"

#include "base/platform/dynamic_library.h"

namespace trundle {
namespace {

using MakeSource = ImageSource*(const ExperimentSpec*, const SignalLayout*, const ImageSourceRequest*, std::size_t);

/// An image source together with the library that contains its code.
class LoadedSource final : public ImageSource {
public:
    LoadedSource(DynamicLibrary library, std::unique_ptr<ImageSource> source)
        : m_library(std::move(library)), m_source(std::move(source)) {}

    Result<CameraImage> capture(const std::string& camera, const SignalBlock& block) override {
        return m_source->capture(camera, block);
    }
    Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                             const SignalBlock& block) override {
        return m_source->view(name, width, height, block);
    }
    Result<std::string> encode(const CameraImage& frame, const std::string& camera, const std::string& fileName) override {
        return m_source->encode(frame, camera, fileName);
    }

private:
    DynamicLibrary m_library; // destroyed last
    std::unique_ptr<ImageSource> m_source;
};

} // namespace

Result<std::unique_ptr<ImageSource>> openImageSource(const std::string& folder, const ExperimentSpec& experiment,
                                                     const SignalLayout& layout, const ImageSourceRequest& pictureOptions) {
    Result<DynamicLibrary> library = DynamicLibrary::open(folder + "/" TRUNDLE_RENDER_LIBRARY);
    if (!library) return Error{Code::NoGraphics, "pictures cannot be drawn: " + library.error().message};
    auto* const make = library.value().function<MakeSource>("trundle_frame_source");
    std::unique_ptr<ImageSource> source(make ? make(&experiment, &layout, &pictureOptions, sizeof(RenderJob)) : nullptr);
    if (!source)
        return Error{Code::NoGraphics, "pictures cannot be drawn: " + library.value().path() + " is not this program's library"};
    library.value().keepLoaded(); // drivers may have started threads that still run code of the library
    return std::unique_ptr<ImageSource>(new LoadedSource(std::move(library).value(), std::move(source)));
}

} // namespace trundle
