#pragma once
// The other end of a client's socket.
#include <QtTest>

#include <optional>

#include <nlohmann/json.hpp>

#include "base/platform/socket.h"
#include "remote/frame.h"

namespace trundle {

struct Peer {
    Socket socket;
    FrameReader reader{{1u << 26, 1u << 26}};
    std::vector<std::pair<nlohmann::json, std::string>> events = {};

    void write(std::string_view bytes) { QCOMPARE(socket.write(bytes).value_or(0), bytes.size()); }
    void ask(const nlohmann::json& request) {
        std::string bytes;
        appendFrame(bytes, request.dump());
        write(bytes);
    }
    /// Takes what has arrived; the first reply, if there is one.
    std::optional<std::pair<nlohmann::json, std::string>> take() {
        std::vector<char> bytes(1u << 20);
        for (auto got = socket.read(bytes); got && *got > 0; got = socket.read(bytes)) reader.add(std::span(bytes).first(*got));
        while (auto frame = reader.next().value()) {
            std::pair message(nlohmann::json::parse(frame->json), std::move(frame->bytes));
            if (!message.first.contains("event")) return message;
            events.push_back(std::move(message));
        }
        return std::nullopt;
    }
};

} // namespace trundle
