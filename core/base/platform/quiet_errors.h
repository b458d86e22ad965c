#pragma once

namespace trundle {

/// Redirects standard error of this process to /dev/null for its lifetime, because some libraries write there directly.
class QuietErrors {
public:
    QuietErrors();
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

private:
    int m_errors; // the original descriptor
};

} // namespace trundle
