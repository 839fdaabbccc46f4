#pragma once

namespace terratact {

/// Makes glibc return blocks of 64 KiB or more to the system as soon as they are freed. By default glibc keeps them in
/// its heaps after a few were freed (mallopt(3), M_MMAP_THRESHOLD). A model's factors leave holes there. Does nothing
/// without glibc. Call before threads start.
void giveBackBigBlocks();

}  // namespace terratact
