#pragma once
// The property values of one object: their texts, evaluated values and source ranges.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "project/objects/path_scopes.h"
#include "schema/value_reader.h"

namespace trundle {

/// Where the value of a property is set, relative to the object.
enum class ValueOrigin {
    Default,    ///< not set
    Own,        ///< in the object's own block
    Override,   ///< in the instance, overriding its config
    Config,     ///< in the config of the instance
    CommandLine ///< in a `--set`
};

/// Bytes of a value's text up to which it is shown in a row; a row holds it several times.
inline constexpr std::uint32_t kMaxShownValue = 64 * 1024;

/// The value of one property or Param of one object. `property` is valid as long as the project it was read from.
struct FieldValue {
    std::string path;                   ///< "robot0.leftMotor.Resistance"
    const Property* property = nullptr; ///< nullptr: a Param
    const ParamDescription* description = nullptr; ///< of a Param; nullptr: nothing is said about it
    ValueOrigin origin = ValueOrigin::Default;
    SourceRange place;                  ///< range of the value's text; if it is not set, of the block that would contain it
    std::string text;                   ///< as written; a default as it would be written; empty: not set
    std::vector<TextRange> elements;    ///< ranges in `text`
    bool formula = false;               ///< contains Params or an expression
    bool broken = false;                ///< syntax error
    bool isLong = false;                ///< above kMaxShownValue: text, elements and value are left empty
    std::optional<PropertyValue> value; ///< evaluated; nothing if not set or invalid
    std::string shown;                  ///< of a formula: its evaluated value for display
    std::string separator = ",";        ///< between elements, as in the file
    std::string config, inherited;      ///< of an override: the config's name, and its value there with unit; empty: none
    /// Of an override that is for more members of a Repeat than this one: its path in the instance, "roller.axle.Damping".
    std::string setForAll;
    std::vector<std::string> parts;     ///< of a formula: the evaluated value of each element, if their numbers match

    [[nodiscard]] bool given() const { return origin != ValueOrigin::Default; }
    [[nodiscard]] std::string element(std::size_t i) const;
    /// The text with one element replaced. Separators are kept.
    [[nodiscard]] std::string with(std::size_t i, const std::string& element) const;
    /// The text before an element.
    [[nodiscard]] std::string before(std::size_t i) const;
};

/// Reads the values of one object. A member of a Grid or Scatter is treated as the whole Grid or Scatter.
class ObjectValues {
public:
    ObjectValues(std::shared_ptr<const LoadedProject> loaded, std::string path);

    [[nodiscard]] bool exists() const { return m_kind != nullptr || m_part != nullptr; }
    [[nodiscard]] const std::string& path() const { return m_path; }           ///< for a member: the path of its Grid or Scatter
    [[nodiscard]] const std::string& shownPath() const { return m_shownPath; } ///< as selected
    /// nullptr if the kind is unknown, for example of a module that could not be loaded.
    [[nodiscard]] const Kind* kind() const { return m_kind; }
    [[nodiscard]] const Part* part() const { return m_part; }               ///< nullptr: the experiment
    [[nodiscard]] const Part* instance() const { return m_place.instance; } ///< the object, or the path goes through it
    [[nodiscard]] const Part* config() const { return m_config; } ///< of the object, of the instance, or the one that contains it
    /// The innermost config that has the object's block: within a Part the PartConfig. nullptr: it is in none.
    [[nodiscard]] const Part* definedIn() const;
    [[nodiscard]] bool isInstance() const { return m_part && isPlaced(*m_part); }
    [[nodiscard]] bool inConfig() const { return m_inConfig; } ///< the block is in the instance's config
    /// Path below instance(), "left.wheel"; empty: it is the instance, or there is none.
    [[nodiscard]] const std::string& within() const { return m_place.within; }
    [[nodiscard]] bool member() const { return m_member; }
    [[nodiscard]] const LoadedProject& loaded() const { return *m_loaded; }
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& sharedLoaded() const { return m_loaded; }

    [[nodiscard]] std::vector<FieldValue> properties();
    [[nodiscard]] std::optional<FieldValue> property(std::string_view name);
    /// The first `most` Params declared in the object; for an instance, those of its config.
    [[nodiscard]] std::vector<FieldValue> params(std::size_t most);
    /// For an instance: properties of the config itself.
    [[nodiscard]] std::vector<FieldValue> configProperties();
    /// For an instance: paths, relative to its config, of the values that it overrides ("leftMotor.Resistance").
    [[nodiscard]] std::vector<std::string> overrides() const;

private:
    /// The text of a value and the Params in its scope.
    struct ValueText {
        const Value* value = nullptr;
        FileId file = kNoFile;
        ParamScope* scope = nullptr;
        ValueOrigin origin = ValueOrigin::Default;
    };
    [[nodiscard]] FieldValue read(const Property& property, const std::string& path, const AssignmentList* list,
                                  ParamScope& scope);
    [[nodiscard]] FieldValue readParam(const SourceParam& param);
    void fill(FieldValue& field, const ValueText& written);
    void fillInherited(FieldValue& field, const PathScopes::Layer& from, const Value* value, FileId file) const;
    void showFormula(FieldValue& field, const GivenValue& given);
    [[nodiscard]] std::string below(std::string_view name) const;
    [[nodiscard]] const std::string& separator();

    std::shared_ptr<const LoadedProject> m_loaded;
    std::string m_path, m_shownPath;
    std::string m_separator; ///< cached; empty: not determined yet
    ObjectLocation m_place;
    std::unique_ptr<PathScopes> m_scopes;
    const Kind* m_kind = nullptr;
    const Part *m_part = nullptr, *m_config = nullptr;
    bool m_member = false, m_inConfig = false;
    Diagnostics m_silent;
};

} // namespace trundle
