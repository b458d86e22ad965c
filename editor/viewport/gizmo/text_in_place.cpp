#include "editor/viewport/gizmo/text_in_place.h"

#include "model/dotted_path.h"
#include "model/provenance.h"
#include "project/objects/object_location.h"

namespace trundle {

std::string textInPlace(const LoadedProject& loaded, const std::string& property) {
    const auto from = provenanceOf(*loaded.outline, property);
    if (!from || !from->value.known()) return {};
    // A value written in the config is not edited through an instance; the instance gets a new value with plain numbers.
    const bool inConfig = property.starts_with("RobotConfig.") || property.starts_with("StaticConfig.");
    if (const auto place = placeOf(loaded, withoutLastWord(property)); inConfig && place && !place->above.empty()) {
        const SourceRange config = place->above.front()->range; // a value in a PartConfig is not edited through its Part
        if (config.file != from->value.file || from->value.range.begin < config.range.begin ||
            from->value.range.end > config.range.end)
            return {};
    }
    const SourceRange own = blockOf(loaded, firstWord(property));
    const bool inPlace = inConfig || (own.known() && own.file == from->value.file && own.range.begin <= from->value.range.begin &&
                                      from->value.range.end <= own.range.end);
    return inPlace ? std::string(loaded.sources.slice(from->value)) : std::string();
}

} // namespace trundle
