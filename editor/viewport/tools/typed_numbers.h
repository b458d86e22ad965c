#pragma once
#include <optional>
#include <string>

#include <QString>

namespace trundle {

/// Two numbers that are typed while something is drawn; Tab changes between them. Each may have a unit.
class TypedNumbers {
public:
    /// `negative`: the second one may begin with a minus.
    explicit TypedNumbers(bool negative) : m_negative(negative) {}

    /// False if the key does not belong to a number.
    [[nodiscard]] bool type(int key, const QString& text);
    void clear();
    [[nodiscard]] bool empty() const { return m_typed[0].empty() && m_typed[1].empty(); }
    /// `unit`: of a number without one, and of the result. Nothing if the text is no number.
    [[nodiscard]] std::optional<double> number(bool second, const char* unit) const;
    /// What is typed, with a cursor in the active one; `measured` where nothing is.
    [[nodiscard]] QString shown(bool second, const QString& measured) const;

private:
    std::string m_typed[2];
    bool m_isSecond = false, m_negative;
};

} // namespace trundle
