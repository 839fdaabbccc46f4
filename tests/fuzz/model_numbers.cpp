// The numbers of a model file: the first byte says how many training rows a real model has, then 10 bytes each change
// one of its numbers (two say which, eight are the new one).  A model that is refused may not be written; one that is
// accepted survives a file, and estimates a terrain in finite numbers or says why it cannot.
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/infer/estimator.h"
#include "core/learn/model_file.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/absolem.h"
#include "tests/support/random_model.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

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

/// A model with conditionals of clearances, too.
ModelData realModel(int rows)
{
    ModelData model = randomModel(rows);
    for (auto* const conditionals :
         {&model.clearance.conditionalOpen, &model.clearance.conditionalCovered})
        for (Hyperparameters& hyper : *conditionals)
            hyper = {Eigen::VectorXd::Constant(21, 5.0), 1.0, 0.1};
    return model;
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

void promiseEstimate(const Proprioception& s, const RobotModel& robot, const Models& models,
                     Method method)
{
    Settings settings;
    settings.method = method;
    settings.draws = 8;
    settings.chains = 2;
    settings.burnIn = 2;
    const TerrainEstimate estimate = estimateTerrain(s, {}, robot, models, settings);
    for (std::size_t i = 0; i < kBins; ++i)
        for (const double value : {estimate.height[i], estimate.mean[i], estimate.sd[i],
                                   estimate.q10[i], estimate.q90[i]})
            promise(std::isfinite(value), "an estimate is finite");
}

void promiseEstimates(const ModelData& model)
{
    static const RobotModel robot = absolem();
    Proprioception s{
        .pitch = 0.1, .front = -0.3, .rear = 0.2, .frontCurrent = 2.0, .rearCurrent = 1.0};
    s.force.fill(1.0);
    for (const Method method : {Method::Joint, Method::Local, Method::Clearance, Method::Pafc})
        try {
            const Models models(model, robot);
            promiseEstimate(s, robot, models, method);
        } catch (const std::invalid_argument&) {
            continue;  // which the console shows
        }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const ScratchFile file("numbers.ttm");
    if (size == 0) return 0;
    ModelData model = realModel(1 + data[0] % 40);
    change(model, data + 1, size - 1);
    try {
        promise(bool(writeModel(file.path(), model)), "a model can be written");
    } catch (const std::invalid_argument&) {
        return 0;
    }
    const Result<StoredModel> again = readModel(file.path());
    promise(again && same(again->data, model), "a model survives being written and read");
    promiseEstimates(again->data);
    return 0;
}
