#pragma once
// A log of an experiment: a CSV file with a row, or some rows, at the initial state and every `Interval`.

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

/// What every log has in the text.
struct LogSettings {
    double interval = 0;             ///< s, 0: every tick
    std::optional<std::string> file; ///< in the log folder; none: "<name>.csv"
};

/// A picture that a log asks for.
struct PictureWish {
    std::string camera, view; ///< both empty: everything
    std::uint32_t width = 0, height = 0;
};
/// Gives the time that the picture shows (s): a camera with an UpdatePeriod took it earlier.
using PictureSaver = std::function<Result<double>(const PictureWish&, const std::string& fileName)>;

class Log {
public:
    virtual ~Log() = default;
    /// Called before anything else.
    virtual void usePictures(PictureSaver) {}
    /// The header row, then rows of the state that the world stands in.
    virtual void header(std::string& csv) const = 0;
    virtual void rows(const World& world, double time, std::string& csv) = 0;
};

/// Fills the object's fields from a resolved component; what the text leaves out keeps its default.
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

/// Describes what every log has, after its own fields.
template <class T> void describeLogSettings(Describe<T>& d) {
    d.field("Interval", &T::interval, seconds().atLeast(0),
            "Time between rows; 0 writes one every tick. The initial state is always there.");
    d.field("File", &T::file, text(), "File in the log folder; by default the log's name with .csv.");
}

// One maker per kind. Names that do not exist are diagnostics that list those that do; then there is no log.
std::unique_ptr<Log> makePoseLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeSignalLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeContactLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeFrameLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeEnergyLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeRadioLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);
std::unique_ptr<Log> makeLinkMatrix(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);

} // namespace trundle
