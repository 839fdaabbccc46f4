#pragma once

#include <memory>
#include <vector>

#include "app/figures/report_document.h"
#include "core/strip/strip.h"

namespace terratact {

/// Returns pictures of the ground felt along the way: each shows a piece of at most kStripPiece of one section, the left
/// and the right side in colours, the 0.1 to 0.9 quantiles as bands. Axes are equal [m]. Felt, bounded and not felt
/// bins differ by shape. The pictures keep the strip.
std::vector<DocumentPicture> stripPictures(const std::shared_ptr<const Strip>& strip);
inline constexpr double kStripPiece = 6.0;  ///< [m]

}  // namespace terratact
