#pragma once

namespace terratact {

/// From now on memory in blocks of 64 KiB or more goes back to the system as soon as it is free.  By itself glibc
/// keeps them in its heaps once a few were freed (mallopt(3), M_MMAP_THRESHOLD), and a model's factors leave
/// holes there.  Elsewhere than with glibc: nothing.  Call it before there are threads.
void giveBackBigBlocks();

}  // namespace terratact
