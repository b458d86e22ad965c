#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// Adds cells and rows to a CSV text by RFC 4180: cells are quoted where they must be, rows end with LF, numbers are the shortest text
/// that reads back to the same double.
class CsvWriter {
public:
    explicit CsvWriter(std::string& out) : m_out(out) {}
    CsvWriter& cell(std::string_view text);
    CsvWriter& cell(double number);
    void endRow();

private:
    void separate();

    std::string& m_out;
    bool m_first = true;
};

} // namespace trundle
