#include "editor/viewport/gizmo/text_in_place.h"

#include <algorithm>

#include "lang/characters.h"
#include "model/dotted_path.h"
#include "model/provenance.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

bool usesIndex(std::string_view text) {
    for (std::size_t at = 0; (at = text.find("index", at)) != std::string_view::npos; at += 5) {
        const std::size_t end = at + (text.substr(at + 5).starts_with("2") ? 6 : 5);
        if ((at == 0 || !isIdent(text[at - 1])) && (end == text.size() || !isIdent(text[end]))) return true;
    }
    return false;
}

} // namespace

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

bool isPlacedByIndex(const LoadedProject& loaded, const std::string& path, const ObjectLocation& place) {
    const bool isRepeated = place.part->isRepeat() || !place.around.empty() || std::ranges::any_of(place.above, &Part::isRepeat);
    for (const char* key : {".Pos", ".HPR"}) {
        if (!isRepeated) return false;
        const auto from = provenanceOf(*loaded.outline, path + key);
        const bool isOfAll = place.members.empty() && textInPlace(loaded, path + key).empty();
        if (from && from->value.known() && isOfAll && usesIndex(loaded.sources.slice(from->value))) return true;
    }
    return false;
}

bool hasTextsOf(const LoadedProject& loaded, const std::string& path, const std::string& object,
                std::span<const char* const> keys) {
    return path == object || std::ranges::all_of(keys, [&](const char* key) {
               const auto text = provenanceOf(*loaded.outline, pathInside(path, key)),
                          own = provenanceOf(*loaded.outline, pathInside(object, key));
               return text.has_value() == own.has_value() && (!text || text->value == own->value);
           });
}

ObjectRef objectWithTexts(const LoadedProject& loaded, const std::string& path, const ObjectIndex& objects,
                          std::span<const ObjectRef> meant, std::span<const char* const> keys) {
    const auto it = std::ranges::find_if(
        meant, [&](const ObjectRef& object) { return hasTextsOf(loaded, path, objects.pathOf(object), keys); });
    return it == meant.end() ? meant.front() : *it;
}

GeomSpec sizedByText(const LoadedProject& loaded, const ObjectLocation& place, GeomSpec geom) {
    const auto read = [&](const char* key, double* numbers, std::size_t count) {
        if (const auto value = valueAt(loaded, place, key); value && value->numbers.size() == count)
            std::ranges::copy(value->numbers, numbers);
    };
    read("Size", geom.size.data(), 3);
    read("Radius", &geom.radius, 1);
    read("Length", &geom.length, 1);
    return geom;
}

} // namespace trundle
