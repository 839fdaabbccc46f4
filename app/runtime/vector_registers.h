#pragma once

namespace terratact {

/// Clears the upper halves of this thread's vector registers (VZEROUPPER), if it has any. While they are in use, x86
/// processors run SSE code four to ten times slower. Most of the core and of Qt is SSE code. Qt's painting and system
/// copies leave them in use, and new threads inherit them. Call after painting, and at the start of threads that a
/// painting thread creates.
void clearUpperVectorHalves();

}  // namespace terratact
