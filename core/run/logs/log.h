#pragma once
// Interface of logs: a CSV file with one or more rows for the initial state and then every `Interval`.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <trundle/describe.h>

#include "base/diagnostic.h"
#include "model/experiment_spec.h"
#include "world/world.h"

namespace trundle {

/// Settings shared by all logs.
struct LogSettings {
    double interval = 0;             ///< s; 0: every tick
    std::optional<std::string> file; ///< path in the log folder; none: "<name>.csv"
};

/// An image requested by a log.
struct PictureOptions {
    std::string camera, view; ///< both empty: the whole scene
    std::uint32_t width = 0, height = 0;
};
/// Saves an image and returns the time (s) that it shows: earlier than now for a camera with an UpdatePeriod.
using PictureSaver = std::function<Result<double>(const PictureOptions&, const std::string& fileName)>;

class RunLog {
public:
    virtual ~RunLog() = default;
    /// Called before all other functions.
    virtual void usePictures(PictureSaver) {}
    /// The header row; rows() appends the rows for the world's current state.
    virtual void header(std::string& csv) const = 0;
    virtual void rows(const World& world, double time, std::string& csv) = 0;
    /// Appends what it has collected since the last rows(): the file is flushed or closed before the next are due.
    virtual void collected(std::string&) {}
};

/// Sets the fields of a T from a resolved component; properties not given keep their defaults.
template <class T> T settingsFrom(const ComponentSpec& spec) {
    T settings;
    for (const FieldInfo& field : descriptionOf<T>().fields()) {
        const ResolvedValue* given = spec.find(field.name);
        if (!given) continue;
        const bool isText = field.type >= TRUNDLE_CHOICE;
        const std::size_t count = isText ? given->value.texts.size() : given->value.numbers.size();
        if (count == 0 || count < field.minCount) continue;
        std::vector<const char*> texts;
        for (const std::string& text : given->value.texts) texts.push_back(text.c_str());
        field.set(&settings, {given->value.numbers.data(), texts.data(), static_cast<std::uint32_t>(count)});
    }
    return settings;
}

/// Describes the settings shared by all logs, after the log's own fields.
template <class T> void describeLogSettings(Describe<T>& d) {
    d.field("Interval", &T::interval, seconds().atLeast(0),
            "Time between rows; 0 writes one every tick. The initial state is always there.");
    d.field("File", &T::file, text(), "File in the log folder; by default the log's name with .csv.");
}

// One factory per kind. An unknown name is an error that lists the existing names; the result is then nullptr.
std::unique_ptr<RunLog> makePoseLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeSignalLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeContactLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeFrameLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeEnergyLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeRadioLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<RunLog> makeLinkMatrix(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);

} // namespace trundle
