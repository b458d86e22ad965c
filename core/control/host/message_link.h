#pragma once
#include <string>
#include <string_view>

#include "control/host/control_page.h"

namespace trundle {

/// One end of the messages through a control page. Long messages cross in parts.
class MessageLink {
public:
    virtual ~MessageLink() = default;
    MessageLink(const MessageLink&) = delete;
    MessageLink& operator=(const MessageLink&) = delete;

protected:
    MessageLink(ControlPage& page, Turn mine);

    /// Waits until this end has the turn. False: the other end has ended.
    [[nodiscard]] virtual bool awaitTurn() = 0;
    /// Appends to the message in the mailbox; hands parts over if it does not fit.
    [[nodiscard]] bool append(std::string_view bytes);
    /// Ends the message and hands the turn over.
    void finishMessage();
    /// Waits for a part of a message and appends it. False: the other end has ended.
    [[nodiscard]] bool receivePart(std::string& message, bool& more);
    /// Appends what is in the mailbox, of a message that may not be complete.
    void drain(std::string& message);
    /// Hands the turn back to get the next part.
    void askForMore();
    /// Polls for the turn for some microseconds; cheaper than sleeping if the other end is quick.
    [[nodiscard]] bool pollTurn() const;
    [[nodiscard]] bool hasTurn() const { return m_page.turn.load(std::memory_order_acquire) == static_cast<std::uint32_t>(m_mine); }
    /// Sleeps until the turn changes or the time is over. timeoutMs < 0: no limit.
    void sleepForTurn(int timeoutMs);

    ControlPage& m_page;

private:
    void give();
    const Turn m_mine, m_other;
    Mailbox &m_out, &m_in;
    std::atomic<std::uint32_t>&m_sleeps, &m_otherSleeps;
};

} // namespace trundle
