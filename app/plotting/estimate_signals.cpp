#include "app/plotting/estimate_signals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr std::array kEstimateSides{ProbeSide::Left, ProbeSide::Right};

SourceText sideText(ProbeSide side)
{
    return side == ProbeSide::Left ? TR_NOOP("core", "left") : TR_NOOP("core", "right");
}

/// Collects either the signals or the values, so that both have one order.
class EstimateTable {
public:
    explicit EstimateTable(const EstimateFacts* facts) : facts_(facts) {}

    void fill()
    {
        add("p_step", TR_NOOP("core", "P(step)"), "", [](const EstimateFacts& f) {
            return f.verdict ? std::optional(f.verdict->either.p) : std::nullopt;
        });
        add("seconds", TR_NOOP("core", "computing time"), "s",
            [](const EstimateFacts& f) { return std::optional(f.seconds); });
        for (std::size_t side = 0; side < 2; ++side) addSide(side);
        for (std::size_t side = 0; side < 2; ++side)
            for (int bin = 0; bin < kBins; ++bin) addBin(side, bin);
    }

    std::vector<PlotSignal> signals{};
    std::vector<std::optional<double>> values{};

private:
    using Value = std::optional<double>;

    template <class ValueOf>
    void add(std::string id, Message called, const char* unit, const ValueOf& valueOf)
    {
        if (facts_)
            values.push_back(valueOf(*facts_));
        else
            signals.push_back({SignalOrigin::Estimate, std::move(id), std::move(called), unit, {}});
    }

    static std::string idOf(std::string_view what, std::size_t side)
    {
        return std::string(what) + '.' + std::string(name(kEstimateSides.at(side)));
    }

    void addSide(std::size_t side)
    {
        const SourceText where = sideText(kEstimateSides.at(side));
        add(idOf("p_step", side), {TR_NOOP("core", "P(step), %1"), where}, "",
            [side](const EstimateFacts& f) -> Value {
                return f.verdict ? Value(f.verdict->side.at(side).step.p) : Value();
            });
        add(idOf("sd_mean", side), {TR_NOOP("core", "mean sd ahead, %1"), where}, "m",
            [side](const EstimateFacts& f) -> Value {
                const Heights& sd = f.estimate.side.at(side).sd;
                double sum = 0.0;
                for (std::size_t i = kFirstAhead; i < sd.size(); ++i) sum += sd[i];
                return sum / static_cast<double>(kBins - kFirstAhead);
            });
        add(idOf("sd_max", side), {TR_NOOP("core", "largest sd ahead, %1"), where}, "m",
            [side](const EstimateFacts& f) -> Value {
                const Heights& sd = f.estimate.side.at(side).sd;
                return *std::max_element(sd.begin() + kFirstAhead, sd.end());
            });
        add(idOf("error_mean", side), {TR_NOOP("core", "mean absolute error, %1"), where}, "m",
            [side](const EstimateFacts& f) { return error(f, side, false); });
        add(idOf("error_max", side), {TR_NOOP("core", "largest absolute error, %1"), where}, "m",
            [side](const EstimateFacts& f) { return error(f, side, true); });
    }

    static Value error(const EstimateFacts& facts, std::size_t side, bool largest)
    {
        const auto& truth = facts.truth.at(side);
        if (!truth) return {};
        double sum = 0.0, most = 0.0;
        for (std::size_t i = 0; i < truth->size(); ++i) {
            const double off = std::abs(facts.estimate.side.at(side).height[i] - (*truth)[i]);
            sum += off;
            most = std::max(most, off);
        }
        return largest ? most : sum / static_cast<double>(kBins);
    }

    void addBin(std::size_t side, int bin)
    {
        const auto i = static_cast<std::size_t>(bin);
        const SourceText where = sideText(kEstimateSides.at(side));
        const std::string x = signedFixed(binCentre(bin), 1);
        add(idOf("height", side) + x, {TR_NOOP("core", "height at %1 m, %2"), x, where}, "m",
            [=](const EstimateFacts& f) -> Value { return f.estimate.side.at(side).height[i]; });
        add(idOf("sd", side) + x, {TR_NOOP("core", "sd at %1 m, %2"), x, where}, "m",
            [=](const EstimateFacts& f) -> Value { return f.estimate.side.at(side).sd[i]; });
        add(idOf("error", side) + x, {TR_NOOP("core", "error at %1 m, %2"), x, where}, "m",
            [=](const EstimateFacts& f) -> Value {
                const auto& truth = f.truth.at(side);
                return truth ? Value(f.estimate.side.at(side).height[i] - (*truth)[i]) : Value();
            });
    }

    const EstimateFacts* facts_;  ///< null: collects the signals
};

}  // namespace

std::array<std::optional<Heights>, 2> truthOf(bool onePlane, const std::optional<Heights>& plane,
                                              const std::optional<std::array<Heights, 2>>& sides)
{
    if (onePlane) return {plane, plane};
    if (!sides) return {};
    return {sides->at(0), sides->at(1)};
}

std::span<const PlotSignal> estimateSignals()
{
    static const std::vector<PlotSignal> kSignals = [] {
        EstimateTable table(nullptr);
        table.fill();
        return table.signals;
    }();
    return kSignals;
}

std::vector<std::optional<double>> estimateValues(const EstimateFacts& facts)
{
    EstimateTable table(&facts);
    table.fill();
    return table.values;
}

}  // namespace terratact
