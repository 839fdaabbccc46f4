// Fuzzes model files as bytes. Mutants keep the size of a real file, otherwise its header would reject them all.
#include "core/learn/model/file/model_file.h"

#include <cstdint>

#include "tests/fuzz/in_place.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/support/random_model.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

const ScratchFile& file()
{
    static const ScratchFile scratch("model.ttm");
    return scratch;
}

const std::string& realModel()
{
    static const std::string bytes = [] {
        promise(bool(writeModel(file().path(), randomModel(3))), "a model can be written");
        return file().read();
    }();
    return bytes;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
{
    return mutateInPlace(realModel(), data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    file().write(data, size);
    const Result<StoredModel> model = readModel(file().path());
    if (!model) return promiseRefusal(model.error(), file().path()), 0;
    promise(contentHash(model->data) == model->contentHash, "a model has the hash that is stored");
    promise(bool(writeModel(file().path(), model->data)), "what was read can be written");
    const Result<StoredModel> again = readModel(file().path());
    promise(again && same(again->data, model->data), "a model survives being written and read");
    return 0;
}
