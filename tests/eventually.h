#pragma once
// Waits for as long as the slowest machine under a sanitizer may take; QTRY_VERIFY gives up after five seconds.

#include <QtTest>

inline constexpr int kTimeoutMs = 60'000;

#define EVENTUALLY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kTimeoutMs)
#define EVENTUALLY_EQUAL(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kTimeoutMs)
