#include <cstdio>

#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_folder.h"
#include "run/logs/log_kinds.h"
#include "run/logs/log_settings.h"

namespace trundle {
namespace {

class FrameLog final : public RunLog {
public:
    /// `folder`: that of the table, with "/"; its pictures are beside it.
    FrameLog(std::string folder, std::string name, const FrameLogSettings& settings)
        : m_folder(std::move(folder)),
          m_name(std::move(name)), m_pictureOptions{settings.camera.value_or(""), settings.view.value_or(""),
                                                    static_cast<std::uint32_t>(settings.size[0]),
                                                    static_cast<std::uint32_t>(settings.size[1])},
          m_ending(settings.format) {}

    void usePictures(PictureSaver save) override { m_save = std::move(save); }

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        for (const char* name : {"time [s]", "picture"}) out.cell(name);
        out.endRow();
    }

    /// The time is that of the image. The file name is empty if the image could not be taken.
    void rows(const World&, double time, std::string& csv) override {
        char number[32];
        std::snprintf(number, sizeof number, "_%06llu.", static_cast<unsigned long long>(m_frames++));
        const std::string file = m_name + number + m_ending;
        const Result<double> taken =
            m_save ? m_save(m_pictureOptions, m_folder + file) : Result<double>(Error{Code::NoGraphics, ""});
        CsvWriter out(csv);
        out.cell(taken ? taken.value() : time).cell(taken ? file : std::string());
        out.endRow();
    }

private:
    std::string m_folder, m_name;
    PictureOptions m_pictureOptions;
    std::string m_ending;
    PictureSaver m_save;
    std::uint64_t m_frames = 0;
};

} // namespace

void FrameLogSettings::describe(Describe<FrameLogSettings>& d) {
    d.help("Pictures of the run as numbered files, from a robot's camera or a View, and a table that says when each was taken: "
           "of a camera with an UpdatePeriod, its newest picture and the time of that. A run saves at most 100,000 pictures.");
    d.field("Camera", &FrameLogSettings::camera, text(), "The camera that takes them, as robot0/eye.");
    d.field("View", &FrameLogSettings::view, text(), "The View they are taken from; without it and a camera, one of everything.");
    Quantity pixels = number().within(1, 4096);
    pixels.type = TRUNDLE_INTEGER;
    d.field("Size", &FrameLogSettings::size, pixels, "Width and height in pixels; a camera has its own.");
    d.field("Format", &FrameLogSettings::format, oneOf("jpg|png"), "What kind of files.");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makeFrameLog(const ComponentSpec& spec, const World&, Diagnostics&) {
    const Result<std::string> table = cleanLogName(logFileName(spec)); // a name that is refused is reported with its file
    std::string folder = table ? table.value().substr(0, table.value().rfind('/') + 1) : std::string();
    return std::make_unique<FrameLog>(std::move(folder), spec.name, settingsFrom<FrameLogSettings>(spec));
}

} // namespace trundle
