#pragma once
#include <string>
#include <string_view>

namespace trundle {

/// Appends cells and rows to a CSV text (RFC 4180): cells are quoted if necessary, rows end with LF, numbers are the shortest
/// text that parses to the same double.
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
