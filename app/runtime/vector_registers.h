#pragma once

namespace terratact {

/// Clears the upper halves of this thread's vector registers (VZEROUPPER) where there are any.  While they are in use,
/// x86 processors run SSE code, which most of the core and of Qt is, four to ten times slower.  Qt's painting and what
/// the system copies leave them in use, and a new thread inherits them.  To be called after painting, and before work
/// in a thread that a painting one made.
void clearUpperVectorHalves();

}  // namespace terratact
