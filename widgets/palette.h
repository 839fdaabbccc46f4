#pragma once

#include <QColor>

/// The colours of the console, chosen so that blue, purple, green and amber stay apart for the common
/// colour-vision deficiencies; no meaning hangs on a colour alone.
namespace terratact::palette {

inline constexpr QColor kWindow{0xed, 0xf1, 0xf5};
inline constexpr QColor kCard{0xff, 0xff, 0xff};
inline constexpr QColor kCardBorder{0xcf, 0xd8, 0xe1};
inline constexpr QColor kHeader{0x1d, 0x2a, 0x36};
inline constexpr QColor kHeaderText{0xf4, 0xf7, 0xfa};
inline constexpr QColor kSource{0xff, 0xd1, 0x66};  ///< the source's name

inline constexpr QColor kText{0x16, 0x22, 0x2e};
inline constexpr QColor kMuted{0x4a, 0x58, 0x66};  ///< secondary text: 7 : 1 on white
inline constexpr QColor kButton{0xe3, 0xe9, 0xef};
inline constexpr QColor kButtonDown{0xc9, 0xd3, 0xdd};
inline constexpr QColor kGrid{0xe4, 0xe9, 0xee};

inline constexpr QColor kStop{0xc6, 0x1c, 0x1c};
inline constexpr QColor kGood{0x1b, 0x6e, 0x3c};
inline constexpr QColor kDoubt{0x8f, 0x52, 0x00};
inline constexpr QColor kBad{0xb0, 0x12, 0x12};
inline constexpr QColor kAccent{0x6a, 0x1b, 0x9a};  ///< the probe and what the operator decides

inline constexpr QColor kSampled{0x12, 0x80, 0x4a};
inline constexpr QColor kContact{0x15, 0x58, 0xa6};
inline constexpr QColor kArm{0x6a, 0x1b, 0x9a};
inline constexpr QColor kPrior{0xb0, 0x64, 0x00};
inline constexpr QColor kPriorZone{0xff, 0xf4, 0xd2};
inline constexpr QColor kCeiling{0x8a, 0x98, 0xa6};
inline constexpr QColor kTruth{0xd3, 0x2f, 0x2f};

inline constexpr QColor kRobotBody{0xdd, 0xe3, 0xe9};
inline constexpr QColor kRobotTrack{0xcc, 0xd4, 0xdc};
inline constexpr QColor kRobotFlipper{0xb6, 0xc3, 0xd0};
inline constexpr QColor kRobotLine{0x6c, 0x7a, 0x89};
inline constexpr QColor kForce{0x9d, 0xae, 0xbf};

inline constexpr int kTarget = 34;  ///< [px] least height of what can be pressed

}  // namespace terratact::palette
