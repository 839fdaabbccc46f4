#pragma once

#include "app/figures/canvas.h"

namespace terratact {

/// What every figure draws its texts and frames with, on white.
inline constexpr Colour kFigureText{0x16222e}, kFigureMuted{0x4a5866}, kFigureGrid{0xe4e9ee},
    kFigureFrame{0xcfd8e1};

}  // namespace terratact
