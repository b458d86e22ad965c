#include "editor/viewport/tools/typed_numbers.h"

#include <charconv>

#include "base/units.h"

namespace trundle {
namespace {

constexpr std::size_t kLongestNumber = 24; // of a typed number

} // namespace

bool TypedNumbers::type(int key, const QString& text) {
    std::string& typed = m_typed[m_isSecond ? 1 : 0];
    if (key == Qt::Key_Tab) {
        m_isSecond = !m_isSecond;
        return true;
    }
    if (key == Qt::Key_Backspace) {
        if (typed.empty()) return false;
        typed.pop_back();
        return true;
    }
    if (text.size() != 1 || typed.size() > kLongestNumber) return false;
    const char c = text[0].toLatin1();
    const bool isMinus = c == '-' && m_negative && m_isSecond && typed.empty();
    const bool isDigit = (c >= '0' && c <= '9') || c == '.' || c == ',' || isMinus;
    const bool isUnit = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == ' ';
    if (!isDigit && (typed.empty() || !isUnit)) return false;
    typed += c;
    return true;
}

void TypedNumbers::clear() {
    for (std::string& text : m_typed) text.clear();
    m_isSecond = false;
}

std::optional<double> TypedNumbers::number(bool second, const char* unit) const {
    double value = 0;
    std::string number = m_typed[second ? 1 : 0];
    for (char& c : number)
        if (c == ',') c = '.';
    const char* const end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, value, std::chars_format::fixed);
    if (read.ec != std::errc()) return std::nullopt;
    std::string given(read.ptr, end);
    std::erase(given, ' ');
    return given.empty() ? std::optional(value) : convertUnit(value, given, unit);
}

QString TypedNumbers::shown(bool second, const QString& measured) const {
    const std::string& typed = m_typed[second ? 1 : 0];
    const bool isActive = !empty() && m_isSecond == second;
    if (typed.empty() && !isActive) return measured;
    return QString::fromStdString(typed) + (isActive ? QStringLiteral("▏") : QString());
}

} // namespace trundle
