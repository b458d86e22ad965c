// Sockets that never block.
#include <QtTest>

#include <sys/socket.h>
#include <unistd.h>

#include "base/platform/socket.h"

using namespace trundle;

class SocketTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bytesArriveAndTheEndIsSeen() {
        auto [a, b] = std::move(Socket::pair().value());
        std::array<char, 8> bytes;
        QCOMPARE(a.read(bytes), std::optional<std::size_t>(0)); // nothing yet
        QCOMPARE(b.write("hello"), std::optional<std::size_t>(5));
        std::vector<SocketWait> waits{{a.descriptor(), true, true}};
        waitForSockets(waits, std::chrono::seconds(5));
        QVERIFY(waits[0].canRead && waits[0].canWrite && !waits[0].hasEnded);
        QCOMPARE(a.read(bytes), std::optional<std::size_t>(5));
        QCOMPARE(std::string(bytes.data(), 5), std::string("hello"));
        b.close();
        waitForSockets(waits, std::chrono::seconds(5));
        QVERIFY(waits[0].hasEnded);
        QCOMPARE(a.read(bytes), std::nullopt);
        QCOMPARE(a.write("x"), std::nullopt); // and no signal
    }

    void aFullSocketTakesNoMore() {
        auto [a, b] = std::move(Socket::pair().value());
        const std::string much(1u << 22, 'x');
        const std::size_t taken = a.write(much).value();
        QVERIFY(taken > 0 && taken < much.size());
        QCOMPARE(a.write(much), std::optional<std::size_t>(0));
        std::vector<SocketWait> waits{{a.descriptor(), false, true}};
        waitForSockets(waits, std::chrono::milliseconds(0));
        QVERIFY(!waits[0].canWrite);
        std::vector<char> bytes(taken);
        QCOMPARE(b.read(bytes), std::optional(taken));
        QVERIFY(a.write(much).value() > 0);
    }

    void listensAtLoopback() {
        auto listener = Socket::listen("127.0.0.1", 0);
        QVERIFY(listener.ok());
        const std::uint16_t port = listener.value().port();
        QVERIFY(port > 0);
        QVERIFY(!listener.value().accept().has_value());
        const auto again = Socket::listen("localhost", port);
        QVERIFY(!again.ok() && again.error().message.find("Address already in use") != std::string::npos);
        for (const char* wrong : {"", "example.org", "1.2.3", "127.0.0.1:5"}) QVERIFY2(!Socket::listen(wrong, 0).ok(), wrong);
    }

    void knowsLoopback() {
        for (const char* yes : {"127.0.0.1", "127.9.9.9", "localhost", "::1"}) QVERIFY2(isLoopback(yes), yes);
        for (const char* no : {"0.0.0.0", "192.168.1.1", "::", "example.org"}) QVERIFY2(!isLoopback(no), no);
    }

    void adoptsStreamSocketsOnly() {
        QVERIFY(!Socket::adopt(1000).ok());
        QVERIFY(!Socket::adopt(STDERR_FILENO).ok());
        int files[2];
        QVERIFY(socketpair(AF_UNIX, SOCK_STREAM, 0, files) == 0);
        auto adopted = Socket::adopt(files[0]);
        QVERIFY(adopted.ok());
        std::array<char, 1> byte;
        QCOMPARE(adopted.value().read(byte), std::optional<std::size_t>(0)); // it does not block any more
        ::close(files[1]);
    }
};

QTEST_APPLESS_MAIN(SocketTest)
#include "socket_test.moc"
