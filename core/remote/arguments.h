#pragma once
// The members of a request, read with checks of their types.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace trundle {

/// Each read marks a member as expected. The first mistake is kept, and a default is returned in its place.
class Arguments {
public:
    explicit Arguments(const nlohmann::json& request) : m_request(request) {}

    [[nodiscard]] bool has(const std::string& name);
    /// A finite number.
    [[nodiscard]] double number(const std::string& name, std::optional<double> otherwise = {});
    /// A whole number from 0 to `most`.
    [[nodiscard]] std::uint64_t count(const std::string& name, std::uint64_t most, std::optional<std::uint64_t> otherwise = {});
    [[nodiscard]] bool flag(const std::string& name, bool otherwise);
    [[nodiscard]] std::string text(const std::string& name, std::optional<std::string> otherwise = {});
    [[nodiscard]] std::vector<std::string> texts(const std::string& name);
    /// `size` finite numbers.
    [[nodiscard]] std::vector<double> numbers(const std::string& name, std::size_t size);
    /// An object whose members are finite numbers or arrays of them, in the order of their names; empty if it is missing.
    [[nodiscard]] std::vector<std::pair<std::string, std::vector<double>>> values(const std::string& name);

    void setProblem(std::string problem);
    /// What is wrong: a mistake, or a member that was not read. Empty if nothing is.
    [[nodiscard]] std::string problem() const;

private:
    [[nodiscard]] const nlohmann::json* find(const std::string& name, bool required);
    const nlohmann::json& m_request;
    std::vector<std::string> m_expected{"id", "op"};
    std::string m_problem;
};

} // namespace trundle
