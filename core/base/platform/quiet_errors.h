#pragma once

namespace trundle {

/// As long as it lives, what this process writes to standard error goes nowhere: libraries write there past everybody.
class QuietErrors {
public:
    QuietErrors();
    ~QuietErrors();
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;

private:
    int m_errors; // the real one
};

} // namespace trundle
