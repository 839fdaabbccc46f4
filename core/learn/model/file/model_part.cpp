#include "core/learn/model/file/model_part.h"

#include <stdexcept>

#include "core/learn/model/clearance_training.h"
#include "core/learn/model/file/model_checks.h"
#include "core/learn/model/file/model_layout.h"
#include "core/learn/model/file/model_reading.h"
#include "core/learn/model/file/model_writing.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/store/sqlite.h"

namespace terratact {
namespace {

/// Property that all parts of one training share.
struct Mark {
    std::string name;
    std::string found, expected;
};

std::vector<Mark> marksOf(const ModelPart& found, const ModelPart& expected)
{
    const auto command = [](const Portion& p) {
        return p.commandBeforeOut + "(model)" + p.commandAfterOut;
    };
    return {
        {"command", command(found.portion), command(expected.portion)},
        {"seed", std::to_string(found.model.seed), std::to_string(expected.model.seed)},
        {"number of inducing rows", std::to_string(found.model.inducing),
         std::to_string(expected.model.inducing)},
        {"scenes' SHA-256", found.model.dataHash, expected.model.dataHash},
        {"robot's SHA-256", found.portion.robotHash, expected.portion.robotHash},
    };
}

template <class Matrix>
bool equal(const Matrix& a, const Matrix& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

bool sameInputs(const BinModelData& a, const BinModelData& b)
{
    return equal(a.mean, b.mean) && equal(a.sd, b.sd);
}

bool sameRows(const ModelData& a, const ModelData& b)
{
    return a.repeats == b.repeats && equal(a.heights, b.heights) && equal(a.features, b.features)
        && equal(a.scannedHeights, b.scannedHeights) && equal(a.heightSd, b.heightSd)
        && a.unknownBins == b.unknownBins && sameInputs(a.pa, b.pa) && sameInputs(a.paf, b.paf)
        && equal(a.clearance.featureMean, b.clearance.featureMean)
        && equal(a.clearance.featureSd, b.clearance.featureSd)
        && a.clearance.coveredBins == b.clearance.coveredBins;
}

Status requireSameTraining(const NamedModelPart& part, const NamedModelPart& first)
{
    for (const Mark& mark : marksOf(part.part, first.part))
        if (mark.found != mark.expected)
            return fileError(part.path, "is a part of another training: its " + mark.name + " is "
                                            + mark.found + ", expected " + mark.expected + " as in "
                                            + first.path);
    if (!sameRows(part.part.model, first.part.model))
        return fileError(part.path, "is a part of another training: expected the training rows of "
                                        + first.path);
    return Done{};
}

/// Checks that every bin is in exactly one part.
Status requireEveryBin(std::span<const NamedModelPart> parts, const std::string& out)
{
    BinSet held;
    std::string list;
    for (const NamedModelPart& part : parts) {
        const BinSet& bins = part.part.portion.bins;
        if ((held & bins).any())
            return fileError(part.path,
                             "holds bins " + text(held & bins)
                                 + " a second time, expected every bin in one part:" + list);
        held |= bins;
        list += " " + part.path + " (" + text(bins) + ")";
    }
    if (held != kAllBins)
        return fileError(out, "cannot be made: bins " + text(~held) + " are in no part, expected "
                                  + text(kAllBins) + "; there are" + list);
    return Done{};
}

void copyEntry(BinModelData& into, const BinModelData& from, std::size_t i)
{
    into.bins[i] = from.bins[i];
    into.logLikelihood[i] = from.logLikelihood[i];
}

void copyBin(ModelData& into, const ModelData& from, int bin)
{
    const auto i = static_cast<std::size_t>(bin);
    copyEntry(into.pa, from.pa, i);
    copyEntry(into.paf, from.paf, i);
    ClearanceData& clearance = into.clearance;
    clearance.open[i] = from.clearance.open[i];
    clearance.covered[i] = from.clearance.covered[i];
    clearance.conditionalOpen[i] = from.clearance.conditionalOpen[i];
    clearance.conditionalCovered[i] = from.clearance.conditionalCovered[i];
    clearance.residuals.col(bin) = from.clearance.residuals.col(bin);
}

}  // namespace

Status writeModelPart(const std::string& path, const ModelPart& part)
{
    try {
        model_file::requireModel(part.model, &part.portion);
    } catch (const model_file::Refused& refused) {
        throw std::invalid_argument(std::string("writeModelPart: ") + refused.what());
    }
    Result<NewFile> file = NewFile::begin(path, Access::Everybody);
    if (!file) return file.error();
    try {
        model_file::fill(file->temporaryPath(), part.model, &part.portion);
    } catch (const SqliteError& error) {
        return fileError(path, "cannot be written: " + std::string(error.what()));
    }
    return file->commit();
}

Result<ModelPart> readModelPart(const std::string& path)
{
    try {
        SqliteFile file = SqliteFile::openUntrusted(path, model_file::kMaxBytes);
        return model_file::readStoredPart(file);
    } catch (const SqliteError& error) {
        return fileError(path, error.message());
    } catch (const model_file::Refused& refused) {
        return fileError(path, refused.message());
    }
}

Result<ModelData> mergeModelParts(std::span<const NamedModelPart> parts, const RobotModel& robot,
                                  const std::string& robotHash, const std::string& out)
{
    if (parts.empty()) return fileError(out, "cannot be made of no part");
    const NamedModelPart& first = parts.front();
    for (const NamedModelPart& part : parts)
        if (Status same = requireSameTraining(part, first); !same) return same.error();
    if (Status every = requireEveryBin(parts, out); !every) return every.error();
    const Portion& portion = first.part.portion;
    if (robotHash != portion.robotHash)
        return fileError(first.path, "was trained for another robot: its robot's SHA-256 is "
                                         + portion.robotHash + ", expected " + robotHash);
    ModelData model = first.part.model;
    for (const NamedModelPart& part : parts)
        for (const int bin : binsOf(part.part.portion.bins)) copyBin(model, part.part.model, bin);
    model.command = portion.commandBeforeOut + out + portion.commandAfterOut;
    finishClearance(model, bodyCeilings(model.features, robot), robot);
    return model;
}

}  // namespace terratact
