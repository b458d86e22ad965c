#include "base/diagnostic.h"

namespace trundle {

Diagnostic& Diagnostics::add(Severity severity, Code code, SourceRange range, std::string message) {
    if (severity == Severity::Error) ++m_errors;
    Diagnostic& d = m_all.emplace_back();
    d.severity = severity;
    d.code = code;
    d.range = range;
    d.message = std::move(message);
    return d;
}

void Diagnostics::append(std::vector<Diagnostic> more) {
    for (Diagnostic& d : more) {
        if (d.severity == Severity::Error) ++m_errors;
        m_all.push_back(std::move(d));
    }
}

} // namespace trundle
