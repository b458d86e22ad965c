#include "parts/frame_library.h"

#include "base/platform/dynamic_library.h"

namespace trundle {
namespace {

using MakeSource = FrameSource*(const ExperimentSpec*, const SignalLayout*, const FrameSourceWish*, std::size_t);

/// Keeps the library for as long as its code is needed.
class LoadedSource final : public FrameSource {
public:
    LoadedSource(DynamicLibrary library, std::unique_ptr<FrameSource> source)
        : m_library(std::move(library)), m_source(std::move(source)) {}

    Result<Frame> capture(const std::string& camera, const SignalBlock& block) override {
        return m_source->capture(camera, block);
    }
    Result<Frame> view(const std::string& name, std::uint32_t width, std::uint32_t height, const SignalBlock& block) override {
        return m_source->view(name, width, height, block);
    }
    Result<std::string> encode(const Frame& frame, const std::string& camera, const std::string& fileName) override {
        return m_source->encode(frame, camera, fileName);
    }
    std::string objectName(std::uint32_t object) const override { return m_source->objectName(object); }

private:
    DynamicLibrary m_library; // goes last
    std::unique_ptr<FrameSource> m_source;
};

} // namespace

Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& folder, const ExperimentSpec& experiment,
                                                     const SignalLayout& layout, const FrameSourceWish& wish) {
    Result<DynamicLibrary> library = DynamicLibrary::open(folder + "/" TRUNDLE_RENDER_LIBRARY);
    if (!library) return Error{Code::NoGraphics, "pictures cannot be drawn: " + library.error().message};
    auto* const make = library.value().function<MakeSource>("trundle_frame_source");
    std::unique_ptr<FrameSource> source(make ? make(&experiment, &layout, &wish, sizeof(RenderJob)) : nullptr);
    if (!source)
        return Error{Code::NoGraphics, "pictures cannot be drawn: " + library.value().path() + " is not this program's library"};
    library.value().keepLoaded(); // what drivers left behind in threads may still point into it
    return std::unique_ptr<FrameSource>(new LoadedSource(std::move(library).value(), std::move(source)));
}

} // namespace trundle
