#include "editor/running/remote_access.h"

#include "remote/run_guest.h"
#include "run/logs/log_location.h"

namespace trundle {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr int kWatchMs = 250;

} // namespace

RemoteAccess::RemoteAccess(QObject* parent) : QObject(parent) {
    m_watch.setInterval(kWatchMs);
    connect(&m_watch, &QTimer::timeout, this, [this] {
        if (std::exchange(m_shown, clientCount()) != m_shown) Q_EMIT clientsChanged();
    });
}

QString RemoteAccess::start(std::uint16_t port) {
    stop();
    Result<Socket> listener = Socket::listen(kHost, port);
    if (!listener) return QString::fromStdString(listener.error().message);
    m_listener = std::move(listener).value();
    m_token = randomToken();
    m_watch.start();
    Q_EMIT switched();
    return {};
}

void RemoteAccess::stop() {
    if (!isOn()) return;
    m_listener.close();
    m_watch.stop();
    m_shown = 0;
    Q_EMIT switched();
}

GuestMaker RemoteAccess::guestFor(const std::string& file) const {
    if (!isOn()) return {};
    Result<Socket> listener = m_listener.duplicate();
    if (!listener) return {};
    ServerOptions options;
    options.token = m_token;
    options.experiment = experimentName(file);
    return [socket = std::make_shared<Socket>(std::move(listener).value()), options, clients = m_clients] {
        return std::make_unique<RunGuest>(std::move(*socket), options, clients);
    };
}

} // namespace trundle
