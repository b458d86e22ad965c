#pragma once
// What the properties of one object hold: their texts, what they come to, and where they stand.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/params.h"
#include "project/project.h"

namespace trundle {

/// Where a value stands, seen from the object that is asked for it.
enum class Standing {
    Default,    ///< nowhere
    Own,        ///< in the object's own block
    Override,   ///< in the instance, in place of its config's
    Config,     ///< in the config of the instance
    CommandLine ///< in a `--set`
};

/// One property or Param of one object. `property` lives as long as the load it was read from.
struct FieldValue {
    std::string path;                   ///< "robot0.leftMotor.Resistance"
    const Property* property = nullptr; ///< nullptr: a Param
    Standing standing = Standing::Default;
    SourceRange place;                  ///< of the value's text; of the block that would hold it where there is none
    std::string text;                   ///< as written; the default as it would be written; empty: not given
    std::vector<TextRange> elements;    ///< of `text`
    bool formula = false;               ///< Params or an expression in it
    bool broken = false;                ///< the parser could not read it
    std::optional<PropertyValue> value; ///< what it comes to; nothing where it is not given or faulty
    std::string shown;                  ///< of a formula: what it comes to, in words
    std::string separator = ",";        ///< between elements, as the file writes it
    std::string config, inherited;  ///< of an override: the config's name, and what it has there, with its unit; empty: nothing
    std::vector<std::string> parts; ///< of a formula: the same for each element, where they match the elements

    [[nodiscard]] bool given() const { return standing != Standing::Default; }
    [[nodiscard]] std::string element(std::size_t i) const;
    /// The text with one element in place of another. What stands between elements stays.
    [[nodiscard]] std::string with(std::size_t i, const std::string& element) const;
    /// The text up to an element, without it.
    [[nodiscard]] std::string before(std::size_t i) const;
};

/// Reads one object of a load. Members of a Grid or Scatter answer for all of them.
class ObjectValues {
public:
    ObjectValues(std::shared_ptr<const Loaded> loaded, std::string path);

    [[nodiscard]] bool exists() const { return m_kind != nullptr || m_part != nullptr; }
    [[nodiscard]] const std::string& path() const { return m_path; }           ///< of a member: that of its Grid or Scatter
    [[nodiscard]] const std::string& shownPath() const { return m_shownPath; } ///< as selected
    /// nullptr where the kind is not known: a module that could not be read.
    [[nodiscard]] const Kind* kind() const { return m_kind; }
    [[nodiscard]] const Part* part() const { return m_part; }         ///< nullptr: the experiment
    [[nodiscard]] const Part* instance() const { return m_instance; } ///< through which it is reached, or that it is
    [[nodiscard]] const Part* config() const { return m_config; }     ///< of the instance, or in which it stands
    [[nodiscard]] bool isInstance() const { return m_instance && m_part == m_instance; }
    [[nodiscard]] bool inConfig() const { return m_inConfig; } ///< of its instance, not the instance's own
    [[nodiscard]] bool member() const { return m_member; }
    [[nodiscard]] const Loaded& loaded() const { return *m_loaded; }
    [[nodiscard]] const std::shared_ptr<const Loaded>& sharedLoaded() const { return m_loaded; }

    [[nodiscard]] std::vector<FieldValue> properties();
    [[nodiscard]] std::optional<FieldValue> property(std::string_view name);
    /// The first Params declared in the object; of an instance, those of its config.
    [[nodiscard]] std::vector<FieldValue> params(std::size_t most);
    /// Of an instance: properties of the config as a whole.
    [[nodiscard]] std::vector<FieldValue> configProperties();
    /// Of an instance: values it sets inside its config, by their paths below it ("leftMotor.Resistance").
    [[nodiscard]] std::vector<std::string> overrides() const;

private:
    /// A value's text and the Params it sees.
    struct Written {
        const Value* value = nullptr;
        FileId file = kNoFile;
        ParamScope* scope = nullptr;
        Standing standing = Standing::Default;
    };
    void walk(const std::vector<std::string>& words);
    void enterInstance(const std::vector<std::string>& words, std::size_t used);
    void descend(const Part* from, const std::vector<std::string>& words, std::size_t used);
    [[nodiscard]] ParamScope* inside(ParamScope* outer, const std::vector<PlacedParam>& params);
    [[nodiscard]] FieldValue read(const Property& property, const std::string& path, const AssignmentList* list,
                                  ParamScope* scope, const std::string& overrideKey);
    [[nodiscard]] FieldValue readParam(const PlacedParam& param, ParamScope* scope, const PlacedAssignment* own);
    void fill(FieldValue& field, const Written& written);
    void fillInherited(FieldValue& field, const Value* value, FileId file) const;
    void showFormula(FieldValue& field, const GivenValue& given);
    [[nodiscard]] std::string below(std::string_view name) const;
    [[nodiscard]] const std::string& separator();

    std::shared_ptr<const Loaded> m_loaded;
    std::string m_path, m_shownPath;
    std::string m_within;    ///< path below the config
    std::string m_separator; ///< empty: not looked up yet
    const Kind* m_kind = nullptr;
    const Part *m_part = nullptr, *m_instance = nullptr, *m_config = nullptr;
    bool m_member = false, m_inConfig = false;
    Diagnostics m_silent;
    Evaluator m_evaluator;
    std::deque<ParamScope> m_scopes; // pointed to
    ParamScope *m_globals = nullptr, *m_instanceScope = nullptr, *m_configScope = nullptr, *m_scope = nullptr;
};

} // namespace trundle
