// Fuzzes the numbers of a model. In the first byte, the lowest two bits select the number of training rows. The next
// bit sends the model through a file. The next one makes a height unknown. The highest two bits select the method. Then
// each 10 bytes change one number (two select it, eight are its value). An accepted model survives a file. It estimates
// a terrain with finite numbers, or says why it cannot.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/infer/closed_form.h"
#include "core/infer/estimator.h"
#include "core/infer/reconstruct.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/training.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/absolem.h"
#include "tests/support/random_model.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

constexpr unsigned kThroughFile = 4, kWithHole = 8;  // bits of the first byte

using Numbers = std::vector<double*>;

template <class Matrix>
void addAll(Numbers& numbers, Matrix& matrix)
{
    for (double& value : matrix.reshaped()) numbers.push_back(&value);
}

void add(Numbers& numbers, Hyperparameters& hyper)
{
    addAll(numbers, hyper.lengthScale);
    numbers.insert(numbers.end(), {&hyper.signalSd, &hyper.noiseSd});
}

void add(Numbers& numbers, BinModelData& data)
{
    addAll(numbers, data.mean);
    addAll(numbers, data.sd);
    for (Hyperparameters& hyper : data.bins) add(numbers, hyper);
    for (double& value : data.logLikelihood) numbers.push_back(&value);
}

void add(Numbers& numbers, ClearanceData& data)
{
    addAll(numbers, data.featureMean);
    addAll(numbers, data.featureSd);
    addAll(numbers, data.residuals);
    numbers.insert(numbers.end(), {&data.noveltyScale, &data.contactBias, &data.contactSd});
    for (auto* const processes : {&data.open, &data.covered})
        for (SurfaceProcess& process : *processes) {
            add(numbers, process.hyper);
            addAll(numbers, process.weights);
            numbers.insert(numbers.end(), {&process.mean, &process.residualSd});
        }
    for (auto* const conditionals : {&data.conditionalOpen, &data.conditionalCovered})
        for (Hyperparameters& hyper : *conditionals) add(numbers, hyper);
}

Numbers numbersOf(ModelData& model)
{
    Numbers numbers;
    add(numbers, model.clearance);
    add(numbers, model.pa);
    add(numbers, model.paf);
    addAll(numbers, model.heights);
    addAll(numbers, model.features);
    addAll(numbers, model.scannedHeights);
    return numbers;
}

/// Returns a model that also has conditionals of clearances.
ModelData realModel(int rows)
{
    ModelData model = randomModel(rows);
    for (auto* const conditionals :
         {&model.clearance.conditionalOpen, &model.clearance.conditionalCovered})
        for (Hyperparameters& hyper : *conditionals)
            hyper = {Eigen::VectorXd::Constant(21, 5.0), 1.0, 0.1};
    return model;
}

/// Makes the height of bin 10, open in every row, unknown in the last row.
void addHole(ModelData& model)
{
    const Eigen::Index last = model.heights.rows() - 1;
    model.unknownBins.assign(static_cast<std::size_t>(model.heights.rows()), 0U);
    model.unknownBins.back() = 1U << 10U;
    model.heights(last, 10) = model.clearance.residuals(last, 10) = 0.0;
    model.scannedHeights.conservativeResize(std::max<Eigen::Index>(last, 1), Eigen::NoChange);
    model.scannedHeights = model.heights.topRows(model.scannedHeights.rows());
    model.clearance.open[10].weights.conservativeResize(last);
}

void change(ModelData& model, const std::uint8_t* data, std::size_t size)
{
    const Numbers numbers = numbersOf(model);
    constexpr std::size_t kChange = 10;
    for (; size >= kChange; data += kChange, size -= kChange) {
        std::uint64_t bits = 0;
        for (std::size_t i = 2; i < kChange; ++i) bits = bits << 8U | data[i];
        *numbers[(data[0] + std::size_t{256} * data[1]) % numbers.size()] =
            std::bit_cast<double>(bits);
    }
}

TerrainEstimate estimateBy(Method method, const ModelData& model)
{
    static const RobotModel robot = absolem();
    Proprioception s{
        .pitch = 0.1, .front = -0.3, .rear = 0.2, .frontCurrent = 2.0, .rearCurrent = 1.0};
    s.force.fill(1.0);
    Settings settings;
    settings.method = method;
    settings.draws = 8;
    settings.chains = 2;
    settings.burnIn = 2;
    if (isClosedForm(method))
        return reconstructClosedForm(s, {}, robot, ClearanceModel(model), settings);
    if (method == Method::Pafc)
        return sampleScene(
            paperSampling(s, {}, robot, BinModels(model, FeatureSet::Paf), settings));
    return estimateTerrain(s, {}, robot, Models(model, robot), settings);
}

void promiseEstimate(Method method, const ModelData& model)
{
    try {
        const TerrainEstimate estimate = estimateBy(method, model);
        for (std::size_t i = 0; i < kBins; ++i)
            for (const double value : {estimate.height[i], estimate.mean[i], estimate.sd[i],
                                       estimate.q10[i], estimate.q90[i], estimate.rhat[i]})
                promise(std::isfinite(value), "an estimate is finite");
    } catch (const std::invalid_argument& error) {
        promise(error.what()[0] != '\0', "what cannot be estimated says why");
    }
}

void promiseRoundTrip(const ModelData& model)
{
    static const ScratchFile file("numbers.ttm");
    promise(bool(writeModel(file.path(), model)), "a model can be written");
    const Result<StoredModel> again = readModel(file.path());
    promise(again && same(again->data, model), "a model survives being written and read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::array kTried{Method::Joint, Method::Local, Method::Pafc, Method::Clearance};
    if (size == 0) return 0;
    const Method method = kTried[data[0] / 64U];
    ModelData model = realModel(method == Method::Clearance ? kMinTrainingRows : 1 + data[0] % 4);
    if (data[0] & kWithHole && model.heights.rows() > 1) addHole(model);
    change(model, data + 1, size - 1);
    try {
        promise(!contentHash(model).empty(), "an accepted model has a hash");
    } catch (const std::invalid_argument&) {
        return 0;  // refused
    }
    if (data[0] & kThroughFile) promiseRoundTrip(model);
    promiseEstimate(method, model);
    return 0;
}
