#include "run/logs/csv.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace trundle {

void CsvWriter::separate() {
    if (!m_first) m_out += ',';
    m_first = false;
}

CsvWriter& CsvWriter::cell(std::string_view text) {
    separate();
    if (text.find_first_of("\",\r\n") == std::string_view::npos) {
        m_out += text;
        return *this;
    }
    m_out += '"';
    for (const char c : text) {
        if (c == '"') m_out += '"';
        m_out += c;
    }
    m_out += '"';
    return *this;
}

CsvWriter& CsvWriter::cell(double number) {
    separate();
    if (number == 0) number = 0; // write -0 as 0
    if (std::isnan(number)) number = std::numeric_limits<double>::quiet_NaN(); // and -nan as nan
    char digits[64];
    m_out.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    return *this;
}

void CsvWriter::endRow() {
    m_out += '\n';
    m_first = true;
}

} // namespace trundle
