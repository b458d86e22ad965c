#pragma once
#include <memory>

#include <QtTest>

#include "render/service.h"

namespace trundle {

/// Starts a render service for all functions of a test; the calling function fails if it cannot start.
inline void startService(std::unique_ptr<RenderService>& service) {
    auto started = RenderService::start();
    QVERIFY2(started.ok(), started.ok() ? "" : started.error().message.c_str());
    service = std::move(started).value();
}

} // namespace trundle
