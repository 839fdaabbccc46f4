#pragma once

#include "app/figures/canvas.h"

namespace terratact {

/// Colours of texts and frames on white in every figure.
inline constexpr Colour kFigureText{0x16222e}, kFigureMuted{0x4a5866}, kFigureGrid{0xe4e9ee},
    kFigureFrame{0xcfd8e1};

}  // namespace terratact
