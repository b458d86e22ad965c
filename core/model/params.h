#pragma once
// Params and `$( )` expressions, evaluated on demand in any order; cycles are reported as a chain of names.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/amount.h"
#include "model/block_view.h"
#include "schema/value_reader.h"

namespace trundle {

class Registry;

/// The Params of one block; lookup continues in the outer scopes.
class ParamScope {
public:
    explicit ParamScope(ParamScope* outer = nullptr) : m_outer(outer) {}
    ParamScope(const ParamScope&) = delete;
    ParamScope& operator=(const ParamScope&) = delete;

    void declare(const std::vector<SourceParam>& params);
    /// Overrides a Param of this block with a value from outside.
    void preset(const std::string& name, const GivenValue& value);
    /// Adds a number that no text declares.
    void set(const std::string& name, double number);
    /// Whether a Param of that name is seen there.
    [[nodiscard]] bool has(std::string_view name) { return find(name) != nullptr; }
    /// Whether the number of set() was needed for a value.
    [[nodiscard]] bool isUsed(const std::string& name) const;

private:
    friend class Evaluator;
    enum class State { Fresh, Preset, Busy, Done, Failed }; ///< Preset: not compared with its description yet
    struct Entry {
        SourceParam param;
        ParamScope* scope = nullptr;
        State state = State::Fresh;
        GivenValue value;
        bool isUsed = false;
        bool isPreset = false;
        /// An instance gives the value, or a variant.
        [[nodiscard]] bool isFromOutside() const { return isPreset || (param.item && param.value != &param.item->value); }
    };
    [[nodiscard]] Entry* find(std::string_view name);
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] std::size_t count() const; ///< of them, one that hides another counted twice

    ParamScope* m_outer;
    std::map<std::string, Entry, std::less<>> m_entries;
};

class Evaluator {
public:
    /// With a registry, Params with a unit that neither the language nor a property in the registry has are reported where they
    /// are declared, used or not.
    Evaluator(const TextSet& texts, Diagnostics& diagnostics, const Registry* registry = nullptr)
        : m_texts(texts), m_diagnostics(diagnostics), m_registry(registry) {}

    /// The elements of a value, with Params substituted and expressions evaluated; nothing, with a diagnostic, on failure.
    [[nodiscard]] std::optional<GivenValue> evaluate(const Value& value, FileId file, ParamScope& scope);
    /// Whether all units written in the value of a Param exist; reports the first that does not.
    [[nodiscard]] bool checkUnits(const GivenValue& value);
    /// Whether the parser reported errors inside the range, so that further errors there may be follow-ups.
    [[nodiscard]] bool broken(const SourceRange& range);
    /// Evaluates every Param of the scope, so that errors in unused ones are reported too.
    void checkAll(ParamScope& scope);

private:
    void finish(ParamScope::Entry& entry);
    bool addElement(const Element& element, FileId file, ParamScope& scope, GivenValue& out);
    bool addParam(std::string_view name, SourceRange place, ParamScope& scope, GivenValue& out);
    bool addPicked(const Expression& e, FileId file, ParamScope& scope, SourceRange place, GivenValue& out);
    [[nodiscard]] const GivenElement* picked(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] const GivenValue* paramValue(std::string_view name, SourceRange place, ParamScope& scope);
    [[nodiscard]] std::optional<Amount> amount(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] std::optional<Amount> paramAmount(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] std::optional<Amount> numberOf(const GivenElement& element, const Expression& e, FileId file);
    [[nodiscard]] bool hasNames(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] const Expression* held(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] bool isText(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] std::optional<Amount> call(const Expression& e, FileId file, ParamScope& scope);
    [[nodiscard]] std::optional<Amount> fault(const Expression& e, FileId file, std::string message);
    [[nodiscard]] std::optional<Amount> orFault(Result<Amount> computed, const Expression& e, FileId file);
    void unknown(std::string_view name, SourceRange place, ParamScope& scope);
    void circle(const ParamScope::Entry& entry);

    const TextSet& m_texts;
    Diagnostics& m_diagnostics;
    const Registry* m_registry;
    std::vector<ParamScope::Entry*> m_chain;
    SourceRange m_source; ///< of the first value from outside of the config that the present expression uses
    std::map<FileId, std::vector<std::uint32_t>> m_broken; ///< offsets of syntax errors, sorted, by file
};

} // namespace trundle
