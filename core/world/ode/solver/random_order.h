#pragma once
// ODE's quick solver takes the rows of each island in a random order. Its own random numbers are one stream of the process, so that an
// island would change the order of all after it. This program's come from a stream that begins anew with each order. Needs: ODE as a
// shared library; with any other way of linking it keeps its own stream.

#include <cstdint>

namespace trundle {

/// Where the stream of the calling thread begins.
void seedOrders(std::uint64_t seed);

} // namespace trundle
