// Conversion takes no solid that has not been checked.
#include "osem/convert.hpp"

osem::Status begin(osem::Conversion& job, const osem::Solid& solid) {
    return job.begin(solid, osem::ConvertOptions{}, nullptr, 0, nullptr);
}
