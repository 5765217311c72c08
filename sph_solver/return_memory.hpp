// SPDX-License-Identifier: MIT
#pragma once

#include <malloc.h>

namespace sph {

/// Asks the C library to take every array of 256 kB and more from the system and to give it back when it is freed. By itself
/// glibc raises that threshold to the size of each array that is freed, up to 32 MB; smaller ones come from its heap then, where
/// what is freed stays with the process (docs/performance.md, memory).
inline void return_freed_memory()
{
#if defined(M_MMAP_THRESHOLD)
    mallopt(M_MMAP_THRESHOLD, 256 * 1024);
#endif
}

} // namespace sph
