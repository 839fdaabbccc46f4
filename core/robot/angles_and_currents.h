#pragma once

/// The angles and currents of a line of telemetry, in the order of every enumeration that begins with
/// them: Sensor and Quantity. Code compares enumerators by this order.
#define TERRATACT_ANGLES_AND_CURRENTS                                                              \
    Pitch, Roll, FrontLeft, FrontRight, RearLeft, RearRight, FrontLeftCurrent, FrontRightCurrent,  \
        RearLeftCurrent, RearRightCurrent
