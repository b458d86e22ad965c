#include "control/host/message_link.h"

#include <algorithm>

namespace trundle {
namespace {

constexpr int kPolls = 200; // some microseconds; more takes time from the other end where processors are short

} // namespace

MessageLink::MessageLink(ControlPage& page, Turn mine)
    : m_page(page), m_mine(mine), m_other(mine == Turn::Run ? Turn::Host : Turn::Run),
      m_out(mine == Turn::Run ? page.toHost : page.toRun), m_in(mine == Turn::Run ? page.toRun : page.toHost),
      m_sleeps(mine == Turn::Run ? page.runSleeps : page.hostSleeps),
      m_otherSleeps(mine == Turn::Run ? page.hostSleeps : page.runSleeps) {}

void MessageLink::give() {
    m_page.turn.store(static_cast<std::uint32_t>(m_other));
    if (m_otherSleeps.load() != 0) wakeWaiting(m_page.turn);
}

bool MessageLink::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::uint32_t used = std::min(m_out.size.load(std::memory_order_relaxed), Mailbox::kCapacity);
        const std::size_t fits = std::min<std::size_t>(bytes.size(), Mailbox::kCapacity - used);
        std::copy_n(bytes.data(), fits, m_out.bytes.data() + used);
        m_out.size.store(used + static_cast<std::uint32_t>(fits), std::memory_order_release);
        bytes.remove_prefix(fits);
        if (bytes.empty()) return true;
        m_out.more = 1;
        give();
        if (!awaitTurn()) return false;
        m_out.size = 0;
    }
    return true;
}

void MessageLink::finishMessage() {
    m_out.more = 0;
    give();
}

bool MessageLink::receivePart(std::string& message, bool& more) {
    if (!awaitTurn()) return false;
    drain(message);
    more = m_in.more != 0;
    m_out.size = 0;
    m_out.more = 0;
    return true;
}

void MessageLink::drain(std::string& message) {
    message.append(m_in.bytes.data(), std::min(m_in.size.exchange(0), Mailbox::kCapacity));
}

void MessageLink::askForMore() { give(); }

bool MessageLink::pollTurn() const {
    for (int i = 0; i < kPolls; ++i) {
        if (hasTurn()) return true;
        relaxProcessor();
    }
    return hasTurn();
}

void MessageLink::sleepForTurn(int timeoutMs) {
    m_sleeps = 1;
    waitWhile(m_page.turn, static_cast<std::uint32_t>(m_other), timeoutMs);
    m_sleeps = 0;
}

} // namespace trundle
