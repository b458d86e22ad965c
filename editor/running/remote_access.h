#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include <QObject>
#include <QTimer>

#include "base/platform/socket.h"
#include "run/live/live_guest.h"

namespace trundle {

/// Lets other programs of this machine take part in the runs of the window: where they connect, the token that they give, how many are
/// connected. The port and the token stay the same from run to run; the connections end with each run.
class RemoteAccess final : public QObject {
    Q_OBJECT
public:
    explicit RemoteAccess(QObject* parent = nullptr);

    /// Listens at a port of this machine; 0: a free one. Returns why not; empty: it does.
    QString start(std::uint16_t port);
    void stop();
    [[nodiscard]] bool isOn() const { return m_listener.isOpen(); }
    [[nodiscard]] std::uint16_t port() const { return m_listener.port(); }
    [[nodiscard]] QString token() const { return QString::fromStdString(m_token); }
    [[nodiscard]] std::size_t clientCount() const { return m_clients->load(); }

    /// What serves the next run, for LiveRun; an empty maker while this is off. `file`: of the experiment.
    [[nodiscard]] GuestMaker guestFor(const std::string& file) const;

Q_SIGNALS:
    void switched(); ///< on or off
    void clientsChanged();

private:
    Socket m_listener;
    std::string m_token;
    std::shared_ptr<std::atomic<std::size_t>> m_clients = std::make_shared<std::atomic<std::size_t>>(0);
    std::size_t m_shown = 0; ///< clients
    QTimer m_watch;
};

} // namespace trundle
