#pragma once

#include <regex>
#include <string>

#include "core/strip/strip.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"

namespace terratact {

/// Returns the strip of a robot that felt a step, turned left on the spot, and felt it again: two sections.
inline Strip feltStrip(const RobotModel& robot = absolem())
{
    Strip strip(robot);
    Measurement line;
    line.travelled = 1.0;
    line.turned = 0.2;
    for (const double turn : {0.0, 0.5}) {
        line.time += 0.1;
        *line.turned += turn;
        strip.add(line);
        strip.beginScene(line);
        strip.enter(leftStepEstimate(), turn > 0.0 ? 8 : 7);
    }
    return strip;
}

/// Returns an SVG without cairo's numbers of surfaces, which count all pictures of a program.
inline std::string withoutSurfaces(const std::string& svg)
{
    static const std::regex kSurface("surface[0-9]+");
    return std::regex_replace(svg, kSurface, "surface");
}

}  // namespace terratact
