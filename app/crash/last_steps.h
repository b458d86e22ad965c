#pragma once
namespace trundle {

/// What a program does that a fault of a module ends: it reports the fault, then writes its logs out. The module may have overwritten
/// memory, so each step may have a fault of its own: then the next follows. Each function is async-signal-safe.
class LastSteps {
public:
    virtual void report() = 0;
    virtual void reportWithoutHeap() = 0; ///< after a fault in report(): what that has not printed yet
    virtual void reportLostLogs() = 0;    ///< after a fault while logs were written
    /// Call it in the thread that ends the program, and again after each fault of that.
    void take();

protected:
    ~LastSteps() = default;

private:
    enum Step { None, Reporting, WithoutHeap, Logs, LostLogs, Done };
    Step m_begun = None;
};

/// A text for a descriptor that is written as a whole, or after a fault meanwhile not at all. Async-signal-safe.
class Draft {
public:
    explicit Draft(int file);
    ~Draft();
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    [[nodiscard]] int file() const { return m_draft >= 0 ? m_draft : m_file; } ///< to write to
    void publish();

private:
    int m_file, m_draft;
};

} // namespace trundle
