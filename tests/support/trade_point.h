#pragma once

/// A measured setting.
namespace terratact {

inline TradePoint tradePoint(std::string varied, std::optional<QualityPreset> preset,
                             double seconds, double off)
{
    TradePoint p;
    p.setting = {std::move(varied), Settings{.method = Method::Pafc}, preset};
    p.seconds = seconds;
    p.reference = {0.5 * off, off};
    p.error = 0.02;
    p.crps = 0.015;
    p.draws = 800;
    p.converged = 0.75;
    return p;
}

}  // namespace terratact
