#pragma once

namespace terratact {

/// Meaning of a label, shown as weight and colour.
enum class Tone { Plain, Muted, Strong, Good, Warning, Bad, Accent };

}  // namespace terratact
