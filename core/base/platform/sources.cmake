# Relative to core/base; read by core/base/CMakeLists.txt, which also links ${CMAKE_DL_LIBS}.
set(BASE_PLATFORM_SOURCES
  platform/atomic_file.cpp
  platform/buffered_file.cpp
  platform/dynamic_library.cpp
  platform/end_requests.cpp
  platform/fed_process.cpp
  platform/file_lock.cpp
  platform/limits.cpp
  platform/locked_file.cpp
  platform/memory.cpp
  platform/process.cpp
  platform/process_identity.cpp
  platform/program_path.cpp
  platform/quiet_errors.cpp
  platform/read_file.cpp
  platform/thread_priority.cpp)
